#include "smHostileTrims.h"

#include "smHostileCuts.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace smhostile
{
namespace
{
using EdgePointer = std::shared_ptr<const sm::Edge>;

struct RailEdges
{
  /// Interior parameters, then also 0 and 1, increasing.
  std::vector<double> Breaks;
  std::vector<Point3> Vertices;
  std::vector<EdgePointer> Edges;
  /// Bernstein coefficients of the rail's parameter over each edge's range: every face runs along the edge like this.
  std::vector<std::vector<std::array<double, 1>>> Progress;
};

class Trimmer
{
public:
  Trimmer(const Shape& shape, bool insideOut, Random& random);
  TrimmedSolid Build();

private:
  EdgeQuality ChooseQuality();
  std::vector<std::array<double, 1>> ChooseProgress(double start, double end);
  Point3 Displace(const Point3& point);
  void AddBreak(int rail, double t);
  void PlanSheet(const Sheet& sheet);
  void BuildRail(int rail);
  Point3 GetVertex(int rail, double t) const;

  void AddBorder(sm::Loop& loop, const Sheet& sheet, Side side, double from, double to) const;
  void AddCut(sm::Loop& loop, const Sheet& sheet, const EdgePointer& edge, const sm::TrimCurve& curve,
    bool reversed) const;
  EdgePointer MakeCutEdge(
    const Sheet& sheet, const sm::TrimCurve& curve, const Point3& start, const Point3& end);
  sm::Loop MakeFrame(const Sheet& sheet) const;
  void BuildSheet(std::size_t index);
  void BuildHoles(const Sheet& sheet, const Split& split);
  void AddFace(const Sheet& sheet, std::vector<sm::Loop> loops);

  const Shape& Source;
  bool InsideOut;
  Random& Dice;
  std::vector<Point3> Corners;
  std::vector<RailEdges> Rails;
  std::vector<Split> Splits;
  double VertexOffset = 0.0;
  double EdgeOffset = 0.0;
  bool PoorEdges = false;
  int NextFileId = 1;
  TrimmedSolid Result;
};

/// The same curve in the surface's (u,v).
sm::TrimCurve ToDomain(const Sheet& sheet, sm::TrimCurve curve)
{
  for (Point2& p : curve.Coefficients)
  {
    for (int d = 0; d < 2; ++d)
    {
      p[d] = sheet.Low[d] + sheet.Width[d] * p[d];
    }
  }
  return curve;
}

Trimmer::Trimmer(const Shape& shape, bool insideOut, Random& random)
  : Source(shape)
  , InsideOut(insideOut)
  , Dice(random)
  , Rails(shape.Rails.size())
{
  if (random.Chance(0.5))
  {
    this->VertexOffset = shape.Size * random.LogUniform(1e-12, 1e-3);
  }
  this->PoorEdges = random.Chance(0.5);
  if (random.Chance(0.3))
  {
    this->EdgeOffset = shape.Size * random.LogUniform(1e-9, 1e-1);
  }
}

Point3 Trimmer::Displace(const Point3& point)
{
  Point3 result = point;
  for (double& x : result)
  {
    x += this->VertexOffset * this->Dice.Uniform(-1.0, 1.0);
  }
  return result;
}

EdgeQuality Trimmer::ChooseQuality()
{
  EdgeQuality quality;
  quality.Offset = this->EdgeOffset;
  quality.Pieces = this->Dice.Integer(2, 5);
  if (this->PoorEdges && this->Dice.Chance(0.5))
  {
    quality.Degree = this->Dice.Integer(1, 4);
    quality.Pieces = this->Dice.Integer(1, 2);
    quality.Lag = this->Dice.Chance(0.3) ? this->Dice.Sign() * this->Dice.LogUniform(1e-9, 0.1) : 0.0;
  }
  return quality;
}

std::vector<std::array<double, 1>> Trimmer::ChooseProgress(double start, double end)
{
  std::vector<double> values = { start, end };
  for (int i = this->Dice.Chance(0.3) ? this->Dice.Integer(1, 4) : 0; i > 0; --i)
  {
    values.push_back(std::clamp(QuantizeParameter(this->Dice.Uniform(start, end)), start, end));
  }
  // Sorted coefficients: it never turns back.
  std::sort(values.begin(), values.end());
  std::vector<std::array<double, 1>> progress;
  std::transform(values.begin(), values.end(), std::back_inserter(progress),
    [](double x) { return std::array<double, 1>{ x }; });
  return progress;
}

void Trimmer::AddBreak(int rail, double t)
{
  std::vector<double>& breaks = this->Rails[rail].Breaks;
  if (t > 0.0 && t < 1.0 && std::find(breaks.begin(), breaks.end(), t) == breaks.end())
  {
    breaks.push_back(t);
  }
}

void Trimmer::PlanSheet(const Sheet& sheet)
{
  std::vector<double> lines[2];
  for (int d = 0; d < 2; ++d)
  {
    for (const double knot : sheet.Surface.GetSpanBreaks(d))
    {
      const double x = (knot - sheet.Low[d]) / sheet.Width[d];
      if (x > 0.0 && x < 1.0)
      {
        lines[d].push_back(x);
      }
    }
  }
  const Split split = MakeSplit(this->Dice, lines);
  for (const sm::TrimCurve& curve : split.Curves)
  {
    const Point2& start = curve.GetStartPoint();
    const Point2& end = curve.GetEndPoint();
    const bool low = split.How == Split::Kind::LowCorner;
    const bool high = split.How == Split::Kind::HighCorner;
    this->AddBreak(sheet.Sides[high ? TOP : BOTTOM], start[0]);
    this->AddBreak(sheet.Sides[low ? LEFT : high ? RIGHT : TOP], low || high ? end[1] : end[0]);
  }
  this->Splits.push_back(split);
  this->Result.Description += " " + split.Name;
}

void Trimmer::BuildRail(int index)
{
  const Rail& rail = this->Source.Rails[index];
  RailEdges& result = this->Rails[index];
  result.Breaks.push_back(0.0);
  result.Breaks.push_back(1.0);
  std::sort(result.Breaks.begin(), result.Breaks.end());
  for (const double t : result.Breaks)
  {
    result.Vertices.push_back(t == 0.0 || rail.Degenerate ? this->Corners[rail.StartVertex]
        : t == 1.0                                        ? this->Corners[rail.EndVertex]
                                                          : this->Displace(rail.Evaluate(t)));
  }
  for (std::size_t i = 0; i + 1 < result.Breaks.size(); ++i)
  {
    auto edge = std::make_shared<sm::Edge>();
    edge->Id = sm::NewId();
    edge->FileId = this->NextFileId++;
    edge->StartVertex = result.Vertices[i];
    edge->EndVertex = result.Vertices[i + 1];
    edge->Degenerate = rail.Degenerate;
    const double start = result.Breaks[i];
    const double end = result.Breaks[i + 1];
    const std::vector<std::array<double, 1>> progress = this->ChooseProgress(start, end);
    if (rail.Degenerate)
    {
      edge->Curve.Breaks = { result.Breaks[i] };
      edge->Curve.AppendPiece(result.Breaks[i + 1], &edge->StartVertex, 0);
    }
    else
    {
      // A closed curve needs pieces, or its chord is a point; a multiple of four meets the quarters' joints.
      EdgeQuality quality = this->ChooseQuality();
      quality.Pieces *= rail.Pieces.size() > 1 ? 4 : 1;
      const sm::BernsteinPiece<1> along{ progress.data(), static_cast<int>(progress.size()) - 1 };
      edge->Curve =
        MakeEdgeCurve([&](double t) { return rail.Evaluate(along.Evaluate((t - start) / (end - start))[0]); },
          start, end, quality, this->Dice);
    }
    result.Edges.push_back(edge);
    result.Progress.push_back(progress);
  }
}

Point3 Trimmer::GetVertex(int rail, double t) const
{
  const RailEdges& edges = this->Rails[rail];
  const auto at = std::find(edges.Breaks.begin(), edges.Breaks.end(), t);
  return edges.Vertices[at - edges.Breaks.begin()];
}

void Trimmer::AddBorder(sm::Loop& loop, const Sheet& sheet, Side side, double from, double to) const
{
  const RailEdges& rail = this->Rails[sheet.Sides[side]];
  const int along = side == BOTTOM || side == TOP ? 0 : 1;
  const double across = side == RIGHT || side == TOP ? 1.0 : 0.0;
  std::vector<sm::Coedge> coedges;
  for (std::size_t i = 0; i < rail.Edges.size(); ++i)
  {
    const double ends[2] = { rail.Breaks[i], rail.Breaks[i + 1] };
    if (ends[0] < std::min(from, to) || ends[1] > std::max(from, to))
    {
      continue;
    }
    std::vector<Point2> points;
    for (const std::array<double, 1>& t : rail.Progress[i])
    {
      Point2 point;
      point[along] = t[0];
      point[1 - along] = across;
      points.push_back(point);
    }
    sm::Coedge coedge;
    coedge.Use = rail.Edges[i];
    coedge.Reversed = from > to;
    coedge.Curve.Breaks = { ends[0] };
    coedge.Curve.AppendPiece(ends[1], points.data(), static_cast<int>(points.size()) - 1);
    coedge.Curve = ToDomain(sheet, coedge.Curve);
    coedges.push_back(coedge);
  }
  if (from > to)
  {
    std::reverse(coedges.begin(), coedges.end());
  }
  loop.Coedges.insert(loop.Coedges.end(), coedges.begin(), coedges.end());
}

void Trimmer::AddCut(sm::Loop& loop, const Sheet& sheet, const EdgePointer& edge, const sm::TrimCurve& curve,
  bool reversed) const
{
  sm::Coedge coedge;
  coedge.Use = edge;
  coedge.Reversed = reversed;
  coedge.Curve = ToDomain(sheet, curve);
  loop.Coedges.push_back(coedge);
}

EdgePointer Trimmer::MakeCutEdge(
  const Sheet& sheet, const sm::TrimCurve& curve, const Point3& start, const Point3& end)
{
  auto edge = std::make_shared<sm::Edge>();
  edge->Id = sm::NewId();
  edge->FileId = this->NextFileId++;
  edge->StartVertex = start;
  edge->EndVertex = end;
  // Joints of pieces are joints of the edge, so that a closed edge of low degree does not shrink to a point.
  EdgeQuality quality = this->ChooseQuality();
  quality.Pieces *= curve.GetNumberOfPieces();
  const sm::TrimCurve onSurface = ToDomain(sheet, curve);
  edge->Curve = MakeEdgeCurve(
    [&](double t)
    {
      const Point2 uv = onSurface.Evaluate(t);
      Point3 point;
      sheet.Surface.Evaluate(uv[0], uv[1], point.data());
      return point;
    },
    curve.GetStart(), curve.GetEnd(), quality, this->Dice);
  return edge;
}

sm::Loop Trimmer::MakeFrame(const Sheet& sheet) const
{
  sm::Loop loop;
  this->AddBorder(loop, sheet, BOTTOM, 0.0, 1.0);
  this->AddBorder(loop, sheet, RIGHT, 0.0, 1.0);
  this->AddBorder(loop, sheet, TOP, 1.0, 0.0);
  this->AddBorder(loop, sheet, LEFT, 1.0, 0.0);
  return loop;
}

void Trimmer::AddFace(const Sheet& sheet, std::vector<sm::Loop> loops)
{
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->FileId = this->NextFileId++;
  face->Surface = sheet.Surface;
  face->Reversed = sheet.Reversed != this->InsideOut;
  face->Loops = std::move(loops);
  if (this->Dice.Chance(0.3))
  {
    // The same face with u and v exchanged: its normal turns and so do its loops.
    face->Surface = sheet.Surface.Transposed();
    face->Reversed = !face->Reversed;
    for (sm::Loop& loop : face->Loops)
    {
      std::reverse(loop.Coedges.begin(), loop.Coedges.end());
      for (sm::Coedge& coedge : loop.Coedges)
      {
        coedge.Reversed = !coedge.Reversed;
        for (Point2& p : coedge.Curve.Coefficients)
        {
          std::swap(p[0], p[1]);
        }
      }
    }
  }
  for (sm::Loop& loop : face->Loops)
  {
    // A loop may start anywhere.
    const int start = this->Dice.Integer(0, static_cast<int>(loop.Coedges.size()) - 1);
    std::rotate(loop.Coedges.begin(), loop.Coedges.begin() + start, loop.Coedges.end());
  }
  this->Result.Faces.push_back(face);
}

void Trimmer::BuildHoles(const Sheet& sheet, const Split& split)
{
  std::vector<sm::Loop> outer = { this->MakeFrame(sheet) };
  std::vector<Point3> first;
  for (const std::vector<sm::TrimCurve>& curves : split.Loops)
  {
    std::vector<Point3> vertices;
    for (const sm::TrimCurve& curve : curves)
    {
      const Point2 uv = ToDomain(sheet, curve).GetStartPoint();
      Point3 point;
      sheet.Surface.Evaluate(uv[0], uv[1], point.data());
      vertices.push_back(this->Displace(point));
    }
    if (!first.empty())
    {
      // Touching loops share the vertex where they touch.
      vertices[0] = first[0];
    }
    first = vertices;
    sm::Loop cap;
    sm::Loop hole;
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      const EdgePointer edge =
        this->MakeCutEdge(sheet, curves[i], vertices[i], vertices[(i + 1) % curves.size()]);
      this->AddCut(cap, sheet, edge, curves[i], false);
      this->AddCut(hole, sheet, edge, curves[i], true);
    }
    std::reverse(hole.Coedges.begin(), hole.Coedges.end());
    outer.push_back(hole);
    this->AddFace(sheet, { cap });
  }
  this->AddFace(sheet, outer);
}

void Trimmer::BuildSheet(std::size_t index)
{
  const Sheet& sheet = this->Source.Sheets[index];
  const Split& split = this->Splits[index];
  if (split.How == Split::Kind::None)
  {
    this->AddFace(sheet, { this->MakeFrame(sheet) });
    return;
  }
  if (split.How == Split::Kind::Holes)
  {
    this->BuildHoles(sheet, split);
    return;
  }
  if (split.How != Split::Kind::Columns)
  {
    const bool low = split.How == Split::Kind::LowCorner;
    const sm::TrimCurve& curve = split.Curves[0];
    const double a = curve.GetStartPoint()[0];
    const double b = curve.GetEndPoint()[1];
    const EdgePointer edge =
      this->MakeCutEdge(sheet, curve, this->GetVertex(sheet.Sides[low ? BOTTOM : TOP], a),
        this->GetVertex(sheet.Sides[low ? LEFT : RIGHT], b));
    sm::Loop corner;
    sm::Loop rest;
    if (low)
    {
      this->AddBorder(corner, sheet, BOTTOM, 0.0, a);
      this->AddCut(corner, sheet, edge, curve, false);
      this->AddBorder(corner, sheet, LEFT, b, 0.0);
      this->AddBorder(rest, sheet, BOTTOM, a, 1.0);
      this->AddBorder(rest, sheet, RIGHT, 0.0, 1.0);
      this->AddBorder(rest, sheet, TOP, 1.0, 0.0);
      this->AddBorder(rest, sheet, LEFT, 1.0, b);
    }
    else
    {
      this->AddBorder(corner, sheet, TOP, 1.0, a);
      this->AddCut(corner, sheet, edge, curve, false);
      this->AddBorder(corner, sheet, RIGHT, b, 1.0);
      this->AddBorder(rest, sheet, TOP, a, 0.0);
      this->AddBorder(rest, sheet, LEFT, 1.0, 0.0);
      this->AddBorder(rest, sheet, BOTTOM, 0.0, 1.0);
      this->AddBorder(rest, sheet, RIGHT, 0.0, b);
    }
    this->AddCut(rest, sheet, edge, curve, true);
    this->AddFace(sheet, { corner });
    this->AddFace(sheet, { rest });
    return;
  }
  const std::size_t count = split.Curves.size();
  std::vector<EdgePointer> edges;
  for (const sm::TrimCurve& curve : split.Curves)
  {
    edges.push_back(
      this->MakeCutEdge(sheet, curve, this->GetVertex(sheet.Sides[BOTTOM], curve.GetStartPoint()[0]),
        this->GetVertex(sheet.Sides[TOP], curve.GetEndPoint()[0])));
  }
  for (std::size_t i = 0; i <= count; ++i)
  {
    sm::Loop loop;
    const double low[2] = { i == 0 ? 0.0 : split.Curves[i - 1].GetStartPoint()[0],
      i == 0 ? 0.0 : split.Curves[i - 1].GetEndPoint()[0] };
    const double high[2] = { i == count ? 1.0 : split.Curves[i].GetStartPoint()[0],
      i == count ? 1.0 : split.Curves[i].GetEndPoint()[0] };
    if (low[0] < high[0])
    {
      this->AddBorder(loop, sheet, BOTTOM, low[0], high[0]);
    }
    if (i == count)
    {
      this->AddBorder(loop, sheet, RIGHT, 0.0, 1.0);
    }
    else
    {
      this->AddCut(loop, sheet, edges[i], split.Curves[i], false);
    }
    if (low[1] < high[1])
    {
      this->AddBorder(loop, sheet, TOP, high[1], low[1]);
    }
    if (i == 0)
    {
      this->AddBorder(loop, sheet, LEFT, 1.0, 0.0);
    }
    else
    {
      this->AddCut(loop, sheet, edges[i - 1], split.Curves[i - 1], true);
    }
    this->AddFace(sheet, { loop });
  }
}

TrimmedSolid Trimmer::Build()
{
  for (const Point3& vertex : this->Source.Vertices)
  {
    this->Corners.push_back(this->Displace(vertex));
  }
  if (this->Dice.Chance(0.05))
  {
    // No trim at all: the sheets close by themselves.
    this->Result.Description = " untrimmed";
    for (const Sheet& sheet : this->Source.Sheets)
    {
      this->AddFace(sheet, {});
    }
    return this->Result;
  }
  std::for_each(this->Source.Sheets.begin(), this->Source.Sheets.end(),
    [this](const Sheet& sheet) { this->PlanSheet(sheet); });
  for (std::size_t i = 0; i < this->Rails.size(); ++i)
  {
    this->BuildRail(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < this->Source.Sheets.size(); ++i)
  {
    this->BuildSheet(i);
  }
  char text[96];
  std::snprintf(text, sizeof(text), "; edges off %.0e%s, vertices off %.0e (of the size)",
    this->EdgeOffset / this->Source.Size, this->PoorEdges ? " and poor" : "",
    this->VertexOffset / this->Source.Size);
  this->Result.Description += text;
  return this->Result;
}
}

TrimmedSolid TrimShape(const Shape& shape, bool insideOut, Random& random)
{
  return Trimmer(shape, insideOut, random).Build();
}
}
