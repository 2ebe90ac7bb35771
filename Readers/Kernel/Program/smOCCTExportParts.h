/**
 * @file smOCCTExportParts.h
 * @brief Builds the parts of an export tree as shapes
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
  /// The shape of the body, or a compound of those of several bodies; null if no face is left.
  TopoDS_Shape Shape;
  std::vector<BuiltBody> Bodies;
};

/// Builds all parts, with `unit` kernel lengths per length of the models, and adds warnings with the name of
/// the part. If `progress` returns false, it stops and returns fewer parts than the tree has.
std::vector<BuiltPart> BuildParts(
  const ExportTree& tree, double unit, std::vector<std::string>& warnings, const ProgressCallback& progress);

/// Converts a rigid placement; the translation is multiplied by `unit`.
TopLoc_Location MakeLocation(const MatrixRows& placement, double unit);
}

#endif
