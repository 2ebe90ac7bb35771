#include "vtkSMExactGeometryDomain.h"

#include "vtkExactGeometryInformation.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

vtkStandardNewMacro(vtkSMExactGeometryDomain);

vtkSMExactGeometryDomain::vtkSMExactGeometryDomain() = default;
vtkSMExactGeometryDomain::~vtkSMExactGeometryDomain() = default;

void vtkSMExactGeometryDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

int vtkSMExactGeometryDomain::IsInDomain(vtkSMProperty* property)
{
  if (this->IsOptional)
  {
    return IN_DOMAIN;
  }
  if (!property)
  {
    return NOT_IN_DOMAIN;
  }
  const vtkSMUncheckedPropertyHelper inputs(property);
  for (unsigned int i = 0; i < inputs.GetNumberOfElements(); ++i)
  {
    auto* source = vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy(i));
    if (!source)
    {
      return NOT_IN_DOMAIN;
    }
    vtkNew<vtkExactGeometryInformation> information;
    information->SetPortNumber(static_cast<int>(inputs.GetOutputPort(i)));
    source->GatherInformation(information);
    if (!information->GetHasExactGeometry())
    {
      return NOT_IN_DOMAIN;
    }
  }
  return inputs.GetNumberOfElements() > 0 ? IN_DOMAIN : NOT_IN_DOMAIN;
}
