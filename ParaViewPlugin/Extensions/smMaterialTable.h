/**
 * @file smMaterialTable.h
 * @brief The table of parts, materials, densities and masses in the panel of Mass Properties, as texts
 *
 * A row has four cells: part, material, density in kg/m^3, mass in kg. The first row has titles where the
 * panel shows none (smPanel.h), and the last one the total. Between them is a row for each part of the input,
 * then one for each rule that has another pattern. A rule is a row of the property Materials: pattern of
 * names, material, density, or a mass with a unit in its place.
 *
 * Cells of material and density that no rule of that row gave say where they come from: "7850 (file)", "2700
 * (Density)", "7850 (below)". Only cells without such an ending make rules, so that a table as text has a
 * meaning without the input that it was made for.
 */
#ifndef smMaterialTable_h
#define smMaterialTable_h

#include <array>
#include <string>
#include <vector>

namespace sm
{
/// All solids of one name.
struct PartMaterial
{
  std::string Name;
  /// Number of solids; of those with a volume, where masses are known.
  int Solids = 1;
  /// Material and density that the file states; kg/m^3, 0 without one.
  std::string Material;
  double Density = 0.0;
  /// True if the solids differ in material or density.
  bool HasSeveral = false;
  /// Number of solids with a mass, and the sum of their masses in kg.
  int Weighed = 0;
  double Mass = 0.0;
};

/// Pattern of names, material and density, as in vtkMassPropertiesBase::AddMaterial().
using MaterialRow = std::array<std::string, 3>;

constexpr int MaterialTableColumns = 4;
constexpr std::array<const char*, MaterialTableColumns> MaterialTableTitles = { "Part", "Material", "kg/m^3",
  "kg" };

/// Returns the cells, row by row; none without parts and rules. `parts` are those of the input, `masses`
/// those of the last run (may be empty), `density` is that of all solids, or 0, `hasTitles` asks for the row
/// of titles. A total of only some solids is marked as such.
std::vector<std::string> MakeMaterialTable(const std::vector<PartMaterial>& parts,
  const std::vector<PartMaterial>& masses, const std::vector<MaterialRow>& rules, double density,
  bool isSomeSolids, bool hasTitles);

/// If exactly one cell differs from the previous table, it was edited: removes the ending of the cell, so
/// that it has the text that was typed.
void TakeEditedCell(const std::vector<std::string>& before, std::vector<std::string>& cells);

/**
 * Returns the rules that a table has, each pattern once, in the order of its rows. A common material gives
 * its density to a row without a density, and to a row whose material was changed but not its density
 * (`rules` are the previous ones). The row of titles, the last row if it is a total, and the masses are
 * ignored.
 */
std::vector<MaterialRow> ReadMaterialTable(
  const std::vector<std::string>& cells, const std::vector<MaterialRow>& rules);
}

#endif
