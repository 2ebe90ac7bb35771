#include "smProductTree.h"

#include "smInstanceNames.h"
#include "smMaterials.h"

#include "vtkCADReader.h"
#include "vtkDataAssembly.h"
#include "vtkNURBSDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>

namespace sm
{
namespace
{
vtkPartitionedDataSetCollection* GetParts(vtkCADReader* reader)
{
  return vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
}

/// Calls `use` with the number of the partitioned dataset and the body, for every body. The ids are those of
/// the filter.
template <typename Use>
void ForEachBody(vtkPartitionedDataSetCollection* parts, const Use& use)
{
  size_t id = 0;
  for (unsigned int i = 0; i < parts->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int j = 0; j < parts->GetNumberOfPartitions(i); ++j)
    {
      auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartitionAsDataObject(i, j));
      if (leaf && leaf->GetModel())
      {
        ProductBody body{ std::to_string(++id), leaf->GetModel(), leaf, {} };
        std::copy_n(leaf->GetPlacementData(), 12, body.Placement.begin());
        use(i, body);
      }
    }
  }
}
}

std::vector<ProductBody> ListBodies(vtkCADReader* reader)
{
  std::vector<ProductBody> bodies;
  if (vtkPartitionedDataSetCollection* parts = GetParts(reader))
  {
    ForEachBody(parts, [&bodies](unsigned int, const ProductBody& body) { bodies.push_back(body); });
  }
  return bodies;
}

ProductTreeNode GetProductTree(vtkCADReader* reader)
{
  return MakeProductTree(GetParts(reader));
}

std::vector<std::string> FindProducts(vtkCADReader* reader, const std::string& pattern)
{
  vtkPartitionedDataSetCollection* parts = GetParts(reader);
  vtkDataAssembly* assembly = parts ? parts->GetDataAssembly() : nullptr;
  std::vector<std::string> selectors;
  if (assembly)
  {
    for (const int node : assembly->GetChildNodes(vtkDataAssembly::GetRootNode(), true))
    {
      if (MatchesPattern(pattern, GetFileName(*assembly, node)) ||
        MatchesPattern(pattern, assembly->GetAttributeOrDefault(node, "label", "")))
      {
        selectors.push_back("//*[@id='" + std::to_string(node) + "']");
      }
    }
  }
  if (selectors.empty())
  {
    const char quote = pattern.find('\'') == std::string::npos ? '\'' : '"';
    selectors.push_back(std::string("//*[@only=") + quote + pattern + quote + "]");
  }
  return selectors;
}
}
