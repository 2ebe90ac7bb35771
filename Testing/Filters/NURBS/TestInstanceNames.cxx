// Names of instances are unique, also as VTK's node names, and none is a name of the file; paths.
#include "smInstanceNames.h"
#include "smTesting.h"

#include "vtkDataAssembly.h"
#include "vtkNew.h"

#include <set>

namespace
{
using Names = std::vector<std::string>;

std::string Join(const Names& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : "|") + name;
  }
  return text;
}

void CheckNumbers(
  const std::string& expected, const Names& names, const std::unordered_set<std::string>& taken = {})
{
  const Names numbered = sm::NumberNames(names, taken);
  smtest::CheckEqual("numbers of " + Join(names), expected, Join(numbered));
  std::set<std::string> nodes;
  for (const std::string& name : numbered)
  {
    if (!name.empty())
    {
      smtest::CheckTrue("a node name of its own: " + name, nodes.insert(sm::MakeNodeName(name)).second);
    }
  }
}

void CheckPaths()
{
  vtkNew<vtkDataAssembly> assembly;
  const int top = assembly->AddNode("top");
  assembly->SetAttribute(top, "label", "top");
  const auto add = [&assembly](
                     const char* node, const char* label, int parent, const Names& own, unsigned int first)
  {
    const int id = assembly->AddNode(node, parent);
    assembly->SetAttribute(id, "label", label);
    for (unsigned int i = 0; i < own.size(); ++i)
    {
      assembly->AddDataSetIndex(id, first + i);
    }
    return id;
  };
  const int arm = add("arm", "arm", top, {}, 0);
  add("nut1", "nut (1)", arm, { "nut" }, 0);
  const int second = add("nut2", "nut (2)", arm, { "nut" }, 1);
  assembly->SetAttribute(second, sm::FileNameAttribute, "nut");
  add("pair", "pair", top, { "pair", "pair (2)" }, 2);
  smtest::CheckEqual("paths", "arm/nut (1)|arm/nut (2)|pair/pair|pair/pair (2)|loose",
    Join(sm::ListPaths(*assembly, { "nut", "nut", "pair", "pair (2)", "loose" })));
  smtest::CheckEqual("the name in the file", "nut", sm::GetFileName(*assembly, second));
  smtest::CheckEqual("which is the label", "arm", sm::GetFileName(*assembly, arm));
}
}

int TestInstanceNames(int, char*[])
{
  CheckNumbers("", {});
  CheckNumbers("nut|rod", { "nut", "rod" });
  CheckNumbers("nut (1)|rod|nut (2)", { "nut", "rod", "nut" });
  // VTK's node names leave out what is not a letter or a digit.
  CheckNumbers("a-b (1)|ab (2)", { "a-b", "ab" });
  CheckNumbers("nut (3)|nut (2)|nut (4)|nut1", { "nut", "nut (2)", "nut", "nut1" });
  CheckNumbers("nut (2)|nut (3)", { "nut", "nut" }, { "nut1" });
  CheckNumbers("x||", { "x", "", "" });
  CheckNumbers("dataset (1)|dataset (2)", { "dataset", "dataset" });
  CheckPaths();
  return smtest::Finish();
}
