#include "smProductBodies.h"

#include "smInstanceNames.h"
#include "smMaterials.h"

#include "vtkDataAssembly.h"
#include "vtkNURBSDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cstddef>

namespace sm
{
std::vector<ProductBody> ListBodies(vtkDataObject* input)
{
  std::vector<ProductBody> bodies;
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(input);
  std::size_t id = 0;
  for (unsigned int i = 0; parts && i < parts->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int j = 0; j < parts->GetNumberOfPartitions(i); ++j)
    {
      auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartitionAsDataObject(i, j));
      if (leaf && leaf->GetModel())
      {
        bodies.push_back({ std::to_string(++id), leaf->GetModel(), leaf, {} });
        std::copy_n(leaf->GetPlacementData(), 12, bodies.back().Placement.begin());
      }
    }
  }
  return bodies;
}

std::vector<std::string> FindProducts(vtkDataObject* input, const std::string& pattern)
{
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(input);
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
