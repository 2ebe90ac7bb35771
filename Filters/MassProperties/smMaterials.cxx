#include "smMaterials.h"

#include <algorithm>

namespace sm
{
namespace
{
char ToLower(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool AreEqual(char a, char b)
{
  return ToLower(a) == ToLower(b);
}
}

const std::vector<Material>& GetCommonMaterials()
{
  static const std::vector<Material> materials = { { "abs", 1050.0 }, { "acrylic", 1180.0 },
    { "aluminium", 2700.0 }, { "aluminum", 2700.0 }, { "brass", 8500.0 }, { "bronze", 8800.0 },
    { "cast iron", 7200.0 }, { "concrete", 2400.0 }, { "copper", 8960.0 }, { "glass", 2500.0 },
    { "gold", 19300.0 }, { "lead", 11340.0 }, { "magnesium", 1740.0 }, { "nickel", 8900.0 },
    { "nylon", 1140.0 }, { "pc", 1200.0 }, { "peek", 1300.0 }, { "pet", 1380.0 }, { "pla", 1240.0 },
    { "polyethylene", 950.0 }, { "polypropylene", 905.0 }, { "pom", 1410.0 }, { "ptfe", 2200.0 },
    { "pvc", 1400.0 }, { "rubber", 1100.0 }, { "silver", 10490.0 }, { "stainless steel", 8000.0 },
    { "steel", 7850.0 }, { "tin", 7290.0 }, { "titanium", 4510.0 }, { "tungsten", 19250.0 },
    { "water", 1000.0 }, { "zinc", 7140.0 } };
  return materials;
}

const Material* FindCommonMaterial(const std::string& name)
{
  const std::vector<Material>& materials = GetCommonMaterials();
  const auto found = std::find_if(materials.begin(), materials.end(),
    [&name](const Material& material)
    { return std::equal(name.begin(), name.end(), material.Name.begin(), material.Name.end(), AreEqual); });
  return found == materials.end() ? nullptr : &*found;
}

bool MatchesPattern(const std::string& pattern, const std::string& name)
{
  // Where a character does not match, the last star takes one character more. Earlier stars need not be tried
  // again.
  std::size_t p = 0;
  std::size_t n = 0;
  std::size_t star = std::string::npos;
  std::size_t afterStar = 0;
  while (n < name.size())
  {
    if (p < pattern.size() && pattern[p] == '*')
    {
      star = p++;
      afterStar = n;
    }
    else if (p < pattern.size() && (pattern[p] == '?' || AreEqual(pattern[p], name[n])))
    {
      ++p;
      ++n;
    }
    else if (star != std::string::npos)
    {
      p = star + 1;
      n = ++afterStar;
    }
    else
    {
      return false;
    }
  }
  return std::all_of(
    pattern.begin() + static_cast<std::ptrdiff_t>(p), pattern.end(), [](char c) { return c == '*'; });
}

std::size_t FindPattern(std::size_t count, const std::function<const std::string&(std::size_t)>& getPattern,
  const std::string& name)
{
  std::size_t found = count;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string& pattern = getPattern(i);
    if (pattern == name)
    {
      return i;
    }
    if (found == count && MatchesPattern(pattern, name))
    {
      found = i;
    }
  }
  return found;
}

const MaterialRule* FindRule(const std::vector<MaterialRule>& rules, const std::string& name)
{
  const std::size_t found = FindPattern(
    rules.size(), [&rules](std::size_t i) -> const std::string& { return rules[i].Pattern; }, name);
  return found == rules.size() ? nullptr : &rules[found];
}
}
