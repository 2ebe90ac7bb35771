#include "smMaterialFile.h"

#include "smInputFile.h"
#include "smJson.h"
#include "smText.h"
#include "smWeights.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace sm
{
namespace
{
std::string Trim(const std::string& text)
{
  const size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? std::string() : TrimEnd(text.substr(first));
}

/// Returns the values of a line of CSV; a quote inside quotes is doubled.
std::vector<std::string> SplitLine(const std::string& line)
{
  std::vector<std::string> values(1);
  bool isQuoted = false;
  for (size_t i = 0; i < line.size(); ++i)
  {
    if (line[i] == '"' && isQuoted && i + 1 < line.size() && line[i + 1] == '"')
    {
      values.back() += line[++i];
    }
    else if (line[i] == '"')
    {
      isQuoted = !isQuoted;
    }
    else if (line[i] == ',' && !isQuoted)
    {
      values.emplace_back();
    }
    else
    {
      values.back() += line[i];
    }
  }
  for (std::string& value : values)
  {
    value = Trim(value);
  }
  return values;
}

/// The columns of a table, in the order of a table without a header.
constexpr std::string MaterialTexts::*MaterialColumns[] = { &MaterialTexts::Pattern, &MaterialTexts::Material,
  &MaterialTexts::Density, &MaterialTexts::Tolerance, &MaterialTexts::Mass };
constexpr const char* MaterialColumnNames[] = { "name", "material", "density", "tolerance", "mass" };

/// The members of a row that the values of a line belong to.
using MaterialHeader = std::vector<std::string MaterialTexts::*>;

/// Returns true for a line that has the words density or mass after its first value.
bool NamesColumns(const std::vector<std::string>& values)
{
  return std::any_of(values.begin() + 1, values.end(),
    [](const std::string& value) { return LowerCase(value) == "density" || LowerCase(value) == "mass"; });
}

/// Returns true for a line that says which the columns are. A line such as "ballast,Mass" is that of a solid.
bool IsHeader(const std::vector<std::string>& values)
{
  return LowerCase(values[0]) == "name" &&
    (NamesColumns(values) ||
      std::find_if(values.begin() + 1, values.end(),
        [](const std::string& value) { return LowerCase(value) == "material"; }) != values.end());
}

/// Reads the columns of a header, the first of which is that of the names. Returns an error message; empty if
/// all are known.
std::string ReadHeader(const std::vector<std::string>& values, MaterialHeader& header)
{
  header = { &MaterialTexts::Pattern };
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    const auto* const name =
      std::find(std::begin(MaterialColumnNames), std::end(MaterialColumnNames), LowerCase(values[i]));
    const auto column = name == std::end(MaterialColumnNames)
      ? nullptr
      : MaterialColumns[name - std::begin(MaterialColumnNames)];
    if (!column || std::find(header.begin(), header.end(), column) != header.end())
    {
      return "there is no column " + values[i] + (column ? " twice" : "") +
        "; write name, material, density, tolerance and mass, each at most once";
    }
    header.push_back(column);
  }
  return {};
}

std::string AddRule(const MaterialTexts& texts, std::vector<MaterialRule>& rules)
{
  MaterialRule rule;
  std::string problem = MakeRule(texts, rule);
  if (problem.empty())
  {
    rules.push_back(rule);
  }
  return problem;
}

/// Adds the rule of a line. Returns an error message; empty if it is one.
std::string ReadLine(
  const std::vector<std::string>& values, const MaterialHeader& header, std::vector<MaterialRule>& rules)
{
  if (values.size() < 2 || values.size() > header.size())
  {
    return "write NAME,MATERIAL,DENSITY, and perhaps TOLERANCE and MASS, or the columns of the header";
  }
  MaterialTexts texts;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    texts.*header[i] = values[i];
  }
  const std::string problem = AddRule(texts, rules);
  return problem.empty() || !NamesColumns(values)
    ? problem
    : problem + "; if this line names the columns, write name as the first of them";
}

std::string ReadCsv(const std::string& text, std::vector<MaterialRule>& rules)
{
  size_t number = 0;
  MaterialHeader header{ std::begin(MaterialColumns), std::end(MaterialColumns) };
  for (size_t begin = 0; begin < text.size();)
  {
    const size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = Trim(text.substr(begin, end - begin));
    begin = end + 1;
    ++number;
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    const std::vector<std::string> values = SplitLine(line);
    const std::string problem =
      IsHeader(values) ? ReadHeader(values, header) : ReadLine(values, header, rules);
    if (!problem.empty())
    {
      return "line " + std::to_string(number) + ": " + problem;
    }
  }
  return {};
}

std::string ReadJson(const std::string& text, std::vector<MaterialRule>& rules)
{
  const Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded())
  {
    return "it is not JSON";
  }
  const Json& list =
    document.is_object() && document.contains("materials") ? document["materials"] : document;
  if (!list.is_array())
  {
    return "there is no list of materials in it";
  }
  for (size_t i = 0; i < list.size(); ++i)
  {
    const Json& entry = list[i];
    MaterialTexts texts;
    for (std::size_t k = 0; k < std::size(MaterialColumns) && entry.is_object(); ++k)
    {
      const auto value = entry.find(MaterialColumnNames[k]);
      if (value != entry.end() && !value->is_null())
      {
        texts.*MaterialColumns[k] = value->is_string() ? value->get<std::string>() : Dump(*value);
      }
    }
    const std::string problem = AddRule(texts, rules);
    if (!problem.empty())
    {
      return "entry " + std::to_string(i + 1) + ": " + problem;
    }
  }
  return {};
}
}

std::string ReadMaterialFile(const std::string& name, std::vector<MaterialRule>& rules)
{
  const std::optional<std::string> text = ReadTextFile(name);
  if (!text)
  {
    return "the materials " + name + " cannot be read";
  }
  const size_t first = text->find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string::npos && ((*text)[first] == '[' || (*text)[first] == '{');
  const std::string problem = isJson ? ReadJson(*text, rules) : ReadCsv(*text, rules);
  return problem.empty() ? problem : name + ", " + problem;
}

Material ParseDensity(const std::string& text)
{
  if (const Material* common = FindCommonMaterial(text))
  {
    return *common;
  }
  const double density = ParseNumber(text);
  return { std::string(), IsWeight(density) ? density : 0.0 };
}
}
