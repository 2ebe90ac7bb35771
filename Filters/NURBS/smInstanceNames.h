/**
 * @file smInstanceNames.h
 * @brief Names by which single instances are selected, and the names that the file gives them
 *
 * ParaView selects by names: a node of an assembly by its path of node names, a block of the hierarchy by the
 * node name that VTK makes of the block's name. Where names repeat, one selector means several instances.
 * Repeated names therefore get a number: `nut (1)`, `nut (2)`. All of them do, so that no new name is a name
 * of the file, and selectors of the file's names keep their meaning.
 */
#ifndef smInstanceNames_h
#define smInstanceNames_h

#include "smFiltersNURBSModule.h"

#include <string>
#include <unordered_set>
#include <vector>

class vtkDataAssembly;
class vtkNURBSDataSet;

namespace sm
{
/// Attribute of an assembly's node with the name in the file, where its attribute "label" has a number or a
/// replacement.
constexpr const char* FileNameAttribute = "name";

/// Attribute of an assembly's node with the placement of its product: twelve numbers, the rows of the matrix
/// from the product to the world, in the unit of the output; it is rigid. Missing where it is not known.
constexpr const char* PlacementAttribute = "placement";

/// Returns the node name that VTK makes of a name, also of one that is empty or reserved.
SMFILTERSNURBS_EXPORT std::string MakeNodeName(const std::string& name);

/// Returns the names with numbers where several have one node name, so that no two have, and none of a new
/// name is in `taken`, a list of node names. Empty names remain empty.
SMFILTERSNURBS_EXPORT std::vector<std::string> NumberNames(
  const std::vector<std::string>& names, const std::unordered_set<std::string>& taken);

/// Returns the name in the file of an assembly's node.
SMFILTERSNURBS_EXPORT std::string GetFileName(vtkDataAssembly& assembly, int node);

/// Returns the name in the file of a solid. `block` is the name of its block, which counts where the dataset
/// has none; then that of the model.
SMFILTERSNURBS_EXPORT std::string GetPartName(vtkNURBSDataSet& leaf, const std::string& block);

/// Returns for each partitioned dataset of an assembly the labels from the top of the tree to its node, with
/// a slash between; and the dataset's name, where its node has several. A product that has all others is left
/// out. Datasets in no node have their name.
SMFILTERSNURBS_EXPORT std::vector<std::string> ListPaths(
  vtkDataAssembly& assembly, const std::vector<std::string>& names);
}

#endif
