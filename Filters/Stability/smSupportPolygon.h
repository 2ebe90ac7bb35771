/**
 * @file smSupportPolygon.h
 * @brief Convex hulls in the ground's plane, and the signed distance of a point from their border
 *
 * The signed distance of a point c to the border of a convex set K, positive inside, is the least over all directions of
 * (largest p.d over K) - c.d, inside and outside alike. It grows with K: a hull of certain contacts gives a lower bound, a hull
 * that encloses all possible ones an upper bound. Hulls are chains over points sorted by coordinate (Andrew's monotone chain), turns
 * decided in extended precision. Rounding moves a side by less than the merging tolerance, which every bound holds.
 * VTK's own hulls are not used: vtkConvexHull2D is made for the screen, vtkPointsProjectedHull throws away points by octants of its
 * own and keeps duplicates; neither bounds its own error.
 */
#ifndef smSupportPolygon_h
#define smSupportPolygon_h

#include "smFiltersStabilityModule.h"
#include <array>
#include <vector>

namespace sm
{
using Point2D = std::array<double, 2>;

struct SMFILTERSSTABILITY_EXPORT SupportPolygon
{
  /// Counter-clockwise, no three in a line; one or two where the hull is a point or a segment; none: it is empty.
  std::vector<Point2D> Corners;

  /// Hull of the points, those closer than `merge` to each other taken as one, and corners closer than that to the line of their
  /// neighbours left out. The result lies in the true hull, whose points are at most 4 merge outside.
  static SupportPolygon FromPoints(std::vector<Point2D> points, double merge);

  /// Positive inside; minus infinity for an empty hull.
  double GetMargin(const Point2D& point) const;

  /// Unit directions in which the least of the definition above is reached, or comes as close as `range` to it.
  std::vector<Point2D> GetCriticalDirections(const Point2D& point, double range) const;

  /// Largest p.d of the corners.
  double GetSupport(const Point2D& direction) const;

  /// The corner farthest from any, and the one farthest from that: at least half the diameter apart. Not for an empty hull.
  std::array<Point2D, 2> GetTips() const;
  /// Their distance, and the extent of the hull across their line: its diameter and width within a factor of two. 0 for a point.
  double GetLength() const;
  double GetWidth() const;
};
}

#endif
