#include "smMaterialTable.h"

#include "smFormat.h"
#include "smMaterials.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <map>

namespace sm
{
namespace
{
using Cells = std::array<std::string, MaterialTableColumns>;

constexpr const char* TotalName = "Total";
constexpr const char* TickedTotalName = "Total of ticked solids";
constexpr const char* FromFile = " (file)";
constexpr const char* FromDensity = " (Density)";
constexpr const char* FromRowBelow = " (below)";
/// Text that replaces a material or density if the solids of a name differ.
constexpr const char* Several = "several";
/// Text that replaces a mass if the filter refuses the rule and has computed the solids without it.
constexpr const char* NoDensity = "no density";
/// Text that replaces a mass if the rule's pattern matches no part of the input.
constexpr const char* NoPart = "fits no part";
constexpr int MassDigits = 6;

/// Returns the shortest text that reads back as the same double.
std::string FormatDensity(double density)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof(text), density).ptr);
}

std::string GetCommonDensity(const std::string& material)
{
  const Material* common = FindCommonMaterial(material);
  return common ? FormatDensity(common->Density) : std::string();
}

/// Returns the text without the ending that states its origin, such as "(file)".
std::string RemoveOrigin(const std::string& cell)
{
  for (const std::string origin : { FromFile, FromDensity, FromRowBelow })
  {
    if (cell.size() >= origin.size() && cell.compare(cell.size() - origin.size(), origin.size(), origin) == 0)
    {
      return cell.substr(0, cell.size() - origin.size());
    }
  }
  return cell;
}

bool IsTyped(const std::string& cell)
{
  return !cell.empty() && RemoveOrigin(cell) == cell;
}

std::string AddOrigin(const std::string& text, const char* origin)
{
  return text.empty() ? text : text + origin;
}

/// Returns the mass, with "(6 of 7 solids)" if only some have one.
std::string FormatMass(const PartMaterial& part)
{
  if (part.Weighed == 0)
  {
    return {};
  }
  const std::string mass = FormatDigits(part.Mass, MassDigits);
  return part.Weighed == part.Solids
    ? mass
    : mass + " (" + std::to_string(part.Weighed) + " of " + std::to_string(part.Solids) + " solids)";
}

std::string GetDensity(const MaterialRow& rule)
{
  return rule[2].empty() ? GetCommonDensity(rule[1]) : rule[2];
}

/// Returns true for a rule that vtkMassPropertiesBase::AddMaterial() accepts: with a density, a mass with a
/// unit, or of solids that are left out.
bool IsAccepted(const MaterialRow& rule)
{
  MaterialRule made;
  return MakeRule({ rule[0], rule[1], GetDensity(rule), "", "" }, made).empty();
}

/// Returns the text that a rule takes from a cell; empty for a cell that states that the solids differ.
std::string TakeCell(const std::string& cell)
{
  const std::string text = RemoveOrigin(cell);
  return IsTyped(cell) || text != Several ? text : std::string();
}

Cells MakePartRow(const PartMaterial& part, const MaterialRow* rule, double density, const PartMaterial* mass)
{
  Cells row = { part.Name, "", "", "" };
  if (mass)
  {
    row[3] = FormatMass(*mass);
  }
  if (rule && !IsAccepted(*rule))
  {
    row[3] = NoDensity;
  }
  if (rule && (*rule)[0] == part.Name)
  {
    row[1] = (*rule)[1];
    row[2] = GetDensity(*rule);
  }
  else if (rule)
  {
    row[1] = AddOrigin((*rule)[1], FromRowBelow);
    row[2] = AddOrigin(GetDensity(*rule), FromRowBelow);
  }
  else if (density > 0.0)
  {
    row[2] = FormatDensity(density) + FromDensity;
  }
  else
  {
    row[1] = AddOrigin(part.HasSeveral ? Several : part.Material, FromFile);
    row[2] = part.HasSeveral ? std::string(Several) + FromFile
      : part.Density > 0.0   ? FormatDensity(part.Density) + FromFile
                             : std::string();
  }
  return row;
}

Cells GetRow(const std::vector<std::string>& cells, std::size_t row)
{
  Cells result;
  for (std::size_t k = 0; k < result.size() && row * result.size() + k < cells.size(); ++k)
  {
    result[k] = cells[row * result.size() + k];
  }
  return result;
}
}

std::vector<std::string> MakeMaterialTable(const std::vector<PartMaterial>& parts,
  const std::vector<PartMaterial>& masses, const std::vector<MaterialRow>& rules, double density,
  bool isSomeSolids, bool hasTitles)
{
  if (parts.empty() && rules.empty())
  {
    return {};
  }
  std::map<std::string, const PartMaterial*> massOfPart;
  PartMaterial total;
  total.Solids = 0;
  for (const PartMaterial& part : masses)
  {
    massOfPart[part.Name] = &part;
    total.Solids += part.Solids;
    total.Weighed += part.Weighed;
    total.Mass += part.Mass;
  }
  std::vector<std::string> cells;
  if (hasTitles)
  {
    cells.assign(MaterialTableTitles.begin(), MaterialTableTitles.end());
  }
  std::vector<bool> isShown(rules.size(), false);
  for (const PartMaterial& part : parts)
  {
    const std::size_t found = FindPattern(
      rules.size(), [&rules](std::size_t i) -> const std::string& { return rules[i][0]; }, part.Name);
    const MaterialRow* const rule = found == rules.size() ? nullptr : &rules[found];
    const auto mass = massOfPart.find(part.Name);
    const Cells row = MakePartRow(part, rule, density, mass == massOfPart.end() ? nullptr : mass->second);
    cells.insert(cells.end(), row.begin(), row.end());
    if (rule && (*rule)[0] == part.Name)
    {
      isShown[found] = true;
    }
  }
  for (std::size_t i = 0; i < rules.size(); ++i)
  {
    if (!isShown[i])
    {
      const bool fits = parts.empty() ||
        std::any_of(parts.begin(), parts.end(),
          [&pattern = rules[i][0]](const PartMaterial& part) { return MatchesPattern(pattern, part.Name); });
      cells.insert(cells.end(), { rules[i][0], rules[i][1], GetDensity(rules[i]), fits ? "" : NoPart });
    }
  }
  cells.insert(cells.end(), { isSomeSolids ? TickedTotalName : TotalName, "", "", FormatMass(total) });
  return cells;
}

void TakeEditedCell(const std::vector<std::string>& before, std::vector<std::string>& cells)
{
  if (before.size() != cells.size())
  {
    return;
  }
  const auto [edited, from] = std::mismatch(cells.begin(), cells.end(), before.begin());
  if (edited != cells.end() && std::equal(edited + 1, cells.end(), from + 1))
  {
    *edited = RemoveOrigin(*edited);
  }
}

std::vector<MaterialRow> ReadMaterialTable(
  const std::vector<std::string>& cells, const std::vector<MaterialRow>& rules)
{
  std::vector<MaterialRow> result;
  const std::size_t rows = (cells.size() + MaterialTableColumns - 1) / MaterialTableColumns;
  for (std::size_t i = 0; i < rows; ++i)
  {
    const Cells row = GetRow(cells, i);
    const bool isTitle = row[1] == MaterialTableTitles[1] && row[2] == MaterialTableTitles[2];
    const bool isTotal = i + 1 == rows && (row[0] == TotalName || row[0] == TickedTotalName);
    const bool isKnown = std::any_of(
      result.begin(), result.end(), [&row](const MaterialRow& other) { return other[0] == row[0]; });
    if (isTitle || isTotal || isKnown || row[0].empty() || !(IsTyped(row[1]) || IsTyped(row[2])))
    {
      continue;
    }
    const auto before =
      std::find_if(rules.begin(), rules.end(), [&row](const MaterialRow& rule) { return rule[0] == row[0]; });
    MaterialRow rule = { row[0], TakeCell(row[1]), TakeCell(row[2]) };
    const std::string common = GetCommonDensity(rule[1]);
    const bool isLeft = before != rules.end() && (*before)[1] != rule[1] && GetDensity(*before) == rule[2];
    if (!common.empty() && (!IsTyped(row[2]) || isLeft))
    {
      rule[2] = common;
    }
    result.push_back(rule);
  }
  return result;
}
}
