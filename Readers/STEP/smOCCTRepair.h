/**
 * @file smOCCTRepair.h
 * @brief Transfer of a STEP file's shapes without OpenCASCADE's repairs where they are sound as they are
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

/// Which shapes of a transfer were repaired, and why.
struct RepairLog
{
  /// Faces that are as the file has them, with complete loops.
  SoundFaceTable SoundFaces;
  int SoundBodies = 0;
  int RepairedBodies = 0;
  /// Wall-clock seconds that the inspections took.
  double Seconds = 0.0;
  /// "solid #12: face #34: a loop does not close", for the first of them.
  std::vector<std::string> Reasons;
};

/// A sentence that says how many were repaired, and why.
std::string Describe(const RepairLog& log);

/// "face #12", or "a face" when it has no number.
using ShapeLabel = std::function<std::string(const TopoDS_Shape&)>;

/**
 * While this exists, OpenCASCADE's transfer leaves solids and shells alone that are sound: edges of a solid are used once in either
 * direction, each shell is connected, and all faces pass InspectFace (smOCCTFaceInspection.h). A solid that is turned inside out is
 * reversed. Others it repairs as ever. The conditions of TransferFilter hold.
 */
class RepairOnNeed
{
public:
  RepairOnNeed(RepairLog& log, ShapeLabel label);

private:
  TransferFilter Filter;
};

/// Why a solid or shell should be repaired; empty when it is sound, and then `faces` gets its faces. A solid that is turned inside out,
/// clearly, is reversed.
SMREADERSSTEP_EXPORT std::string FindShapeDamage(
  TopoDS_Shape& shape, const ShapeLabel& label, SoundFaceTable& faces);
}

#endif
