/**
 * @file smDisplayPoints.h
 * @brief Display points of a leaf evaluated again on faces that changed
 */
#ifndef smDisplayPoints_h
#define smDisplayPoints_h

#include "smModelEdit.h"

class vtkNURBSDataSet;
class vtkTrimmedNURBSModel;

namespace sm
{
/**
 * Gives `leaf`, a shallow copy of a leaf with the model `before`, the model `after`: points and normals of faces that are new are
 * evaluated at (FaceIndex, Parameters) by the placement of the leaf, the others keep their bits. Where the leaf lacks these
 * arrays, all points are moved by `map`, in the coordinates of the stored faces.
 */
void SetEditedModel(
  vtkNURBSDataSet* leaf, vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* after, const PointMap& map);
}

#endif
