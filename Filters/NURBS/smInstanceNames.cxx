#include "smInstanceNames.h"

#include "vtkDataAssembly.h"
#include "vtkNURBSDataSet.h"
#include "vtkTrimmedNURBSModel.h"

#include <unordered_map>

namespace sm
{
namespace
{
constexpr const char* LabelAttribute = "label";

void AddPaths(vtkDataAssembly& assembly, int node, const std::string& path,
  const std::vector<std::string>& names, std::vector<std::string>& paths)
{
  const std::vector<unsigned int> own = assembly.GetDataSetIndices(node, false);
  for (const unsigned int index : own)
  {
    if (index < paths.size())
    {
      paths[index] =
        own.size() == 1 && !path.empty() ? path : path + (path.empty() ? "" : "/") + names[index];
    }
  }
  for (const int child : assembly.GetChildNodes(node, false))
  {
    AddPaths(assembly, child,
      path + (path.empty() ? "" : "/") +
        assembly.GetAttributeOrDefault(child, LabelAttribute, assembly.GetNodeName(child)),
      names, paths);
  }
}
}

std::string MakeNodeName(const std::string& name)
{
  if (name.empty())
  {
    return name;
  }
  // VTK reports an error for a reserved name.
  return vtkDataAssembly::IsNodeNameReserved(name.c_str()) ? name + "_"
                                                           : vtkDataAssembly::MakeValidNodeName(name.c_str());
}

std::vector<std::string> NumberNames(
  const std::vector<std::string>& names, const std::unordered_set<std::string>& taken)
{
  std::unordered_map<std::string, int> counts;
  for (const std::string& name : names)
  {
    ++counts[MakeNodeName(name)];
  }
  std::unordered_set<std::string> used;
  std::unordered_map<std::string, int> numbers;
  std::vector<std::string> numbered;
  numbered.reserve(names.size());
  for (const std::string& name : names)
  {
    const std::string node = MakeNodeName(name);
    std::string unique = name;
    for (int& number = numbers[node]; !name.empty() && counts[node] > 1;)
    {
      unique = name + " (" + std::to_string(++number) + ")";
      const std::string candidate = MakeNodeName(unique);
      if (counts.count(candidate) == 0 && taken.count(candidate) == 0 && used.insert(candidate).second)
      {
        break;
      }
    }
    numbered.push_back(unique);
  }
  return numbered;
}

std::string GetFileName(vtkDataAssembly& assembly, int node)
{
  return assembly.GetAttributeOrDefault(
    node, FileNameAttribute, assembly.GetAttributeOrDefault(node, LabelAttribute, ""));
}

std::string GetPartName(vtkNURBSDataSet& leaf, const std::string& block)
{
  vtkTrimmedNURBSModel* model = leaf.GetModel();
  return !leaf.GetPartName().empty() ? leaf.GetPartName() : block.empty() && model ? model->GetName() : block;
}

std::vector<std::string> ListPaths(vtkDataAssembly& assembly, const std::vector<std::string>& names)
{
  std::vector<std::string> paths = names;
  int top = vtkDataAssembly::GetRootNode();
  const std::vector<int> products = assembly.GetChildNodes(top, false);
  const bool hasOneProduct = products.size() == 1 && assembly.GetDataSetIndices(top, false).empty() &&
    !assembly.GetChildNodes(products[0], false).empty();
  AddPaths(assembly, hasOneProduct ? products[0] : top, "", names, paths);
  return paths;
}
}
