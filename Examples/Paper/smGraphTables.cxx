#include "smGraphTables.h"

#include "smPaperRun.h"
#include "smPaperSolid.h"

#include <cmath>

namespace smfigure
{
namespace
{
/// Runs ADAPTIVE, then each of the paper's schemes with every factor. `reference` is the volume of the
/// errors; NaN: that of ADAPTIVE.
FigureTable MakeTable(
  const std::string& name, vtkDataObject* input, double reference, const std::vector<int>& factors)
{
  FigureTable table;
  table.Name = name;
  table.Columns = { "scheme", "k", "sub_patches", "volume", "normalised_volume", "relative_error", "bound",
    "estimate", "estimate_with_boundary" };
  PaperFilter filter(input);
  const PaperRun adaptive = filter.RunAdaptive();
  const double scale = std::isnan(reference) ? adaptive.Volume : reference;
  if (!std::isfinite(scale))
  {
    return table;
  }
  const auto add = [&](const PaperRun& run)
  {
    table.Rows.push_back({ GetName(run.Used), std::to_string(run.Factor), std::to_string(run.SubPatches),
      FormatNumber(run.Volume), FormatNumber(run.Volume / scale),
      FormatNumber(std::abs(run.Volume / scale - 1.0)), FormatNumber(run.Bound / scale),
      FormatNumber(run.Estimate / scale), FormatNumber(run.EstimateWithBoundary / scale) });
  };
  add(adaptive);
  for (const Scheme scheme : { Scheme::Midpoint, Scheme::Gauss2, Scheme::Gauss3 })
  {
    for (const int factor : factors)
    {
      add(filter.RunScheme(scheme, factor));
    }
  }
  return table;
}
}

FigureTable MakeFigure7a()
{
  const PaperSolid solid = MakeQuarterCylinder();
  return MakeTable("fig7a", solid.DataSet, solid.Volume, { 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64 });
}

FigureTable MakeFigure7b()
{
  const PaperSolid solid = MakeSlantedBlock();
  return MakeTable(
    "fig7b", solid.DataSet, solid.Volume, { 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128 });
}

FigureTable MakeFigure8(vtkDataObject* part)
{
  return MakeTable("fig8", part, std::nan(""), { 1, 2, 3, 4, 6, 8, 12, 16, 24, 32 });
}
}
