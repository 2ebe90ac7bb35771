#include "smWaterlineFrame.h"
#include "smBodyScales.h"
#include "smPlacementError.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
using Wide = long double;
using Wide3 = std::array<Wide, 3>;

/// Distance by which rounding moves a sample, R p + t with p in the model's coordinates. In every coordinate
/// it is u for p, u for the entries of R, 3 u for products and sums, and with t, which is as large where the
/// result is small, 2 u; 8 u with some room. The bound of a sample's rounding has that for coordinates as
/// large as the body; here p is the middle of the body.
double GetEvaluationError(const std::array<double, 12>& placement, const std::array<double, 3>& middle)
{
  std::array<double, 3> sums{};
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      sums[k] += std::abs(placement[4 * k + j] * middle[j]);
    }
  }
  return 8.0 * UnitRoundoff * Norm(sums);
}
}

WaterlineFrame WaterlineFrame::Make(const BodyIntegrals& body, const Waterline& waterline)
{
  const Wide3 up = Normalized(Wide3{ waterline.Up[0], waterline.Up[1], waterline.Up[2] });
  const int minimum = static_cast<int>(
    std::min_element(up.begin(), up.end(), [](Wide a, Wide b) { return std::abs(a) < std::abs(b); }) -
    up.begin());
  Wide3 axis{};
  axis[minimum] = 1.0L;
  const Wide3 x = Normalized(Cross(axis, up));
  const std::array<Wide3, 3> axes = { x, Cross(up, x), up };

  const std::array<double, 6> box = GetBox(*body.Model);
  const double* modelOrigin = body.Model->GetOrigin();
  const double* m = body.Placement.data();
  WaterlineFrame frame;
  // Model origin and middle of the model's box, relative to the waterline's point.
  Wide3 toModel;
  Wide3 toMiddle;
  double distance = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    toModel[i] = static_cast<Wide>(m[4 * i + 3]) - waterline.Point[i];
    Wide local = 0.0L;
    for (int j = 0; j < 3; ++j)
    {
      toModel[i] += static_cast<Wide>(m[4 * i + j]) * modelOrigin[j];
      local += static_cast<Wide>(m[4 * i + j]) * 0.5L * (static_cast<Wide>(box[2 * j]) + box[2 * j + 1]);
      distance += std::abs(m[4 * i + j] * modelOrigin[j]);
    }
    toMiddle[i] = toModel[i] + local;
    frame.LocalMiddle[i] = 0.5 * (box[2 * i] + box[2 * i + 1]);
    frame.Middle[i] = static_cast<double>(toMiddle[i] + waterline.Point[i]);
    distance += std::abs(m[4 * i + 3]) + std::abs(waterline.Point[i]);
  }
  frame.Plane.Offset = Dot(up, toModel);
  const double radius = GetRadius(*body.Model);
  frame.PlacementBound = PlacementError::Make(body, false).Moved;
  const std::array<Wide, 3> middle = { Dot(axes[0], toMiddle), Dot(axes[1], toMiddle),
    Dot(axes[2], toMiddle) };
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      Wide entry = 0.0L;
      for (int i = 0; i < 3; ++i)
      {
        entry += axes[k][i] * m[4 * i + j];
      }
      frame.Placement[4 * k + j] = static_cast<double>(entry);
      frame.Axes[k][j] = static_cast<double>(axes[k][j]);
    }
    frame.Placement[4 * k + 3] = static_cast<double>(Dot(axes[k], toModel) - (k < 2 ? middle[k] : 0.0L));
  }
  frame.PlacementBound += GetEvaluationError(frame.Placement, frame.LocalMiddle);
  frame.PlaneBound = 16.0 * WideRoundoff * distance + frame.PlacementBound;
  frame.Plane.Up = { frame.Placement[8], frame.Placement[9], frame.Placement[10] };
  for (int i = 0; i < 3; ++i)
  {
    frame.Origin[i] =
      static_cast<double>(waterline.Point[i] + middle[0] * axes[0][i] + middle[1] * axes[1][i]);
  }
  frame.PlaneOrigin = frame.Origin;
  frame.Reach = radius;
  return frame;
}

void WaterlineFrame::MoveToMiddle()
{
  this->Placement[11] = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    this->Placement[11] -= this->Plane.Up[c] * this->LocalMiddle[c];
  }
  this->Origin = this->Middle;
  this->PlaneBound = this->PlacementBound;
}
}
