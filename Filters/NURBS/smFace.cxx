#include "smFace.h"

#include <atomic>

namespace sm
{
std::uint64_t NewId()
{
  static std::atomic<std::uint64_t> next{ 1 };
  return next++;
}

std::size_t GetMemorySize(const Face& face)
{
  const NURBSSurface& surface = face.Surface;
  std::size_t bytes = sizeof(Face) + surface.ControlPoints.size() * sizeof(surface.ControlPoints[0]) +
    (surface.Knots[0].size() + surface.Knots[1].size()) * sizeof(double);
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      bytes += sizeof(Coedge) + coedge.Curve.Coefficients.size() * sizeof(TrimCurve::Point) +
        coedge.Curve.Breaks.size() * (sizeof(double) + sizeof(std::size_t));
    }
  }
  return bytes;
}
}
