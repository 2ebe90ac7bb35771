#include "smBodyBox.h"
#include "smBoxAnalysis.h"
#include "smResults.h"

#include "vtkCADReader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
void SetBox(BodyResult& body, const BodyBox& box)
{
  const std::array<double, 6>& b = box.Bounds;
  if (std::isfinite(box.Bound) && b[0] <= b[1])
  {
    body.LowCorner.Value = { b[0], b[2], b[4] };
    body.HighCorner.Value = { b[1], b[3], b[5] };
    body.LowCorner.Bound = body.HighCorner.Bound = box.Bound;
  }
}
}

const char* BoxAnalysis::GetMissingModule() const
{
  return nullptr;
}

void BoxAnalysis::Run(const AnalysisRun& run) const
{
  const std::vector<BodyBox> boxes = ComputeBodyBoxes(run.Reader->GetOutputDataObject(0));
  const double maximum = std::numeric_limits<double>::infinity();
  BodyBox total{ { maximum, -maximum, maximum, -maximum, maximum, -maximum }, 0.0 };
  for (SolidResult& solid : run.File.Solids)
  {
    const BodyBox& box = boxes.at(std::stoul(solid.Id) - 1);
    SetBox(solid, box);
    for (std::size_t i = 0; i < 6; i += 2)
    {
      total.Bounds[i] = std::min(total.Bounds[i], box.Bounds[i]);
      total.Bounds[i + 1] = std::max(total.Bounds[i + 1], box.Bounds[i + 1]);
    }
    // A NaN is kept: without the box of one body the box of all is not known.
    total.Bound = box.Bound <= total.Bound ? total.Bound : box.Bound;
    if (std::isnan(box.Bound))
    {
      return;
    }
  }
  SetBox(run.File.Total, total);
}
}
