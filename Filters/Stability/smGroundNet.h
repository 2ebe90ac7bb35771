/**
 * @file smGroundNet.h
 * @brief Curves and patches of faces in the frame of the ground: heights enclosed by control points, and
 * their slopes
 *
 * The frame's coordinates are a, b in the ground's plane and the height h along its normal, away from the
 * body's support. A rational Bézier curve or patch lies in the convex hull of its control points (weights are
 * positive), so the smallest and the largest h_i enclose its heights; halving a net halves its slack at
 * second order. The slope of h = H / W has the sign of H' - h W', linear in h: where its Bernstein
 * coefficients have one sign for the smallest and the largest h, it has that sign on the whole net, and no
 * height on it is stationary.
 */
#ifndef smGroundNet_h
#define smGroundNet_h

#include "smFacePanels.h"
#include "smFiltersStabilityModule.h"

#include <array>
#include <utility>
#include <vector>

namespace sm
{
/// Binomial coefficient n over k.
double GetBinomial(int n, int k);

/// Homogeneous coordinates w a, w b, w h, w.
using GroundPoint = std::array<double, 4>;

/// Transform from model coordinates to the ground's frame: rotation or reflection, then translation.
struct SMFILTERSSTABILITY_EXPORT GroundFrame
{
  std::array<std::array<double, 3>, 3> Rows{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  std::array<double, 3> Shift{};

  GroundPoint Transform(const std::array<double, 4>& homogeneous, const double center[3]) const;
};

struct HeightRange
{
  double Low;
  double High;
};

/// A curve, or a part of one (the root) after halvings. Low and High are its range in the root's parameter t
/// in [0,1].
struct SMFILTERSSTABILITY_EXPORT GroundCurve
{
  std::vector<GroundPoint> Points;
  /// Bernstein coefficients of the derivative of Points in the root's parameter, degree one less; none for a
  /// point.
  std::vector<GroundPoint> Steps;
  double Start = 0.0;
  double End = 1.0;

  /// Makes a root from its control points.
  static GroundCurve FromPoints(std::vector<GroundPoint> points);

  HeightRange GetHeights() const;
  /// Returns true if the height is strictly monotone; `slack` bounds the rounding errors of H and W.
  bool IsMonotone(double slack) const;
  /// Returns true if all slopes of the height are within their rounding bound.
  bool IsLevel(double slack) const;
  std::pair<GroundCurve, GroundCurve> Split() const;
};

/// A patch, or a part of one (the root) after halvings: a box of the root's parameters (s, r).
struct SMFILTERSSTABILITY_EXPORT GroundPatch
{
  int Degree[2] = { 1, 1 };
  /// Control points, (Degree[0]+1) x (Degree[1]+1), s fastest.
  std::vector<GroundPoint> Points;
  /// Bernstein coefficients of the derivatives in the root's s and r.
  std::vector<GroundPoint> Steps[2];
  double Low[2] = { 0.0, 0.0 };
  double High[2] = { 1.0, 1.0 };

  GroundPatch() = default;
  GroundPatch(const FacePanels& panels, const Patch& patch, const GroundFrame& frame);

  HeightRange GetHeights() const;
  /// Returns true if the height is strictly monotone in `direction` on the whole box.
  bool IsMonotone(int direction, double slack) const;
  /// Returns the variation of the height's slopes along a direction, in the root's parameters. The box is
  /// halved in the direction with the larger one.
  double GetVariation(int direction) const;
  std::pair<GroundPatch, GroundPatch> Split(int direction) const;
  /// Returns the border at the low (0) or high (1) `end` of a direction, as a curve in the other direction.
  GroundCurve GetBorder(int direction, int end) const;
  /// Returns the largest distance, in the ground's plane, of a control point from the first one of its line
  /// in this direction.
  double GetExtent(int direction) const;
  /// Returns true if the determinant of the map to the ground's plane is proved to have one sign on the box,
  /// so that the image of the box is bounded by the image of its border.
  bool IsRegular() const;

  /// Height and curvature at a point of the root (Low = 0, High = 1).
  struct Shape
  {
    double Normal; ///< cosine between the surface's normal and the ground's, not negative
    /// Largest principal curvature, positive where the surface bends away from the ground; NaN where there is
    /// no normal.
    double Curvature;
    /// Smallest principal curvature; and the derivatives in s and r, projected to the ground's plane.
    double MinimumCurvature;
    std::array<double, 2> Tangents[2];
  };
  Shape GetShape(double s, double r) const;
};
}

#endif
