/**
 * @file smMeshLimits.h
 * @brief The deflection and the angle of a display mesh
 */
#ifndef smMeshLimits_h
#define smMeshLimits_h

namespace sm
{
struct MeshLimits
{
  /// Largest distance of a triangle from its surface and of a segment from its edge, in model units.
  double Deflection = 0.0;
  /// Wanted angle between neighbouring triangles and segments, in radians.
  double Angle = 0.35;
};
}

#endif
