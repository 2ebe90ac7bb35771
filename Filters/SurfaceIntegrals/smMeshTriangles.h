/**
 * @file smMeshTriangles.h
 * @brief The triangles of a display mesh by face
 */
#ifndef smMeshTriangles_h
#define smMeshTriangles_h

#include "smFiltersSurfaceIntegralsModule.h"

#include <array>
#include <cstddef>
#include <functional>

class vtkPolyData;

namespace sm
{
/// Receives the index of a face, and the corners of a triangle of its mesh with the normals there; zero if
/// the mesh has none.
using TriangleVisitor = std::function<void(std::size_t face,
  const std::array<std::array<double, 3>, 3>& corners, const std::array<std::array<double, 3>, 3>& normals)>;

/// Visits the polygons of a mesh with the cell array FaceIndex, divided into triangles, in the order of the
/// mesh. Cells of no face below `faces` are passed over, and so is a mesh that is null or has no such array.
SMFILTERSSURFACEINTEGRALS_EXPORT void VisitShownTriangles(
  vtkPolyData* mesh, std::size_t faces, const TriangleVisitor& visit);

/// The same for the scale mesh of the instance's model in its place, so that nothing depends on what is
/// shown; without a scale mesh for the triangles that are shown.
SMFILTERSSURFACEINTEGRALS_EXPORT void VisitTriangles(
  vtkPolyData* instance, std::size_t faces, const TriangleVisitor& visit);

/// Returns about how many triangles VisitTriangles() visits.
SMFILTERSSURFACEINTEGRALS_EXPORT std::size_t CountTriangles(vtkPolyData* instance);
}

#endif
