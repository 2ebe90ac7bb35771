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
  columns.Add("density", body.Density);
  columns.Add("material", NullIfEmpty(body.Material));
  columns.Add("mass_uncertainty", body.MassUncertainty[0]);
  columns.Add("mass_uncertainty_density", body.MassUncertainty[1]);
  columns.Add("mass_uncertainty_gaps", body.MassUncertainty[2]);
  columns.AddPoint("mass_center", body.MassCenter.Value);
  columns.Add("mass_center_bound", body.MassCenter.Bound);
  columns.AddMatrix("mass_inertia", body.MassInertia.Value);
  columns.Add("mass_inertia_bound", body.MassInertia.Bound);
  const TotalResult none;
  const TotalResult& sum = total ? *total : none;
  columns.Add("known_mass", sum.KnownMass.Get());
  columns.Add("known_mass_bound", sum.KnownMass.Bound);
  columns.Add("solids_with_mass", sum.SolidsWithMass);
  columns.Add("solids_with_volume", sum.SolidsWithVolume);
  columns.Add("radius_of_gyration", body.RadiiOfGyration.Value.data(), { "1", "2", "3" });
  columns.Add("radius_of_gyration_bound", body.RadiiOfGyration.Bound);
  columns.AddMatrix("inertia_at_origin", body.InertiaAtOrigin.Value);
  columns.Add("inertia_at_origin_bound", body.InertiaAtOrigin.Bound);
}

/// Adds the columns of the frame of reference; empty cells without one.
void AddFrameColumns(const FrameQuantities& about, Columns& columns)
{
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
  columns.Add("volume", body.Volume.Get());
  columns.Add("volume_bound", body.Volume.Bound);
  columns.Add("area", body.Area.Get());
  columns.Add("area_bound", body.Area.Bound);
  columns.AddPoint("center", body.Center.Value);
  columns.Add("center_bound", body.Center.Bound);
  columns.AddMatrix("inertia", body.Inertia.Value);
  columns.Add("inertia_bound", body.Inertia.Bound);
  columns.Add("principal", body.PrincipalMoments.Value.data(), { "1", "2", "3" });
  for (size_t i = 0; i < 3; ++i)
  {
    columns.Add("axis" + std::to_string(i + 1), body.PrincipalAxes.Value.data() + 3 * i, { "x", "y", "z" });
  }
  columns.Add("mass", body.Mass.Get());
  columns.Add("mass_bound", body.Mass.Bound);
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
  columns.Add("box", body.LowCorner.Value.data(), { "xmin", "ymin", "zmin" });
  columns.Add("box", body.HighCorner.Value.data(), { "xmax", "ymax", "zmax" });
  columns.Add("box_bound", body.LowCorner.Bound);
}

/// Returns the row of a solid, or of all together if `solid` is null.
Cells MakeRow(const FileResult& file, const SolidResult* solid)
{
  using Text = std::optional<std::string>;
  Columns columns;
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
  return columns.GetCells();
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
  for (const auto& [name, value] : MakeRow(file, nullptr))
  {
    names.push_back(name);
  }
  return names;
}

std::string FormatFields(const FileResult& file, const std::vector<std::string>& fields)
{
  std::string line;
  for (const auto& [name, value] : Select(MakeRow(file, nullptr), fields))
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
    const Cells total = Select(MakeRow(file, nullptr), fields);
    text += (text.empty() ? FormatRow(total, true) : "") + FormatRow(total, false);
    for (const SolidResult& solid : file.Solids)
    {
      text += FormatRow(Select(MakeRow(file, &solid), fields), false);
    }
  }
  return text;
}
}
