/**
 * @file smDisplayPoints.h
 * @brief Display points of a leaf on an edited model, with or without their faces and parameters
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
 * Gives `leaf`, a shallow copy of a leaf with another model, the model `edited`: by `evaluator`, see there, where the leaf has
 * FaceIndex and Parameters. Where it lacks these arrays, all points are moved by `map`, in the coordinates of the stored
 * faces. A leaf without points gets its scale mesh moved instead, once for all instances of `edited`. False with `error` where the evaluator fails.
 */
bool SetEditedModel(vtkNURBSDataSet* leaf, vtkTrimmedNURBSModel* edited, const PointMap& map,
  vtkNURBSPointEvaluator* evaluator, std::string& error);
}

#endif
