#include "smNaturalBoundary.h"

#include "Trims/smFootPoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
/// A seam stays away from the holes by this fraction of a period; their extent is known from points of their
/// curves only.
constexpr double MinDistance = 1e-3;

/// Number of segments that approximate a coedge's trim curve.
constexpr int CurveSamples = 32;

/// Returns the range of a coordinate of a loop.
std::pair<double, double> GetRange(const DraftLoop& loop, int direction)
{
  std::pair<double, double> range(1e300, -1e300);
  for (const DraftCoedge& coedge : loop)
  {
    for (int i = 0; i <= CurveSamples; ++i)
    {
      const double x = static_cast<double>(i) / CurveSamples;
      const double value =
        coedge.Trim.Evaluate((1.0 - x) * coedge.Trim.First + x * coedge.Trim.Last)[direction];
      range.first = std::min(range.first, value);
      range.second = std::max(range.second, value);
    }
  }
  return range;
}

/// Finds the middle of the widest gap between the ranges of the loops, modulo a period, and moves the loops
/// into the period from there on.
bool PlaceSeam(DraftFace& face, int direction, double& start)
{
  const double period = face.Period[direction];
  std::vector<std::pair<double, double>> ranges;
  for (const DraftLoop& loop : face.Loops)
  {
    auto range = GetRange(loop, direction);
    const double shift = std::floor(range.first / period) * period;
    ranges.emplace_back(range.first - shift, range.second - shift);
  }
  std::sort(ranges.begin(), ranges.end());
  ranges.emplace_back(ranges[0].first + period, ranges[0].second + period);
  double widest = 0.0;
  double end = -1e300;
  // A range may reach into the next period and cover the first ones there.
  for (const auto& range : ranges)
  {
    end = std::max(end, range.second - period);
  }
  for (const auto& range : ranges)
  {
    if (range.first - end > widest)
    {
      widest = range.first - end;
      start = 0.5 * (range.first + end);
    }
    end = std::max(end, range.second);
  }
  if (!(widest > 2.0 * MinDistance * period))
  {
    return false;
  }
  for (DraftLoop& loop : face.Loops)
  {
    const double shift = std::floor((GetRange(loop, direction).first - start) / period) * period;
    for (DraftCoedge& coedge : loop)
    {
      coedge.Trim.Shift[direction] -= shift;
    }
  }
  return true;
}

DraftCoedge MakeSide(DraftFace& face, const Point2& from, const Point2& to, bool isPole)
{
  DraftCoedge side;
  side.EdgeIndex = -1 - face.AddedEdges++;
  side.Degenerate = isPole;
  SetStraight(from, to, side.Trim);
  return side;
}

/// Finds the range of parameters between the poles; a periodic direction is left as it is. Returns false if
/// the surface has another border.
bool FindDomain(const DraftFace& face, double low[2], double high[2])
{
  if (face.Period[0] <= 0.0 && face.Period[1] <= 0.0)
  {
    return false;
  }
  const auto finder = FootPointFinder::Make(face.Surface);
  for (int d = 0; finder && d < 2; ++d)
  {
    std::vector<double> poles;
    for (const FootPointFinder::Pole& pole : finder->GetPoles())
    {
      if (pole.Direction == d)
      {
        poles.push_back(pole.Value);
      }
    }
    std::sort(poles.begin(), poles.end());
    if (face.Period[d] <= 0.0)
    {
      if (poles.size() != 2 || !(poles[0] < poles[1]))
      {
        return false;
      }
      low[d] = poles[0];
      high[d] = poles[1];
    }
  }
  return finder != nullptr;
}

/// Returns the other use of a seam, a period away.
DraftCoedge MakeOtherSide(const DraftCoedge& seam, int direction, double shift)
{
  DraftCoedge side = seam;
  side.Reversed = true;
  side.Trim.Shift[direction] = shift;
  return side;
}
}

bool HasSeam(const DraftFace& face)
{
  std::unordered_set<int> edges;
  for (const DraftLoop& loop : face.Loops)
  {
    for (const DraftCoedge& coedge : loop)
    {
      if (!edges.insert(coedge.EdgeIndex).second)
      {
        return true;
      }
    }
  }
  return false;
}

bool IsOnClosedSurface(const DraftFace& face)
{
  double low[2];
  double high[2];
  return FindDomain(face, low, high);
}

bool AddNaturalBoundary(DraftFace& face)
{
  double low[2] = { 0.0, 0.0 };
  double high[2] = { 0.0, 0.0 };
  if (face.Loops.empty() || !FindDomain(face, low, high))
  {
    return false;
  }
  const DraftFace before = face;
  for (int d = 0; d < 2; ++d)
  {
    if (face.Period[d] > 0.0)
    {
      if (!PlaceSeam(face, d, low[d]))
      {
        face = before;
        return false;
      }
      high[d] = low[d] + face.Period[d];
    }
  }
  const Point2 corners[4] = { { low[0], low[1] }, { high[0], low[1] }, { high[0], high[1] },
    { low[0], high[1] } };
  DraftLoop loop;
  // A side whose coordinate in direction 1 - d is constant is a seam if that direction is periodic, else a
  // pole.
  for (int i = 0; i < 4; ++i)
  {
    const int across = i % 2 == 0 ? 1 : 0;
    const double period = face.Period[across];
    const bool isSecond = i >= 2;
    loop.push_back(isSecond && period > 0.0
        ? MakeOtherSide(loop[i - 2], across, across == 1 ? period : -period)
        : MakeSide(face, corners[i], corners[(i + 1) % 4], period == 0.0));
  }
  face.Loops.insert(face.Loops.begin(), std::move(loop));
  face.HasNaturalBoundary = true;
  return true;
}
}
