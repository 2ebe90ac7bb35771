/**
 * @file smTrimPolygons.h
 * @brief The loops of a face as closed polygons in (u,v), to a proved tolerance
 */
#ifndef smTrimPolygons_h
#define smTrimPolygons_h

#include "smFiltersNURBSModule.h"

#include "smFace.h"

#include <array>
#include <functional>
#include <vector>

namespace sm
{
struct TrimPolygons
{
  /// One closed polygon for each of the face's loops, oriented as the loop (face to the left); the first
  /// point is not repeated. No points: a loop without coedges, which encloses nothing.
  std::vector<std::vector<std::array<double, 2>>> Loops;
  /// Proved: no curve is farther than this from its chord, at equal parameters, in u and in v. At most the
  /// tolerance, unless that asks for more than 65536 chords of one trim piece.
  std::array<double, 2> Deviation{};
};

/// Tolerance in u and in v where a part of a curve lies within the box from `low` to `high`.
using TrimTolerance =
  std::function<std::array<double, 2>(const std::array<double, 2>& low, const std::array<double, 2>& high)>;

/**
 * Every trim piece is cut into chords that stay within the tolerance of it, in u and in v; pieces keep their
 * ends to the bit, and where the end of a coedge is not the start of the next one a straight closing piece
 * joins them. Coedges without a curve are passed over. The degree of a piece is at most MaximumDegree. Thread
 * safe.
 */
///@{
SMFILTERSNURBS_EXPORT TrimPolygons FlattenLoops(const Face& face, const std::array<double, 2>& tolerance);
SMFILTERSNURBS_EXPORT TrimPolygons FlattenLoops(const Face& face, const TrimTolerance& tolerance);
///@}
}

#endif
