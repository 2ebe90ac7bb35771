#include "smPartsReport.h"

#include "smReport.h"
#include "smTableText.h"
#include "smText.h"

#include <algorithm>
#include <utility>

namespace sm
{
namespace
{
Json Describe(const PartsSums& sums)
{
  const bool isWhole = sums.HasWholeMass();
  Json entry;
  entry["volume"] = MakeNumber(sums.Volume.GetValue());
  entry["area"] = MakeNumber(sums.Area.GetValue());
  entry["mass"] = isWhole ? MakeNumber(sums.Mass.GetValue()) : Json();
  entry["known_mass"] = MakeNumber(sums.Mass.GetValue());
  entry["solids_with_mass"] = sums.Mass.Terms;
  entry["solids_with_volume"] = sums.Volume.Terms;
  entry["bounds"] = { { "volume", MakeNumber(sums.Volume.GetBound()) },
    { "area", MakeNumber(sums.Area.GetBound()) },
    { "mass", isWhole ? MakeNumber(sums.Mass.GetBound()) : Json() },
    { "known_mass", MakeNumber(sums.Mass.GetBound()) } };
  return entry;
}

Json MakeEntries(const std::vector<PartsListEntry>& parts, int level, int depth)
{
  Json entries = Json::array();
  for (const PartsListEntry& part : parts)
  {
    Json entry;
    entry["name"] = part.Name;
    entry["kind"] = part.IsAssembly ? "assembly" : "part";
    entry["count"] = part.Count;
    entry["count_in_all"] = part.CountInAll;
    entry["solids"] = part.Solids;
    entry["status"] = GetText(part.Status);
    entry["layer"] = part.Layer.empty() ? Json() : Json(part.Layer);
    entry["material"] = part.Material.empty() ? Json() : Json(part.Material);
    entry["density"] = MakeNumber(part.Density);
    entry["each"] = Describe(part.Each);
    entry["in_all"] = Describe(part.InAll);
    entry["children"] =
      depth > 0 && level >= depth ? Json::array() : MakeEntries(part.Children, level + 1, depth);
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

/// Formats a mass with as many digits as its bound leaves; if only some solids have one, in the form "1.5 of 2/3".
std::string FormatMass(const Json& sums)
{
  return sums["mass"].is_number() || sums["known_mass"].is_null()
    ? FormatBrief(sums["mass"], sums["bounds"]["mass"])
    : FormatBrief(sums["known_mass"], sums["bounds"]["known_mass"]) + " (" + Dump(sums["solids_with_mass"]) +
      " of " + Dump(sums["solids_with_volume"]) + ")";
}
}

Json MakePartsJson(const std::vector<PartsListEntry>& entries, int depth)
{
  return MakeEntries(entries, 1, depth);
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
  std::string text =
    "file,level,name,kind,count,count_in_all,solids,status,layer,material,density,length_unit";
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
        for (const char* key :
          { "name", "kind", "count", "count_in_all", "solids", "status", "layer", "material", "density" })
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
