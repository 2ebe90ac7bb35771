/**
 * @file smPartMatch.h
 * @brief Tests if two parts have the same shape, and finds the rotation that maps one to the other
 *
 * Two shapes are equal if there is a rotation that maps the faces of one to those of the other, one to one.
 * Two faces are equal if their area, its moments of order 1 and 2, and their vector area are, within the
 * bounds of both and within a tolerance relative to the face. These do not depend on parametrisation, knots,
 * trim curves or the order of the faces. A change that leaves all thirteen numbers of every face, or that is
 * smaller than the bounds, is not detected. For example, a single face with three or more equal lobes (a
 * spline gear, a polygonal bore) has the same numbers in every position about its axis. The same boundary
 * divided into other faces is a different shape. A mirrored shape is different, too, unless it has a plane of
 * symmetry; AreMirrored() finds it.
 */
#ifndef smPartMatch_h
#define smPartMatch_h

#include "smFiltersMassPropertiesModule.h"
#include "smPartShape.h"

#include <array>

namespace sm
{
/// Returns false if numbers that do not depend on placements distinguish the shapes. `tolerance`: of the
/// area.
SMFILTERSMASSPROPERTIES_EXPORT bool MayBeEqual(const PartShape& a, const PartShape& b, double tolerance);

/// Returns true if a translation alone maps `a` to `b`. Both are centred. `tolerance`: of the radius, and of
/// each face's integrals.
SMFILTERSMASSPROPERTIES_EXPORT bool AreParallel(const PartShape& a, const PartShape& b, double tolerance);

/// The result of FindRotation().
struct Rotation
{
  bool IsFound = false;
  /// The matrix, row-major; its angle in radians, 0 to pi; the unit vector of its axis, zeros for the angle
  /// 0.
  std::array<double, 9> Matrix{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  double Angle = 0.0;
  std::array<double, 3> Axis{};
  /// False if there were more candidates than are tried: then another rotation may exist.
  bool IsComplete = true;
};

/**
 * Returns the rotation by the smallest angle that maps `a` to `b`, apart from a translation. Both are
 * centred. Candidates follow from two directions that the faces of `a` define (their centres, normals and
 * principal axes) and each pair of directions of `b` that may correspond to them; each candidate is tested on
 * all faces. Where all directions are parallel, the shape is rotationally symmetric about them. At most 2000
 * rotations are tried.
 */
SMFILTERSMASSPROPERTIES_EXPORT Rotation FindRotation(
  const PartShape& a, const PartShape& b, double tolerance);

/// Returns true if a reflection and a rotation map the faces of `a` to those of `b`, and no rotation alone
/// does: one is the mirror image of the other, and they are of different hands. Both are centred. False where
/// not all rotations can be tried.
SMFILTERSMASSPROPERTIES_EXPORT bool AreMirrored(const PartShape& a, const PartShape& b, double tolerance);
}

#endif
