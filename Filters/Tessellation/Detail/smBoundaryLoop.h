/**
 * @file smBoundaryLoop.h
 * @brief The loops of a face as polygons
 */
#ifndef smBoundaryLoop_h
#define smBoundaryLoop_h

#include "smSurfaceBlocks.h"

#include <array>
#include <vector>

namespace sm
{
/// A point of a loop, and the chord that leads from it to the next.
struct BoundaryPoint
{
  std::array<double, 2> Parameters{};
  std::array<double, 3> Position{};
  /// The point of the body, see BodyMesh; two points of a loop are one where they have the same.
  int Shared = -1;
  /// Edge of the chord and its number there; -1: a straight line in (u,v) that closes the loop.
  int Edge = -1;
  int Chord = -1;
};
using BoundaryLoop = std::vector<BoundaryPoint>;

inline std::size_t CountPoints(const std::vector<BoundaryLoop>& loops)
{
  std::size_t count = 0;
  for (const BoundaryLoop& loop : loops)
  {
    count += loop.size();
  }
  return count;
}

/// The box of their points in (u,v).
inline ParameterBox FindBox(const std::vector<BoundaryLoop>& loops)
{
  ParameterBox box;
  bool first = true;
  for (const BoundaryLoop& loop : loops)
  {
    for (const BoundaryPoint& p : loop)
    {
      box = first ? ParameterBox{ p.Parameters, p.Parameters } : box;
      box.Add(p.Parameters);
      first = false;
    }
  }
  return box;
}
}

#endif
