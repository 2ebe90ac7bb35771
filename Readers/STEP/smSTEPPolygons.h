/**
 * @file smSTEPPolygons.h
 * @brief Loops of faceted bodies: polygons whose sides are shared by faces
 */
#ifndef smSTEPPolygons_h
#define smSTEPPolygons_h

#include "Shapes/smShape.h"

#include <map>
#include <utility>
#include <vector>

namespace sm
{
/// Makes the loops of POLY_LOOP (ISO 10303-42). Corners with the same coordinates are one vertex, and sides
/// between the same corners are one edge. One object for the polygons of a body.
class STEPPolygons
{
public:
  /// Adds the polygon with these corners, in millimetres, to a face, in their order or, if not `isForward`,
  /// against it. Returns false for one without sides.
  bool Add(const std::vector<Vector3>& corners, bool isForward, FaceShape& face);

private:
  const EdgePointer& GetSide(const Vector3& from, const Vector3& to);

  std::map<Vector3, VertexPointer> Corners;
  std::map<std::pair<Vector3, Vector3>, EdgePointer> Sides;
};
}

#endif
