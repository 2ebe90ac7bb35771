/**
 * @file smBodySize.h
 * @brief Box, volume and area of a body, from its mesh
 */
#ifndef smBodySize_h
#define smBodySize_h

#include "smBodyMesh.h"
#include "smFiltersTessellationModule.h"

#include <array>
#include <vector>

namespace sm
{
struct BodySize
{
  /// xmin xmax ymin … in the coordinates of the faces: the box of the meshes, wider by their deviations. A
  /// scale, no bound: deviations are measured across the surface, and an edge may bulge sideways over its
  /// chords.
  std::array<double, 6> Bounds{};
  /// About the volume and the area, with seven binary digits.
  double Volume = 0.0;
  double Area = 0.0;
  /// The volume with its sign and all digits: below 0 for a body whose normals point inwards.
  double SignedVolume = 0.0;
  /// What the deviations of the triangles may change in it, about.
  double VolumeError = 0.0;
  /// Area of the triangles of each face, with all digits.
  std::vector<double> FaceAreas;
  /// False: no face has a triangle.
  bool IsKnown = false;
};

/// Measures whole spheres (FaceMesh::Sphere) by formulas and other faces by their meshes. These should not
/// depend on what is shown: scales fix the accuracy that is asked of each face.
SMFILTERSTESSELLATION_EXPORT BodySize MeasureBody(const std::vector<FaceMesh>& meshes);
}

#endif
