#include "smPatchParts.h"

#include "smBernstein.h"
#include "smUnitRoundoff.h"

#include "smPolynomialCurve.h"

#include <algorithm>
#include <vector>

namespace sm
{
namespace
{
using Point3 = std::array<double, 3>;

}

std::uint32_t AppendPatchPart(const FacePanels& from, std::uint32_t index, const std::array<double, 2>& low,
  const std::array<double, 2>& high, bool exchange, FacePanels& to)
{
  const Patch& whole = from.Patches[index];
  const int p = whole.Degree[0];
  const int q = whole.Degree[1];
  const int count = (p + 1) * (q + 1);
  const std::array<double, 4>* source = from.Points.data() + whole.FirstPoint;
  std::vector<std::array<double, 4>> points(source, source + count);
  Patch patch = whole;
  bool isWhole = true;
  for (int d = 0; d < 2; ++d)
  {
    isWhole = isWhole && low[d] == whole.Start[d] && high[d] == whole.Start[d] + whole.Width[d];
  }
  if (!isWhole)
  {
    double minimum = source[0][3];
    double maximum = minimum;
    for (int i = 0; i < count; ++i)
    {
      minimum = std::min(minimum, source[i][3]);
      maximum = std::max(maximum, source[i][3]);
    }
    // De Casteljau's scheme runs twice in either direction, 2 (p + q) steps. Each rounds a convex combination
    // of points and of weights.
    const Point3 reach = GetReach(source, count);
    for (int d = 0; d < 2; ++d)
    {
      const double start = (low[d] - whole.Start[d]) / whole.Width[d];
      const double end = (high[d] - whole.Start[d]) / whole.Width[d];
      const int lines = d == 0 ? q + 1 : p + 1;
      for (int line = 0; line < lines; ++line)
      {
        RestrictBernstein(
          points.data() + line * (d == 0 ? p + 1 : 1), d == 0 ? p : q, d == 0 ? 1 : p + 1, start, end);
      }
      patch.Start[d] = low[d];
      patch.Width[d] = high[d] - low[d];
    }
    for (int c = 0; c < 3; ++c)
    {
      double lowest = points[0][c] / points[0][3];
      double highest = lowest;
      for (const std::array<double, 4>& point : points)
      {
        lowest = std::min(lowest, point[c] / point[3]);
        highest = std::max(highest, point[c] / point[3]);
      }
      // The centre is rounded to a double; the translation to it is exact, or rounded as a length of the
      // patch.
      patch.Center[c] = whole.Center[c] + 0.5 * (lowest + highest);
      const double step = patch.Center[c] - whole.Center[c];
      for (std::array<double, 4>& point : points)
      {
        point[c] -= step * point[3];
      }
      patch.Displacement[c] += (4.0 * (p + q) + 4.0) * UnitRoundoff * reach[c] * maximum / minimum;
    }
  }
  if (exchange)
  {
    std::vector<std::array<double, 4>> exchanged(points.size());
    for (int j = 0; j <= q; ++j)
    {
      for (int i = 0; i <= p; ++i)
      {
        exchanged[j + (q + 1) * i] = points[i + (p + 1) * j];
      }
    }
    points = std::move(exchanged);
    std::swap(patch.Degree[0], patch.Degree[1]);
    std::swap(patch.Start[0], patch.Start[1]);
    std::swap(patch.Width[0], patch.Width[1]);
    patch.Exchanged = !patch.Exchanged;
  }
  MeasurePatch(points.data(), patch);
  patch.FirstPoint = static_cast<std::uint32_t>(to.Points.size());
  to.Points.insert(to.Points.end(), points.begin(), points.end());
  to.Patches.push_back(patch);
  return static_cast<std::uint32_t>(to.Patches.size() - 1);
}
}
