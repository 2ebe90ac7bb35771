/**
 * @file smBodySelection.h
 * @brief Selection of bodies by the nodes of an assembly
 */
#ifndef smBodySelection_h
#define smBodySelection_h

#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkDataObject;

namespace sm
{
/// A leaf of a composite dataset, and how many times the same object occurs before it: a leaf may be in
/// several places.
using LeafPlace = std::pair<vtkDataObject*, int>;

/**
 * Finds the leaves of a composite dataset below the nodes that `selectors` (see vtkDataAssembly::SelectNodes)
 * name in an assembly. The assembly is "Assembly", that of a vtkPartitionedDataSetCollection itself, or
 * "Hierarchy", its structure of blocks, which a vtkMultiBlockDataSet has too. Returns an empty string, or a
 * sentence with the reason why nothing can be chosen. `unmatched` receives the selectors that name no leaf.
 */
std::string SelectLeaves(vtkDataObject* input, const std::string& assemblyName,
  const std::vector<std::string>& selectors, std::set<LeafPlace>& leaves,
  std::vector<std::string>& unmatched);
}

#endif
