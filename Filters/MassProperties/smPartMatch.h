/**
 * @file smPartMatch.h
 * @brief A test if two parts have one shape, and the rotation that carries one to the other
 *
 * Two shapes are equal if there is a rotation that carries the faces of one to those of the other, one to one. Two faces are equal if
 * their area, its moments of order 1 and 2, and their vector area are, within the bounds of both and within a tolerance relative to the
 * face. These do not depend on parametrisation, knots, trim curves or the order of the faces. A change that leaves all thirteen
 * numbers of every face, or that is smaller than the bounds, is not seen: so has a single face with three or more equal lobes (a spline
 * gear, a polygonal bore) in every position about its axis the same numbers. One boundary that is divided into other faces is another shape. A
 * mirrored shape is another one unless it has a plane of symmetry.
 */
#ifndef smPartMatch_h
#define smPartMatch_h

#include "smFiltersMassPropertiesModule.h"
#include "smPartShape.h"

#include <array>

namespace sm
{
/// Returns false if numbers that do not depend on placements tell the shapes apart. `tolerance`: of the area.
SMFILTERSMASSPROPERTIES_EXPORT bool MayBeEqual(const PartShape& a, const PartShape& b, double tolerance);

/// Returns true if a translation alone carries `a` to `b`. Both are centred. `tolerance`: of the radius, and of each face's integrals.
SMFILTERSMASSPROPERTIES_EXPORT bool AreParallel(const PartShape& a, const PartShape& b, double tolerance);

/// The result of FindRotation().
struct Rotation
{
  bool IsFound = false;
  /// Row-major; in radians, 0 to pi; the unit vector of its axis, zeros for the angle 0.
  std::array<double, 9> Matrix{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  double Angle = 0.0;
  std::array<double, 3> Axis{};
};

/**
 * Returns the rotation by the smallest angle that carries `a` to `b`, apart from a translation. Both are centred. Rotations are
 * proposed by two directions that the faces of `a` define (their centres, normals and principal axes) and each pair of directions in `b`
 * that may be theirs, and each is tried on all faces; where all directions are parallel the shape is round about them. At most
 * 2000 rotations are tried.
 */
SMFILTERSMASSPROPERTIES_EXPORT Rotation FindRotation(
  const PartShape& a, const PartShape& b, double tolerance);
}

#endif
