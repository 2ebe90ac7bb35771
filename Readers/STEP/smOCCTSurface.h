/**
 * @file smOCCTSurface.h
 * @brief OpenCASCADE surfaces as rational B-splines without error, and the map between their parameters
 */
#ifndef smOCCTSurface_h
#define smOCCTSurface_h

#include "smFace.h"

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Standard_Handle.hxx>
#include <gp_Trsf.hxx>

#include <array>
#include <string>
#include <vector>

namespace sm
{
using Vector3 = std::array<double, 3>;

/// Coordinates of the kernel's geometry (mm, before a location) to those of the model.
struct AffineMap
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

/**
 * Native parameter to ours, in one direction. Circular: equal arcs of opening 2a <= 90 degrees, weights
 * (1, cos a, 1); arc k of ours is [k, k+1] and
 *   s = (1 + tan(phi/2) / tan(a/2)) / 2,  phi measured from the arc's middle.
 * Hyperbolic: one piece, the same with tanh and weights (1, cosh a, 1).
 */
struct ParameterMap
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

  /// Arcs that cover [low, high]; a full turn is four of them.
  static ParameterMap MakeCircular(double low, double high);
  static ParameterMap MakeHyperbolic(double low, double high);

  double GetBorder(int arc) const { return this->Start + arc * this->Width; }
  int FindArc(double native) const;
  double EvaluateInArc(int arc, double native) const;
  double Evaluate(double native) const
  {
    return this->Type == Kind::Identity ? native : this->EvaluateInArc(this->FindArc(native), native);
  }
  /// What rounding alone does to the mapped parameter.
  double GetRounding() const;
  /// Homogeneous control points (c, s, w) of the unit circle (or hyperbola) over all arcs.
  std::vector<Vector3> GetControlPoints() const;
  std::vector<double> GetKnots() const;
};

struct ConvertedSurface
{
  NURBSSurface Surface;
  ParameterMap Map[2];
};

/// Native parameters that the trims of a face cover.
struct ParameterBox
{
  double Low[2] = { 0.0, 0.0 };
  double High[2] = { 0.0, 0.0 };
};

/// The surface below rectangular trims, whose parameters it shares.
Handle(Geom_Surface) GetBasisSurface(Handle(Geom_Surface) surface);

/// Throws std::runtime_error with the reason when the surface cannot be carried over.
ConvertedSurface ConvertSurface(
  const Handle(Geom_Surface) & surface, const ParameterBox& box, const AffineMap& map);

/// Tensor Chebyshev fit over the box; the last resort, used for offset surfaces. Residual is stated.
NURBSSurface FitSurface(const Handle(Geom_Surface) & surface, const ParameterBox& box, const AffineMap& map);

/// A curve as a rational B-spline in kernel coordinates: homogeneous (w x, w y, w z, w).
struct Profile
{
  int Degree = 1;
  std::vector<double> Knots;
  std::vector<std::array<double, 4>> Poles;
  ParameterMap Map;
  double Residual = 0.0;
};
Profile ConvertProfile(const Handle(Geom_Curve) & curve, double low, double high);
}

#endif
