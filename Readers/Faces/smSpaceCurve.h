/**
 * @file smSpaceCurve.h
 * @brief A curve in space as a file defines it, and its part between two vertices
 */
#ifndef smSpaceCurve_h
#define smSpaceCurve_h

#include "smLineIntegrals.h"

#include <vector>

namespace sm
{
/// A curve as ISO 10303-42 defines it (clause 4.4). Its parameters are those of the standard, angles in
/// radians.
struct SMREADERSFACES_EXPORT SpaceCurve
{
  enum class Type
  {
    /// Only its vertices matter: a straight line.
    Line,
    /// Origin + Radii[0] cos t Axes[0] + Radii[1] sin t Axes[1]; a circle if the radii are equal.
    Ellipse,
    /// Origin + Radii[0] (t^2 Axes[0] + 2 t Axes[1]).
    Parabola,
    /// Origin + Radii[0] cosh t Axes[0] + Radii[1] sinh t Axes[1].
    Hyperbola,
    /// A rational B-spline curve.
    Spline
  };
  Type Kind = Type::Line;
  Vector3 Origin{};
  Vector3 Axes[2]{};
  double Radii[2] = { 0.0, 0.0 };
  int Degree = 0;
  std::vector<double> Knots;
  std::vector<Vector3> Points;
  /// As many as Points, or none.
  std::vector<double> Weights;

  /// Returns true if the numbers of a spline fit together and its knots do not decrease; true for other
  /// curves.
  bool IsConsistent() const;
  /// Evaluates the point, and the derivative if that is not null.
  Vector3 Evaluate(double t, Vector3* derivative = nullptr) const;
};

/// Integrates along the part of a curve from `start` to `end`, vertices near it; `isForward`: in the
/// direction of the curve's parameter. Points of a closed curve have two parts between them, chosen by the
/// direction; if they are equal, the part is the whole curve. Straight pieces connect the vertices with the
/// curve. The integrals are about `start`. Returns false if the curve has no such part.
SMREADERSFACES_EXPORT bool IntegrateEdge(
  const SpaceCurve& curve, const Vector3& start, const Vector3& end, bool isForward, LineIntegrals& result);
}

#endif
