/**
 * @file smLoopCrossings.h
 * @brief Loops that cross themselves or each other, or lie where they must not; not installed
 */
#ifndef smLoopCrossings_h
#define smLoopCrossings_h

#include "smFiltersNURBSModule.h"

#include "smFace.h"

#include <array>
#include <vector>

namespace sm
{
/**
 * Returns true if the loops wind more than once, or the wrong way, around a point of the (u,v) plane next to
 * a loop, or next to a place where they cross, so that the face covers a part of its surface twice or from
 * outside: a hole outside the outer loop or in another hole, for example. Where two pieces of loops cross,
 * the winding numbers left of both and right of both differ by 2: one of them is neither 0 nor 1. Such a
 * point counts if it is farther from all loops, in u or in v, than 1e-3 of their extent there, plus the
 * tolerance of the edges, at least 1e-4 and at most 1e-3 of the longer side of the face, and than the gaps at
 * the corners of the loops: a smaller overlap is not found. Nor is one behind 4096 places where loops touch.
 * The trim curves are valid, with edges. A short degenerate edge along which the surface moves is such a gap,
 * too: it joins the ends of two edges that do not meet. Thread safe.
 */
SMFILTERSNURBS_EXPORT bool HasWrongLoops(const Face& face);

/// For each point (u,v) whether it is farther from all loops than that.
SMFILTERSNURBS_EXPORT std::vector<bool> AreFarFromLoops(
  const Face& face, const std::vector<std::array<double, 2>>& points);
}

#endif
