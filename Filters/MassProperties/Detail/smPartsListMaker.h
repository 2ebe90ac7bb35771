/**
 * @file smPartsListMaker.h
 * @brief Makes the parts list of an input, and its table
 */
#ifndef smPartsListMaker_h
#define smPartsListMaker_h

#include "smPartsList.h"

#include <string>
#include <vector>

class vtkTable;

namespace sm
{
namespace columns
{
class KeptArrays;
}
struct BodyIntegrals;
struct MassRow;
struct ProductTreeNode;

/// Returns the products below the root of the tree, sorted by name. Rows are those of the bodies; bodies of
/// the tree that are not among `bodies` (not selected) are left out.
std::vector<PartsListEntry> MakePartsList(
  const ProductTreeNode& tree, const std::vector<BodyIntegrals>& bodies, const std::vector<MassRow>& rows);

/// Writes the entries in depth-first order, a row each, with the columns of smMassPropertyNames.h: Name,
/// indented by its level, Kind, Level, Count, CountInAll, Solids, SolidsWithVolume, Status, Layer where there
/// is one, Volume and SurfaceArea of one, and, `withMass`, Material, Density, SolidsWithMass, Mass and
/// KnownMass of one, MassInAll and KnownMassInAll of all, each with its bound, and LengthUnit. If there are
/// several entries at the top level, a row of the kind "total" precedes them. Mass and MassInAll are NaN
/// where a solid with a volume has no density; known masses are those of the solids that have one.
void FillPartsTable(columns::KeptArrays& arrays, const std::vector<PartsListEntry>& entries,
  const std::string& unit, bool withMass, vtkTable* table);
}

#endif
