/**
 * @file smOCCTRepair.h
 * @brief Restricts OpenCASCADE's repairs of a STEP file's shapes to those with defects
 */
#ifndef smOCCTRepair_h
#define smOCCTRepair_h

#include "smOCCTFixShape.h"
#include "smOCCTShapeInspection.h"

#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>

#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
/// A surface that one face of a repaired body has, with the side that the face took before, and the shell
/// that it was in; ambiguous if several faces have it.
struct FaceSide
{
  Handle(Geom_Surface) Surface;
  TopoDS_Shape Shell;
  bool Reversed = false;
  bool Ambiguous = false;
};

/// Record of the repairs of a transfer.
struct RepairLog
{
  /// Faces that were not repaired, with completed loops.
  SoundFaceTable SoundFaces;
  /// Sides of the faces of repaired bodies.
  std::unordered_map<const Geom_Surface*, FaceSide> Sides;
  int SoundBodies = 0;
  int RepairedBodies = 0;
  /// Bodies of which only some faces were repaired, and these faces.
  int PatchedBodies = 0;
  int RepairedFaces = 0;
  /// Bodies with edges whose direction was reversed (TurnEdges()), and these uses of edges.
  int TurnedBodies = 0;
  int TurnedEdges = 0;
  /// Wall-clock seconds that the inspections took.
  double Seconds = 0.0;
  /// Labels of faces outside their loops (FindOutsideFaces()) that were repaired.
  std::vector<std::string> OutsideFaces;
  /// Labels of faces whose sense contradicts their neighbours' (FindFoldedFaces()).
  std::vector<std::string> FoldedFaces;
  /// Reasons of the first repairs, for example "solid #12: face #34: a loop does not close".
  std::vector<std::string> Reasons;
  /// Sound bodies that were inside out, and were reversed.
  std::vector<TopoDS_Shape> ReversedBodies;
};

/// Returns messages with the numbers of repaired and reversed shapes and the reasons.
std::vector<std::string> Describe(const RepairLog& log);

/**
 * Returns true if a solid or shell needs no repair, or no more after some of its faces were repaired: edges
 * of a solid are used once in either direction, each shell is connected, and all faces pass InspectFace()
 * (smOCCTFaceInspection.h). A solid that is inside out is reversed. If only a few faces do not pass, these
 * alone are repaired. The result is added to the log.
 */
bool IsSoundBody(TopoDS_Shape& shape, RepairLog& log, const ShapeLabel& label, const FaceRepair& repair);

/// Adds the sides of faces, and faces outside their loops, to the log, before a shape is repaired whatever it
/// is.
void LogBeforeRepair(const TopoDS_Shape& shape, RepairLog& log, const ShapeLabel& label);
}

#endif
