#include "smProductTree.h"

#include "smMaterials.h"

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
constexpr int MaximumLevel = 100;

vtkPartitionedDataSetCollection* GetParts(vtkCADReader* reader)
{
  return vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
}

/// Calls `use` with the number of the partitioned dataset and the body, for every body. The ids count the bodies as the filter does.
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

/// Bodies by the number of their partitioned dataset.
std::vector<Json> GroupBodies(vtkPartitionedDataSetCollection* parts)
{
  std::vector<Json> bodies(parts->GetNumberOfPartitionedDataSets(), Json::array());
  std::map<vtkTrimmedNURBSModel*, size_t> models;
  ForEachBody(parts,
    [&](unsigned int i, const ProductBody& body)
    {
      const size_t model = models.emplace(body.Model, models.size()).first->second;
      bodies[i].push_back({ { "id", body.Id }, { "model", model }, { "placement", body.Placement } });
    });
  return bodies;
}

void AddNode(vtkDataAssembly* assembly, int node, int level, const std::vector<Json>& bodies, Json& entry)
{
  for (const unsigned int index : assembly->GetDataSetIndices(node, false))
  {
    for (const Json& body : index < bodies.size() ? bodies[index] : Json::array())
    {
      entry["bodies"].push_back(body);
    }
  }
  bool isUnnamed = false; ///< the last child
  for (const int child : assembly->GetChildNodes(node, false))
  {
    if (level == MaximumLevel)
    {
      AddNode(assembly, child, level, bodies, entry);
      continue;
    }
    Json below = { { "name", assembly->GetAttributeOrDefault(child, "label", "") },
      { "bodies", Json::array() }, { "children", Json::array() } };
    AddNode(assembly, child, level + 1, bodies, below);
    if (!below["bodies"].empty() || !below["children"].empty())
    {
      isUnnamed = assembly->GetAttributeOrDefault(child, "unnamed", 0) == 1;
      entry["children"].push_back(std::move(below));
    }
  }
  // Some systems relate the shape of a product to another one, which has the bodies and no name: it is the same product.
  Json& children = entry["children"];
  if (level > 0 && isUnnamed && entry["bodies"].empty() && children.size() == 1 &&
    children[0]["children"].empty())
  {
    const Json bodiesBelow = children[0]["bodies"];
    entry["bodies"] = bodiesBelow;
    children = Json::array();
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

Json GetProductTree(vtkCADReader* reader)
{
  vtkPartitionedDataSetCollection* parts = GetParts(reader);
  vtkDataAssembly* assembly = parts ? parts->GetDataAssembly() : nullptr;
  Json root = { { "name", "" }, { "bodies", Json::array() }, { "children", Json::array() } };
  if (assembly)
  {
    AddNode(assembly, vtkDataAssembly::GetRootNode(), 0, GroupBodies(parts), root);
  }
  return root;
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
      if (MatchesPattern(pattern, assembly->GetAttributeOrDefault(node, "label", "")))
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
