#include "smMaterialFile.h"

#include "smJson.h"
#include "smText.h"

#include <fstream>
#include <iterator>

namespace sm
{
namespace
{
bool IsDensity(double density)
{
  return density > 0.0 && density < 1e300;
}

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

/// Adds a rule. Returns an error message; empty if the rule is valid.
std::string AddRule(const std::string& pattern, const std::string& material, const std::string& density,
  const std::string& tolerance, std::vector<MaterialRule>& rules)
{
  MaterialRule rule{ pattern, { material, 0.0 } };
  rule.Material.Tolerance = tolerance.empty() ? -1.0 : ParseShare(tolerance);
  const Material* common = FindCommonMaterial(material);
  rule.Material.Density = !density.empty() ? ParseNumber(density) : common ? common->Density : 0.0;
  if (pattern.empty())
  {
    return "the name is empty";
  }
  if (!IsDensity(rule.Material.Density))
  {
    return density.empty() ? material + " is none of the materials of --list-materials: it needs a density"
                           : density + " is not a density; give kg/m^3, for example 7850";
  }
  if (!tolerance.empty() && !(rule.Material.Tolerance >= 0.0))
  {
    return tolerance + " is not a relative tolerance; give 0.01 or 1%, for example";
  }
  rules.push_back(rule);
  return {};
}

std::string ReadCsv(const std::string& text, std::vector<MaterialRule>& rules)
{
  size_t number = 0;
  for (size_t begin = 0; begin < text.size();)
  {
    const size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = Trim(text.substr(begin, end - begin));
    begin = end + 1;
    ++number;
    std::vector<std::string> values = SplitLine(line);
    if (line.empty() || line[0] == '#' || (values.size() >= 3 && LowerCase(values[2]) == "density"))
    {
      continue;
    }
    const std::string place = "line " + std::to_string(number) + ": ";
    if (values.size() < 2 || values.size() > 4)
    {
      return place + "write NAME,MATERIAL,DENSITY or NAME,MATERIAL,DENSITY,TOLERANCE";
    }
    values.resize(4);
    const std::string problem = AddRule(values[0], values[1], values[2], values[3], rules);
    if (!problem.empty())
    {
      return place + problem;
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
    const auto get = [&entry](const char* key)
    {
      const bool known = entry.is_object() && entry.contains(key) && !entry[key].is_null();
      return !known              ? std::string()
        : entry[key].is_string() ? entry[key].get<std::string>()
                                 : Dump(entry[key]);
    };
    const std::string problem =
      AddRule(get("name"), get("material"), get("density"), get("tolerance"), rules);
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
  std::ifstream file(name, std::ios::binary);
  const std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (!file.is_open() || file.bad())
  {
    return "the materials " + name + " cannot be read";
  }
  const size_t first = text.find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string::npos && (text[first] == '[' || text[first] == '{');
  const std::string problem = isJson ? ReadJson(text, rules) : ReadCsv(text, rules);
  return problem.empty() ? problem : name + ", " + problem;
}

double ParseShare(const std::string& text)
{
  const bool isPercent = !text.empty() && text.back() == '%';
  const double value = isPercent ? ParseNumber(text.substr(0, text.size() - 1)) / 100.0 : ParseNumber(text);
  return value >= 0.0 && value <= 1.0 ? value : -1.0;
}

Material ParseDensity(const std::string& text)
{
  if (const Material* common = FindCommonMaterial(text))
  {
    return *common;
  }
  const double density = ParseNumber(text);
  return { std::string(), IsDensity(density) ? density : 0.0 };
}
}
