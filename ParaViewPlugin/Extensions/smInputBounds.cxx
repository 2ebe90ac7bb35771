#include "smInputBounds.h"

#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

namespace sm
{
vtkBoundingBox ComputeInputBounds(vtkSMProxy* filter)
{
  vtkSMPropertyHelper input(filter, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!source)
  {
    return {};
  }
  source->UpdatePipeline();
  double bounds[6];
  source->GetDataInformation(input.GetOutputPort())->GetBounds(bounds);
  return vtkBoundingBox(bounds);
}
}
