/**
 * @file smOCCTExportParts.h
 * @brief The parts of an export tree as shapes
 */
#ifndef smOCCTExportParts_h
#define smOCCTExportParts_h

#include "smExportTree.h"
#include "smOCCTBuildBody.h"
#include "smProgressCallback.h"

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace sm
{
struct BuiltPart
{
  /// The body's shape, or a compound of those of several; null when nothing is left of it.
  TopoDS_Shape Shape;
  std::vector<BuiltBody> Bodies;
};

/// Builds all parts with `unit` kernel lengths per length of the models, and adds what there is to say, with the part's name.
/// Stops, with fewer parts than the tree has, when `progress` answers false.
std::vector<BuiltPart> BuildParts(
  const ExportTree& tree, double unit, std::vector<std::string>& warnings, const ProgressCallback& progress);

/// A rigid placement, its translation scaled by `unit`.
TopLoc_Location MakeLocation(const Placement& placement, double unit);
}

#endif
