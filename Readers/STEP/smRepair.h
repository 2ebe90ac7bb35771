/**
 * @file smRepair.h
 * @brief Decides which bodies of a STEP file need a repair, and keeps a record
 */
#ifndef smRepair_h
#define smRepair_h

#include "Loops/smShapeInspection.h"
#include "smReadersSTEPModule.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
/// The side that a face of a body took before a repair, and the shell that it was in.
struct FaceSide
{
  ShellPointer Shell;
  bool Reversed = false;
};

/// Record of the repairs of a transfer.
struct RepairLog
{
  /// Faces that were not repaired, with completed loops.
  SoundFaceTable SoundFaces;
  /// Sides of the faces of repaired bodies.
  std::unordered_map<const FaceShape*, FaceSide> Sides;
  int SoundBodies = 0;
  int RepairedBodies = 0;
  /// Bodies of which only some faces were repaired, and these faces.
  int PatchedBodies = 0;
  int RepairedFaces = 0;
  /// Bodies with edges whose direction was reversed (ReverseEdges()), and these uses of edges.
  int BodiesWithReversedEdges = 0;
  int ReversedEdges = 0;
  /// Wall-clock seconds that the inspections took.
  double Seconds = 0.0;
  /// Labels of faces outside their loops (FindOutsideFaces()) that were repaired.
  std::vector<std::string> OutsideFaces;
  /// Labels of faces whose sense contradicts their neighbours' (FindFoldedFaces()).
  std::vector<std::string> FoldedFaces;
  /// Reasons of the first repairs, for example "solid #12: face #34: a loop does not close".
  std::vector<std::string> Reasons;
  /// Sound bodies that were inside out, and were reversed.
  std::vector<ShellPointer> ReversedShells;
};

/// Returns messages with the numbers of repaired and reversed shapes and the reasons.
SMREADERSSTEP_EXPORT std::vector<std::string> Describe(const RepairLog& log);

/**
 * Reverses a solid that is inside out, and repairs its faces if only a few of them do not pass InspectFace()
 * (smFaceInspection.h). Returns true if the solid or shell is sound then: edges of a solid are used once in
 * either direction, each shell is connected, and all faces pass. Adds what was done to the log.
 */
SMREADERSSTEP_EXPORT bool MakeSoundBody(BodyShape& body, RepairLog& log, const FaceRepair& repair);

/// Adds the sides of faces, and faces outside their loops, to the log, before a shape is repaired whatever it
/// is.
SMREADERSSTEP_EXPORT void LogBeforeRepair(const BodyShape& body, RepairLog& log);

/// Adds those faces of a body to the log's sound faces that pass their inspection one by one. `precision` is
/// the file's accuracy in millimetres.
void CompleteFaces(const BodyShape& body, double precision, RepairLog& log);
}

#endif
