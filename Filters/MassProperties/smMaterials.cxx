#include "smMaterials.h"

#include "smFormat.h"
#include "smWeights.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <system_error>
#include <utility>

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

/// Reads a number with a decimal point, whatever the locale; NaN for any other text.
double ReadDecimal(const std::string& text)
{
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value
                                                                  : std::numeric_limits<double>::quiet_NaN();
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

bool IsSameMaterial(const std::string& a, const std::string& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), AreEqual);
}

const Material* FindCommonMaterial(const std::string& name)
{
  const std::vector<Material>& materials = GetCommonMaterials();
  const auto found = std::find_if(materials.begin(), materials.end(),
    [&name](const Material& material) { return IsSameMaterial(name, material.Name); });
  return found == materials.end() ? nullptr : &*found;
}

namespace
{
/// Units of mass in kg, with their case: Mg is a megagram by the SI, and mg a milligram.
constexpr std::pair<const char*, double> MassUnits[] = { { "kg", 1.0 }, { "Kg", 1.0 }, { "KG", 1.0 },
  { "g", 1e-3 }, { "mg", 1e-6 }, { "t", 1e3 }, { "lb", 0.45359237 }, { "Lb", 0.45359237 },
  { "LB", 0.45359237 }, { "oz", 0.028349523125 }, { "Oz", 0.028349523125 }, { "OZ", 0.028349523125 } };

/// Returns the number of a mass and its unit; both may be empty.
std::pair<std::string, std::string> SplitMass(const std::string& text)
{
  const std::size_t end = text.find_last_of("0123456789.");
  const std::size_t begin = end == std::string::npos ? end : text.find_first_not_of(' ', end + 1);
  return { end == std::string::npos ? std::string() : text.substr(0, end + 1),
    begin == std::string::npos ? std::string() : text.substr(begin) };
}

/// Returns a remedy for a text whose unit is one of mass in another case; empty for any other text.
std::string DescribeCase(const std::string& text)
{
  const std::string unit = SplitMass(text).second;
  const bool isKnown = std::any_of(
    std::begin(MassUnits), std::end(MassUnits), [&unit](const auto& entry) { return entry.first == unit; });
  const bool isInOtherCase = std::any_of(std::begin(MassUnits), std::end(MassUnits),
    [&unit](const auto& entry) { return MatchesPattern(entry.first, unit); });
  return isKnown || !isInOtherCase
    ? std::string()
    : "; the case of the unit " + unit + " counts: write t for 1000 kg, g for grams, mg for milligrams";
}
}

double ParseMass(const std::string& text, bool needsUnit)
{
  const auto [number, unit] = SplitMass(text);
  const auto* known = std::begin(MassUnits);
  while (known != std::end(MassUnits) && known->first != unit)
  {
    ++known;
  }
  const bool isKnown = known != std::end(MassUnits) || (unit.empty() && !needsUnit);
  const double mass = isKnown ? ReadDecimal(number) * (unit.empty() ? 1.0 : known->second) : 0.0;
  return IsWeight(mass) ? mass : std::numeric_limits<double>::quiet_NaN();
}

double ParseShare(const std::string& text)
{
  const bool isPercent = !text.empty() && text.back() == '%';
  const double value = isPercent ? ReadDecimal(text.substr(0, text.size() - 1)) / 100.0 : ReadDecimal(text);
  return value >= 0.0 && value <= 1.0 ? value : -1.0;
}

namespace
{
constexpr const char* LeftOutProblem =
  "a solid that is left out has neither density nor mass; remove them, or name a material";
constexpr const char* CountedProblem = "a line that counts once states no material; remove density, mass and "
                                       "tolerance, and state them in a line of "
                                       "their own";

/// Returns what the material of a rule counts.
Counting ParseCounting(const std::string& material)
{
  return MatchesPattern(CountedOnceMaterial, material) ? Counting::Once
    : MatchesPattern(CountedInPlaceMaterial, material) ? Counting::OnceInPlace
                                                       : Counting::Every;
}

/// Returns the relative tolerance of a mass; negative if the text is none.
double ParseMassTolerance(const std::string& text, double mass)
{
  const double share = ParseShare(text);
  const double absolute = ParseMass(text, true);
  return share < 0.0 && absolute <= mass ? absolute / mass : share;
}

/// Removes ProductMassSuffix from the end of a text. Returns true if it was there.
bool TakeProductSuffix(std::string& text)
{
  if (!MatchesPattern(std::string("* ") + ProductMassSuffix, text))
  {
    return false;
  }
  text.resize(text.size() - std::string(ProductMassSuffix).size());
  text.resize(text.find_last_not_of(' ') + 1);
  return true;
}

/// Sets the mass that the texts state. Returns an error message; empty if there is none.
std::string TakeMass(const MaterialTexts& texts, Material& material)
{
  const bool isInDensity = texts.Mass.empty();
  const std::string& text = isInDensity ? texts.Density : texts.Mass;
  if (!isInDensity && !texts.Density.empty())
  {
    return "it has the density " + texts.Density + " and the mass " + texts.Mass +
      ", which contradict each other; give one of them";
  }
  material.Mass = ParseMass(text, isInDensity);
  if (!(material.Mass > 0.0))
  {
    return text + " is not a mass; give a number from " + WeightRange +
      " in kg, or with one of the units kg, g, mg, t, lb, oz" +
      (isInDensity ? ", which it needs in the place of a density" : "") + DescribeCase(text);
  }
  return {};
}

/// Sets the density that the texts state. Returns an error message; empty if there is none.
std::string TakeDensity(const MaterialTexts& texts, Material& material)
{
  const Material* common = FindCommonMaterial(texts.Material);
  material.Density = !texts.Density.empty() ? ReadDecimal(texts.Density) : common ? common->Density : 0.0;
  if (IsWeight(material.Density))
  {
    return {};
  }
  return texts.Density.empty()
    ? texts.Material + " is none of the materials of --list-materials: it needs a density"
    : texts.Density + " is not a density; give kg/m^3 from " + WeightRange +
      ", for example 7850, or a mass with a unit, for example 250 g" + DescribeCase(texts.Density);
}
}

std::string MakeRule(const MaterialTexts& given, MaterialRule& rule)
{
  MaterialTexts texts = given;
  MaterialRule made{ texts.Pattern, { texts.Material } };
  if (texts.Pattern.empty())
  {
    return "the name is empty";
  }
  made.IsOfProduct = TakeProductSuffix(texts.Mass.empty() ? texts.Density : texts.Mass);
  made.IsLeftOut = MatchesPattern(LeftOutMaterial, texts.Material);
  made.Counting = ParseCounting(texts.Material);
  if (made.IsLeftOut || made.Counting != Counting::Every)
  {
    if (made.IsOfProduct || !(texts.Density + texts.Tolerance + texts.Mass).empty())
    {
      return made.IsLeftOut ? LeftOutProblem : CountedProblem;
    }
    rule = made;
    return {};
  }
  const bool isMass = !texts.Mass.empty() || made.IsOfProduct || ParseMass(texts.Density, true) > 0.0;
  const std::string problem = isMass ? TakeMass(texts, made.Material) : TakeDensity(texts, made.Material);
  if (!problem.empty())
  {
    return problem;
  }
  if (!texts.Tolerance.empty())
  {
    made.Material.Tolerance =
      isMass ? ParseMassTolerance(texts.Tolerance, made.Material.Mass) : ParseShare(texts.Tolerance);
    if (!(made.Material.Tolerance >= 0.0))
    {
      return texts.Tolerance + " is not a relative tolerance; give 0.01 or 1%, for example" +
        (isMass ? ", or a mass with a unit that is not above the mass, for example 2 g" +
              DescribeCase(texts.Tolerance)
                : "");
    }
  }
  rule = made;
  return {};
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

std::string FindRuleProblem(const MaterialRule& rule)
{
  const Material& material = rule.Material;
  if (rule.IsLeftOut)
  {
    return {};
  }
  if (rule.Counting != Counting::Every || ParseCounting(material.Name) != Counting::Every)
  {
    return rule.Counting == Counting::Every || rule.IsOfProduct || material.HasMass() ? CountedProblem : "";
  }
  if (MatchesPattern(LeftOutMaterial, material.Name))
  {
    return LeftOutProblem;
  }
  if (!(material.Tolerance <= 1.0))
  {
    return FormatDigits(material.Tolerance, 6) +
      " is not a relative tolerance; give 0 to 1, for example 0.01 for one per cent";
  }
  if (material.Density != 0.0 && material.Mass != 0.0)
  {
    return "the density " + FormatDigits(material.Density, 6) + " and the mass " +
      FormatDigits(material.Mass, 6) + " contradict each other; give one of them";
  }
  if (rule.IsOfProduct && material.Density != 0.0)
  {
    return "a product has a mass, not the density " + FormatDigits(material.Density, 6) +
      "; give its mass, or densities for its solids";
  }
  const double value = material.Mass != 0.0 ? material.Mass : material.Density;
  if (!IsWeight(value))
  {
    const std::string range = std::string(" from ") + WeightRange;
    return material.Mass != 0.0 ? FormatDigits(value, 6) + " is not a mass; give kg" + range
                                : FormatDigits(value, 6) + " is not a density; give kg/m^3" + range +
        ", for example 7850, one of the common materials, or a mass";
  }
  return {};
}

namespace
{
const MaterialRule* FindRuleOf(const std::function<bool(const MaterialRule&)>& isOne,
  const std::vector<MaterialRule>& rules, const std::string& name)
{
  std::vector<const MaterialRule*> candidates;
  for (const MaterialRule& rule : rules)
  {
    if (isOne(rule))
    {
      candidates.push_back(&rule);
    }
  }
  const std::size_t found = FindPattern(
    candidates.size(), [&](std::size_t i) -> const std::string& { return candidates[i]->Pattern; }, name);
  return found == candidates.size() ? nullptr : candidates[found];
}
}

const MaterialRule* FindRule(const std::vector<MaterialRule>& rules, const std::string& name)
{
  return FindRuleOf([](const MaterialRule& rule)
    { return !rule.IsOfProduct && rule.Counting == Counting::Every; },
    rules, name);
}

const MaterialRule* FindProductRule(const std::vector<MaterialRule>& rules, const std::string& name)
{
  return FindRuleOf([](const MaterialRule& rule) { return rule.IsOfProduct; }, rules, name);
}

const MaterialRule* FindCountingRule(
  const std::vector<MaterialRule>& rules, Counting counting, const std::string& name)
{
  return FindRuleOf([counting](const MaterialRule& rule) { return rule.Counting == counting; }, rules, name);
}
}
