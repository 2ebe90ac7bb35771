/**
 * @file smMaterials.h
 * @brief Materials of solids: densities by name, and rules that give a solid its material by the solid's name
 */
#ifndef smMaterials_h
#define smMaterials_h

#include "smFiltersMassPropertiesModule.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace sm
{
struct Material
{
  /// May be empty.
  std::string Name;
  /// kg/m^3; 0 without one.
  double Density = 0.0;
  /// Largest relative deviation of the density, or of the mass, 0 to 1; negative if none is stated for this
  /// material: then that of the options counts for a density, and 0 for a mass.
  double Tolerance = -1.0;
  /// Mass in kg of each solid, or of each product (MaterialRule::IsOfProduct), which overrides volume times
  /// density; 0 if none is stated. Then Density is 0.
  double Mass = 0.0;

  bool HasMass() const { return this->Density > 0.0 || this->Mass > 0.0; }
};

/// Which bodies count.
enum class Counting
{
  Every,
  /// One of equal products, wherever they are.
  Once,
  /// One of equal solids that are in one place.
  OnceInPlace
};

/// Gives a material to the solids whose name matches the pattern.
struct MaterialRule
{
  /// See MatchesPattern().
  std::string Pattern;
  sm::Material Material;
  /// True if these solids are left out of everything. Then Material has no meaning.
  bool IsLeftOut = false;
  /// True if the pattern is that of products, parts or assemblies, and the mass that of all solids of each
  /// occurrence together. Such a rule gives no solid a density.
  bool IsOfProduct = false;
  /// Not Every: the rule gives no material. Once: the pattern is that of products, parts or assemblies;
  /// OnceInPlace: of solids.
  sm::Counting Counting = sm::Counting::Every;
};

/// What follows a mass that is that of a product.
constexpr const char* ProductMassSuffix = "per product";

/// The material of rules that leave solids out.
constexpr const char* LeftOutMaterial = "left out";
/// The materials of rules that count products, or coincident solids, once.
constexpr const char* CountedOnceMaterial = "counted once";
constexpr const char* CountedInPlaceMaterial = "counted once in place";

/// Common engineering materials with usual densities at room temperature, in the order of their names.
SMFILTERSMASSPROPERTIES_EXPORT const std::vector<Material>& GetCommonMaterials();

/// Returns true for equal names; letters of ASCII match in either case.
SMFILTERSMASSPROPERTIES_EXPORT bool IsSameMaterial(const std::string& a, const std::string& b);

/// Returns the common material of that name, whatever its case, or null.
SMFILTERSMASSPROPERTIES_EXPORT const Material* FindCommonMaterial(const std::string& name);

/// Reads a mass in kg: a number above 0, perhaps followed by a unit: kg, g, mg, t, lb or oz, with its case
/// (also Kg, KG, Lb, LB, Oz, OZ; not Mg). Returns NaN for any other text. With `needsUnit` a number without a
/// unit is not a mass.
SMFILTERSMASSPROPERTIES_EXPORT double ParseMass(const std::string& text, bool needsUnit);

/// Reads a fraction from 0 to 1, "0.01" or "1%"; returns a negative number for any other text.
SMFILTERSMASSPROPERTIES_EXPORT double ParseShare(const std::string& text);

/// The texts of a rule, as in a table of materials; all but the pattern may be empty.
struct MaterialTexts
{
  /// `Density` is in kg/m^3, or a mass with a unit; `Tolerance` is relative, or a mass with a unit where a
  /// mass is stated.
  std::string Pattern, Material, Density, Tolerance, Mass;
};

/// Makes a rule: of a density, of a common material, of a mass, perhaps followed by ProductMassSuffix, or of
/// the material LeftOutMaterial, CountedOnceMaterial or CountedInPlaceMaterial alone. Returns an error
/// message with a remedy, and leaves `rule` as it is; empty if the texts make a rule.
SMFILTERSMASSPROPERTIES_EXPORT std::string MakeRule(const MaterialTexts& texts, MaterialRule& rule);

/// Returns true if the name is the pattern, in which * stands for any characters and ? for one byte. Letters
/// of ASCII match in either case.
SMFILTERSMASSPROPERTIES_EXPORT bool MatchesPattern(const std::string& pattern, const std::string& name);

/// Returns the index of the first pattern that is equal to the name, else of the first that the name matches;
/// `count` if there is none.
SMFILTERSMASSPROPERTIES_EXPORT std::size_t FindPattern(std::size_t count,
  const std::function<const std::string&(std::size_t)>& getPattern, const std::string& name);

/// Returns why a rule is none, with a remedy; empty if it is one: either a density or a mass, from 1e-200 to
/// 1e200, the latter for a product, and a tolerance of at most 1; or a pattern of what is left out or
/// counted once.
SMFILTERSMASSPROPERTIES_EXPORT std::string FindRuleProblem(const MaterialRule& rule);

/// Returns the rule whose pattern FindPattern() finds among those of solids, or null.
SMFILTERSMASSPROPERTIES_EXPORT const MaterialRule* FindRule(
  const std::vector<MaterialRule>& rules, const std::string& name);

/// Returns the rule whose pattern FindPattern() finds among those of products, or null.
SMFILTERSMASSPROPERTIES_EXPORT const MaterialRule* FindProductRule(
  const std::vector<MaterialRule>& rules, const std::string& name);

/// Returns the rule whose pattern FindPattern() finds among those of a counting, or null.
SMFILTERSMASSPROPERTIES_EXPORT const MaterialRule* FindCountingRule(
  const std::vector<MaterialRule>& rules, Counting counting, const std::string& name);
}

#endif
