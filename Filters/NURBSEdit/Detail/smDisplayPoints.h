/**
 * @file smDisplayPoints.h
 * @brief Moves the display points of a leaf to its edited model
 */
#ifndef smDisplayPoints_h
#define smDisplayPoints_h

#include "smModelEdit.h"

#include <string>

class vtkNURBSDataSet;
class vtkNURBSPointEvaluator;
class vtkTrimmedNURBSModel;

namespace sm
{
/**
 * Gives `leaf`, a shallow copy of a leaf with another model, the model `edited`: by `evaluator`, see there,
 * where the leaf has FaceIndex and Parameters. Where it lacks these arrays, all points are moved by `map`, in
 * the coordinates of the stored faces. A leaf without points gets its scale mesh moved instead, once for all
 * instances of `edited`. Returns false, with `error`, if the evaluator fails.
 */
bool SetEditedModel(vtkNURBSDataSet* leaf, vtkTrimmedNURBSModel* edited, const PointMap& map,
  vtkNURBSPointEvaluator* evaluator, std::string& error);
}

#endif
