#include "Detail/smVariantChain.h"

#include "Detail/smVariantOrders.h"
#include "smTrimCutting.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace sm
{
namespace
{
// Largest ratio of a cell's weights in a direction. In narrower cells ellipses without a zero of the weight
// are larger.
constexpr double MaxWeightRatio = 1.5;
constexpr int MaxCellsOfSpan = 16;

/// Inserts a knot inside a span (Boehm).
void InsertKnot(NURBSSurface& surface, int direction, double knot)
{
  std::vector<double>& knots = surface.Knots[direction];
  const int p = surface.Degree[direction];
  const auto span = static_cast<int>(std::upper_bound(knots.begin(), knots.end(), knot) - knots.begin()) - 1;
  const int count[2] = { surface.NumberOfControlPoints[0], surface.NumberOfControlPoints[1] };
  const std::vector<std::array<double, 4>> old = std::move(surface.ControlPoints);
  ++surface.NumberOfControlPoints[direction];
  surface.ControlPoints.resize(
    static_cast<std::size_t>(surface.NumberOfControlPoints[0]) * surface.NumberOfControlPoints[1]);
  for (int j = 0; j < surface.NumberOfControlPoints[1]; ++j)
  {
    for (int i = 0; i < surface.NumberOfControlPoints[0]; ++i)
    {
      const int index = direction == 0 ? i : j;
      const double share = index <= span - p ? 1.0
        : index > span                       ? 0.0
                                             : (knot - knots[index]) / (knots[index + p] - knots[index]);
      const auto get = [&](int at) -> const std::array<double, 4>&
      {
        return direction == 0 ? old[at + static_cast<std::size_t>(j) * count[0]]
                              : old[i + static_cast<std::size_t>(at) * count[0]];
      };
      std::array<double, 4>& point =
        surface.ControlPoints[i + static_cast<std::size_t>(j) * surface.NumberOfControlPoints[0]];
      for (int c = 0; c < 4; ++c)
      {
        point[c] = share == 1.0 ? get(index)[c]
          : share == 0.0        ? get(index - 1)[c]
                                : share * get(index)[c] + (1.0 - share) * get(index - 1)[c];
      }
    }
  }
  knots.insert(knots.begin() + span + 1, knot);
}

/// The largest ratio of weights along a direction in the span that begins at this knot.
double GetWeightRatio(const NURBSSurface& surface, int direction, int span)
{
  const int p = surface.Degree[direction];
  double ratio = 1.0;
  for (int line = 0; line < surface.NumberOfControlPoints[1 - direction]; ++line)
  {
    double low = std::numeric_limits<double>::max();
    double high = 0.0;
    for (int k = span - p; k <= span; ++k)
    {
      const std::size_t at = direction == 0
        ? k + static_cast<std::size_t>(line) * surface.NumberOfControlPoints[0]
        : line + static_cast<std::size_t>(k) * surface.NumberOfControlPoints[0];
      low = std::min(low, surface.ControlPoints[at][3]);
      high = std::max(high, surface.ControlPoints[at][3]);
    }
    ratio = std::max(ratio, high / low);
  }
  return ratio;
}

/// Divides spans where weights differ much: for the cells alone, whose patches come from the surface itself.
NURBSSurface DivideSpans(NURBSSurface surface)
{
  for (int direction = 0; direction < 2; ++direction)
  {
    std::vector<double> inserted;
    const std::vector<double>& knots = surface.Knots[direction];
    for (int k = surface.Degree[direction]; k < surface.NumberOfControlPoints[direction]; ++k)
    {
      const double ratio = knots[k + 1] > knots[k] ? GetWeightRatio(surface, direction, k) : 1.0;
      const int cells = static_cast<int>(
        std::min(std::ceil(std::log(ratio) / std::log(MaxWeightRatio) - 1e-9), double{ MaxCellsOfSpan }));
      for (int i = 1; i < cells; ++i)
      {
        inserted.push_back(knots[k] + (knots[k + 1] - knots[k]) * i / cells);
      }
    }
    for (const double knot : inserted)
    {
      InsertKnot(surface, direction, knot);
    }
  }
  return surface;
}

/// A vector for each variable, [variable].
using MotionVectors = std::vector<std::array<double, 3>>;

class ChainMaker
{
public:
  ChainMaker(const VariantShape& shape, std::size_t face, const VariantChainOptions& options)
    : Shape(shape)
    , Source(shape.GetFaces()[face])
    , Options(options)
  {
  }
  VariantFaceChain Make();

private:
  const VariantEdge& GetEdge(const Coedge& coedge) const { return *this->Shape.FindEdge(coedge.Use.get()); }
  void FindDirections();
  Face MakeDividedFace() const;
  NURBSSurface MakeSurface(int variable) const;
  void AddPatches();
  std::uint32_t AddTrim(const double* pairs, int degree, const Patch& patch);
  std::uint32_t AddEdge(const VariantEdge& edge, int piece, const VariantPatch& patch);
  std::uint32_t AddVertex(const MotionVectors& vertex, const VariantPatch& patch);
  void PlanPanels(VariantOrders& orders);
  void PlanRibbons(VariantOrders& orders);
  void AddCorners();
  /// The corner between two coedges: caps, and ribbons along the straight piece in (u,v) that joins them.
  void AddCorner(const Coedge& before, const Coedge& after);
  void AddOpenCorner(const MotionVectors& vertex, const MotionVectors& next, const MotionVectors& curveStart);
  void AddCap(const MotionVectors& apex, const MotionVectors& from, const MotionVectors& to);
  MotionVectors GetVertex(const Coedge& coedge, bool atEnd) const;
  MotionVectors GetCurveEnd(const Coedge& coedge, bool atEnd) const;
  MotionVectors GetSurfacePoint(const std::array<double, 2>& uv) const;
  std::array<double, 2> Transpose(const std::array<double, 2>& uv) const
  {
    return this->IsTransposed ? std::array<double, 2>{ uv[1], uv[0] } : uv;
  }
  std::uint32_t GetPatch(int column, int row) const;

  const VariantShape& Shape;
  const VariantFace& Source;
  const VariantChainOptions& Options;
  bool IsTransposed = false;
  CellGrid Grid;
  FacePanels Panels;
  std::map<std::pair<int, int>, std::uint32_t> PatchOfCell;
  /// Centres of the base's patches, in the coordinates of the faces.
  std::vector<std::array<double, 3>> BaseCenters;
  /// Ribbons at corners, with the (u, v) pairs of their straight pieces.
  struct CornerRibbon
  {
    VariantRibbon Ribbon;
    std::array<double, 4> Line;
  };
  std::vector<CornerRibbon> CornerRibbons;
  VariantFaceChain Result;
};

void ChainMaker::FindDirections()
{
  std::vector<int>& directions = this->Result.Directions;
  for (const auto& [direction, net] : this->Source.Displacements)
  {
    directions.push_back(direction);
  }
  for (const Loop& loop : this->Source.Source->Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      for (const auto& [direction, points] : this->GetEdge(coedge).Displacements)
      {
        directions.push_back(direction);
      }
    }
  }
  std::sort(directions.begin(), directions.end());
  directions.erase(std::unique(directions.begin(), directions.end()), directions.end());
}

/// The face with divided spans and the divided curves of its edges: its panels and ribbons end where these
/// do.
Face ChainMaker::MakeDividedFace() const
{
  Face face = *this->Source.Source;
  face.Surface = DivideSpans(face.Surface);
  std::map<const Edge*, std::shared_ptr<const Edge>> divided;
  for (Loop& loop : face.Loops)
  {
    for (Coedge& coedge : loop.Coedges)
    {
      std::shared_ptr<const Edge>& edge = divided[coedge.Use.get()];
      if (!edge)
      {
        auto copy = std::make_shared<Edge>(*coedge.Use);
        copy->Curve = this->GetEdge(coedge).Curve;
        edge = copy;
      }
      coedge.Use = edge;
    }
  }
  return face;
}

NURBSSurface ChainMaker::MakeSurface(int variable) const
{
  NURBSSurface surface = this->Source.Source->Surface;
  if (variable > 0)
  {
    const auto found = this->Source.Displacements.find(this->Result.Directions[variable - 1]);
    for (std::size_t i = 0; i < surface.ControlPoints.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        surface.ControlPoints[i][c] = found == this->Source.Displacements.end() ? 0.0 : found->second[i][c];
      }
    }
  }
  return this->IsTransposed ? surface.Transposed() : surface;
}

void ChainMaker::AddPatches()
{
  const std::size_t count = this->Panels.Patches.size();
  this->Result.Patches.resize(count);
  std::vector<std::pair<int, int>> cells(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Patch& patch = this->Panels.Patches[i];
    cells[i] = { CellGrid::Find(this->Grid.U, patch.Start[0] + 0.5 * patch.Width[0]),
      CellGrid::Find(this->Grid.V, patch.Start[1] + 0.5 * patch.Width[1]) };
    this->PatchOfCell[cells[i]] = static_cast<std::uint32_t>(i);
  }
  for (int a = 0; a < this->Result.GetNumberOfVariables(); ++a)
  {
    const NURBSSurface surface = this->MakeSurface(a);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto [column, row] = cells[i];
      std::vector<std::array<double, 4>> points;
      const Patch patch = MakePatch(surface, this->Grid.U[column], this->Grid.U[column + 1],
        this->Grid.V[row], this->Grid.V[row + 1], points);
      std::array<double, 3> center{ patch.Center[0], patch.Center[1], patch.Center[2] };
      double error = 0.0;
      if (a == 0)
      {
        this->BaseCenters.push_back(center);
        for (int c = 0; c < 3; ++c)
        {
          center[c] -= this->Options.Reference[c];
          error = std::max(error, UnitRoundoff * std::abs(center[c]));
        }
      }
      this->Result.Patches[i].AddVariable(patch, points.data(), center, error);
    }
  }
  for (VariantPatch& patch : this->Result.Patches)
  {
    patch.Finish();
  }
}

std::uint32_t ChainMaker::GetPatch(int column, int row) const
{
  const auto found = this->PatchOfCell.find({ column, row });
  if (found == this->PatchOfCell.end())
  {
    throw std::runtime_error("a corner lies in a cell without panels");
  }
  return found->second;
}

std::uint32_t ChainMaker::AddTrim(const double* pairs, int degree, const Patch& patch)
{
  const auto first = static_cast<std::uint32_t>(this->Result.Coefficients.size());
  for (int i = 0; i <= degree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      this->Result.Coefficients.push_back((pairs[2 * i + d] - patch.Start[d]) / patch.Width[d]);
    }
  }
  return first;
}

std::uint32_t ChainMaker::AddEdge(const VariantEdge& edge, int piece, const VariantPatch& patch)
{
  const auto first = static_cast<std::uint32_t>(this->Result.Coefficients.size());
  const std::size_t from = edge.Curve.Offsets[piece];
  const std::size_t to = edge.Curve.Offsets[piece + 1];
  for (int a = 0; a < this->Result.GetNumberOfVariables(); ++a)
  {
    const auto found =
      a == 0 ? edge.Displacements.end() : edge.Displacements.find(this->Result.Directions[a - 1]);
    for (std::size_t i = from; i < to; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double center =
          a == 0 ? this->BaseCenters[&patch - this->Result.Patches.data()][c] : patch.Centers[a][c];
        const double value = a == 0           ? edge.Curve.Coefficients[i][c]
          : found == edge.Displacements.end() ? 0.0
                                              : found->second[i][c];
        this->Result.Coefficients.push_back(value - center);
      }
    }
  }
  return first;
}

std::uint32_t ChainMaker::AddVertex(const MotionVectors& vertex, const VariantPatch& patch)
{
  const auto first = static_cast<std::uint32_t>(this->Result.Coefficients.size());
  for (int a = 0; a < this->Result.GetNumberOfVariables(); ++a)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Result.Coefficients.push_back(vertex[a][c] - patch.Centers[a][c]);
    }
  }
  return first;
}

MotionVectors ChainMaker::GetVertex(const Coedge& coedge, bool atEnd) const
{
  const VariantEdge& edge = this->GetEdge(coedge);
  const bool isEnd = atEnd != coedge.Reversed;
  MotionVectors vertex(this->Result.GetNumberOfVariables(), std::array<double, 3>{});
  for (std::size_t a = 0; a < vertex.size(); ++a)
  {
    if (a == 0)
    {
      const std::array<double, 3>& point = isEnd ? edge.Source->EndVertex : edge.Source->StartVertex;
      for (int c = 0; c < 3; ++c)
      {
        vertex[a][c] = point[c] - this->Options.Reference[c];
      }
      continue;
    }
    const auto found = edge.Vertices.find(this->Result.Directions[a - 1]);
    vertex[a] = found == edge.Vertices.end() ? std::array<double, 3>{} : found->second[isEnd ? 1 : 0];
  }
  return vertex;
}

MotionVectors ChainMaker::GetCurveEnd(const Coedge& coedge, bool atEnd) const
{
  const VariantEdge& edge = this->GetEdge(coedge);
  const bool isEnd = atEnd != coedge.Reversed;
  MotionVectors point(this->Result.GetNumberOfVariables(), std::array<double, 3>{});
  for (std::size_t a = 0; a < point.size(); ++a)
  {
    if (a == 0)
    {
      const std::array<double, 3>& end = isEnd ? edge.Curve.GetEndPoint() : edge.Curve.GetStartPoint();
      for (int c = 0; c < 3; ++c)
      {
        point[a][c] = end[c] - this->Options.Reference[c];
      }
      continue;
    }
    const auto found = edge.Displacements.find(this->Result.Directions[a - 1]);
    if (found != edge.Displacements.end())
    {
      point[a] = isEnd ? found->second.back() : found->second.front();
    }
  }
  return point;
}

MotionVectors ChainMaker::GetSurfacePoint(const std::array<double, 2>& uv) const
{
  const std::uint32_t index =
    this->GetPatch(CellGrid::Find(this->Grid.U, uv[0]), CellGrid::Find(this->Grid.V, uv[1]));
  const Patch& cell = this->Panels.Patches[index];
  const VariantPatch& patch = this->Result.Patches[index];
  PatchBasis basis;
  patch.FillBasis((uv[0] - cell.Start[0]) / cell.Width[0], (uv[1] - cell.Start[1]) / cell.Width[1], basis);
  const int variables = patch.Variables;
  std::vector<double> values[3];
  for (std::vector<double>& value : values)
  {
    value.resize(3 * static_cast<std::size_t>(variables));
  }
  patch.Sample(basis, values[0].data(), values[1].data(), values[2].data(), false);
  MotionVectors point(variables);
  for (int a = 0; a < variables; ++a)
  {
    for (int c = 0; c < 3; ++c)
    {
      point[a][c] = values[0][static_cast<std::size_t>(c) * variables + a];
    }
  }
  return point;
}

void ChainMaker::AddCap(const MotionVectors& apex, const MotionVectors& from, const MotionVectors& to)
{
  // Cones run over the loop with the sign opposite to the face's.
  VariantCap cap;
  cap.Sign = this->Source.Source->Reversed ? 1.0 : -1.0;
  const MotionVectors* corners[3] = { &apex, &from, &to };
  for (int k = 0; k < 3; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (const std::array<double, 3>& vector : *corners[k])
      {
        cap.Corners[k][c].push_back(vector[c]);
      }
    }
  }
  this->Result.Caps.push_back(std::move(cap));
}

/// Edges that do not meet leave a hole, see AddOpenCorners() in smQuadraturePlan.cxx: its area is at most 4
/// times the square of the face's side.
void ChainMaker::AddOpenCorner(
  const MotionVectors& vertex, const MotionVectors& next, const MotionVectors& curveStart)
{
  if (vertex == next)
  {
    return;
  }
  VariantError hole;
  hole.ValueFactor = 1.0;
  hole.Forms = TangentForms<ErrorBound>(vertex.size());
  for (std::size_t a = 0; a < vertex.size(); ++a)
  {
    double side = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      side += std::abs(curveStart[a][c] - vertex[a][c]) + std::abs(next[a][c] - curveStart[a][c]);
    }
    for (int c = 0; c < 3; ++c)
    {
      // The normal's bounds are twice the product of both tangents'.
      hole.Forms.Position[c][a].Value = std::abs(vertex[a][c]) + side;
      hole.Forms.First[c][a].Value = hole.Forms.Second[c][a].Value = 1.4142135623731 * side;
    }
  }
  this->Result.Errors.push_back(std::move(hole));
}

void ChainMaker::AddCorner(const Coedge& before, const Coedge& after)
{
  const auto from =
    this->Transpose(before.Reversed ? before.Curve.GetStartPoint() : before.Curve.GetEndPoint());
  auto to = this->Transpose(after.Reversed ? after.Curve.GetEndPoint() : after.Curve.GetStartPoint());
  const bool isJoined = this->Grid.AreSame(from, to);
  to = isJoined ? from : to;
  const MotionVectors vertex = this->GetVertex(before, true);
  const MotionVectors curveStart = this->GetCurveEnd(after, false);
  this->AddOpenCorner(vertex, this->GetVertex(after, false), curveStart);
  this->AddCap(vertex, this->GetCurveEnd(before, true), this->GetSurfacePoint(from));
  this->AddCap(vertex, this->GetSurfacePoint(to), curveStart);
  if (isJoined)
  {
    return;
  }
  const std::array<double, 2> line[2] = { from, to };
  std::vector<TrimSegment> segments;
  CutAtKnotLines({ line, 1 }, this->Grid, segments);
  for (const TrimSegment& segment : segments)
  {
    VariantRibbon ribbon{};
    ribbon.Patch = this->GetPatch(segment.Column, segment.Row);
    ribbon.Trim = this->AddTrim(line[0].data(), 1, this->Panels.Patches[ribbon.Patch]);
    ribbon.TrimDegree = 1;
    ribbon.Start = segment.Start;
    ribbon.End = segment.End;
    ribbon.Edge = this->AddVertex(vertex, this->Result.Patches[ribbon.Patch]);
    ribbon.EdgeEnd = 1.0;
    ribbon.Sign = this->Source.Source->Reversed ? -1.0 : 1.0;
    ribbon.Coedge = -1;
    this->CornerRibbons.push_back({ ribbon, { from[0], from[1], to[0], to[1] } });
  }
}

void ChainMaker::PlanPanels(VariantOrders& orders)
{
  for (const Panel& panel : this->Panels.Panels)
  {
    const double* trim = this->Panels.Coefficients.data() + panel.Trim;
    VariantPanel planned{};
    planned.Patch = panel.Patch;
    planned.Trim = this->AddTrim(trim, panel.TrimDegree, this->Panels.Patches[panel.Patch]);
    planned.TrimDegree = panel.TrimDegree;
    planned.Start = panel.Start;
    planned.End = panel.End;
    planned.AcrossEnd = 1.0;
    planned.Sign = panel.Negative != panel.FlipNormal ? -1.0 : 1.0;
    orders.AddPanel(planned, trim);
  }
}

void ChainMaker::PlanRibbons(VariantOrders& orders)
{
  std::vector<const Coedge*> coedges;
  for (const Loop& loop : this->Source.Source->Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      coedges.push_back(&coedge);
    }
  }
  for (const Ribbon& ribbon : this->Panels.Ribbons)
  {
    // Corners are added by themselves: what is negligible for the base may not be for a variant.
    if (ribbon.Coedge < 0)
    {
      continue;
    }
    const Coedge& coedge = *coedges[ribbon.Coedge];
    const TrimCurve& curve = coedge.Curve;
    const double start = curve.Breaks[ribbon.Piece];
    const double width = curve.Breaks[ribbon.Piece + 1] - start;
    const VariantEdge& edge = this->GetEdge(coedge);
    const int piece = FindEdgePiece(edge.Curve, ribbon, start, width);
    const double* trim = this->Panels.Coefficients.data() + ribbon.Trim;
    const VariantPatch& patch = this->Result.Patches[ribbon.Patch];
    VariantRibbon planned{};
    planned.Patch = ribbon.Patch;
    planned.Trim = this->AddTrim(trim, ribbon.TrimDegree, this->Panels.Patches[ribbon.Patch]);
    planned.TrimDegree = ribbon.TrimDegree;
    planned.Start = ribbon.Start;
    planned.End = ribbon.End;
    planned.Edge = this->AddEdge(edge, piece, patch);
    planned.EdgeDegree = edge.Curve.GetDegree(piece);
    planned.EdgeStart = ribbon.EdgeStart;
    planned.EdgeEnd = ribbon.EdgeEnd;
    planned.Sign = ribbon.FlipNormal ? -1.0 : 1.0;
    planned.Coedge = ribbon.Coedge;
    orders.AddRibbon(planned, trim);
  }
}

void ChainMaker::AddCorners()
{
  for (const Loop& loop : this->Source.Source->Loops)
  {
    const std::size_t count = loop.Coedges.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      this->AddCorner(loop.Coedges[(i + count - 1) % count], loop.Coedges[i]);
    }
  }
}

VariantFaceChain ChainMaker::Make()
{
  this->FindDirections();
  this->Panels = BuildFacePanels(this->MakeDividedFace());
  if (this->Panels.AreTrimsMoved)
  {
    throw std::runtime_error("its trim curves lead where its weights may vanish");
  }
  const NURBSSurface& base = this->Source.Source->Surface;
  this->IsTransposed = base.Degree[0] > base.Degree[1];
  const NURBSSurface divided = DivideSpans(base);
  const NURBSSurface surface = this->IsTransposed ? divided.Transposed() : divided;
  this->Grid = { surface.GetSpanBreaks(0), surface.GetSpanBreaks(1) };
  this->AddPatches();
  this->AddCorners();
  VariantOrders orders(this->Result, this->Panels.Patches, this->Options);
  for (const Panel& panel : this->Panels.Panels)
  {
    orders.Announce(
      panel.Patch, this->Panels.Coefficients.data() + panel.Trim, panel.TrimDegree, panel.Start, panel.End);
  }
  for (const Ribbon& ribbon : this->Panels.Ribbons)
  {
    orders.Announce(ribbon.Patch, this->Panels.Coefficients.data() + ribbon.Trim, ribbon.TrimDegree,
      ribbon.Start, ribbon.End);
  }
  for (const CornerRibbon& corner : this->CornerRibbons)
  {
    orders.Announce(corner.Ribbon.Patch, corner.Line.data(), 1, corner.Ribbon.Start, corner.Ribbon.End);
  }
  this->PlanPanels(orders);
  this->PlanRibbons(orders);
  for (const CornerRibbon& corner : this->CornerRibbons)
  {
    orders.AddRibbon(corner.Ribbon, corner.Line.data());
  }
  orders.Finish();
  return std::move(this->Result);
}

}

VariantFaceChain MakeFaceChain(
  const VariantShape& shape, std::size_t face, const VariantChainOptions& options)
{
  return ChainMaker(shape, face, options).Make();
}
}
