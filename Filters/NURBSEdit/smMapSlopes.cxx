#include "Detail/smMapSlopes.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// A difference quotient that deviates from 1 or 0 by no more than this is set to 1 or 0: the deviation is
// rounding.
constexpr double SlopeNoise = 1e-9;
}

void MapSlopes::Add(const PointMap& map, const std::array<double, 3>& point, double step)
{
  const std::array<double, 3> to = map(point);
  double slopes[3][3];
  for (int k = 0; k < 3; ++k)
  {
    std::array<double, 3> beside = point;
    beside[k] += step;
    const std::array<double, 3> there = map(beside);
    for (int c = 0; c < 3; ++c)
    {
      const double same = c == k ? 1.0 : 0.0;
      const double slope = (there[c] - to[c]) / (beside[k] - point[k]);
      slopes[c][k] = std::abs(slope - same) <= SlopeNoise ? same : slope;
      this->Entries[c][k] = std::max(this->Entries[c][k], std::abs(slopes[c][k]));
    }
  }
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (!std::all_of(&slopes[0][0], &slopes[0][0] + 9, [](double slope) { return std::isfinite(slope); }))
  {
    std::fill(&this->Entries[0][0], &this->Entries[0][0] + 9, unknown);
    this->Lengthening = unknown;
    return;
  }
  double u[3][3];
  double w[3];
  double vt[3][3];
  vtkMath::SingularValueDecomposition3x3(slopes, u, w, vt);
  this->Lengthening = std::max({ this->Lengthening, std::abs(w[0]), std::abs(w[1]), std::abs(w[2]) });
}

std::array<double, 3> MapSlopes::Apply(const std::array<double, 3>& bounds) const
{
  std::array<double, 3> result{};
  for (int c = 0; c < 3; ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      // An exact component (bound 0) contributes 0 even if the derivative is infinite.
      result[c] += bounds[k] > 0.0 ? this->Entries[c][k] * bounds[k] : 0.0;
    }
  }
  return result;
}
}
