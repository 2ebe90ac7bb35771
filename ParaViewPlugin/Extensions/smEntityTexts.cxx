#include "smEntityTexts.h"

#include "smColumnUnits.h"
#include "smFormat.h"
#include "smMassPropertyNames.h"
#include "smTableCells.h"
#include "smUnitRoundoff.h"
#if VTK_MODULE_ENABLE_SolidMoments_FiltersBuoyancy
#include "smBuoyancyNames.h"
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersSection
#include "smSectionNames.h"
#endif

#include "vtkNURBSDataSet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>

namespace sm
{
namespace
{
/// Largest number of solids, faces or edges that a text has.
constexpr std::size_t MaxEntities = 4;
/// Largest number of characters of a line.
constexpr std::size_t LengthOfLines = 64;
/// Digits of a gap, which has no bound.
constexpr int GapDigits = 3;

struct Figure
{
  const char* Label;
  const char* Column;
};

const Figure FiguresOfSolids[] = {
  { "mass", names::Mass },
  { "volume", names::Volume },
  { "area", names::SurfaceArea },
#if VTK_MODULE_ENABLE_SolidMoments_FiltersBuoyancy
  { "displaced volume", names::DisplacedVolume },
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersSection
  { "section area", names::SectionArea },
#endif
  { "widest gap", names::MaxGap },
};
const Figure FiguresOfFaces[] = { { "area", names::SurfaceArea }, { "widest gap", names::MaxGap } };
const Figure FiguresOfEdges[] = { { "widest gap", names::MaxGap } };

/// Returns the figures that are known, as "mass 0.5 kg (+- 1e-9), area 12 mm^2 (+- 2e-9)".
template <std::size_t Count>
std::string ListFigures(
  vtkTable* table, vtkIdType row, const Figure (&figures)[Count], const std::string& unit)
{
  std::string list;
  for (const Figure& figure : figures)
  {
    const double value = GetNumber(table, figure.Column, row);
    const double bound = GetNumber(table, std::string(figure.Column) + names::BoundSuffix, row);
    if (std::isfinite(value))
    {
      const std::string inUnit = GetColumnUnit(figure.Column, unit);
      list += (list.empty() ? "" : ", ") + std::string(figure.Label) + " " +
        (std::isfinite(bound) ? FormatWithBound(value, bound, inUnit)
                              : FormatDigits(value, GapDigits) + " " + inUnit);
    }
  }
  return list;
}

std::string NameSolid(vtkTable* solids, vtkIdType row)
{
  const std::string name = GetText(solids, names::Name, row);
  const std::string number = "solid " + GetText(solids, names::Id, row);
  return name.empty() ? number : name + " (" + number + ")";
}

/// "face 3 (#197) of rail (solid 2)": the number that NURBS Deform takes, and that of the entity in the file.
std::string NameEntity(const std::string& kind, const char* indexColumn, const char* idColumn,
  vtkTable* table, vtkTable* solids, vtkIdType row)
{
  const vtkIdType id = GetIndex(table, idColumn, row);
  return kind + " " + std::to_string(GetIndex(table, indexColumn, row)) +
    (id > 0 ? " (#" + std::to_string(id) + ")" : std::string()) + " of " +
    NameSolid(solids, GetIndex(table, names::Solid, row));
}

/// Returns one or two lines for each of the first rows, and the number of the others.
std::string ListRows(
  const std::vector<vtkIdType>& rows, const char* kind, const std::function<std::string(vtkIdType)>& describe)
{
  std::string list;
  const std::size_t shown = std::min(rows.size(), MaxEntities);
  for (std::size_t i = 0; i < shown; ++i)
  {
    // Continuation lines of a text are indented.
    std::string lines = WrapText(describe(rows[i]), LengthOfLines);
    for (std::size_t at = lines.find('\n'); at + 1 < lines.size(); at = lines.find('\n', at + 1))
    {
      lines.insert(at + 1, "   ");
    }
    list += lines;
  }
  return list +
    (rows.size() > shown ? "and " + std::to_string(rows.size() - shown) + " more " + kind + "\n" : "");
}

std::string DescribeSolids(vtkTable* solids, const std::vector<vtkIdType>& rows)
{
  std::string text = ListRows(rows, "solids",
    [solids](vtkIdType row)
    {
      return NameSolid(solids, row) + ": " +
        ListFigures(solids, row, FiguresOfSolids, GetText(solids, names::LengthUnit, row));
    });
  double mass = 0.0;
  double bound = 0.0;
  double size = 0.0;
  for (const vtkIdType row : rows)
  {
    mass += GetNumber(solids, names::Mass, row);
    size += std::abs(GetNumber(solids, names::Mass, row));
    bound += GetNumber(solids, std::string(names::Mass) + names::BoundSuffix, row);
  }
  if (rows.size() > 1 && std::isfinite(mass))
  {
    // Includes the rounding of each addition.
    bound += 2.0 * static_cast<double>(rows.size()) * UnitRoundoff * (size + bound);
    text += std::to_string(rows.size()) + " solids: mass " + FormatWithBound(mass, bound, "kg") + "\n";
  }
  return text;
}
}

std::string DescribeSolidsAndFaces(vtkTable* solids, const std::vector<vtkIdType>& solidRows, vtkTable* faces,
  const std::vector<vtkIdType>& faceRows)
{
  std::set<vtkIdType> all(solidRows.begin(), solidRows.end());
  for (const vtkIdType row : faceRows)
  {
    all.insert(GetIndex(faces, names::Solid, row));
  }
  const std::string ofFaces = ListRows(faceRows, "faces",
    [solids, faces](vtkIdType row)
    {
      const std::string unit = GetText(solids, names::LengthUnit, GetIndex(faces, names::Solid, row));
      return NameEntity("face", vtkNURBSDataSet::FaceIndexArrayName(), names::FaceId, faces, solids, row) +
        ": " + ListFigures(faces, row, FiguresOfFaces, unit);
    });
  return ofFaces + DescribeSolids(solids, { all.begin(), all.end() });
}

std::string DescribeEdges(vtkTable* solids, vtkTable* edges, const std::vector<vtkIdType>& edgeRows)
{
  return ListRows(edgeRows, "edges",
    [solids, edges](vtkIdType row)
    {
      const std::string unit = GetText(solids, names::LengthUnit, GetIndex(edges, names::Solid, row));
      const std::string figures = ListFigures(edges, row, FiguresOfEdges, unit);
      return NameEntity("edge", names::EdgeIndex, names::EdgeId, edges, solids, row) + ": " + figures +
        (figures.empty() ? "" : ", ") + "used " + FormatDigits(GetNumber(edges, names::Uses, row), 9) +
        " times by faces" + (GetNumber(edges, names::Open, row) > 0.0 ? ", open" : "");
    });
}
}
