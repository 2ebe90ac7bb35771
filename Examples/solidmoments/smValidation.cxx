#include "smValidation.h"

#include "smIntegralNames.h"
#include "smLengthUnits.h"
#include "smProducts.h"
#include "smResults.h"
#include "smSTEPProducts.h"
#include "smSafeFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace sm
{
namespace
{
using Vector = std::array<double, 3>;

/// The computed values of a product of the tree, in millimetres; NaN if not known.
struct Computed
{
  /// The reason why no value is known.
  std::string Reason;
  double Volume = 0.0, VolumeBound = 0.0;
  double Area = 0.0, AreaBound = 0.0;
  Vector Center{ std::nan(""), std::nan(""), std::nan("") };
  double CenterBound = std::nan("");
  /// The reason why the centre cannot be compared; empty if it can.
  std::string NoCenter;
  /// False if some solid is flagged by more than a bound above the tolerance.
  bool IsSound = true;
  /// Material and density; empty and NaN for an assembly.
  std::string Material;
  double Density = std::nan("");
};

struct PlacedSolid
{
  const SolidResult* Values;
  const double* Placement;
};

using SolidsById = std::map<std::string, const SolidResult*>;

bool IsKnown(const SolidResult& solid)
{
  return solid.Volume.IsKnown() && solid.Area.IsKnown() && solid.Center.IsKnown() &&
    !std::isnan(solid.Volume.Bound) && !std::isnan(solid.Area.Bound) && !std::isnan(solid.Center.Bound);
}

bool IsSound(const std::string& status)
{
  return status == names::StatusOk || status == names::StatusToleranceNotMet;
}

/// Collects the solids below a node; returns false if one of them was not computed.
bool Collect(const ProductTreeNode& node, const SolidsById& byId, std::vector<PlacedSolid>& solids)
{
  for (const ProductTreeNode::Body& body : node.Bodies)
  {
    const auto found = byId.find(body.Id);
    if (found == byId.end() || !IsKnown(*found->second))
    {
      return false;
    }
    solids.push_back({ found->second, body.Placement });
  }
  return std::all_of(node.Children.begin(), node.Children.end(),
    [&](const ProductTreeNode& child) { return Collect(child, byId, solids); });
}

/// Returns the centre in the coordinates of the part: R^T (c - t) for a rigid placement.
Vector PlaceBack(const Vector& c, const double* placement)
{
  Vector result{};
  for (size_t i = 0; i < 3; ++i)
  {
    for (size_t k = 0; k < 3; ++k)
    {
      result[i] += placement[4 * k + i] * (c[k] - placement[4 * k + 3]);
    }
  }
  return result;
}

/// Returns the sums of the solids below a node: in the coordinates of the part if there is a single part,
/// otherwise in world coordinates.
Computed Compute(const ProductTreeNode& node, bool isRoot, const SolidsById& byId, double millimetres)
{
  Computed sum;
  std::vector<PlacedSolid> solids;
  if (!Collect(node, byId, solids) || solids.empty())
  {
    sum.Reason = "not all of its solids were computed";
    return sum;
  }
  const double cube = millimetres * millimetres * millimetres;
  const bool isPart = node.Children.empty();
  std::vector<Vector> centers;
  Vector first{};
  double rounding = 0.0;
  for (const PlacedSolid& solid : solids)
  {
    const SolidResult& values = *solid.Values;
    sum.IsSound = sum.IsSound && IsSound(values.Status);
    const double volume = cube * values.Volume.Get();
    sum.Volume += volume;
    sum.VolumeBound += cube * values.Volume.Bound;
    sum.Area += millimetres * millimetres * values.Area.Get();
    sum.AreaBound += millimetres * millimetres * values.Area.Bound;
    const Vector& world = values.Center.Value;
    centers.push_back(isPart ? PlaceBack(world, solid.Placement) : world);
    for (size_t i = 0; i < 3; ++i)
    {
      centers.back()[i] *= millimetres;
      first[i] += volume * centers.back()[i];
      rounding += 1e-15 * millimetres * (std::abs(world[i]) + std::abs(centers.back()[i]) / millimetres);
      rounding += isPart ? 1e-15 * millimetres * std::abs(solid.Placement[4 * i + 3]) : 0.0;
    }
  }
  sum.VolumeBound += 1e-15 * sum.Volume;
  sum.AreaBound += 1e-15 * sum.Area;
  sum.NoCenter = isPart || isRoot ? "" : "the place of a sub-assembly is not known";
  // c = sum V_i c_i / sum V_i, with bounds e_i of V_i and d_i of c_i, is off by at most (sum V_i d_i + e_i
  // (|c_i - c| + d_i)) / (sum V_i - e_i).
  double error = 0.0;
  for (size_t i = 0; i < 3; ++i)
  {
    sum.Center[i] = first[i] / sum.Volume;
  }
  for (size_t k = 0; k < solids.size(); ++k)
  {
    const SolidResult& values = *solids[k].Values;
    const double e = cube * values.Volume.Bound;
    const double d = millimetres * values.Center.Bound;
    const double away =
      std::hypot(centers[k][0] - sum.Center[0], centers[k][1] - sum.Center[1], centers[k][2] - sum.Center[2]);
    error += cube * values.Volume.Get() * d + e * (away + d);
  }
  sum.CenterBound = error / (sum.Volume - sum.VolumeBound) + rounding;
  if (!isPart)
  {
    return sum;
  }
  // One material for all solids, or none.
  sum.Material = solids.front().Values->Material;
  sum.Density = solids.front().Values->Density;
  for (const PlacedSolid& solid : solids)
  {
    sum.Material = solid.Values->Material == sum.Material ? sum.Material : "";
    sum.Density = solid.Values->Density == sum.Density ? sum.Density : std::nan("");
  }
  return sum;
}

using Nodes = std::map<std::string, std::pair<const ProductTreeNode*, bool>>;

/// Collects the first node of each name, and if it is at the top level.
void ListNodes(const ProductTreeNode& node, bool isTop, Nodes& nodes)
{
  for (const ProductTreeNode& child : node.Children)
  {
    nodes.emplace(child.Name, std::pair(&child, isTop));
    ListNodes(child, false, nodes);
  }
}

class ProductComparison
{
public:
  ProductComparison(const std::string& fileName, const ProductTreeNode& tree, const FileResult& file)
    : Millimetres(GetUnitInMillimetres(file.LengthUnit.value_or("")))
  {
    this->IsRead = this->File.Read(fileName);
    this->Products = this->IsRead ? ReadSTEPProducts(this->File) : std::vector<STEPProduct>();
    for (const STEPProduct& product : this->Products)
    {
      ++this->Uses[product.Name];
    }
    for (const SolidResult& solid : file.Solids)
    {
      this->ById[solid.Id] = &solid;
    }
    ListNodes(tree, true, this->NodesByName);
  }

  Computed Find(const STEPProduct& product) const
  {
    const auto found = this->NodesByName.find(product.Name);
    Computed result;
    if (this->Uses.at(product.Name) > 1)
    {
      result.Reason = "several products have this name";
    }
    else if (found == this->NodesByName.end())
    {
      result.Reason = "no product of this name was read";
    }
    else
    {
      result = Compute(*found->second.first, found->second.second, this->ById, this->Millimetres);
    }
    return result;
  }

  Part21File File;
  bool IsRead = false;
  std::vector<STEPProduct> Products;
  double Millimetres;

private:
  std::map<std::string, int> Uses;
  Nodes NodesByName;
  SolidsById ById;
};

/// Adds an entry. Values are in millimetres to a power, those of a centroid in three components; `allowed` is
/// without the bound.
void AddEntry(const STEPProduct& product, const char* quantity, const std::vector<double>& stated,
  const std::vector<double>& computed, double bound, double allowed, const std::string& reason, double unit,
  std::vector<ValidationEntry>& list)
{
  const auto convert = [unit](const std::vector<double>& values)
  {
    std::vector<double> result;
    for (const double value : values)
    {
      result.push_back(value / unit);
    }
    return result;
  };
  double squared = 0.0;
  for (size_t i = 0; i < stated.size(); ++i)
  {
    squared += (computed[i] - stated[i]) * (computed[i] - stated[i]);
  }
  const double difference = std::sqrt(squared);
  const double limit = allowed + (stated.size() == 1 ? bound : std::sqrt(3.0) * bound);
  const std::string problem = !product.Problem.empty() ? product.Problem : reason;
  const bool isComparable = problem.empty() && std::isfinite(limit) && std::isfinite(difference);
  ValidationEntry entry;
  entry.Product = product.Name;
  entry.Definition = static_cast<long long>(product.Definition);
  entry.Quantity = quantity;
  entry.Stated = convert(stated);
  if (isComparable)
  {
    entry.Computed = convert(computed);
    entry.Bound = bound / unit;
    entry.Difference = difference / unit;
    entry.Limit = limit / unit;
  }
  entry.Result = !isComparable ? "not-comparable" : difference <= limit ? "pass" : "fail";
  entry.Reason = isComparable ? "" : problem.empty() ? "it was not computed" : problem;
  list.push_back(std::move(entry));
}
}

void ValidationEntry::Visit(Fields& fields)
{
  const auto visit = [&](const char* key, std::vector<double>& values)
  {
    std::array<double, 3> numbers{ Unknown, Unknown, Unknown };
    std::copy(values.begin(), values.end(), numbers.begin());
    if (this->Quantity == "centroid")
    {
      fields.Point(key, numbers);
    }
    else
    {
      fields.Number(key, numbers[0]);
    }
    values.assign(numbers.begin(), numbers.begin() + (this->Quantity == "centroid" ? 3 : 1));
    values.resize(std::isnan(values[0]) ? 0 : values.size());
  };
  fields.Note("", "its name").Text("product", this->Product);
  fields.Note("", "entity number").Count("definition", this->Definition);
  fields.Note("", "`volume`, `area` or `centroid`").Text("quantity", this->Quantity);
  visit("stated", this->Stated);
  visit("computed", this->Computed);
  fields.Number("bound", this->Bound);
  fields.Number("difference", this->Difference);
  fields.Note("", "largest difference that passes, with the bound").Number("limit", this->Limit);
  fields.Note("", "`pass`, `fail` or `not-comparable`").Text("result", this->Result);
  fields.Note("", "why it is not comparable").Name("reason", this->Reason);
}

std::vector<ValidationEntry> CompareValidation(
  const std::string& fileName, const ProductTreeNode& tree, const FileResult& file, double limit)
{
  const ProductComparison comparison(fileName, tree, file);
  const double unit = comparison.Millimetres > 0.0 ? comparison.Millimetres : 1.0;
  std::vector<ValidationEntry> list;
  for (const STEPProduct& product : comparison.Products)
  {
    const STEPValidation& stated = product.Stated;
    const Vector& point = stated.Centroid;
    const bool hasPoint = std::isfinite(point[0] + point[1] + point[2]);
    if (!hasPoint && !std::isfinite(stated.Volume) && !std::isfinite(stated.Area))
    {
      continue;
    }
    const Computed computed = comparison.Find(product);
    if (std::isfinite(stated.Volume))
    {
      AddEntry(product, "volume", { stated.Volume }, { computed.Volume }, computed.VolumeBound,
        limit * std::abs(stated.Volume), computed.Reason, unit * unit * unit, list);
    }
    if (std::isfinite(stated.Area))
    {
      AddEntry(product, "area", { stated.Area }, { computed.Area }, computed.AreaBound,
        limit * std::abs(stated.Area), computed.Reason, unit * unit, list);
    }
    if (hasPoint)
    {
      AddEntry(product, "centroid", { point.begin(), point.end() },
        { computed.Center.begin(), computed.Center.end() }, computed.CenterBound,
        limit * std::cbrt(computed.Volume), computed.Reason.empty() ? computed.NoCenter : computed.Reason,
        unit, list);
    }
  }
  return list;
}

std::string WriteValidation(
  const std::string& fileName, const ProductTreeNode& tree, const FileResult& file, const std::string& target)
{
  const ProductComparison comparison(fileName, tree, file);
  if (!comparison.IsRead)
  {
    return fileName + " is not a STEP file that can be written again with validation properties";
  }
  // A flag that no solid has is that of the file: something that it declares is missing or contradictory.
  const bool isFileSound = IsSound(file.Status) ||
    std::any_of(file.Solids.begin(), file.Solids.end(),
      [](const SolidResult& solid) { return !IsSound(solid.Status); });
  std::vector<STEPStatement> statements;
  for (const STEPProduct& product : comparison.Products)
  {
    const Computed computed = comparison.Find(product);
    const STEPValidation& stated = product.Stated;
    if (!computed.Reason.empty() || !product.Problem.empty() || product.Context == 0)
    {
      continue;
    }
    STEPStatement statement;
    statement.Product = product;
    // A property that the file states already is not written a second time, and none of which this program
    // says that it may be wrong.
    const bool isSound = isFileSound && computed.IsSound;
    statement.Values.Volume = std::isfinite(stated.Volume) || !isSound ? std::nan("") : computed.Volume;
    statement.Values.Area = std::isfinite(stated.Area) || !isSound ? std::nan("") : computed.Area;
    if (computed.NoCenter.empty() && isSound && !std::isfinite(stated.Centroid[0]))
    {
      statement.Values.Centroid = computed.Center;
    }
    if (!std::isnan(computed.Density) && !product.HasDensity)
    {
      statement.Density = computed.Density;
      statement.Material = computed.Material;
    }
    statements.push_back(statement);
  }
  const std::string text = AppendSTEPValidation(comparison.File, statements);
  const std::string problem = text.empty() ? "it has no entities" : SaveFile(target, text);
  return problem.empty() ? problem : target + " cannot be written: " + problem;
}

long long CountValidation(const FileResult& file, const std::string& result)
{
  const std::vector<ValidationEntry> list = file.Validation.value_or(std::vector<ValidationEntry>());
  return std::count_if(
    list.begin(), list.end(), [&result](const ValidationEntry& entry) { return entry.Result == result; });
}
}
