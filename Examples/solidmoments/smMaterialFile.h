/**
 * @file smMaterialFile.h
 * @brief Materials by the names of solids, from a small CSV or JSON file
 *
 * CSV: lines "pattern,material,density,tolerance", the density in kg/m^3, its relative tolerance as
 * ParseShare() reads it; a first line "name,material,density" and lines that begin with # are skipped, a
 * value in quotes may have commas. JSON: a list of objects with the keys "name", "material", "density",
 * "tolerance", or such a list under the key "materials". Without a density the material is one of the common
 * ones; without a tolerance that of the option --density-tolerance applies. The format is determined by the
 * first character.
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

/// Reads a fraction from 0 to 1, "0.01" or "1%"; returns a negative number for any other text.
double ParseShare(const std::string& text);

/// Reads a density, "7850", or the name of a common material; returns a density of 0 for any other text.
Material ParseDensity(const std::string& text);
}

#endif
