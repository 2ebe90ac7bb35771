#include "vtkSMPlaneDefaultsHelper.h"

#include "smInputBounds.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

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
  if (proxy->GetProperty("Point")->GetMTime() > initializationTimeStamp)
  {
    return;
  }
  const vtkBoundingBox box = sm::ComputeInputBounds(proxy);
  if (box.IsValid())
  {
    double middle[3];
    box.GetCenter(middle);
    vtkSMPropertyHelper(proxy, "Point").Set(middle, 3);
    proxy->UpdateVTKObjects();
  }
}
