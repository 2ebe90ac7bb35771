#include "vtkProducts.h"

#include "smComparison.h"
#include "smFormat.h"
#include "smJsonFields.h"
#include "smMaterials.h"
#include "smPartsFields.h"
#include "smProducts.h"
#include "smRobot.h"
#include "smValidation.h"

#include "vtkDataSetAttributes.h"
#include "vtkMassPropertiesBase.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkProducts);

namespace
{
std::string FormatNumber(double value)
{
  return sm::FormatDigits(value, 17);
}

template <typename Type, typename Use>
std::string WriteList(std::vector<Type> entries, const Use& use)
{
  sm::JsonFields fields;
  fields.List("entries", entries, [&](Type& entry) { use(fields, entry); });
  return sm::Dump(fields.Take()["entries"]);
}
}

std::string vtkProducts::GetMaterials()
{
  return WriteList(sm::GetCommonMaterials(),
    [](sm::Fields& fields, sm::Material& material)
    {
      fields.Text("name", material.Name);
      fields.Number("density", material.Density);
    });
}

std::string vtkProducts::AddMaterial(vtkMassPropertiesBase* filter, const std::string& pattern,
  const std::string& material, const std::string& density, const std::string& tolerance,
  const std::string& mass)
{
  sm::MaterialRule rule;
  std::string problem = sm::MakeRule({ pattern, material, density, tolerance, mass }, rule);
  if (problem.empty() && rule.IsLeftOut)
  {
    filter->AddLeftOut(pattern.c_str());
  }
  else if (problem.empty() && rule.Counting != sm::Counting::Every)
  {
    filter->AddCountedOnce(pattern.c_str(), rule.Counting == sm::Counting::OnceInPlace);
  }
  else if (problem.empty() && rule.IsOfProduct)
  {
    filter->AddProductMass(pattern.c_str(), material.c_str(), rule.Material.Mass, rule.Material.Tolerance);
  }
  else if (problem.empty() && rule.Material.Mass > 0.0)
  {
    filter->AddMass(pattern.c_str(), material.c_str(), rule.Material.Mass, rule.Material.Tolerance);
  }
  else if (problem.empty())
  {
    filter->AddMaterial(pattern.c_str(), material.c_str(), rule.Material.Density, rule.Material.Tolerance);
  }
  return problem;
}

std::string vtkProducts::GetPartsList(vtkMassPropertiesBase* filter)
{
  return WriteList(filter->GetPartsList(), sm::VisitPart);
}

std::string vtkProducts::Compare(vtkMassPropertiesBase* before, vtkMassPropertiesBase* after, double limit)
{
  const sm::ProductResults results[2] = { sm::ReadProductResults(before), sm::ReadProductResults(after) };
  if (results[0].LengthUnit != results[1].LengthUnit)
  {
    return {};
  }
  const auto measure = [](vtkMassPropertiesBase* filter, const sm::ProductResults& product)
  { return sm::MeasureProduct(filter->GetInputDataObject(0, 0), product, filter->GetMaximumSeconds()); };
  auto difference = sm::CompareProducts(results[0], measure(before, results[0]), results[1],
    measure(after, results[1]), limit, FormatNumber, []() { return true; });
  return sm::Dump(sm::WriteJsonFields([&difference](sm::Fields& fields) { difference->Visit(fields); }));
}

std::string vtkProducts::CompareValidation(vtkMassPropertiesBase* filter, vtkTable* stated, double limit)
{
  vtkDataSetAttributes* columns = stated->GetRowData();
  std::vector<sm::StatedProduct> products;
  for (vtkIdType row = 0; row < stated->GetNumberOfRows(); ++row)
  {
    products.push_back({ sm::GetText(columns, row, "Product"), sm::GetCount(columns, row, "Definition"),
      sm::GetText(columns, row, "VolumeProblem"), sm::GetText(columns, row, "AreaProblem"),
      sm::GetText(columns, row, "CentroidProblem"), sm::GetNumber(columns, row, "Volume"),
      sm::GetNumber(columns, row, "Area"), sm::GetPoint(columns, row, "Centroid") });
  }
  const sm::ProductTreeNode tree = sm::MakeProductTree(filter->GetInputDataObject(0, 0));
  return WriteList(sm::CompareValidation(products, tree, sm::ReadProductResults(filter), limit,
                     sm::FindLeftOutNote(filter->GetInputDataObject(0, 0))),
    [](sm::Fields& fields, sm::ValidationEntry& entry) { entry.Visit(fields); });
}

std::string vtkProducts::MakeRobot(vtkMassPropertiesBase* filter, const std::string& name,
  const std::string& format, const std::string& joints, const std::string& fused)
{
  std::vector<std::string> patterns;
  std::istringstream lines(fused);
  for (std::string line; std::getline(lines, line);)
  {
    patterns.push_back(line);
  }
  std::vector<sm::RobotJoint> table;
  sm::Robot robot;
  const std::optional<sm::RobotFormat> known = sm::ParseRobotFormat(format);
  const std::string wrong =
    known ? sm::ParseRobotJoints(joints, table) : "there is no format " + format + "; use urdf, sdf or mjcf";
  std::string text;
  if (wrong.empty())
  {
    robot = sm::MakeRobot(name, sm::MakeProductTree(filter->GetInputDataObject(0, 0)),
      sm::ReadProductResults(filter), patterns, table);
    sm::CheckRobot(robot, *known);
    text = robot.Problem.empty() ? sm::FormatRobot(robot, *known) : "";
  }
  else
  {
    robot.Problem = wrong;
  }
  return sm::Dump(sm::WriteJsonFields(
    [&](sm::Fields& fields)
    {
      fields.Text("text", text);
      fields.Texts("messages", robot.Messages);
      fields.Text("problem", robot.Problem);
    }));
}
