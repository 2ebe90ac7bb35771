#include "smProducts.h"

#include "smInstanceNames.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataAssembly.h"
#include "vtkNURBSDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>
#include <utility>

namespace sm
{
namespace
{
constexpr int MaximumLevel = 100;

using Bodies = std::vector<ProductTreeNode::Body>;

ProductTreeNode::Body MakeBody(std::size_t number, vtkNURBSDataSet* leaf)
{
  return { std::to_string(number), leaf->GetModel(), leaf->GetPlacementData() };
}

/// Bodies by the number of their partitioned dataset.
std::vector<Bodies> GroupBodies(vtkPartitionedDataSetCollection* collection)
{
  std::vector<Bodies> groups(collection->GetNumberOfPartitionedDataSets());
  std::size_t number = 0;
  for (unsigned int i = 0; i < groups.size(); ++i)
  {
    for (unsigned int j = 0; j < collection->GetNumberOfPartitions(i); ++j)
    {
      auto* leaf = vtkNURBSDataSet::SafeDownCast(collection->GetPartitionAsDataObject(i, j));
      if (leaf && leaf->GetModel())
      {
        groups[i].push_back(MakeBody(++number, leaf));
      }
    }
  }
  return groups;
}

/// Reads the numbers of PlacementAttribute; none if the node has no such attribute.
std::optional<std::array<double, 12>> ReadPlacement(vtkDataAssembly* assembly, int node)
{
  const std::string text = assembly->GetAttributeOrDefault(node, PlacementAttribute, "");
  std::array<double, 12> numbers{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (double& number : numbers)
  {
    while (at != end && *at == ' ')
    {
      ++at;
    }
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number))
    {
      return std::nullopt;
    }
    at = next;
  }
  return numbers;
}

/// Moves bodies from `groups` into a product and those below it: a body that several nodes have counts in the
/// first.
void AddNode(
  vtkDataAssembly* assembly, int node, int level, std::vector<Bodies>& groups, ProductTreeNode& product)
{
  for (const unsigned int index : assembly->GetDataSetIndices(node, false))
  {
    if (index < groups.size())
    {
      product.Bodies.insert(product.Bodies.end(), groups[index].begin(), groups[index].end());
      groups[index].clear();
    }
  }
  bool isUnnamed = false; // the last child
  for (const int child : assembly->GetChildNodes(node, false))
  {
    if (level == MaximumLevel)
    {
      AddNode(assembly, child, level, groups, product);
      continue;
    }
    ProductTreeNode below;
    below.Name = GetFileName(*assembly, child);
    below.Layer = assembly->GetAttributeOrDefault(child, "layer", "");
    below.Placement = ReadPlacement(assembly, child);
    AddNode(assembly, child, level + 1, groups, below);
    if (!below.Bodies.empty() || !below.Children.empty())
    {
      isUnnamed = assembly->GetAttributeOrDefault(child, "unnamed", 0) == 1;
      product.Children.push_back(std::move(below));
    }
  }
  // Some CAD systems relate the shape of a product to an unnamed one, which has the bodies. Both are taken
  // for one product.
  if (level > 0 && isUnnamed && product.Bodies.empty() && product.Children.size() == 1 &&
    product.Children[0].Children.empty())
  {
    product.Bodies = Bodies(product.Children[0].Bodies);
    product.Children.clear();
  }
}

/// Adds a product of one body, with the name of its model.
void AddBody(const ProductTreeNode::Body& body, ProductTreeNode& root)
{
  ProductTreeNode product;
  product.Name = body.Model->GetName();
  product.Bodies.push_back(body);
  root.Children.push_back(std::move(product));
}

/// Adds a product for each body.
void AddBodies(vtkDataObject* input, ProductTreeNode& root)
{
  const auto add = [&root](vtkDataObject* object, std::size_t number)
  {
    auto* leaf = vtkNURBSDataSet::SafeDownCast(object);
    if (!leaf || !leaf->GetModel())
    {
      return number;
    }
    AddBody(MakeBody(++number, leaf), root);
    return number;
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    add(input, 0);
    return;
  }
  std::size_t number = 0;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    number = add(iterator->GetCurrentDataObject(), number);
  }
}
}

ProductTreeNode MakeProductTree(vtkDataObject* input)
{
  ProductTreeNode root;
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(input);
  vtkDataAssembly* assembly = collection ? collection->GetDataAssembly() : nullptr;
  if (assembly)
  {
    std::vector<Bodies> groups = GroupBodies(collection);
    AddNode(assembly, vtkDataAssembly::GetRootNode(), 0, groups, root);
    // Nobody has to put every body into the assembly.
    for (const Bodies& left : groups)
    {
      for (const ProductTreeNode::Body& body : left)
      {
        AddBody(body, root);
      }
    }
  }
  else
  {
    AddBodies(input, root);
  }
  return root;
}
}
