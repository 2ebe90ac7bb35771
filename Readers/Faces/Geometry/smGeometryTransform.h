/**
 * @file smGeometryTransform.h
 * @brief Images of curves and surfaces under affine maps, as values with a parameter of their own
 */
#ifndef smGeometryTransform_h
#define smGeometryTransform_h

#include "smGeometricSurface.h"

namespace sm
{
/// p -> Linear p + Translation.
template <int Dimension>
struct AffineTransform
{
  std::array<std::array<double, Dimension>, Dimension> Linear{};
  std::array<double, Dimension> Translation{};

  std::array<double, Dimension> MapVector(const std::array<double, Dimension>& v) const;
  std::array<double, Dimension> MapPoint(const std::array<double, Dimension>& p) const;
  /// Returns the factor of all lengths if it is a similarity, else 0.
  double GetScale() const;
  /// Returns true if it is a reflection.
  bool IsMirrored() const;
};

/**
 * Returns the image of a curve, and in `parameter` its parameter for that of the curve: a line, a parabola
 * and an offset of them have lengths as parameters. Null, with a short reason, for an offset curve or a curve
 * on a surface under a map that is not a similarity, or for the image of a line that has no length.
 */
template <int Dimension>
CurvePointer<Dimension> TransformCurve(const CurvePointer<Dimension>& curve,
  const AffineTransform<Dimension>& transform, ParameterScale& parameter, std::string& problem);

/// The same for a surface under a similarity, with the parameters of both directions.
SMREADERSFACES_EXPORT SurfacePointer TransformSurface(const SurfacePointer& surface,
  const AffineTransform<3>& transform, ParameterScale parameters[2], std::string& problem);

extern template struct SMREADERSFACES_EXPORT AffineTransform<2>;
extern template struct SMREADERSFACES_EXPORT AffineTransform<3>;
extern template SMREADERSFACES_EXPORT CurvePointer<2> TransformCurve<2>(
  const CurvePointer<2>&, const AffineTransform<2>&, ParameterScale&, std::string&);
extern template SMREADERSFACES_EXPORT CurvePointer<3> TransformCurve<3>(
  const CurvePointer<3>&, const AffineTransform<3>&, ParameterScale&, std::string&);
}

#endif
