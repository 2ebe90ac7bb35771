#include "smValidation.h"

#include "smFileState.h"
#include "smIntegralNames.h"
#include "smLengthUnits.h"
#include "smProductResults.h"
#include "smProducts.h"
#include "smVector.h"

#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
constexpr const char* MissingProduct = "no product of this name was read";

struct PlacedSolid
{
  const SolidResults* Solid;
  const ProductTreeNode::Body* Body;
};

using SolidsById = std::map<std::string, const SolidResults*>;

bool IsKnown(const Quantities& solid)
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
    if (found == byId.end() || !IsKnown(found->second->Values))
    {
      return false;
    }
    solids.push_back({ found->second, &body });
  }
  return std::all_of(node.Children.begin(), node.Children.end(),
    [&](const ProductTreeNode& child) { return Collect(child, byId, solids); });
}

/// Returns the centre in the coordinates of the part: R^T (c - t) for a rigid placement.
Vector3 PlaceBack(const Vector3& c, const double* placement)
{
  Vector3 result{};
  for (size_t i = 0; i < 3; ++i)
  {
    for (size_t k = 0; k < 3; ++k)
    {
      result[i] += placement[4 * k + i] * (c[k] - placement[4 * k + 3]);
    }
  }
  return result;
}

/// Returns the sums of the solids below a node, in the coordinates of the product if these are known,
/// otherwise in those of the world.
ComputedProduct Compute(const ProductTreeNode& node, bool isRoot, const SolidsById& byId, double millimetres)
{
  ComputedProduct sum;
  std::vector<PlacedSolid> solids;
  if (!Collect(node, byId, solids) || solids.empty())
  {
    sum.Reason = "not all of its solids were computed, or some are left out";
    return sum;
  }
  const double cube = millimetres * millimetres * millimetres;
  const bool isPart = node.Children.empty();
  const bool isPlaced = isPart || node.Placement.has_value();
  std::vector<Vector3> centers;
  Vector3 first{};
  double rounding = 0.0;
  for (const PlacedSolid& solid : solids)
  {
    const Quantities& values = solid.Solid->Values;
    sum.IsSound = sum.IsSound && IsSound(solid.Solid->Status);
    const double volume = cube * values.Volume.Get();
    sum.Volume += volume;
    sum.VolumeBound += cube * values.Volume.Bound;
    sum.Area += millimetres * millimetres * values.Area.Get();
    sum.AreaBound += millimetres * millimetres * values.Area.Bound;
    const Vector3& world = values.Center.Value;
    const double* placement = node.Placement ? node.Placement->data() : solid.Body->Placement;
    centers.push_back(isPlaced ? PlaceBack(world, placement) : world);
    for (size_t i = 0; i < 3; ++i)
    {
      centers.back()[i] *= millimetres;
      first[i] += volume * centers.back()[i];
      rounding += 1e-15 * millimetres * (std::abs(world[i]) + std::abs(centers.back()[i]) / millimetres);
      rounding += isPlaced ? 1e-15 * millimetres * std::abs(placement[4 * i + 3]) : 0.0;
    }
  }
  sum.VolumeBound += 1e-15 * sum.Volume;
  sum.AreaBound += 1e-15 * sum.Area;
  sum.NoCenter = isPlaced || isRoot ? "" : "the place of a sub-assembly is not known";
  // c = sum V_i c_i / sum V_i, with bounds e_i of V_i and d_i of c_i, is off by at most (sum V_i d_i + e_i
  // (|c_i - c| + d_i)) / (sum V_i - e_i).
  double error = 0.0;
  for (size_t i = 0; i < 3; ++i)
  {
    sum.Center[i] = first[i] / sum.Volume;
  }
  for (size_t k = 0; k < solids.size(); ++k)
  {
    const Quantities& values = solids[k].Solid->Values;
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
  sum.Material = solids.front().Solid->Values.Material;
  sum.Density = solids.front().Solid->Values.Density;
  for (const PlacedSolid& solid : solids)
  {
    sum.Material = solid.Solid->Values.Material == sum.Material ? sum.Material : "";
    sum.Density = solid.Solid->Values.Density == sum.Density ? sum.Density : std::nan("");
  }
  return sum;
}

using Nodes = std::map<std::string, std::pair<const ProductTreeNode*, bool>>;

/// Collects the first node of each name, and if it is at the top level; and all nodes of each name.
void ListNodes(const ProductTreeNode& node, bool isTop, Nodes& nodes,
  std::map<std::string, std::vector<const ProductTreeNode*>>& all)
{
  for (const ProductTreeNode& child : node.Children)
  {
    nodes.emplace(child.Name, std::pair(&child, isTop));
    all[child.Name].push_back(&child);
    ListNodes(child, false, nodes, all);
  }
}

/// Adds the materials that the file names for an occurrence, and takes material and density from a sum where
/// its solids have others.
void CompareMaterials(const ProductTreeNode& node, const SolidsById& byId, ComputedProduct& sum)
{
  std::vector<PlacedSolid> solids;
  if (!std::isnan(sum.Density) && Collect(node, byId, solids))
  {
    for (const PlacedSolid& solid : solids)
    {
      sum.Material = solid.Solid->Values.Material == sum.Material ? sum.Material : "";
      sum.Density = solid.Solid->Values.Density == sum.Density ? sum.Density : std::nan("");
      sum.FileMaterials.insert(solid.Body->Model->GetMaterial());
    }
  }
}

/// Adds an entry. Values are in millimetres to a power, those of a centroid in three components; `allowed` is
/// without the bound.
void AddEntry(const StatedProduct& product, const char* quantity, const std::vector<double>& stated,
  const std::vector<double>& computed, double bound, double allowed, const std::string& problem, double unit,
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
  const bool isComparable = problem.empty() && std::isfinite(limit) && std::isfinite(difference);
  ValidationEntry entry;
  entry.Product = product.Name;
  entry.Definition = product.Definition;
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

namespace
{
/// Marks entries as not comparable whose product may have bodies that the reader left out.
void ExcuseLeftOut(const std::string& leftOut, std::vector<ValidationEntry>& list)
{
  for (ValidationEntry& entry : list)
  {
    if (leftOut.empty() || (entry.Result != "fail" && entry.Reason != MissingProduct))
    {
      continue;
    }
    entry.Result = "not-comparable";
    entry.Reason =
      "the file states it with all bodies, and some, perhaps of this product, were left out; compare "
      "with --hidden count. " +
      leftOut;
    entry.Computed.clear();
    entry.Bound = entry.Difference = entry.Limit = Unknown;
  }
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

ProductSums::ProductSums(
  const std::vector<StatedProduct>& products, const ProductTreeNode& tree, const ProductResults& results)
  : Millimetres(GetUnitInMillimetres(results.LengthUnit.value_or("")))
{
  for (const StatedProduct& product : products)
  {
    ++this->Uses[product.Name];
  }
  for (const SolidResults& solid : results.Solids)
  {
    this->ById[solid.Id] = &solid;
  }
  ListNodes(tree, true, this->NodesByName, this->Occurrences);
}

ComputedProduct ProductSums::Find(const std::string& name) const
{
  const auto found = this->NodesByName.find(name);
  ComputedProduct result;
  if (this->Uses.at(name) > 1)
  {
    result.Reason = "several products have this name";
  }
  else if (found == this->NodesByName.end())
  {
    result.Reason = MissingProduct;
  }
  else
  {
    result = Compute(*found->second.first, found->second.second, this->ById, this->Millimetres);
    for (const ProductTreeNode* node : this->Occurrences.at(name))
    {
      CompareMaterials(*node, this->ById, result);
    }
  }
  return result;
}

bool IsFileSound(const ProductResults& results)
{
  return IsSound(results.Status) ||
    std::any_of(results.Solids.begin(), results.Solids.end(),
      [](const SolidResults& solid) { return !IsSound(solid.Status); });
}

std::string FindLeftOutNote(vtkDataObject* readerOutput)
{
  // As LeaveOutHidden() of the reader words it.
  for (const std::string& note : GetFileState(readerOutput).Notes)
  {
    const bool isOfHidden = note.find(" that the file hides (INVISIBILITY) ") != std::string::npos ||
      note.find(" that the file shows ") != std::string::npos;
    if (isOfHidden && note.find(" left out: ") != std::string::npos)
    {
      return note;
    }
  }
  return {};
}

std::vector<ValidationEntry> CompareValidation(const std::vector<StatedProduct>& products,
  const ProductTreeNode& tree, const ProductResults& results, double limit, const std::string& leftOut)
{
  const ProductSums sums(products, tree, results);
  const double unit = sums.GetMillimetres() > 0.0 ? sums.GetMillimetres() : 1.0;
  std::vector<ValidationEntry> list;
  for (const StatedProduct& product : products)
  {
    const Vector3& point = product.Centroid;
    const bool hasVolume = std::isfinite(product.Volume) || !product.VolumeProblem.empty();
    const bool hasArea = std::isfinite(product.Area) || !product.AreaProblem.empty();
    const bool hasPoint = std::isfinite(point[0] + point[1] + point[2]) || !product.CentroidProblem.empty();
    if (!hasPoint && !hasVolume && !hasArea)
    {
      continue;
    }
    const ComputedProduct computed = sums.Find(product.Name);
    const auto getReason = [&computed](const std::string& problem, const std::string& other) {
      return !problem.empty() ? problem : !computed.Reason.empty() ? computed.Reason : other;
    };
    if (hasVolume)
    {
      AddEntry(product, "volume", { product.Volume }, { computed.Volume }, computed.VolumeBound,
        limit * std::abs(product.Volume), getReason(product.VolumeProblem, ""), unit * unit * unit, list);
    }
    if (hasArea)
    {
      AddEntry(product, "area", { product.Area }, { computed.Area }, computed.AreaBound,
        limit * std::abs(product.Area), getReason(product.AreaProblem, ""), unit * unit, list);
    }
    if (hasPoint)
    {
      AddEntry(product, "centroid", { point.begin(), point.end() },
        { computed.Center.begin(), computed.Center.end() }, computed.CenterBound,
        limit * std::cbrt(computed.Volume), getReason(product.CentroidProblem, computed.NoCenter), unit,
        list);
    }
  }
  ExcuseLeftOut(leftOut, list);
  return list;
}
}
