/**
 * @file smSTEPGeometryReading.h
 * @brief Points, placements, operators and splines of a STEP file, for the conversion of its curves and
 * surfaces
 */
#ifndef smSTEPGeometryReading_h
#define smSTEPGeometryReading_h

#include "Geometry/smGeometricSurface.h"
#include "Geometry/smGeometryTransform.h"
#include "smSTEPAttributes.h"

#include <array>
#include <string>
#include <vector>

namespace sm
{
/// Failure of a conversion: the reason, for the ledger. It never leaves smSTEPGeometry.
struct STEPGeometryFailure
{
  std::string Reason;
};

/// Throws the reason if it is not empty.
void RequireGeometry(const std::string& problem);

/// The attribute as a number; throws if it is none.
double RequireNumber(const Part21Value& value, const char* name);
bool RequireLogical(const Part21Value& value, const char* name);

/// Reads a CARTESIAN_POINT and multiplies it by the unit of lengths. Throws if it has another number of
/// coordinates.
template <int Dimension>
std::array<double, Dimension> ReadGeometryPoint(
  const STEPAttributes& entities, Part21File::Index point, double unit);

/// Reads the unit vector of a DIRECTION.
template <int Dimension>
std::array<double, Dimension> ReadGeometryDirection(
  const STEPAttributes& entities, Part21File::Index direction);

/// Reads an AXIS2_PLACEMENT_3D.
GeometricFrame ReadGeometryFrame(const STEPAttributes& entities, Part21File::Index placement, double unit);

/// Reads an AXIS2_PLACEMENT_2D, or the first two axes of one in space, as origin and axes.
template <int Dimension>
std::array<std::array<double, Dimension>, 3> ReadGeometryAxes(
  const STEPAttributes& entities, Part21File::Index placement, double unit);

template <>
std::array<std::array<double, 2>, 3> ReadGeometryAxes<2>(
  const STEPAttributes& entities, Part21File::Index placement, double unit);
template <>
std::array<std::array<double, 3>, 3> ReadGeometryAxes<3>(
  const STEPAttributes& entities, Part21File::Index placement, double unit);

/// Reads a CARTESIAN_TRANSFORMATION_OPERATOR (ISO 10303-42, base_axis), with its scale.
template <int Dimension>
AffineTransform<Dimension> ReadGeometryOperator(
  const STEPAttributes& entities, Part21File::Index entity, double unit);

/// Makes the knots of a spline of a subtype without own ones, or reads those of the attributes
/// `multiplicities` and `knots`. `direction` is 0 for a curve.
SplineBasis ReadGeometryBasis(const STEPAttributes& entities, Part21File::Index entity, bool isSurface,
  int direction, int degree, int count);

/// Reads all entities of a list.
std::vector<Part21File::Index> ReadGeometryList(const STEPAttributes& entities, const Part21Value& list);
std::vector<double> ReadGeometryNumbers(const Part21Value& list);
}

#endif
