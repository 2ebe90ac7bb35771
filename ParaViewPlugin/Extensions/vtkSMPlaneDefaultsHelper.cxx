#include "vtkSMPlaneDefaultsHelper.h"

#include "vtkBoundingBox.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

vtkStandardNewMacro(vtkSMPlaneDefaultsHelper);

vtkSMPlaneDefaultsHelper::vtkSMPlaneDefaultsHelper() = default;
vtkSMPlaneDefaultsHelper::~vtkSMPlaneDefaultsHelper() = default;

void vtkSMPlaneDefaultsHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkSMPlaneDefaultsHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType initializationTimeStamp)
{
  vtkSMPropertyHelper input(proxy, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!source || proxy->GetProperty("Point")->GetMTime() > initializationTimeStamp)
  {
    return;
  }
  double bounds[6];
  source->GetDataInformation(input.GetOutputPort())->GetBounds(bounds);
  const vtkBoundingBox box(bounds);
  if (box.IsValid())
  {
    double middle[3];
    box.GetCenter(middle);
    vtkSMPropertyHelper(proxy, "Point").Set(middle, 3);
    proxy->UpdateVTKObjects();
  }
}
