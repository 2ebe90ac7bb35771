/**
 * @file smGeometricCurve.h
 * @brief Curves in space and in the parameters of a surface as a file defines them: immutable values
 *
 * The curves of ISO 10303-42, clause 4.4, as points and derivatives. Lengths are in one unit, angles in
 * radians.
 *
 * | value | definition in its natural parameter t | entity, and t for its parameter u |
 * |---|---|---|
 * | LineCurve | O + t D, D a unit vector | line: t = u times the length of the vector |
 * | ConicCurve, ellipse | C + a cos(t) X + b sin(t) Y | circle, ellipse: t = u in radians |
 * | ConicCurve, parabola | C + t^2/(4 f) X + t Y | parabola, C + f (u^2 X + 2 u Y): t = 2 f u |
 * | ConicCurve, hyperbola | C + a cosh(t) X + b sinh(t) Y | hyperbola: t = u |
 * | SplineCurve | sum N_i(t) w_i P_i / sum N_i(t) w_i | polyline, b_spline_curve of all kinds: t = u |
 * | OffsetCurve | B(t) + d N, N unit vector of V x B'(t); in 2D (-y', x') | offset_curve_3d and _2d: t = u |
 * | CompositeCurve | its segments one after another | composite_curve: t = u, segment by segment |
 * | CurveOnSurface | S(c(t)) | pcurve as a curve in space: t = u |
 *
 * A trimmed_curve is its basis over a part of the domain, a curve_replica the transformed value.
 */
#ifndef smGeometricCurve_h
#define smGeometricCurve_h

#include "smReadersFacesModule.h"
#include "smSplineBasis.h"

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace sm
{
class GeometricSurface;
template <int Dimension>
class GeometricCurve;
template <int Dimension>
using CurvePointer = std::shared_ptr<const GeometricCurve<Dimension>>;

/// A range of parameters; infinite where there is no end.
struct ParameterRange
{
  double Low = -std::numeric_limits<double>::infinity();
  double High = std::numeric_limits<double>::infinity();
};

/// The parameter of a value as a function of that of the file: Offset + Scale u.
struct ParameterScale
{
  double Scale = 1.0;
  double Offset = 0.0;

  double operator()(double u) const { return this->Offset + this->Scale * u; }
};

template <int Dimension>
struct LineCurve
{
  std::array<double, Dimension> Origin{};
  /// A unit vector.
  std::array<double, Dimension> Direction{};
};

/// Returns the parameter of the point of a hyperbola that is `y` semi-axes away from its X axis: asinh(y),
/// with the same bits on every system. The C library's depend on its version (glibc 2.36 and 2.43).
SMREADERSFACES_EXPORT double GetHyperbolaParameter(double y);

template <int Dimension>
struct ConicCurve
{
  enum class Type : unsigned char
  {
    Ellipse,
    Parabola,
    Hyperbola
  };
  Type Kind = Type::Ellipse;
  std::array<double, Dimension> Center{};
  /// Unit vectors, normal to each other, for a conic of a file. Its image under an affine map, with the same
  /// parameter, has any two that are not parallel.
  std::array<double, Dimension> X{};
  std::array<double, Dimension> Y{};
  /// Semi-axes along X and Y; the focal distance of a parabola is the first one.
  double Radii[2] = { 1.0, 1.0 };
};

template <int Dimension>
struct SplineCurve
{
  SplineBasis Basis;
  std::vector<std::array<double, Dimension>> Poles;
  /// Positive; empty for a polynomial spline.
  std::vector<double> Weights;
};

template <int Dimension>
struct OffsetCurve
{
  CurvePointer<Dimension> Basis;
  double Distance = 0.0;
  /// The unit vector V; not used in the plane.
  std::array<double, Dimension> Reference{};
};

/// A curve over a part of its domain that is one segment of another one.
template <int Dimension>
struct CurveSegment
{
  CurvePointer<Dimension> Curve;
  /// Natural parameters at the start and at the end in the direction of the whole; the second one may be
  /// less.
  double First = 0.0;
  double Last = 1.0;
  /// Length of the segment in the parameter of the whole.
  double Length = 1.0;
};

template <int Dimension>
struct CompositeCurve
{
  std::vector<CurveSegment<Dimension>> Segments;
};

/// A curve in the parameters of a surface, in space. No curve in the plane.
struct CurveOnSurface
{
  std::shared_ptr<const GeometricSurface> Surface;
  CurvePointer<2> Curve;
};

/// Immutable. Const methods may be called by several threads.
template <int Dimension>
class GeometricCurve
{
public:
  using Point = std::array<double, Dimension>;
  /// Point and derivatives up to an order.
  using Derivatives = std::array<Point, MaximumOrder + 1>;
  using Variant = std::variant<LineCurve<Dimension>, ConicCurve<Dimension>, SplineCurve<Dimension>,
    OffsetCurve<Dimension>, CompositeCurve<Dimension>, CurveOnSurface>;

  /// Makes a curve; null, with a short reason, if the value is not consistent.
  static CurvePointer<Dimension> Make(Variant value, std::string& problem);

  const Variant& GetValue() const { return this->Value; }
  template <class T>
  const T* GetIf() const
  {
    return std::get_if<T>(&this->Value);
  }

  Point Evaluate(double t) const;
  /// Evaluates the derivatives of order 0 to `order`, at most GetMaxOrder(). They are NaN where an offset
  /// has no direction.
  void Evaluate(double t, int order, Derivatives& result) const;
  /// MaximumOrder; for an offset curve one less than for its basis, for a curve on a surface 1 or 2.
  int GetMaxOrder() const { return this->MaxOrder; }

  /// Returns the natural domain: a whole turn from 0 for an ellipse, infinite for lines, parabolas and
  /// hyperbolas.
  const ParameterRange& GetDomain() const { return this->Domain; }
  /// Returns the period; 0 for a curve that is not periodic.
  double GetPeriod() const { return this->Period; }
  /// Returns the parameters between `first` and `last` at which the curve may not be smooth, and both ends.
  std::vector<double> GetBreaks(double first, double last) const;

private:
  explicit GeometricCurve(Variant value)
    : Value(std::move(value))
  {
  }
  std::string Complete();

  Variant Value;
  ParameterRange Domain;
  double Period = 0.0;
  int MaxOrder = MaximumOrder;
  /// Parameters at which the segments of a composite curve begin, and the end of the last one.
  std::vector<double> Starts;
};

extern template class SMREADERSFACES_EXPORT GeometricCurve<2>;
extern template class SMREADERSFACES_EXPORT GeometricCurve<3>;
}

#endif
