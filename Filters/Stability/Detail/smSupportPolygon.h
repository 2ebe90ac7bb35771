/**
 * @file smSupportPolygon.h
 * @brief Convex hulls in the ground's plane, and the signed distance of a point from their border
 *
 * The signed distance of a point c to the border of a convex set K, positive inside, is the minimum over all
 * directions of (largest p.d over K) - c.d, inside and outside alike. It grows with K: a hull of certain
 * contacts gives a lower bound, a hull that encloses all possible ones an upper bound. Hulls are chains over
 * points sorted by coordinate (Andrew's monotone chain), turns decided in extended precision. Rounding moves
 * a side by less than the merging tolerance, which every bound holds. VTK's hulls are not used, because
 * neither bounds its error: vtkConvexHull2D works with screen coordinates, vtkPointsProjectedHull discards
 * points by octants and keeps duplicates.
 */
#ifndef smSupportPolygon_h
#define smSupportPolygon_h

#include "smFiltersStabilityModule.h"
#include "smVector.h"

#include <array>
#include <vector>

namespace sm
{
struct SMFILTERSSTABILITY_EXPORT SupportPolygon
{
  /// Corners counter-clockwise, no three in a line; two for a segment, one for a point, none for an empty
  /// hull.
  std::vector<Point2> Corners;

  /// Returns the hull of the points. Points closer than `merge` to each other count as one, and corners
  /// closer than that to the line of their neighbours are left out. The result lies in the true hull, whose
  /// points are at most 4 merge outside.
  static SupportPolygon FromPoints(std::vector<Point2> points, double merge);

  /// Returns the signed distance of a point from the border, positive inside; minus infinity for an empty
  /// hull.
  double GetMargin(const Point2& point) const;

  /// Returns the unit directions d for which (largest p.d) - c.d is within `range` of its minimum value.
  std::vector<Point2> GetCriticalDirections(const Point2& point, double range) const;

  /// Returns the largest p.d of the corners p.
  double GetSupport(const Point2& direction) const;

  /// Returns two corners that are at least half the diameter apart: the one farthest from the first corner,
  /// and the one farthest from that. The hull must not be empty.
  std::array<Point2, 2> GetTips() const;
  /// The distance of the tips, and the extent of the hull across their line: diameter and width of the hull
  /// within a factor of two; 0 for a point.
  double GetLength() const;
  double GetWidth() const;
};
}

#endif
