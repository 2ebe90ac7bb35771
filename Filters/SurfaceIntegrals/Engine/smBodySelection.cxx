#include "smBodySelection.h"

#include "vtkDataAssembly.h"
#include "vtkDataAssemblyUtilities.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"

#include <map>

namespace sm
{
namespace
{
/// Returns the leaves of every partitioned dataset of a collection.
std::vector<std::vector<LeafPlace>> ListPlaces(vtkPartitionedDataSetCollection& collection)
{
  std::map<vtkDataObject*, int> occurrences;
  std::vector<std::vector<LeafPlace>> places(collection.GetNumberOfPartitionedDataSets());
  for (unsigned int i = 0; i < collection.GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkPartitionedDataSet* partitions = collection.GetPartitionedDataSet(i);
    for (unsigned int k = 0; partitions && k < partitions->GetNumberOfPartitions(); ++k)
    {
      vtkDataObject* leaf = partitions->GetPartitionAsDataObject(k);
      places[i].emplace_back(leaf, occurrences[leaf]++);
    }
  }
  return places;
}
}

std::string SelectLeaves(vtkDataObject* input, const std::string& assemblyName,
  const std::vector<std::string>& selectors, std::set<LeafPlace>& leaves, std::vector<std::string>& unmatched)
{
  auto* tree = vtkCompositeDataSet::SafeDownCast(input);
  vtkSmartPointer<vtkPartitionedDataSetCollection> collection =
    vtkPartitionedDataSetCollection::SafeDownCast(input);
  vtkSmartPointer<vtkDataAssembly> assembly;
  if (assemblyName == vtkDataAssemblyUtilities::HierarchyName())
  {
    assembly = vtkSmartPointer<vtkDataAssembly>::New();
    vtkNew<vtkPartitionedDataSetCollection> flat;
    if (!tree || !vtkDataAssemblyUtilities::GenerateHierarchy(tree, assembly, flat))
    {
      return "the input has no blocks to choose from";
    }
    // The assembly of `flat` is the hierarchy with indices that are valid in `flat`.
    collection = flat.Get();
    assembly = flat->GetDataAssembly();
  }
  else if (collection && assemblyName == "Assembly")
  {
    assembly = collection->GetDataAssembly();
  }
  if (!assembly)
  {
    return "the input has no assembly \"" + assemblyName + "\" to choose from";
  }
  const std::vector<std::vector<LeafPlace>> places = ListPlaces(*collection);
  for (const std::string& selector : selectors)
  {
    bool found = false;
    for (const unsigned int index : assembly->GetDataSetIndices(assembly->SelectNodes({ selector })))
    {
      if (index < places.size())
      {
        leaves.insert(places[index].begin(), places[index].end());
        found = found || !places[index].empty();
      }
    }
    if (!found)
    {
      unmatched.push_back(selector);
    }
  }
  return {};
}
}
