#include "smProductTree.h"

#include "smInstanceNames.h"
#include "smMaterials.h"
#include "smProducts.h"

#include "vtkCADReader.h"
#include "vtkDataAssembly.h"
#include "vtkNURBSDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <map>

namespace sm
{
namespace
{
vtkPartitionedDataSetCollection* GetParts(vtkCADReader* reader)
{
  return vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
}

/// Calls `use` with the number of the partitioned dataset and the body, for every body. The ids are those of the filter.
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

Json MakeNode(const ProductTreeNode& product, std::map<vtkTrimmedNURBSModel*, size_t>& models)
{
  Json node = { { "name", product.Name }, { "bodies", Json::array() }, { "children", Json::array() } };
  for (const ProductTreeNode::Body& body : product.Bodies)
  {
    const size_t model = models.emplace(body.Model, models.size()).first->second;
    node["bodies"].push_back({ { "id", body.Id }, { "model", model },
      { "placement", std::vector<double>(body.Placement, body.Placement + 12) } });
  }
  for (const ProductTreeNode& child : product.Children)
  {
    node["children"].push_back(MakeNode(child, models));
  }
  return node;
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

Json GetProductTree(vtkCADReader* reader)
{
  std::map<vtkTrimmedNURBSModel*, size_t> models;
  return MakeNode(MakeProductTree(GetParts(reader)), models);
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
