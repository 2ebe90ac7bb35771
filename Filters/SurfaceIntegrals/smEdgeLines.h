/**
 * @file smEdgeLines.h
 * @brief Edges as polylines to draw
 */
#ifndef smEdgeLines_h
#define smEdgeLines_h

#include "smFace.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smVector.h"

#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
/// Returns points along an edge from vertex to vertex, in the stored coordinates of its model.
SMFILTERSSURFACEINTEGRALS_EXPORT std::vector<Vector3> SampleEdge(const Edge& edge);

/// Returns the world coordinates of a point in stored coordinates; `placement` is a 4x4 matrix by rows.
SMFILTERSSURFACEINTEGRALS_EXPORT Vector3 PlacePoint(
  vtkTrimmedNURBSModel& model, const double* placement, const Vector3& stored);
}

#endif
