#include "smPointTables.h"

#include "smGaussLegendre.h"
#include "smPaperRun.h"
#include "smPaperSolid.h"

#include <Detail/smSubPatches.h>
#include <smTrimPolygons.h>
#include <vtkTrimmedNURBSModel.h>

namespace smfigure
{
namespace
{
/// Makes a table of the n x n points of every sub-patch of the grid.
FigureTable MakeQuadraturePoints(const std::string& name, const sm::SubPatchGrid& grid, int n)
{
  std::vector<double> nodes;
  std::vector<double> weights;
  sm::ComputeGaussLegendre(n, nodes, weights);
  FigureTable table{ name, { "u", "v", "weight" }, {} };
  for (int row = 0; row < grid.GetNumberOfRows(); ++row)
  {
    for (int column = 0; column < grid.GetNumberOfColumns(); ++column)
    {
      for (int i = 0; i < n * n; ++i)
      {
        const double u = grid.U[column] + nodes[i % n] * (grid.U[column + 1] - grid.U[column]);
        const double v = grid.V[row] + nodes[i / n] * (grid.V[row + 1] - grid.V[row]);
        table.Rows.push_back(
          { FormatNumber(u), FormatNumber(v), FormatNumber(4.0 * weights[i % n] * weights[i / n]) });
      }
    }
  }
  return table;
}

FigureTable MakeTexels(const TexturePoints& texture)
{
  FigureTable table{ "fig6", { "u", "v", "in_face" }, {} };
  for (std::size_t i = 0; i < texture.Inside.size(); ++i)
  {
    table.Rows.push_back({ FormatNumber(texture.U[i % texture.U.size()]),
      FormatNumber(texture.V[i / texture.U.size()]), texture.Inside[i] ? "1" : "0" });
  }
  return table;
}

FigureTable MakeTrimCurves(const sm::Face& face)
{
  FigureTable table{ "fig6_curves", { "loop", "u", "v" }, {} };
  const sm::TrimPolygons polygons = sm::FlattenLoops(face, { 1e-3, 1e-3 });
  for (std::size_t number = 0; number < polygons.Loops.size(); ++number)
  {
    const auto& loop = polygons.Loops[number];
    for (std::size_t i = 0; i <= loop.size(); ++i)
    {
      const auto& point = loop[i % loop.size()];
      table.Rows.push_back({ std::to_string(number), FormatNumber(point[0]), FormatNumber(point[1]) });
    }
  }
  return table;
}
}

std::vector<FigureTable> MakePointTables()
{
  const PaperSolid patch = MakeTrimmedPatch();
  const sm::FacePointer face = patch.DataSet->GetModel()->GetFaces().front();
  const int factor = 2;
  const TexturePoints texture = PaperFilter(patch.DataSet).MakeTexture(factor, 4);
  if (texture.Inside.empty())
  {
    return {};
  }
  const sm::SubPatchGrid subPatch{ { 0.0, 1.0 }, { 0.0, 1.0 } };
  const sm::SubPatchGrid knots{ { 0.0, 0.25, 0.5, 0.75, 1.0 }, { 0.0, 0.2, 0.4, 0.6, 0.8, 1.0 } };
  return { MakeQuadraturePoints("fig3", subPatch, 2), MakeQuadraturePoints("fig4", knots, 2),
    MakeQuadraturePoints("fig5", subPatch, 3), MakeTexels(texture),
    MakeQuadraturePoints("fig6_points", sm::MakeSubPatchGrid(face->Surface, factor), 2),
    MakeTrimCurves(*face) };
}
}
