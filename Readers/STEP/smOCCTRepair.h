/**
 * @file smOCCTRepair.h
 * @brief Restricts OpenCASCADE's repairs in the transfer of a STEP file to shapes with defects
 */
#ifndef smOCCTRepair_h
#define smOCCTRepair_h

#include "smOCCTCompatibility.h"
#include "smOCCTLoop.h"
#include "smReadersSTEPModule.h"

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

/// Record of the repairs of a transfer.
struct RepairLog
{
  /// Faces that were not repaired, with completed loops.
  SoundFaceTable SoundFaces;
  int SoundBodies = 0;
  int RepairedBodies = 0;
  /// Wall-clock seconds that the inspections took.
  double Seconds = 0.0;
  /// Labels of faces outside their loops (FindOutsideFaces()), whose bodies were repaired.
  std::vector<std::string> OutsideFaces;
  /// Labels of faces whose sense contradicts their neighbours' (FindFoldedFaces()).
  std::vector<std::string> FoldedFaces;
  /// Reasons of the first repairs, for example "solid #12: face #34: a loop does not close".
  std::vector<std::string> Reasons;
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

/// During the lifetime of this object all shapes are repaired, and faces outside their loops are added to the log.
class RepairAlways
{
public:
  RepairAlways(RepairLog& log, ShapeLabel label);

private:
  TransferFilter Filter;
};

/// Returns the reason why a solid or shell needs a repair; empty if it is sound, and then its faces are added to `faces`. A solid that is
/// clearly inside out is reversed.
SMREADERSSTEP_EXPORT std::string FindShapeDamage(
  TopoDS_Shape& shape, const ShapeLabel& label, SoundFaceTable& faces);
}

#endif
