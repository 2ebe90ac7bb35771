// The parts list of a file as table and CSV.
#include "smReport.h"
#include "smText.h"

#include <algorithm>

namespace sm
{
namespace
{
/// Calls `use` with every entry and its level, 1 for the first, entries before their children.
template <typename Use>
void ForEachEntry(const std::vector<PartsListEntry>& entries, int level, const Use& use)
{
  for (const PartsListEntry& entry : entries)
  {
    use(entry, level);
    ForEachEntry(entry.Children, level + 1, use);
  }
}

/// Formats a mass with as many digits as its bound leaves; if only some solids have one, in the form "1.5 of
/// 2/3".
std::string FormatMass(const PartsSums& sums)
{
  const std::string mass = FormatBrief(sums.Mass.GetValue(), sums.Mass.GetBound());
  return sums.HasWholeMass() || mass == "-"
    ? mass
    : mass + " (" + std::to_string(sums.Mass.Terms) + " of " + std::to_string(sums.Volume.Terms) + ")";
}

std::string FormatNumberCell(double value)
{
  return "," + (std::isfinite(value) ? FormatExact(value) : std::string());
}

std::string FormatSums(const PartsSums& sums)
{
  const auto format = [](const PartsSum& sum, bool isKnown)
  {
    return FormatNumberCell(isKnown ? sum.GetValue() : Unknown) +
      FormatNumberCell(isKnown ? sum.GetBound() : Unknown);
  };
  return format(sums.Volume, true) + format(sums.Area, true) + format(sums.Mass, sums.HasWholeMass()) +
    format(sums.Mass, true) + "," + std::to_string(sums.Mass.Terms);
}

std::string FormatEntry(const FileResult& file, const PartsListEntry& entry, int level)
{
  std::string text = FormatCell(file.File) + "," + std::to_string(level) + "," + FormatCell(entry.Name) +
    "," + (entry.IsAssembly ? "assembly" : "part");
  for (const int number : { entry.Count, entry.CountInAll, entry.Solids })
  {
    text += "," + std::to_string(number);
  }
  return text + "," + GetText(entry.Status) + "," + FormatCell(entry.Layer) + "," +
    FormatCell(entry.Material) + FormatNumberCell(entry.Density) + "," + FormatCell(file.LengthUnit) +
    FormatSums(entry.Each) + FormatSums(entry.InAll) + "\n";
}
}

std::string FormatPartsList(const FileResult& file)
{
  if (!file.Parts || file.Parts->empty())
  {
    return {};
  }
  size_t width = 24;
  ForEachEntry(*file.Parts, 1,
    [&width](const PartsListEntry& entry, int level)
    { width = std::max(width, 2 * static_cast<size_t>(level - 1) + GetWidth(entry.Name) + 1); });
  width = std::min<size_t>(width, 48);
  std::string text = "\n  " + Pad("parts list", width) + Pad("count", 7, true) + Pad("in all", 8, true) +
    Pad("volume each " + file.FormatUnit(3), 22, true) + Pad("mass each kg", 24, true) +
    Pad("mass in all kg", 24, true) + "  material\n";
  ForEachEntry(*file.Parts, 1,
    [&](const PartsListEntry& entry, int level)
    {
      const std::string indent(std::min<size_t>(2 * static_cast<size_t>(level - 1), width / 2), ' ');
      text += TrimEnd("  " + Pad(indent + Shorten(entry.Name, width - 1 - indent.size()), width) +
                Pad(std::to_string(entry.Count), 7, true) + Pad(std::to_string(entry.CountInAll), 8, true) +
                Pad(FormatBrief(entry.Each.Volume.GetValue(), entry.Each.Volume.GetBound()), 22, true) +
                Pad(FormatMass(entry.Each), 24, true) + Pad(FormatMass(entry.InAll), 24, true) + "  " +
                (entry.Material.empty() ? "-" : entry.Material)) +
        "\n";
    });
  return text;
}

std::string FormatPartsCsv(const std::vector<FileResult>& files)
{
  std::string text =
    "file,level,name,kind,count,count_in_all,solids,status,layer,material,density,length_unit";
  for (const char* place : { "each", "in_all" })
  {
    for (const char* quantity : { "volume", "area", "mass", "known_mass" })
    {
      const std::string column = std::string(",") + quantity + "_" + place;
      text += column + column + "_bound";
    }
    text += std::string(",solids_with_mass_") + place;
  }
  text += "\n";
  for (const FileResult& file : files)
  {
    ForEachEntry(file.Parts.value_or(std::vector<PartsListEntry>()), 1,
      [&](const PartsListEntry& entry, int level) { text += FormatEntry(file, entry, level); });
  }
  return text;
}
}
