#include "smPointFigures.h"

#include "smGaussLegendre.h"
#include "smPaperRun.h"
#include "smPaperSolid.h"

#include <Detail/smSubPatches.h>
#include <smFormat.h>
#include <smTrimPolygons.h>
#include <vtkTrimmedNURBSModel.h>

#include <cmath>

namespace smfigure
{
namespace
{
/// The grey of the borders of sub-patches.
constexpr unsigned char GridGrey = 165;

using Ticks = std::vector<std::pair<double, std::string>>;

/// Makes ticks with grid lines at the borders of sub-patches; every `step`-th has a label.
Ticks MakeBorderTicks(const std::vector<double>& borders, int step)
{
  Ticks ticks;
  for (std::size_t i = 0; i < borders.size(); ++i)
  {
    ticks.emplace_back(borders[i], i % step == 0 ? sm::FormatDigits(borders[i], 3) : "");
  }
  return ticks;
}

FigureTable MakePointTable(const std::vector<double>& weights, const Series& points)
{
  FigureTable table;
  table.Columns = { "u", "v", "weight" };
  for (std::size_t i = 0; i < points.X.size(); ++i)
  {
    table.Rows.push_back({ FormatNumber(points.X[i]), FormatNumber(points.Y[i]), FormatNumber(weights[i]) });
  }
  return table;
}

/// Makes a series of the n x n points of every sub-patch of the grid.
Series MakeQuadraturePoints(const sm::SubPatchGrid& grid, int n)
{
  std::vector<double> nodes;
  std::vector<double> weights;
  sm::ComputeGaussLegendre(n, nodes, weights);
  Series points;
  for (int row = 0; row < grid.GetNumberOfRows(); ++row)
  {
    for (int column = 0; column < grid.GetNumberOfColumns(); ++column)
    {
      for (int i = 0; i < n * n; ++i)
      {
        points.X.push_back(grid.U[column] + nodes[i % n] * (grid.U[column + 1] - grid.U[column]));
        points.Y.push_back(grid.V[row] + nodes[i / n] * (grid.V[row + 1] - grid.V[row]));
      }
    }
  }
  points.Hue = colors::Vermillion;
  points.Symbol = Marker::Circle;
  return points;
}

/// Makes a figure of a square sub-patch, with the positions of the points below and to the left, and the
/// intervals between them above and to the right.
Figure MakeSubPatchFigure(const std::string& name, int n)
{
  Figure figure;
  figure.Name = name;
  figure.Width = figure.Height = 620;
  figure.Left = 95.0f;
  figure.Right = 65.0f;
  figure.AboveAndBelow = 80.0f;
  std::vector<double> nodes;
  std::vector<double> weights;
  sm::ComputeGaussLegendre(n, nodes, weights);
  nodes.insert(nodes.begin(), 0.0);
  nodes.push_back(1.0);
  for (FigureAxis* axis : { &figure.X, &figure.Y })
  {
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      axis->Ticks.emplace_back(nodes[i], sm::FormatDigits(nodes[i], 3));
      if (i > 0)
      {
        axis->OppositeTicks.emplace_back(
          0.5 * (nodes[i - 1] + nodes[i]), sm::FormatDigits(nodes[i] - nodes[i - 1], 3));
      }
    }
    axis->Grid = true;
    axis->GridGrey = GridGrey;
  }
  figure.X.Title = "u as a fraction of the sub-patch";
  figure.Y.Title = "v as a fraction of the sub-patch";
  return figure;
}

sm::SubPatchGrid MakeUnitGrid()
{
  sm::SubPatchGrid grid;
  grid.U = grid.V = { 0.0, 1.0 };
  return grid;
}

/// Makes a flat bicubic patch with the given numbers of equal knot intervals over [0,1] x [0,1].
sm::NURBSSurface MakeUniformPatch(int columns, int rows)
{
  sm::NURBSSurface surface;
  const int intervals[2] = { columns, rows };
  for (int d = 0; d < 2; ++d)
  {
    surface.Degree[d] = 3;
    surface.NumberOfControlPoints[d] = intervals[d] + 3;
    surface.Knots[d].assign(4, 0.0);
    for (int i = 1; i < intervals[d]; ++i)
    {
      surface.Knots[d].push_back(static_cast<double>(i) / intervals[d]);
    }
    surface.Knots[d].insert(surface.Knots[d].end(), 4, 1.0);
  }
  for (int i = 0; i < (columns + 3) * (rows + 3); ++i)
  {
    surface.ControlPoints.push_back({ 1.0 * (i % (columns + 3)), 1.0 * (i / (columns + 3)), 0.0, 1.0 });
  }
  return surface;
}

void AddTexels(const TexturePoints& texture, Figure& figure)
{
  Series inside;
  inside.Label = "trim texture 1: in the face";
  inside.Hue = colors::SkyBlue;
  inside.Symbol = Marker::Square;
  inside.MarkerSize = 7.0f;
  Series outside = inside;
  outside.Label = "trim texture 0: trimmed away";
  outside.Hue = colors::LightGrey;
  figure.Table.Columns = { "u", "v", "in_face" };
  for (std::size_t i = 0; i < texture.Inside.size(); ++i)
  {
    const double u = texture.U[i % texture.U.size()];
    const double v = texture.V[i / texture.U.size()];
    Series& series = texture.Inside[i] ? inside : outside;
    series.X.push_back(u);
    series.Y.push_back(v);
    figure.Table.Rows.push_back({ FormatNumber(u), FormatNumber(v), texture.Inside[i] ? "1" : "0" });
  }
  figure.Content.push_back(inside);
  figure.Content.push_back(outside);
}

void AddTrimCurves(const sm::Face& face, Figure& figure)
{
  const sm::TrimPolygons polygons = sm::FlattenLoops(face, { 1e-3, 1e-3 });
  for (const auto& loop : polygons.Loops)
  {
    Series line;
    line.Label = &loop == &polygons.Loops.front() ? "trim curves" : "";
    line.LineWidth = 2.0f;
    for (std::size_t i = 0; i <= loop.size(); ++i)
    {
      line.X.push_back(loop[i % loop.size()][0]);
      line.Y.push_back(loop[i % loop.size()][1]);
    }
    figure.Content.push_back(line);
  }
}
}

Figure MakeFigure3()
{
  Figure figure = MakeSubPatchFigure("fig3", 2);
  Series points = MakeQuadraturePoints(MakeUnitGrid(), 2);
  points.MarkerSize = 16.0f;
  points.Label = "2 x 2 Gauss points, each of weight 1";
  figure.LegendColumns = 1;
  figure.Table = MakePointTable({ 1.0, 1.0, 1.0, 1.0 }, points);
  figure.Content.push_back(points);
  return figure;
}

Figure MakeFigure4()
{
  Figure figure;
  figure.Name = "fig4";
  figure.TitleLeft = 55.0f;
  figure.Width = 580;
  figure.Height = 710;
  figure.Left = 97.0f;
  figure.Right = 35.0f;
  figure.AboveAndBelow = 75.0f;
  const sm::SubPatchGrid grid = sm::MakeSubPatchGrid(MakeUniformPatch(4, 5), 1);
  figure.X.Title = "u";
  figure.Y.Title = "v";
  figure.X.Ticks = MakeBorderTicks(grid.U, 1);
  figure.Y.Ticks = MakeBorderTicks(grid.V, 1);
  figure.X.Grid = figure.Y.Grid = true;
  figure.X.GridGrey = figure.Y.GridGrey = GridGrey;
  Series points = MakeQuadraturePoints(grid, 2);
  points.Label = "2 x 2 Gauss points of every sub-patch";
  figure.LegendColumns = 1;
  figure.Table = MakePointTable(std::vector<double>(points.X.size(), 1.0), points);
  figure.Content.push_back(points);
  return figure;
}

Figure MakeFigure5()
{
  Figure figure = MakeSubPatchFigure("fig5", 3);
  const Series points = MakeQuadraturePoints(MakeUnitGrid(), 3);
  // The weights of a square of area 4, as in the paper: products of 5/9, 8/9, 5/9.
  const double rule[3] = { 5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0 };
  std::vector<double> weights;
  for (int i = 0; i < 9; ++i)
  {
    weights.push_back(rule[i % 3] * rule[i / 3]);
  }
  figure.Table = MakePointTable(weights, points);
  const std::pair<const char*, Color> kinds[3] = { { "weight 64/81", colors::Vermillion },
    { "weight 40/81", colors::Blue }, { "weight 25/81", colors::Green } };
  const double values[3] = { 64.0 / 81.0, 40.0 / 81.0, 25.0 / 81.0 };
  for (int kind = 0; kind < 3; ++kind)
  {
    Series series;
    series.Hue = kinds[kind].second;
    series.Symbol = Marker::Circle;
    series.MarkerSize = static_cast<float>(30.0 * std::sqrt(values[kind]));
    series.Label = kinds[kind].first;
    for (int i = 0; i < 9; ++i)
    {
      if (std::abs(weights[i] - values[kind]) < 1e-9)
      {
        series.X.push_back(points.X[i]);
        series.Y.push_back(points.Y[i]);
      }
    }
    figure.Content.push_back(series);
  }
  figure.LegendColumns = 3;
  return figure;
}

std::string MakeFigure6(Figure& figure)
{
  const PaperSolid patch = MakeTrimmedPatch();
  const sm::FacePointer face = patch.DataSet->GetModel()->GetFaces().front();
  const int factor = 2;
  const sm::SubPatchGrid grid = sm::MakeSubPatchGrid(face->Surface, factor);
  const TexturePoints texture = PaperFilter(patch.DataSet).MakeTexture(factor, 4);
  if (texture.Inside.empty())
  {
    return "the filter gave no trim texture";
  }
  figure.Name = "fig6";
  figure.TitleLeft = 40.0f;
  figure.Width = 900;
  figure.Height = 750;
  figure.Left = 85.0f;
  figure.Right = 27.0f;
  figure.X.Title = "u";
  figure.Y.Title = "v";
  figure.X.Maximum = grid.U.back();
  figure.Y.Maximum = grid.V.back();
  figure.X.Ticks = MakeBorderTicks(grid.U, factor);
  figure.Y.Ticks = MakeBorderTicks(grid.V, factor);
  figure.X.Grid = figure.Y.Grid = true;
  figure.X.GridGrey = figure.Y.GridGrey = GridGrey;
  AddTexels(texture, figure);
  Series points = MakeQuadraturePoints(grid, 2);
  points.Label = "2 x 2 Gauss points of a sub-patch";
  figure.Content.push_back(points);
  AddTrimCurves(*face, figure);
  figure.LegendColumns = 2;
  return "";
}
}
