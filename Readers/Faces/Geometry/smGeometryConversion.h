/**
 * @file smGeometryConversion.h
 * @brief Native surfaces and curves in the forms of the dataset: rational B-splines and polynomial pieces
 */
#ifndef smGeometryConversion_h
#define smGeometryConversion_h

#include "smConvertedSurface.h"
#include "smGeometricSurface.h"

namespace sm
{
/// A curve as a rational B-spline in native coordinates: homogeneous (w x, w y, w z, w).
struct RationalProfile
{
  int Degree = 1;
  std::vector<double> Knots;
  std::vector<std::array<double, 4>> Poles;
  ParameterMap Map;
  /// Largest distance from the curve; 0: exact.
  double Residual = 0.0;
};

/**
 * Converts a curve over [low, high]. Lines, conics and splines are exact; a conic has its map, the others
 * keep their parameter. Other curves are fitted to rounding level. Throws std::runtime_error with a short
 * reason if that fails.
 */
SMREADERSFACES_EXPORT RationalProfile ConvertProfile(const GeometricCurve<3>& curve, double low, double high);

/**
 * Converts a surface over a box of its natural parameters, where that is exact; the profile of a swept
 * surface may have a residual. Returns false for an offset surface. Throws std::runtime_error with a short
 * reason for a box that no face has.
 */
SMREADERSFACES_EXPORT bool ConvertExactly(
  const GeometricSurface& surface, const NativeBox& box, const AffineMap& map, ConvertedSurface& result);

/// Converts any surface; an offset surface is fitted. Throws std::runtime_error with a short reason.
SMREADERSFACES_EXPORT ConvertedSurface ConvertGeometry(
  const GeometricSurface& surface, const NativeBox& box, const AffineMap& map);

/// Converts a curve to polynomial pieces with the same parameter: lines and polynomial splines exactly,
/// others by FitEdge(). Throws std::runtime_error with a short reason.
SMREADERSFACES_EXPORT EdgeCurve ConvertCurve(
  const GeometricCurve<3>& curve, double first, double last, const AffineMap& map);
}

#endif
