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
  /// Largest relative deviation of the density, 0 to 1; negative if none is stated for this material.
  double Tolerance = -1.0;
};

/// Gives a material to the solids whose name matches the pattern.
struct MaterialRule
{
  /// See MatchesPattern().
  std::string Pattern;
  sm::Material Material;
};

/// Common engineering materials with usual densities at room temperature, in the order of their names.
SMFILTERSMASSPROPERTIES_EXPORT const std::vector<Material>& GetCommonMaterials();

/// Returns the common material of that name, whatever its case, or null.
SMFILTERSMASSPROPERTIES_EXPORT const Material* FindCommonMaterial(const std::string& name);

/// Returns true if the name is the pattern, in which * stands for any characters and ? for one byte. Letters
/// of ASCII match in either case.
SMFILTERSMASSPROPERTIES_EXPORT bool MatchesPattern(const std::string& pattern, const std::string& name);

/// Returns the index of the first pattern that is equal to the name, else of the first that the name matches;
/// `count` if there is none.
SMFILTERSMASSPROPERTIES_EXPORT std::size_t FindPattern(std::size_t count,
  const std::function<const std::string&(std::size_t)>& getPattern, const std::string& name);

/// Returns the rule whose pattern FindPattern() finds, or null.
SMFILTERSMASSPROPERTIES_EXPORT const MaterialRule* FindRule(
  const std::vector<MaterialRule>& rules, const std::string& name);
}

#endif
