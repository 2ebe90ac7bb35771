/**
 * @file smMaterialFile.h
 * @brief Materials by the names of solids, from a small CSV or JSON file
 *
 * CSV: lines "pattern,material,density,tolerance,mass", of which all behind the material may be missing. A
 * line with the names of columns, "name,material,mass", says which they are from there on, the name first.
 * Lines that begin with # are skipped, a value in quotes may have commas. JSON: a list of objects with these
 * names as keys, or such a list under the key "materials". The density is in kg/m^3, the mass, which
 * overrides volume times density, in kg or with a unit ("250 g"), the tolerance as ParseShare() reads it, or
 * a mass with a unit. Without density and mass the material is one of the common ones, or "left out": these
 * solids do not count. Without a tolerance that of the option --density-tolerance applies to a density, and
 * none to a mass. The format is determined by the first character.
 */
#ifndef smMaterialFile_h
#define smMaterialFile_h

#include "smMaterials.h"

#include <string>
#include <vector>

namespace sm
{
/// Appends the rules of a file. Returns an error message with the line or the entry that is wrong; empty if
/// all is well.
std::string ReadMaterialFile(const std::string& name, std::vector<MaterialRule>& rules);

/// Reads a density, "7850", or the name of a common material; returns a density of 0 for any other text.
Material ParseDensity(const std::string& text);
}

#endif
