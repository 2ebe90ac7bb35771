#include "smFacePanels.h"

#include "Detail/smCoverage.h"
#include "Detail/smLoopCrossings.h"
#include "smPatchParts.h"
#include "smTrimCutting.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace sm
{
namespace
{
// Corners and ribbons whose gap is below this fraction of the coordinates' size are left out: their integrals
// are of the order of its square, far below rounding.
constexpr double NegligibleGap = 1e-14;

class Builder
{
public:
  explicit Builder(const Face& face);
  FacePanels Build();

private:
  std::uint32_t GetPatch(int column, int row);
  Point3 EvaluatePatch(const Patch& patch, const Point2& uv) const;
  PanelShape Classify(const Patch& patch) const;
  std::uint32_t AddTrim(const BernsteinPiece<2>& piece);
  std::uint32_t AddEdge(const BernsteinPiece<3>& piece);

  void AddLoop(const Loop& loop);
  void AddCoedge(const Coedge& coedge, const Point2* loopStart);
  void AddRibbons(const Coedge& coedge, int piece, std::uint32_t trim, const TrimSegment& segment);
  void AddPanel(
    const TrimSegment& segment, const BernsteinPiece<2>& piece, std::uint32_t trim, bool reversed);
  void AddCorner(const Coedge& before, const Coedge& after, const Point2& from, const Point2& to);
  void AddCap(const Point3& apex, const Point3& from, const Point3& to);
  void AddCoveredEdges();
  Point2 Transpose(const Point2& uv) const { return this->Transposed ? Point2{ uv[1], uv[0] } : uv; }

  const Face& Source;
  NURBSSurface Surface;
  /// u and v are exchanged.
  bool Transposed;
  CellGrid Grid;
  Coverage Cover;
  double Size = 0.0;
  std::map<std::pair<int, int>, std::uint32_t> PatchOfCell;
  std::vector<PanelShape> ShapeOfPatch;
  std::map<const void*, std::uint32_t> EdgePieces;
  /// Index of the coedge that is cut now, counted through all loops.
  int CoedgeIndex = 0;
  FacePanels Result;
};

Builder::Builder(const Face& face)
  : Source(face)
  , Surface(face.Surface.Degree[0] > face.Surface.Degree[1] ? face.Surface.Transposed() : face.Surface)
  , Transposed(face.Surface.Degree[0] > face.Surface.Degree[1])
  , Grid{ this->Surface.GetSpanBreaks(0), this->Surface.GetSpanBreaks(1) }
  , Cover(this->Grid.GetNumberOfColumns(), this->Grid.GetNumberOfRows())
{
  for (const std::array<double, 4>& p : this->Surface.ControlPoints)
  {
    this->Size =
      std::max({ this->Size, std::abs(p[0] / p[3]), std::abs(p[1] / p[3]), std::abs(p[2] / p[3]) });
  }
}

std::uint32_t Builder::GetPatch(int column, int row)
{
  const auto [entry, isNew] = this->PatchOfCell.emplace(
    std::make_pair(column, row), static_cast<std::uint32_t>(this->Result.Patches.size()));
  if (!isNew)
  {
    return entry->second;
  }
  Patch patch = MakePatch(this->Surface, this->Grid.U[column], this->Grid.U[column + 1], this->Grid.V[row],
    this->Grid.V[row + 1], this->Result.Points);
  patch.Exchanged = this->Transposed;
  this->Result.Patches.push_back(patch);
  this->ShapeOfPatch.push_back(this->Classify(patch));
  return entry->second;
}

PanelShape Builder::Classify(const Patch& patch) const
{
  // Straight in s with weights that do not depend on s: S = A(r) + s B(r), so that n = B x (A' + s B').
  // The normal keeps its direction along s iff n at s = 0 and s = 1 are parallel for every r, which is det(B,
  // S0', S1') = 0: of degree q + 2 (2q - 2) in r over weights. Rounding leaves 1e-13, of which only the
  // square matters (Bounds.md). Equal steps multiply it by less than 1e5 in between up to q = 5; Chebyshev's
  // nodes by 5.
  if (patch.Degree[0] != 1)
  {
    return PanelShape::General;
  }
  const int q = patch.Degree[1];
  const std::array<double, 4>* cell = this->Result.Points.data() + patch.FirstPoint;
  bool polynomial = true;
  for (int j = 0; j <= q; ++j)
  {
    if (cell[2 * j][3] != cell[2 * j + 1][3])
    {
      return PanelShape::General;
    }
    polynomial = polynomial && cell[2 * j][3] == cell[0][3];
  }
  bool constant = true;
  Point3 first{};
  bool flat = q == 1 && polynomial;
  const int steps = q <= 5 ? 4 * q : 5 * q - 4;
  for (int k = 0; k <= steps; ++k)
  {
    const double step = static_cast<double>(k) / steps;
    const double r = q <= 5 ? step : 0.5 - 0.5 * std::cos(M_PI * step);
    std::array<double, 4> line[2][MaximumDegree + 1] = {};
    Point3 position[2];
    Point3 derivative[2];
    for (int side = 0; side < 2; ++side)
    {
      for (int j = 0; j <= q; ++j)
      {
        line[side][j] = cell[2 * j + side];
      }
      std::array<double, 4> dr;
      const std::array<double, 4> h = BernsteinPiece<4>{ line[side], q }.Evaluate(r, &dr);
      for (int c = 0; c < 3; ++c)
      {
        position[side][c] = h[c] / h[3];
        derivative[side][c] = (dr[c] - position[side][c] * dr[3]) / h[3];
      }
    }
    const Point3 ruling = Subtract(position[1], position[0]);
    const Point3 n0 = Cross(ruling, derivative[0]);
    const Point3 n1 = Cross(ruling, derivative[1]);
    const double scale = std::max(Norm(n0), Norm(n1));
    if (Norm(Cross(n0, n1)) > 1e-13 * scale * scale || n0[0] * n1[0] + n0[1] * n1[1] + n0[2] * n1[2] < 0.0)
    {
      return PanelShape::General;
    }
    constant = constant && Norm(Subtract(n0, n1)) <= 1e-14 * scale;
    if (k == 0)
    {
      first = n0;
    }
    flat = flat && constant && Norm(Subtract(n0, first)) <= 1e-14 * scale;
  }
  return flat ? PanelShape::Flat : constant ? PanelShape::Prismatic : PanelShape::Straight;
}

Point3 Builder::EvaluatePatch(const Patch& patch, const Point2& uv) const
{
  const double s = (uv[0] - patch.Start[0]) / patch.Width[0];
  const double r = (uv[1] - patch.Start[1]) / patch.Width[1];
  const int p = patch.Degree[0];
  std::array<double, 4> line[MaximumDegree + 1] = {};
  for (int j = 0; j <= patch.Degree[1]; ++j)
  {
    line[j] = BernsteinPiece<4>{ this->Result.Points.data() + patch.FirstPoint + j * (p + 1), p }.Evaluate(s);
  }
  const std::array<double, 4> h = BernsteinPiece<4>{ line, patch.Degree[1] }.Evaluate(r);
  return { patch.Center[0] + h[0] / h[3], patch.Center[1] + h[1] / h[3], patch.Center[2] + h[2] / h[3] };
}

std::uint32_t Builder::AddTrim(const BernsteinPiece<2>& piece)
{
  const auto first = static_cast<std::uint32_t>(this->Result.Coefficients.size());
  for (int i = 0; i <= piece.Degree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      this->Result.Coefficients.push_back(piece.Coefficients[i][d]);
      this->Result.MaxTrim[d] = std::max(this->Result.MaxTrim[d], std::abs(piece.Coefficients[i][d]));
    }
  }
  return first;
}

std::uint32_t Builder::AddEdge(const BernsteinPiece<3>& piece)
{
  const auto [entry, isNew] = this->EdgePieces.emplace(
    piece.Coefficients, static_cast<std::uint32_t>(this->Result.Coefficients.size()));
  if (isNew)
  {
    for (int i = 0; i <= piece.Degree; ++i)
    {
      this->Result.Coefficients.insert(
        this->Result.Coefficients.end(), piece.Coefficients[i].begin(), piece.Coefficients[i].end());
    }
  }
  return entry->second;
}

void Builder::AddPanel(
  const TrimSegment& segment, const BernsteinPiece<2>& piece, std::uint32_t trim, bool reversed)
{
  // In exchanged parameters a counter-clockwise loop runs clockwise.
  const bool negative = reversed != this->Transposed;
  const double start = reversed ? segment.EndPoint[1] : segment.StartPoint[1];
  const double end = reversed ? segment.StartPoint[1] : segment.EndPoint[1];
  this->Cover.AddPiece(segment.Column, segment.Row, start, end, this->Transposed ? -1 : 1);

  const double left = this->Grid.U[segment.Column];
  bool runsInV = false;
  bool leavesLeft = false;
  for (int i = 0; i <= piece.Degree; ++i)
  {
    runsInV = runsInV || piece.Coefficients[i][1] != piece.Coefficients[0][1];
    leavesLeft = leavesLeft || piece.Coefficients[i][0] != left;
  }
  const std::uint32_t patch = this->GetPatch(segment.Column, segment.Row);
  const Patch& cell = this->Result.Patches[patch];
  this->Result.Outside.Add(
    BoundOverhang(cell, this->Result.Points.data() + cell.FirstPoint, piece, segment.Start, segment.End,
      { this->Grid.U.front(), this->Grid.V.front() }, { this->Grid.U.back(), this->Grid.V.back() }));
  if (runsInV && leavesLeft)
  {
    Panel panel{ patch, trim, static_cast<std::uint8_t>(piece.Degree), this->ShapeOfPatch[patch], negative,
      this->Source.Reversed != this->Transposed, segment.Start, segment.End, false, segment.StartPoint,
      segment.EndPoint };
    if (segment.Start == segment.End)
    {
      // The piece crosses a cell that is narrower than a unit in the last place of its parameter.
      const Point2 line[2] = { segment.StartPoint, segment.EndPoint };
      panel.Trim = this->AddTrim({ line, 1 });
      panel.TrimDegree = 1;
      panel.Start = 0.0;
      panel.End = 1.0;
    }
    this->Result.Panels.push_back(panel);
  }
}

void Builder::AddRibbons(const Coedge& coedge, int piece, std::uint32_t trim, const TrimSegment& segment)
{
  const TrimCurve& curve = coedge.Curve;
  const EdgeCurve& edge = coedge.Use->Curve;
  const std::uint32_t patch = this->GetPatch(segment.Column, segment.Row);
  const double start = curve.Breaks[piece];
  const double width = curve.Breaks[piece + 1] - start;
  const double end = start + width * segment.End;
  double t = start + width * segment.Start;
  double local = segment.Start;
  int edgePiece = edge.FindPiece(t);
  while (true)
  {
    const bool last = edgePiece + 1 == edge.GetNumberOfPieces() || edge.Breaks[edgePiece + 1] >= end;
    const double next = last ? end : edge.Breaks[edgePiece + 1];
    const double nextLocal = last ? segment.End : (next - start) / width;
    if (nextLocal > local)
    {
      const double edgeStart = edge.Breaks[edgePiece];
      const double edgeWidth = edge.Breaks[edgePiece + 1] - edgeStart;
      this->Result.Ribbons.push_back({ patch, trim, this->AddEdge(edge.GetPiece(edgePiece)),
        static_cast<std::uint8_t>(curve.GetDegree(piece)),
        static_cast<std::uint8_t>(edge.GetDegree(edgePiece)), this->Source.Reversed != coedge.Reversed,
        !coedge.Use->Degenerate, local, nextLocal, (t - edgeStart) / edgeWidth,
        (next - edgeStart) / edgeWidth, this->CoedgeIndex, piece });
    }
    if (last)
    {
      return;
    }
    t = next;
    local = nextLocal;
    ++edgePiece;
  }
}

void Builder::AddCoedge(const Coedge& coedge, const Point2* loopStart)
{
  const TrimCurve& curve = coedge.Curve;
  if (curve.GetNumberOfPieces() == 0 || coedge.Use->Curve.GetNumberOfPieces() == 0)
  {
    throw std::runtime_error("a coedge has no trim curve or its edge has no curve");
  }
  for (int k = 0; k < coedge.Use->Curve.GetNumberOfPieces(); ++k)
  {
    if (coedge.Use->Curve.GetDegree(k) > MaximumDegree)
    {
      throw std::runtime_error("an edge's curve has a degree above 25");
    }
  }
  std::vector<TrimSegment> segments;
  std::vector<Point2> coefficients;
  for (int k = 0; k < curve.GetNumberOfPieces(); ++k)
  {
    const BernsteinPiece<2> source = curve.GetPiece(k);
    if (source.Degree > MaximumDegree)
    {
      throw std::runtime_error("a trim curve has a degree above 25");
    }
    coefficients.assign(source.Coefficients, source.Coefficients + source.Degree + 1);
    for (Point2& c : coefficients)
    {
      c = this->Transpose(c);
    }
    const BernsteinPiece<2> piece{ coefficients.data(), source.Degree };
    const std::uint32_t trim = this->AddTrim(piece);
    segments.clear();
    CutAtKnotLines(piece, this->Grid, segments);
    // The end of the coedge before: within rounding the same point, and then the same doubles.
    if (loopStart && !coedge.Reversed && k == 0)
    {
      segments.front().StartPoint = *loopStart;
    }
    if (loopStart && coedge.Reversed && k + 1 == curve.GetNumberOfPieces())
    {
      segments.back().EndPoint = *loopStart;
    }
    for (const TrimSegment& segment : segments)
    {
      this->AddPanel(segment, piece, trim, coedge.Reversed);
      this->AddRibbons(coedge, k, trim, segment);
    }
  }
}

void Builder::AddCap(const Point3& apex, const Point3& from, const Point3& to)
{
  const double gap = std::max(Norm(Subtract(from, apex)), Norm(Subtract(to, apex)));
  if (gap > NegligibleGap * this->Size && Norm(Subtract(from, to)) > 0.0)
  {
    // Cones run over the loop with the sign opposite to the face's, see Filters/NURBS/Mathematics.md.
    this->Result.Caps.push_back({ apex, from, to, !this->Source.Reversed });
  }
}

void Builder::AddCorner(const Coedge& before, const Coedge& after, const Point2& from, const Point2& to)
{
  const Edge& edge0 = *before.Use;
  const Edge& edge1 = *after.Use;
  const Point3 vertex = before.Reversed ? edge0.StartVertex : edge0.EndVertex;
  const Point3 curveEnd = before.Reversed ? edge0.Curve.GetStartPoint() : edge0.Curve.GetEndPoint();
  const Point3 curveStart = after.Reversed ? edge1.Curve.GetEndPoint() : edge1.Curve.GetStartPoint();
  const Point3& nextVertex = after.Reversed ? edge1.EndVertex : edge1.StartVertex;
  if (nextVertex != vertex)
  {
    // This face's side of the hole leads to the end of the next curve, its neighbour's from there to that
    // edge's vertex.
    const double side = Norm(Subtract(curveStart, vertex)) + Norm(Subtract(nextVertex, curveStart));
    this->Result.OpenCorners += side * side;
    this->Result.VertexReach = std::max(this->Result.VertexReach, Norm(vertex) + side);
  }
  const auto surfacePoint = [this](const Point2& uv)
  {
    const std::uint32_t patch =
      this->GetPatch(CellGrid::Find(this->Grid.U, uv[0]), CellGrid::Find(this->Grid.V, uv[1]));
    return this->EvaluatePatch(this->Result.Patches[patch], uv);
  };
  const Point3 surfaceEnd = surfacePoint(from);
  const Point3 surfaceStart = surfacePoint(to);
  this->AddCap(vertex, curveEnd, surfaceEnd);
  this->AddCap(vertex, surfaceStart, curveStart);
  if (from == to)
  {
    return;
  }
  // The straight piece that closes the loop in (u,v): part of the face's boundary like any other, and its
  // ribbon leads to the vertex.
  const Point2 line[2] = { from, to };
  const BernsteinPiece<2> piece{ line, 1 };
  const std::uint32_t trim = this->AddTrim(piece);
  const auto apex = static_cast<std::uint32_t>(this->Result.Coefficients.size());
  this->Result.Coefficients.insert(this->Result.Coefficients.end(), vertex.begin(), vertex.end());
  const bool negligible = std::max(Norm(Subtract(surfaceEnd, vertex)),
                            Norm(Subtract(surfaceStart, vertex))) <= NegligibleGap * this->Size &&
    Norm(Subtract(surfaceEnd, surfaceStart)) <= NegligibleGap * this->Size;
  std::vector<TrimSegment> segments;
  CutAtKnotLines(piece, this->Grid, segments);
  for (const TrimSegment& segment : segments)
  {
    this->AddPanel(segment, piece, trim, false);
    if (!negligible)
    {
      this->Result.Ribbons.push_back({ this->GetPatch(segment.Column, segment.Row), trim, apex, 1, 0,
        this->Source.Reversed, false, segment.Start, segment.End, 0.0, 1.0, -1 });
    }
  }
}

void Builder::AddLoop(const Loop& loop)
{
  const std::size_t count = loop.Coedges.size();
  const auto startOf = [this](const Coedge& c)
  { return this->Transpose(c.Reversed ? c.Curve.GetEndPoint() : c.Curve.GetStartPoint()); };
  const auto endOf = [this](const Coedge& c)
  { return this->Transpose(c.Reversed ? c.Curve.GetStartPoint() : c.Curve.GetEndPoint()); };
  for (std::size_t i = 0; i < count; ++i)
  {
    const Coedge& before = loop.Coedges[(i + count - 1) % count];
    const Coedge& coedge = loop.Coedges[i];
    if (before.Curve.GetNumberOfPieces() == 0 || coedge.Curve.GetNumberOfPieces() == 0)
    {
      throw std::runtime_error("a coedge has no trim curve");
    }
    const Point2 from = endOf(before);
    const Point2 to = startOf(coedge);
    const bool joined = this->Grid.AreSame(from, to);
    this->AddCorner(before, coedge, from, joined ? from : to);
    this->AddCoedge(coedge, joined ? &from : nullptr);
    ++this->CoedgeIndex;
  }
}

void Builder::AddCoveredEdges()
{
  std::vector<Point2> doubtful;
  std::vector<double> widths;
  for (const EdgePanel& edge : this->Cover.ComputeEdgePanels())
  {
    const std::uint32_t patch = this->GetPatch(edge.Column, edge.Row);
    const Patch& cell = this->Result.Patches[patch];
    const double right = this->Grid.U[edge.Column + 1];
    const Point2 line[2] = { { right, edge.StartV }, { right, edge.EndV } };
    const std::uint32_t trim = this->AddTrim({ line, 1 });
    if (edge.Multiplicity != 1 && edge.EndV - edge.StartV > 1e-9 * cell.Width[1])
    {
      doubtful.push_back(this->Transpose({ right, 0.5 * (edge.StartV + edge.EndV) }));
      widths.push_back((edge.EndV - edge.StartV) / cell.Width[1] * cell.Stretch[1]);
    }
    for (int m = 0; m < std::abs(edge.Multiplicity); ++m)
    {
      this->Result.Panels.push_back({ patch, trim, 1, this->ShapeOfPatch[patch], edge.Multiplicity < 0,
        this->Source.Reversed != this->Transposed, 0.0, 1.0, true, line[0], line[1] });
    }
  }
  const std::vector<bool> areFar =
    doubtful.empty() ? std::vector<bool>() : AreFarFromLoops(this->Source, doubtful);
  for (std::size_t i = 0; i < doubtful.size(); ++i)
  {
    this->Result.CoverageDefects += areFar[i] ? 1 : 0;
    this->Result.Overlap = areFar[i] ? this->Result.Overlap : std::max(this->Result.Overlap, widths[i]);
  }
}

FacePanels Builder::Build()
{
  if (this->Source.Loops.empty())
  {
    const int right = this->Grid.GetNumberOfColumns();
    for (int row = 0; row < this->Grid.GetNumberOfRows(); ++row)
    {
      this->Cover.AddPiece(right, row, this->Grid.V[row], this->Grid.V[row + 1], 1);
    }
  }
  for (const Loop& loop : this->Source.Loops)
  {
    if (!loop.Coedges.empty())
    {
      this->AddLoop(loop);
    }
  }
  this->AddCoveredEdges();
  this->Result.CoverageDefects += HasWrongLoops(this->Source) ? 1 : 0;
  return std::move(this->Result);
}

// From this ratio of neighbours' weights a surface is not continued farther than it is wide.
constexpr double LargeWeightRatio = 8.0;

/// Returns true if the surface can be continued to its trim curves.
bool CanContinue(const FacePanels& panels)
{
  double diameter = 0.0;
  double ratio = 0.0;
  for (const Patch& patch : panels.Patches)
  {
    diameter = std::max(diameter, 2.0 * patch.Radius);
    ratio = std::max(ratio, patch.WeightRatio);
  }
  return std::isfinite(panels.Outside.Distance) &&
    (panels.Outside.Distance <= diameter || ratio < LargeWeightRatio);
}
}

FacePanels BuildFacePanels(const Face& face)
{
  std::string reason = face.Surface.Check();
  if (reason.empty())
  {
    try
    {
      FacePanels panels = Builder(face).Build();
      if (CanContinue(panels))
      {
        return panels;
      }
      panels = Builder(MoveTrimsInside(face)).Build();
      panels.AreTrimsMoved = true;
      return panels;
    }
    catch (const std::runtime_error& error)
    {
      reason = error.what();
    }
  }
  throw std::runtime_error("face #" + std::to_string(face.FileId) + ": " + reason);
}
}
