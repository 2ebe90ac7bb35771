/**
 * @file smWholeSphere.h
 * @brief Faces that cover a whole sphere, which need no mesh to be measured or compared; not installed
 */
#ifndef smWholeSphere_h
#define smWholeSphere_h

#include "smFiltersNURBSModule.h"

#include "smFace.h"
#include "smVector.h"

#include <vector>

namespace sm
{
struct SMFILTERSNURBS_EXPORT WholeSphere
{
  /// Relative to the model's origin.
  Vector3 Center{};
  /// 0: the face is not a whole sphere.
  double Radius = 0.0;
  /// Bound of the distance of any point of the surface from the sphere.
  double Error = 0.0;
  /// True if the normals of the face, Reversed included, point to the centre.
  bool Inward = false;
  /// Direction of the surface whose borders are the poles.
  int PoleDirection = 1;

  explicit operator bool() const { return this->Radius > 0.0; }
  double GetArea() const;
  /// Returns the volume that the face encloses, below 0 if its normals point to the centre.
  double GetSignedVolume() const;
};

/**
 * Returns the sphere that a face covers, or one with Radius 0. Proved are:
 * - every point of the surface is within Error of the sphere: |P - c w|^2 - r^2 w^2 is a polynomial on each
 *   Bezier patch, which is bounded by its Bernstein coefficients, and ||x - c| - r| is at most r times its
 *   bound over (r w)^2. Error is at most 1e-10 of the radius;
 * - two opposite borders of the domain are one point each, the poles, and the two others are one curve, so
 *   that the domain is mapped as a sphere is;
 * - the loops run along the borders of the domain, around it once, or there are none.
 *
 * The surface may still run around the sphere several times, or back over itself. As the face has no border,
 * every point of the sphere is then covered equally often, with signs, and the area is that multiple: the
 * exact integrals of the face decide, see Covers().
 */
SMFILTERSNURBS_EXPORT WholeSphere FindWholeSphere(const Face& face);

/// Returns the spheres of all faces, in their order; empty if no face is a whole sphere.
SMFILTERSNURBS_EXPORT std::vector<WholeSphere> FindWholeSpheres(const std::vector<FacePointer>& faces);

/**
 * Returns true if the integrals of area and volume of a face on the sphere prove that it covers the sphere
 * once. The number of sheets with their signs is whole, and is the volume over that of the sphere; it may be
 * 1/4 off, as loose tolerances leave it. The area is that of the sphere to a thousandth and `areaBound`, but
 * at most to 1/4: a part that runs back over itself adds to it.
 */
SMFILTERSNURBS_EXPORT bool Covers(const WholeSphere& sphere, double area, double areaBound, double volume);

/// A grid of triangles on a whole sphere, with normals that leave the body; without triangles at the poles
/// that have no area.
struct SphereGrid
{
  std::vector<Vector3> Points;
  std::vector<Vector3> Normals;
  std::vector<std::array<double, 2>> Parameters;
  /// Counter-clockwise seen from outside of the body.
  std::vector<std::array<int, 3>> Triangles;
  /// Bound of the distance of any point of a triangle from the surface, and of the angle, in radians, by
  /// which the surface's normal turns within a triangle.
  double Deviation = 0.0;
  double NormalTurn = 0.0;
};

/// Returns a grid with at least so many steps around the sphere, and half as many from pole to pole.
SMFILTERSNURBS_EXPORT SphereGrid MakeSphereGrid(const Face& face, const WholeSphere& sphere, int steps);
}

#endif
