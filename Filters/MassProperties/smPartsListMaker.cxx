#include "Detail/smPartsListMaker.h"

#include "smBodyIntegrals.h"
#include "smColumns.h"
#include "smMassPropertyNames.h"
#include "smMassTable.h"
#include "smProducts.h"
#include "smUnitRoundoff.h"

#include "vtkDataSetAttributes.h"
#include "vtkTable.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace sm
{
namespace
{
/// A product with its signature.
struct Product
{
  PartsListEntry Entry;
  /// A text that is the same for equal products, and for no others.
  std::string Signature;
  bool HasMaterial = false;
  std::vector<Product> Children;

  void TakeMaterial(const std::string& material, double density)
  {
    PartsListEntry& entry = this->Entry;
    entry.Material = !this->HasMaterial || entry.Material == material ? material : std::string();
    entry.Density = !this->HasMaterial || entry.Density == density ? density : std::nan("");
    this->HasMaterial = true;
  }
};

/// Adds the sums of an equal product, whose children are in the same order.
void AddInAll(Product& product, const Product& other)
{
  product.Entry.InAll.Add(other.Entry.InAll);
  product.Entry.Status = std::max(product.Entry.Status, other.Entry.Status);
  for (std::size_t i = 0; i < product.Children.size(); ++i)
  {
    AddInAll(product.Children[i], other.Children[i]);
  }
}

std::string GetLowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void SortByName(std::vector<Product>& products)
{
  std::sort(products.begin(), products.end(),
    [](const Product& a, const Product& b)
    {
      const std::string nameA = GetLowerCase(a.Entry.Name);
      const std::string nameB = GetLowerCase(b.Entry.Name);
      return nameA != nameB ? nameA < nameB : a.Signature < b.Signature;
    });
}

class ListMaker
{
public:
  ListMaker(const std::vector<BodyIntegrals>& bodies, const std::vector<MassRow>& rows)
  {
    for (std::size_t i = 0; i < bodies.size() && i < rows.size(); ++i)
    {
      this->Rows.emplace(bodies[i].Id, std::make_pair(&rows[i], bodies[i].Status));
    }
  }

  Product MakeProduct(const ProductTreeNode& node)
  {
    Product product;
    PartsListEntry& entry = product.Entry;
    entry.Name = node.Name;
    entry.Layer = node.Layer;
    entry.IsAssembly = !node.Children.empty();
    std::string models;
    for (const ProductTreeNode::Body& body : node.Bodies)
    {
      const auto found = this->Rows.find(body.Id);
      if (found == this->Rows.end())
      {
        continue;
      }
      const MassRow& row = *found->second.first;
      entry.Status = std::max(entry.Status, found->second.second);
      entry.Each.Volume.Add(row.Properties.Volume, row.Properties.VolumeBound);
      entry.Each.Area.Add(row.Area, row.AreaBound);
      entry.Each.Mass.Add(row.Mass, row.MassBound);
      product.TakeMaterial(row.Material, row.Density);
      ++entry.Solids;
      models += std::to_string(this->Models.emplace(body.Model, this->Models.size()).first->second) + ",";
    }
    this->AddChildren(node, product);
    product.Signature = std::to_string(node.Name.size()) + ":" + node.Name + "[" + models + "](";
    for (const Product& child : product.Children)
    {
      product.Signature += std::to_string(child.Entry.Count) + child.Signature;
    }
    product.Signature += ")";
    entry.InAll = entry.Each;
    return product;
  }

private:
  void AddChildren(const ProductTreeNode& node, Product& product)
  {
    std::map<std::string, std::size_t> places;
    for (const ProductTreeNode& below : node.Children)
    {
      Product child = this->MakeProduct(below);
      if (child.Entry.Solids == 0)
      {
        continue;
      }
      product.Entry.Solids += child.Entry.Solids;
      product.Entry.Status = std::max(product.Entry.Status, child.Entry.Status);
      product.Entry.Each.Add(child.Entry.InAll);
      product.TakeMaterial(child.Entry.Material, child.Entry.Density);
      const auto [place, isNew] = places.emplace(child.Signature, product.Children.size());
      if (isNew)
      {
        product.Children.push_back(std::move(child));
      }
      else
      {
        ++product.Children[place->second].Entry.Count;
        AddInAll(product.Children[place->second], child);
      }
    }
    SortByName(product.Children);
  }

  std::map<std::string, std::pair<const MassRow*, Status>> Rows;
  std::map<const void*, std::size_t> Models;
};

std::vector<PartsListEntry> TakeEntries(std::vector<Product>& products, int above)
{
  std::vector<PartsListEntry> entries;
  for (Product& product : products)
  {
    PartsListEntry& entry = product.Entry;
    entry.CountInAll = entry.Count * above;
    entry.Children = TakeEntries(product.Children, entry.CountInAll);
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// The entries in depth-first order, with their levels.
using Lines = std::vector<std::pair<const PartsListEntry*, int>>;

void ListLines(const std::vector<PartsListEntry>& entries, int level, Lines& lines)
{
  for (const PartsListEntry& entry : entries)
  {
    lines.emplace_back(&entry, level);
    ListLines(entry.Children, level + 1, lines);
  }
}

/// The sums of several products.
PartsListEntry MakeTotal(const std::vector<PartsListEntry>& entries)
{
  PartsListEntry total;
  total.Name = "Total";
  for (const PartsListEntry& entry : entries)
  {
    total.Solids += entry.Count * entry.Solids;
    total.Status = std::max(total.Status, entry.Status);
    total.Each.Add(entry.InAll);
  }
  total.InAll = total.Each;
  return total;
}

/// Returns the mass of all solids; a sum without terms if some solids have no mass.
PartsSum GetWholeMass(const PartsSums& sums)
{
  return sums.HasWholeMass() ? sums.Mass : PartsSum();
}

}

void PartsSum::Add(double value, double bound)
{
  if (!std::isnan(value))
  {
    this->Value += value;
    this->Bound += bound + 2.0 * UnitRoundoff * std::abs(this->Value);
    ++this->Terms;
  }
}

void PartsSum::Add(const PartsSum& other)
{
  this->Value += other.Value;
  this->Bound += other.Bound + 2.0 * UnitRoundoff * std::abs(this->Value);
  this->Terms += other.Terms;
}

void PartsSums::Add(const PartsSums& other)
{
  this->Volume.Add(other.Volume);
  this->Area.Add(other.Area);
  this->Mass.Add(other.Mass);
}

std::vector<PartsListEntry> MakePartsList(
  const ProductTreeNode& tree, const std::vector<BodyIntegrals>& bodies, const std::vector<MassRow>& rows)
{
  Product root = ListMaker(bodies, rows).MakeProduct(tree);
  return TakeEntries(root.Children, 1);
}

void FillPartsTable(columns::KeptArrays& arrays, const std::vector<PartsListEntry>& entries,
  const std::string& unit, bool withMass, vtkTable* table)
{
  using Entry = const PartsListEntry&;
  Lines lines;
  const PartsListEntry total = MakeTotal(entries);
  if (entries.size() > 1)
  {
    lines.emplace_back(&total, 1);
  }
  ListLines(entries, 1, lines);
  columns::Writer writer(arrays, table->GetRowData(), lines.size(), 32);
  const auto fill = [&lines](auto* values, const auto& get)
  { std::transform(lines.begin(), lines.end(), values, [&get](const auto& l) { return get(*l.first); }); };
  const auto addCount = [&](const char* name, const auto& get) { fill(writer.AddIntegers(name), get); };
  const auto addText = [&](const char* name, const auto& get) { fill(writer.AddStrings(name), get); };
  const auto addSum = [&](const std::string& name, const auto& get)
  {
    fill(writer.AddDoubles(name), [&get](Entry e) { return get(e).GetValue(); });
    fill(writer.AddDoubles(name + names::BoundSuffix), [&get](Entry e) { return get(e).GetBound(); });
  };
  std::transform(lines.begin(), lines.end(), writer.AddStrings(names::Name),
    [](const auto& line)
    { return std::string(4 * static_cast<std::size_t>(line.second - 1), ' ') + line.first->Name; });
  addText(
    names::Kind, [&total](Entry e) { return &e == &total ? "total"
                                       : e.IsAssembly    ? "assembly"
                                                         : "part"; });
  std::transform(lines.begin(), lines.end(), writer.AddIntegers(names::Level),
    [](const auto& line) { return line.second; });
  addCount(names::Count, [](Entry e) { return e.Count; });
  addCount(names::CountInAll, [](Entry e) { return e.CountInAll; });
  addCount(names::Solids, [](Entry e) { return e.Solids; });
  addCount(names::SolidsWithVolume, [](Entry e) { return e.Each.Volume.Terms; });
  addText(names::Status, [](Entry e) { return GetText(e.Status); });
  if (std::any_of(lines.begin(), lines.end(), [](const auto& line) { return !line.first->Layer.empty(); }))
  {
    addText(names::Layer, [](Entry e) { return e.Layer; });
  }
  if (withMass)
  {
    addText(names::Material, [](Entry e) { return e.Material; });
    fill(writer.AddDoubles(names::Density), [](Entry e) { return e.Density; });
    addSum(names::Mass, [](Entry e) { return GetWholeMass(e.Each); });
    addSum(names::KnownMass, [](Entry e) { return e.Each.Mass; });
    addSum(names::MassInAll, [](Entry e) { return GetWholeMass(e.InAll); });
    addSum(names::KnownMassInAll, [](Entry e) { return e.InAll.Mass; });
    addCount(names::SolidsWithMass, [](Entry e) { return e.Each.Mass.Terms; });
  }
  addSum(names::Volume, [](Entry e) { return e.Each.Volume; });
  addSum(names::SurfaceArea, [](Entry e) { return e.Each.Area; });
  addText(names::LengthUnit, [&unit](Entry) { return unit; });
}
}
