#include "smBuoyancyAnalysis.h"
#include "smBuoyancyNames.h"
#include "smPlaneCut.h"

#include "vtkBuoyancy.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace sm
{
const char* BuoyancyAnalysis::GetMissingModule() const
{
  return nullptr;
}

void BuoyancyAnalysis::Run(const AnalysisRun& run) const
{
  const std::array<double, 3>& up = this->Up;
  const double largest = std::max({ std::abs(up[0]), std::abs(up[1]), std::abs(up[2]) });
  const std::array<double, 3> scaled = { up[0] / largest, up[1] / largest, up[2] / largest };
  const double length = std::hypot(scaled[0], scaled[1], scaled[2]);
  vtkNew<vtkBuoyancy> filter;
  filter->SetRelativeTolerance(run.Options.Tolerance);
  filter->SetNormal(scaled.data());
  for (std::size_t i = 0; i < this->Waterlines.size(); ++i)
  {
    const double along = this->Waterlines[i] / length;
    filter->SetPoint(along * scaled[0], along * scaled[1], along * scaled[2]);
    RunPlaneCut<WaterlineResult>(run, filter,
      [i](vtkFieldData* data, vtkIdType row, WaterlineResult& result)
      {
        result.Waterlines[i].Volume = GetQuantity<1>(data, row, names::DisplacedVolume);
        result.Waterlines[i].Center = GetQuantity<3>(data, row, names::CenterOfBuoyancy);
      });
  }
}
}
