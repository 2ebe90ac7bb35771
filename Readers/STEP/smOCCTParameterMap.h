/**
 * @file smOCCTParameterMap.h
 * @brief Maps coordinates and parameters of OpenCASCADE's geometry to those of the model
 */
#ifndef smOCCTParameterMap_h
#define smOCCTParameterMap_h

#include "smReadersSTEPModule.h"

#include <gp_Trsf.hxx>

#include <array>
#include <vector>

namespace sm
{
using Vector3 = std::array<double, 3>;

/// Maps coordinates of OpenCASCADE's geometry (mm, before a location) to those of the model.
struct SMREADERSSTEP_EXPORT AffineMap
{
  double Linear[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  Vector3 Translation{};

  /// model = unit * trsf(kernel) - origin
  static AffineMap Make(const gp_Trsf& trsf, double unit, const double origin[3]);
  Vector3 MapVector(const gp_XYZ& v) const;
  Vector3 MapPoint(const gp_XYZ& p) const;
  bool IsMirrored() const;
  /// Length of a mapped unit vector.
  double GetScale() const;
};

/// Limit of the number of turns of a face around its surface.
constexpr double MaximumTurns = 1e4;

/**
 * Maps the native parameter to ours, in one direction. Circular: equal arcs of opening 2a <= 90 degrees, weights
 * (1, cos a, 1); arc k is the interval [k, k+1] of our parameter, and
 *   s = (1 + tan(phi/2) / tan(a/2)) / 2,  phi measured from the arc's middle.
 * Hyperbolic: one piece, the same with tanh and weights (1, cosh a, 1).
 */
struct SMREADERSSTEP_EXPORT ParameterMap
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

  /// Makes a map with arcs that cover [low, high]; a full turn has four arcs. Throws std::runtime_error for a range that is not
  /// finite, or spans or lies beyond MaximumTurns.
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
  double GetLargestSlope() const;
  /// Returns a bound of the rounding error of the mapped parameter.
  double GetRounding() const;
  /// Returns the homogeneous control points (c, s, w) of the unit circle (or hyperbola) over all arcs.
  std::vector<Vector3> GetControlPoints() const;
  std::vector<double> GetKnots() const;
};
}

#endif
