/**
 * @file smOCCTRepair.h
 * @brief Restricts OpenCASCADE's repairs in the transfer of a STEP file to shapes with defects
 */
#ifndef smOCCTRepair_h
#define smOCCTRepair_h

#include "smOCCTCompatibility.h"
#include "smOCCTLoop.h"
#include "smReadersSTEPModule.h"

#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
using SoundFaceTable = std::unordered_map<const TopoDS_TShape*, std::shared_ptr<const DraftFace>>;

/// A surface that one face of a repaired body has, with the side that the face took before; ambiguous if several faces have it.
struct FaceSide
{
  Handle(Geom_Surface) Surface;
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
  /// Wall-clock seconds that the inspections took.
  double Seconds = 0.0;
  /// Reasons of the first repairs, for example "solid #12: face #34: a loop does not close".
  std::vector<std::string> Reasons;
  /// Sound bodies that were inside out, and were reversed.
  std::vector<TopoDS_Shape> TurnedBodies;
};

/// Returns a sentence with the number of repaired shapes and the reasons.
std::string Describe(const RepairLog& log);

/// Returns "face #12", or "a face" if it has no number.
using ShapeLabel = std::function<std::string(const TopoDS_Shape&)>;

/**
 * During the lifetime of this object OpenCASCADE's transfer does not repair solids and shells that are sound: edges of a solid are used
 * once in either direction, each shell is connected, and all faces pass InspectFace() (smOCCTFaceInspection.h). A solid that is inside out
 * is reversed. All others are repaired as usual. The conditions of TransferFilter apply.
 */
class RepairOnNeed
{
public:
  RepairOnNeed(RepairLog& log, ShapeLabel label);

private:
  TransferFilter Filter;
};

/// Returns the reason why a solid or shell needs a repair; empty if it is sound, and then its faces are added to `faces`. A solid that is
/// clearly inside out is reversed.
SMREADERSSTEP_EXPORT std::string FindShapeDamage(
  TopoDS_Shape& shape, const ShapeLabel& label, SoundFaceTable& faces);
}

#endif
