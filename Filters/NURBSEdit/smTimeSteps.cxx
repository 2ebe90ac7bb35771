#include "Detail/smTimeSteps.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <vector>

namespace sm
{
void DeclareTimeSteps(int steps, vtkInformation* outputInformation)
{
  if (steps < 2)
  {
    return;
  }
  std::vector<double> times;
  for (int i = 0; i < steps; ++i)
  {
    times.push_back(static_cast<double>(i) / (steps - 1));
  }
  const double range[] = { 0.0, 1.0 };
  outputInformation->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), steps);
  outputInformation->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
}

double TakeTimeShare(int steps, vtkInformation* outputInformation)
{
  if (steps < 2 || !outputInformation->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    return 1.0;
  }
  const double share =
    std::clamp(outputInformation->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()), 0.0, 1.0);
  vtkDataObject::GetData(outputInformation)->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), share);
  return share;
}
}
