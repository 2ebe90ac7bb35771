#include "smColumns.h"
#include "smReport.h"

#include <algorithm>

namespace sm
{
namespace
{
using Cells = std::vector<std::pair<std::string, std::optional<std::string>>>;

std::optional<std::string> NullIfEmpty(const std::string& text)
{
  return text.empty() ? std::nullopt : std::optional(text);
}

void AddMassColumns(const BodyResult& body, const TotalResult* total, Columns& columns)
{
  columns.Note("kg/m^3");
  columns.Add("density", body.Density);
  columns.Add("material", NullIfEmpty(body.Material));
  columns.Note("kg; the rest of the sum is the numerical bound");
  columns.Add("mass_uncertainty", body.MassUncertainty[0]);
  columns.Add("mass_uncertainty_density", body.MassUncertainty[1]);
  columns.Add("mass_uncertainty_gaps", body.MassUncertainty[2]);
  columns.Add("mass_uncertainty_overridden", body.MassUncertainty[4]);
  columns.Add("mass_uncertainty_tolerance", body.MassUncertainty[5]);
  columns.Note("kg, the part of the mass that materials state");
  columns.Add("overridden_mass", body.OverriddenMass);
  columns.Note("L, with the densities as weight");
  columns.AddPoint("mass_center", body.MassCenter.Value);
  columns.Add("mass_center_bound", body.MassCenter.Bound);
  columns.Note("kg L^2, about the centre of the masses");
  columns.AddMatrix("mass_inertia", body.MassInertia.Value);
  columns.Add("mass_inertia_bound", body.MassInertia.Bound);
  columns.Note("of the total only");
  const TotalResult none;
  const TotalResult& sum = total ? *total : none;
  columns.Add("known_mass", sum.KnownMass.Get());
  columns.Add("known_mass_bound", sum.KnownMass.Bound);
  columns.Add("solids_with_mass", sum.SolidsWithMass);
  columns.Add("solids_with_volume", sum.SolidsWithVolume);
  columns.Note("L");
  columns.Add("radius_of_gyration", body.RadiiOfGyration.Value.data(), { "1", "2", "3" });
  columns.Add("radius_of_gyration_bound", body.RadiiOfGyration.Bound);
  columns.Note("L^5");
  columns.AddMatrix("inertia_at_origin", body.InertiaAtOrigin.Value);
  columns.Add("inertia_at_origin_bound", body.InertiaAtOrigin.Bound);
}

/// Adds the columns of the frame of reference; empty cells without one.
void AddFrameColumns(const FrameQuantities& about, Columns& columns)
{
  columns.Note("with `--about`, in the frame and about its origin");
  columns.AddPoint("about_center", about.Center.Value);
  columns.Add("about_center_bound", about.Center.Bound);
  columns.AddMatrix("about_inertia", about.Inertia.Value);
  columns.Add("about_inertia_bound", about.Inertia.Bound);
  columns.AddPoint("about_mass_center", about.MassCenter.Value);
  columns.Add("about_mass_center_bound", about.MassCenter.Bound);
  columns.AddMatrix("about_mass_inertia", about.MassInertia.Value);
  columns.Add("about_mass_inertia_bound", about.MassInertia.Bound);
}

void AddQuantityColumns(const BodyResult& body, const TotalResult* total, Columns& columns)
{
  columns.Note("L^3, L^2");
  columns.Add("volume", body.Volume.Get());
  columns.Add("volume_bound", body.Volume.Bound);
  columns.Add("area", body.Area.Get());
  columns.Add("area_bound", body.Area.Bound);
  columns.Note("L, centre of mass");
  columns.AddPoint("center", body.Center.Value);
  columns.Add("center_bound", body.Center.Bound);
  columns.Note("L^5, about the centre of mass");
  columns.AddMatrix("inertia", body.Inertia.Value);
  columns.Add("inertia_bound", body.Inertia.Bound);
  columns.Note("L^5, ascending, and their axes");
  columns.Add("principal", body.PrincipalMoments.Value.data(), { "1", "2", "3" });
  for (size_t i = 0; i < 3; ++i)
  {
    columns.Add("axis" + std::to_string(i + 1), body.PrincipalAxes.Value.data() + 3 * i, { "x", "y", "z" });
  }
  columns.Note("kg");
  columns.Add("mass", body.Mass.Get());
  columns.Add("mass_bound", body.Mass.Bound);
  columns.Note("as in JSON");
  columns.Add("closure_spread_volume", body.Spread.Volume);
  columns.Add("closure_spread_area", body.Spread.Area);
  columns.Add("closure_spread_center", body.Spread.Center);
  columns.Add("closure_spread_inertia", body.Spread.Inertia);
  columns.Add("closure_spread_principal", body.Spread.PrincipalMoments);
  columns.Add("closure_spread_mass", body.Spread.Mass);
  columns.Add("closure_spread_mass_center", body.Spread.MassCenter);
  columns.Add("closure_spread_mass_inertia", body.Spread.MassInertia);
  columns.Add("closure_spread_mass_principal", body.Spread.MassPrincipalMoments);
  columns.Add("closure_correction", body.ClosureCorrection);
  columns.Add("gap_squared", body.GapSquared);
  columns.Add("max_gap", body.MaxGap);
  columns.Add("gap_area", body.GapArea);
  columns.Add("open_edges", body.OpenEdges);
  columns.Add("closure_residual", body.ClosureResidual);
  columns.Add("flipped_shells", body.FlippedShells);
  columns.Add("paper_error_estimate", body.PaperErrorEstimate);
  columns.Add("paper_error_estimate_with_boundary", body.PaperErrorEstimateWithBoundary);
  columns.Add("sub_patches", body.SubPatches);
  AddMassColumns(body, total, columns);
  AddFrameColumns(body.About.value_or(FrameQuantities()), columns);
  columns.Note("L, with `--box`");
  columns.Add("box", body.LowCorner.Value.data(), { "xmin", "ymin", "zmin" });
  columns.Add("box", body.HighCorner.Value.data(), { "xmax", "ymax", "zmax" });
  columns.Add("box_bound", body.LowCorner.Bound);
}

/// Returns the row of a solid, or of all together if `solid` is null.
Columns MakeRow(const FileResult& file, const SolidResult* solid)
{
  using Text = std::optional<std::string>;
  Columns columns;
  columns.Note("`row` is `total` or `solid`, and only solids have a name and an id");
  columns.Add("file", Text(file.File));
  columns.Add("row", Text(solid ? "solid" : "total"));
  columns.Add("name", solid ? Text(solid->Name) : std::nullopt);
  columns.Add("id", solid ? Text(solid->Id) : std::nullopt);
  columns.Add("path", solid ? Text(solid->Path) : std::nullopt);
  columns.Add("status", Text(solid ? solid->Status : file.Status));
  columns.Add("scheme", file.Scheme);
  columns.Add("length_unit", file.LengthUnit);
  const BodyResult& body = solid ? static_cast<const BodyResult&>(*solid) : file.Total;
  AddQuantityColumns(body, solid ? nullptr : &file.Total, columns);
  file.AddColumns(solid ? solid->Analyses : file.Analyses, columns);
  return columns;
}

/// Returns the cells with these names, in their order; all cells if there are no names.
Cells Select(const Cells& cells, const std::vector<std::string>& fields)
{
  Cells chosen;
  for (const std::string& field : fields)
  {
    chosen.push_back(
      *std::find_if(cells.begin(), cells.end(), [&field](const auto& cell) { return cell.first == field; }));
  }
  return fields.empty() ? cells : chosen;
}

std::string FormatRow(const Cells& cells, bool isHead)
{
  std::string line;
  for (size_t i = 0; i < cells.size(); ++i)
  {
    line += (i > 0 ? "," : "") + FormatCell(isHead ? cells[i].first : cells[i].second);
  }
  return line + "\n";
}
}

std::vector<std::string> ListColumns(const FileResult& file)
{
  std::vector<std::string> names;
  const Columns row = MakeRow(file, nullptr);
  for (const auto& [name, value] : row.GetCells())
  {
    names.push_back(name);
  }
  return names;
}

std::string FormatColumnReference(const FileResult& file)
{
  const Columns columns = MakeRow(file, nullptr);
  std::string text = "| Columns | Meaning |\n|---|---|\n";
  std::string meaning;
  std::string group;
  for (std::size_t i = 0; i <= columns.GetCells().size(); ++i)
  {
    const bool isEnd = i == columns.GetCells().size();
    const auto note = std::find_if(columns.GetNotes().begin(), columns.GetNotes().end(),
      [i](const auto& entry) { return entry.first == i; });
    if (isEnd || note != columns.GetNotes().end())
    {
      text += group.empty() ? "" : "| " + group + " | " + meaning + " |\n";
      group.clear();
      meaning = isEnd ? "" : note->second;
    }
    group += isEnd ? "" : (group.empty() ? "`" : ", `") + columns.GetCells()[i].first + "`";
  }
  return text;
}

std::string FormatFields(const FileResult& file, const std::vector<std::string>& fields)
{
  std::string line;
  for (const auto& [name, value] : Select(MakeRow(file, nullptr).GetCells(), fields))
  {
    line += (line.empty() ? "" : " ") + value.value_or("nan");
  }
  return line + "\n";
}

std::string FormatCsv(const std::vector<FileResult>& files, const std::vector<std::string>& fields)
{
  std::string text;
  for (const FileResult& file : files)
  {
    const Cells total = Select(MakeRow(file, nullptr).GetCells(), fields);
    text += (text.empty() ? FormatRow(total, true) : "") + FormatRow(total, false);
    for (const SolidResult& solid : file.Solids)
    {
      text += FormatRow(Select(MakeRow(file, &solid).GetCells(), fields), false);
    }
  }
  return text;
}
}
