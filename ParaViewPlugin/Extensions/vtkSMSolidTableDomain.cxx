#include "vtkSMSolidTableDomain.h"

#include "smIntegralNames.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

vtkStandardNewMacro(vtkSMSolidTableDomain);

vtkSMSolidTableDomain::vtkSMSolidTableDomain() = default;
vtkSMSolidTableDomain::~vtkSMSolidTableDomain() = default;

void vtkSMSolidTableDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

int vtkSMSolidTableDomain::IsInDomain(vtkSMProperty* property)
{
  if (!property)
  {
    return NOT_IN_DOMAIN;
  }
  const vtkSMUncheckedPropertyHelper inputs(property);
  for (unsigned int i = 0; i < inputs.GetNumberOfElements(); ++i)
  {
    auto* source = vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy(i));
    if (!source ||
      !source->GetDataInformation(inputs.GetOutputPort(i))
         ->GetArrayInformation(sm::names::LengthUnit, vtkDataObject::ROW))
    {
      return NOT_IN_DOMAIN;
    }
  }
  return inputs.GetNumberOfElements() > 0 ? IN_DOMAIN : NOT_IN_DOMAIN;
}
