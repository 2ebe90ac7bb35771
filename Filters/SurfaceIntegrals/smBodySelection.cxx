#include "smBodySelection.h"

#include "vtkDataAssembly.h"
#include "vtkDataAssemblyUtilities.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"

namespace sm
{
std::string SelectLeaves(vtkDataObject* input, const std::string& assemblyName,
  const std::vector<std::string>& selectors, std::set<vtkDataObject*>& leaves,
  std::vector<std::string>& unmatched)
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
  for (const std::string& selector : selectors)
  {
    bool found = false;
    for (const unsigned int index : assembly->GetDataSetIndices(assembly->SelectNodes({ selector })))
    {
      vtkPartitionedDataSet* partitions = collection->GetPartitionedDataSet(index);
      for (unsigned int i = 0; partitions && i < partitions->GetNumberOfPartitions(); ++i)
      {
        leaves.insert(partitions->GetPartitionAsDataObject(i));
        found = true;
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
