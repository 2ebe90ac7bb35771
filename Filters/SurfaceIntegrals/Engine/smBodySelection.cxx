#include "smBodySelection.h"

#include "smInstanceNames.h"

#include "vtkDataAssembly.h"
#include "vtkDataAssemblyUtilities.h"
#include "vtkNURBSDataSet.h"
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

/// Returns the assembly with the node names and labels that the names in the file make; null where these are
/// its own. Nodes keep their datasets.
vtkSmartPointer<vtkDataAssembly> MakeFileTree(
  vtkDataAssembly& assembly, const std::vector<std::vector<LeafPlace>>& places)
{
  vtkSmartPointer<vtkDataAssembly> tree;
  for (const int node : assembly.GetChildNodes(vtkDataAssembly::GetRootNode(), true))
  {
    std::string name = assembly.GetAttributeOrDefault(node, FileNameAttribute, "");
    const std::vector<unsigned int> own = assembly.GetDataSetIndices(node, false);
    // A node of the hierarchy has no such attribute.
    if (name.empty() && assembly.HasAttribute(node, "number_of_partitions") && own.size() == 1 &&
      own[0] < places.size() && places[own[0]].size() == 1)
    {
      auto* leaf = vtkNURBSDataSet::SafeDownCast(places[own[0]][0].first);
      name = leaf ? leaf->GetPartName() : name;
    }
    const std::string nodeName = MakeNodeName(name);
    if (!nodeName.empty() && nodeName != assembly.GetNodeName(node))
    {
      if (!tree)
      {
        tree = vtkSmartPointer<vtkDataAssembly>::New();
        tree->DeepCopy(&assembly);
      }
      tree->SetNodeName(node, nodeName.c_str());
      tree->SetAttribute(node, "label", name.c_str());
    }
  }
  return tree;
}

/// Returns the numbers of the datasets below the nodes of a selector.
std::set<unsigned int> FindDataSets(vtkDataAssembly* assembly, const std::string& selector)
{
  if (!assembly)
  {
    return {};
  }
  const std::vector<unsigned int> found = assembly->GetDataSetIndices(assembly->SelectNodes({ selector }));
  return { found.begin(), found.end() };
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
  // A name of the file means all instances that have it, a numbered name one of them.
  const vtkSmartPointer<vtkDataAssembly> fileTree = MakeFileTree(*assembly, places);
  for (const std::string& selector : selectors)
  {
    bool found = false;
    std::set<unsigned int> indices = FindDataSets(assembly, selector);
    indices.merge(FindDataSets(fileTree, selector));
    for (const unsigned int index : indices)
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
