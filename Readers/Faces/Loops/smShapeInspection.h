/**
 * @file smShapeInspection.h
 * @brief Inspects if a solid or shell can be converted without a repair
 */
#ifndef smShapeInspection_h
#define smShapeInspection_h

#include "smDraftFace.h"

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
/// Completed loops of faces that were not repaired.
using SoundFaceTable = std::unordered_map<const FaceShape*, std::shared_ptr<const DraftFace>>;

/// Repairs some faces of a body, and returns the body with them; `repaired` gets what became of these faces.
/// All other faces are the same objects. The body may be returned as it is, if there is no repair.
using FaceRepair = std::function<BodyShape(const BodyShape& body, const std::vector<const FaceShape*>& faces,
  std::vector<const FaceShape*>& repaired)>;

/// Returns "face #12", or "a face" if it has no number.
SMREADERSFACES_EXPORT std::string GetLabel(const FaceShape& face);

/// What an inspection of a solid or shell found.
struct ShapeDamage
{
  /// The first reason why the shape, or RepairedFaces of its faces, need a repair; empty if they do not.
  std::string Problem;
  /// Number of faces that were repaired, so that the shape needs no more repair.
  int RepairedFaces = 0;
  /// Number of uses of edges whose direction was reversed.
  int ReversedEdges = 0;
  /// True if the shape was inside out and was reversed.
  bool IsReversed = false;
};

/// Inspects a solid or shell. If it is sound, or `repair` makes it so, its faces that were not repaired are
/// added to `faces`. A solid that is clearly inside out is reversed.
SMREADERSFACES_EXPORT ShapeDamage FindShapeDamage(
  BodyShape& body, SoundFaceTable& faces, const FaceRepair& repair = {});
}

#endif
