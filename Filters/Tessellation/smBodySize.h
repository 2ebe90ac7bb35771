/**
 * @file smBodySize.h
 * @brief Box, volume and area of a body, from a coarse mesh of its own
 */
#ifndef smBodySize_h
#define smBodySize_h

#include "smBodyMesh.h"
#include "smFiltersTessellationModule.h"

#include <array>
#include <functional>
#include <vector>

namespace sm
{
struct BodySize
{
  /// xmin xmax ymin … in the coordinates of the faces; the body lies inside.
  std::array<double, 6> Bounds{};
  /// About the volume and the area, with seven binary digits.
  double Volume = 0.0;
  double Area = 0.0;
  /// False: no face has a triangle.
  bool IsKnown = false;
};

/**
 * Of the triangles within a fixed part of `diagonal`, which is about that of the body's box: the result does not depend on
 * what is shown. `isStopped` as for MeshFaces().
 */
SMFILTERSTESSELLATION_EXPORT BodySize MeasureBody(
  const std::vector<FacePointer>& faces, double diagonal, const std::function<bool()>& isStopped = {});
}

#endif
