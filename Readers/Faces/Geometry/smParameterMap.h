/**
 * @file smParameterMap.h
 * @brief Maps coordinates and parameters of native geometry to those of the model
 */
#ifndef smParameterMap_h
#define smParameterMap_h

#include "smReadersFacesModule.h"

#include "smVector.h"

#include <vector>

namespace sm
{
/// Maps coordinates of native geometry (mm, before a placement) to those of the model.
struct SMREADERSFACES_EXPORT AffineMap
{
  double Linear[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  Vector3 Translation{};

  /// model = unit * placement(native) - origin. The placement is a matrix with three rows and four columns,
  /// Value(1, 1) to Value(3, 4).
  template <class Placement>
  static AffineMap Make(const Placement& placement, double unit, const double origin[3])
  {
    AffineMap map;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        map.Linear[i][j] = unit * placement.Value(i + 1, j + 1);
      }
      map.Translation[i] = unit * placement.Value(i + 1, 4) - origin[i];
    }
    return map;
  }
  Vector3 MapVector(const Vector3& v) const;
  Vector3 MapPoint(const Vector3& p) const;
  ///@{
  /** The same for a vector of another library, with X(), Y() and Z(). */
  template <class Vector>
  Vector3 MapVector(const Vector& v) const
  {
    return this->MapVector(Vector3{ v.X(), v.Y(), v.Z() });
  }
  template <class Vector>
  Vector3 MapPoint(const Vector& p) const
  {
    return this->MapPoint(Vector3{ p.X(), p.Y(), p.Z() });
  }
  ///@}
  bool IsMirrored() const;
  /// Length of a mapped unit vector.
  double GetScale() const;
};

/// Limit of the number of turns of a face around its surface.
constexpr double MaximumTurns = 1e4;

/**
 * Maps the native parameter to ours, in one direction. Circular: equal arcs of opening 2a <= 90 degrees,
 * weights (1, cos a, 1); arc k is the interval [k, k+1] of our parameter, and s = (1 + tan(phi/2) / tan(a/2))
 * / 2,  phi measured from the arc's middle. Hyperbolic: one piece, the same with tanh and weights (1, cosh a,
 * 1).
 */
struct SMREADERSFACES_EXPORT ParameterMap
{
  enum class Kind
  {
    Identity,
    Circular,
    Hyperbolic
  };
  Kind Type = Kind::Identity;
  double Start = 0.0;
  double Width = 1.0;
  int Count = 1;

  /// Makes a map with arcs that cover [low, high]; a full turn has four arcs. Throws std::runtime_error for a
  /// range that is not finite, or spans or lies beyond MaximumTurns.
  static ParameterMap MakeCircular(double low, double high);
  static ParameterMap MakeHyperbolic(double low, double high);

  double GetBorder(int arc) const { return this->Start + arc * this->Width; }
  int FindArc(double native) const;
  double EvaluateInArc(int arc, double native) const;
  double Evaluate(double native) const
  {
    return this->Type == Kind::Identity ? native : this->EvaluateInArc(this->FindArc(native), native);
  }
  /// Returns the largest derivative of the mapped parameter.
  double GetMaxSlope() const;
  /// Returns a bound of the rounding error of the mapped parameter.
  double GetRounding() const;
  /// Returns the homogeneous control points (c, s, w) of the unit circle (or hyperbola) over all arcs.
  std::vector<Vector3> GetControlPoints() const;
  std::vector<double> GetKnots() const;
};
}

#endif
