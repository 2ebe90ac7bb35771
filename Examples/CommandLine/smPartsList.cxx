#include "smPartsList.h"

#include "smReport.h"
#include "smTableText.h"
#include "smText.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace sm
{
namespace
{
/// 2^-53: one operation, rounded to nearest, errs by at most that times its result.
constexpr double Roundoff = 1.1102230246251565e-16;

/// A sum with its bound. Values without a bound make the sum one without.
struct Sum
{
  double Value = 0.0;
  double Bound = 0.0;
  bool HasBound = true;
  int Terms = 0;

  void Add(const Json& value, const Json& bound)
  {
    if (value.is_number())
    {
      this->Value += value.get<double>();
      this->HasBound = this->HasBound && bound.is_number();
      this->Bound += (bound.is_number() ? bound.get<double>() : 0.0) + 2.0 * Roundoff * std::abs(this->Value);
      ++this->Terms;
    }
  }
  void Add(const Sum& other)
  {
    this->Value += other.Value;
    this->Bound += other.Bound + 2.0 * Roundoff * std::abs(this->Value);
    this->HasBound = this->HasBound && other.HasBound;
    this->Terms += other.Terms;
  }
  Json GetValue() const { return this->Terms > 0 ? Json(this->Value) : Json(); }
  Json GetBound() const { return this->Terms > 0 && this->HasBound ? Json(this->Bound) : Json(); }
};

struct Sums
{
  Sum Volume, Area, Mass;

  void Add(const Sums& other)
  {
    this->Volume.Add(other.Volume);
    this->Area.Add(other.Area);
    this->Mass.Add(other.Mass);
  }
};

Json Describe(const Sums& sums)
{
  const bool isWhole = sums.Mass.Terms == sums.Volume.Terms;
  Json entry;
  entry["volume"] = sums.Volume.GetValue();
  entry["area"] = sums.Area.GetValue();
  entry["mass"] = isWhole ? sums.Mass.GetValue() : Json();
  entry["known_mass"] = sums.Mass.GetValue();
  entry["solids_with_mass"] = sums.Mass.Terms;
  entry["solids_with_volume"] = sums.Volume.Terms;
  entry["bounds"] = { { "volume", sums.Volume.GetBound() }, { "area", sums.Area.GetBound() },
    { "mass", isWhole ? sums.Mass.GetBound() : Json() }, { "known_mass", sums.Mass.GetBound() } };
  return entry;
}

struct Product
{
  std::string Name;
  /// Equal for equal products.
  std::string Signature;
  int Solids = 0;
  int Count = 1;
  bool IsAssembly = false;
  /// Of the first product, and of all.
  Sums Each, InAll;
  /// Null where solids differ, once there is one.
  Json Material, Density;
  bool HasMaterial = false;
  std::vector<Product> Children;

  void TakeMaterial(const Json& material, const Json& density)
  {
    this->Material = !this->HasMaterial || this->Material == material ? material : Json();
    this->Density = !this->HasMaterial || this->Density == density ? density : Json();
    this->HasMaterial = true;
  }
};

using SolidsById = std::map<std::string, const Json*>;

/// Adds the sums of an equal product, whose children are in the same order.
void AddInAll(Product& product, const Product& other)
{
  product.InAll.Add(other.InAll);
  for (size_t i = 0; i < product.Children.size(); ++i)
  {
    AddInAll(product.Children[i], other.Children[i]);
  }
}

Product MakeProduct(const Json& node, const SolidsById& solids)
{
  Product product;
  product.Name = node["name"].get<std::string>();
  product.IsAssembly = !node["children"].empty();
  std::string models;
  for (const Json& body : node["bodies"])
  {
    const auto found = solids.find(body["id"].get<std::string>());
    if (found == solids.end())
    {
      continue;
    }
    const Json& solid = *found->second;
    product.Each.Volume.Add(solid["volume"], solid["bounds"]["volume"]);
    product.Each.Area.Add(solid["area"], solid["bounds"]["area"]);
    product.Each.Mass.Add(solid["mass"], solid["bounds"]["mass"]);
    product.TakeMaterial(solid["material"], solid["density"]);
    ++product.Solids;
    models += Dump(body["model"]) + ",";
  }
  std::map<std::string, size_t> places;
  for (const Json& below : node["children"])
  {
    Product child = MakeProduct(below, solids);
    if (child.Solids == 0)
    {
      continue;
    }
    product.Solids += child.Solids;
    product.Each.Add(child.InAll);
    product.TakeMaterial(child.Material, child.Density);
    const auto [place, isNew] = places.emplace(child.Signature, product.Children.size());
    if (isNew)
    {
      product.Children.push_back(std::move(child));
    }
    else
    {
      ++product.Children[place->second].Count;
      AddInAll(product.Children[place->second], child);
    }
  }
  std::sort(product.Children.begin(), product.Children.end(),
    [](const Product& a, const Product& b)
    {
      const std::string nameA = LowerCase(a.Name);
      const std::string nameB = LowerCase(b.Name);
      return nameA != nameB ? nameA < nameB : a.Signature < b.Signature;
    });
  product.Signature = Dump(Json(product.Name)) + "[" + models + "](";
  for (const Product& child : product.Children)
  {
    product.Signature += std::to_string(child.Count) + child.Signature;
  }
  product.Signature += ")";
  product.InAll = product.Each;
  return product;
}

Json MakeEntries(const std::vector<Product>& products, int above, int level, int depth)
{
  Json entries = Json::array();
  for (const Product& product : products)
  {
    Json entry;
    entry["name"] = product.Name;
    entry["kind"] = product.IsAssembly ? "assembly" : "part";
    entry["count"] = product.Count;
    entry["count_in_all"] = product.Count * above;
    entry["solids"] = product.Solids;
    entry["material"] = product.Material;
    entry["density"] = product.Density;
    entry["each"] = Describe(product.Each);
    entry["in_all"] = Describe(product.InAll);
    entry["children"] = depth > 0 && level >= depth
      ? Json::array()
      : MakeEntries(product.Children, product.Count * above, level + 1, depth);
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// Calls `use` with every entry and its level, 1 for the first, entries before their children.
template <typename Use>
void ForEachEntry(const Json& entries, int level, const Use& use)
{
  for (const Json& entry : entries)
  {
    use(entry, level);
    ForEachEntry(entry["children"], level + 1, use);
  }
}

/// A mass with as many digits as its bound leaves; of some solids only in the form "1.5 of 2/3".
std::string FormatMass(const Json& sums)
{
  return sums["mass"].is_number() || sums["known_mass"].is_null()
    ? FormatBrief(sums["mass"], sums["bounds"]["mass"])
    : FormatBrief(sums["known_mass"], sums["bounds"]["known_mass"]) + " (" + Dump(sums["solids_with_mass"]) +
      " of " + Dump(sums["solids_with_volume"]) + ")";
}
}

Json MakePartsList(const Json& tree, const Json& solids, int depth)
{
  SolidsById byId;
  for (const Json& solid : solids)
  {
    byId[solid["id"].get<std::string>()] = &solid;
  }
  return MakeEntries(MakeProduct(tree, byId).Children, 1, 1, depth);
}

std::string FormatPartsList(const Json& file)
{
  if (!file.contains("parts") || file["parts"].empty())
  {
    return {};
  }
  size_t width = 24;
  ForEachEntry(file["parts"], 1,
    [&width](const Json& entry, int level)
    {
      width =
        std::max(width, 2 * static_cast<size_t>(level - 1) + GetWidth(entry["name"].get<std::string>()) + 1);
    });
  width = std::min<size_t>(width, 48);
  std::string text = "\n  " + Pad("parts list", width) + Pad("count", 7, true) + Pad("in all", 8, true) +
    Pad("volume each " + FormatUnit(file, 3), 22, true) + Pad("mass each kg", 24, true) +
    Pad("mass in all kg", 24, true) + "  material\n";
  ForEachEntry(file["parts"], 1,
    [&](const Json& entry, int level)
    {
      const Json& each = entry["each"];
      const std::string indent(std::min<size_t>(2 * static_cast<size_t>(level - 1), width / 2), ' ');
      const std::string name = entry["name"].get<std::string>();
      const std::string material = entry["material"].is_string() ? entry["material"].get<std::string>() : "-";
      text +=
        TrimEnd("  " + Pad(indent + Shorten(name, width - 1 - indent.size()), width) +
          Pad(Dump(entry["count"]), 7, true) + Pad(Dump(entry["count_in_all"]), 8, true) +
          Pad(FormatBrief(each["volume"], each["bounds"]["volume"]), 22, true) +
          Pad(FormatMass(each), 24, true) + Pad(FormatMass(entry["in_all"]), 24, true) + "  " + material) +
        "\n";
    });
  return text;
}

std::string FormatPartsCsv(const Json& files)
{
  std::string text = "file,level,name,kind,count,count_in_all,solids,material,density,length_unit";
  const char* const quantities[] = { "volume", "area", "mass", "known_mass" };
  for (const char* place : { "each", "in_all" })
  {
    for (const char* quantity : quantities)
    {
      const std::string column = std::string(",") + quantity + "_" + place;
      text += column + column + "_bound";
    }
    text += std::string(",solids_with_mass_") + place;
  }
  text += "\n";
  for (const Json& file : files)
  {
    ForEachEntry(file.contains("parts") ? file["parts"] : Json::array(), 1,
      [&](const Json& entry, int level)
      {
        text += FormatCell(file["file"]) + "," + std::to_string(level);
        for (const char* key : { "name", "kind", "count", "count_in_all", "solids", "material", "density" })
        {
          text += "," + FormatCell(entry[key]);
        }
        text += "," + FormatCell(file["length_unit"]);
        for (const char* place : { "each", "in_all" })
        {
          for (const char* quantity : quantities)
          {
            text +=
              "," + FormatCell(entry[place][quantity]) + "," + FormatCell(entry[place]["bounds"][quantity]);
          }
          text += "," + FormatCell(entry[place]["solids_with_mass"]);
        }
        text += "\n";
      });
  }
  return text;
}
}
