/**
 * @file smOCCTShapeInspection.h
 * @brief Inspects if a solid or shell can be converted without OpenCASCADE's repair
 */
#ifndef smOCCTShapeInspection_h
#define smOCCTShapeInspection_h

#include "smOCCTFixShape.h"
#include "smOCCTLoop.h"
#include "smReadersSTEPModule.h"

#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>

namespace sm
{
using SoundFaceTable = std::unordered_map<const TopoDS_TShape*, std::shared_ptr<const DraftFace>>;

/// Returns "face #12", or "a face" if it has no number.
using ShapeLabel = std::function<std::string(const TopoDS_Shape&)>;

/// What an inspection of a solid or shell found.
struct ShapeDamage
{
  /// The first reason why the shape, or RepairedFaces of its faces, need a repair; empty if they do not.
  std::string Problem;
  /// Number of faces that were repaired, so that the shape needs no more repair.
  int RepairedFaces = 0;
  /// Number of uses of edges whose direction was reversed.
  int TurnedEdges = 0;
  /// True if the shape was inside out and was reversed.
  bool IsReversed = false;
};

/// Inspects a solid or shell. If it is sound, or `repair` makes it so, its faces that were not repaired are
/// added to `faces`. A solid that is clearly inside out is reversed.
SMREADERSSTEP_EXPORT ShapeDamage FindShapeDamage(
  TopoDS_Shape& shape, const ShapeLabel& label, SoundFaceTable& faces, const FaceRepair& repair = {});
}

#endif
