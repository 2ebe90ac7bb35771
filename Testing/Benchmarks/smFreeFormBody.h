/**
 * @file smFreeFormBody.h
 * @brief A closed free-form solid of 42 bicubic B-spline faces, as a model with a display mesh
 *
 * About the size of the paper's "Freeform". A cuboid's surface, 3 x 3 x 2 faces along its axes, is bent to a
 * bumpy bean: control points are a smooth map of points of one lattice, so that faces meet along rows of the
 * same control points, bit for bit, and edges are the rows' own curves. Nothing of it is straight, flat or
 * symmetric.
 */
#ifndef smFreeFormBody_h
#define smFreeFormBody_h

#include <vtkNURBSDataSet.h>
#include <vtkSmartPointer.h>

namespace smtest
{
struct FreeFormBody
{
  /// Faces along x, y and z.
  static constexpr int Faces[3] = { 3, 3, 2 };
  static constexpr int NumberOfFaces = 42;
  /// Control points of a face in each direction, 4 at least; knots are clamped and uniform.
  int Points = 7;
  /// Cells of a face's display mesh in each direction.
  int Cells = 24;

  /// The model is a solid of one shell; the mesh has Normals, FaceIndex and Parameters. Lengths are
  /// millimetres.
  vtkSmartPointer<vtkNURBSDataSet> Make() const;
};
}

#endif
