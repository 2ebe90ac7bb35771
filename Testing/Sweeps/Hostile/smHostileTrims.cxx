#include "smHostileTrims.h"

#include "smHostileCuts.h"
#include "smHostileEdges.h"

#include <algorithm>
#include <memory>

namespace smhostile
{
namespace
{
class Trimmer
{
public:
  Trimmer(const Shape& shape, bool insideOut, Random& random)
    : Source(shape)
    , InsideOut(insideOut)
    , Dice(random)
    , Edges(shape, random)
  {
  }
  TrimmedSolid Build();

private:
  void PlanSheet(const Sheet& sheet);
  void AddBorder(sm::Loop& loop, const Sheet& sheet, Side side, double from, double to) const;
  void AddCut(sm::Loop& loop, const Sheet& sheet, const EdgePointer& edge, const sm::TrimCurve& curve,
    bool reversed) const;
  sm::Loop MakeFrame(const Sheet& sheet) const;
  void BuildSheet(const Sheet& sheet, const Split& split);
  void BuildCorner(const Sheet& sheet, const sm::TrimCurve& curve, bool low);
  void BuildColumns(const Sheet& sheet, const std::vector<sm::TrimCurve>& curves);
  void BuildHoles(const Sheet& sheet, const Split& split);
  void AddFace(const Sheet& sheet, std::vector<sm::Loop> loops);

  const Shape& Source;
  bool InsideOut;
  Random& Dice;
  SharedEdges Edges;
  std::vector<Split> Splits;
  TrimmedSolid Result;
};

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
    this->Edges.AddBreak(sheet.Sides[high ? TOP : BOTTOM], start[0]);
    this->Edges.AddBreak(sheet.Sides[low ? LEFT : high ? RIGHT : TOP], low || high ? end[1] : end[0]);
  }
  this->Splits.push_back(split);
  this->Result.Description += " " + split.Name;
}

void Trimmer::AddBorder(sm::Loop& loop, const Sheet& sheet, Side side, double from, double to) const
{
  const RailEdges& rail = this->Edges.GetRail(sheet.Sides[side]);
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
  face->FileId = this->Edges.NewFileId();
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
      vertices.push_back(this->Edges.DisplaceVertex(point));
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
        this->Edges.MakeCutEdge(sheet, curves[i], vertices[i], vertices[(i + 1) % curves.size()]);
      this->AddCut(cap, sheet, edge, curves[i], false);
      this->AddCut(hole, sheet, edge, curves[i], true);
    }
    std::reverse(hole.Coedges.begin(), hole.Coedges.end());
    outer.push_back(hole);
    this->AddFace(sheet, { cap });
  }
  this->AddFace(sheet, outer);
}

void Trimmer::BuildCorner(const Sheet& sheet, const sm::TrimCurve& curve, bool low)
{
  const double a = curve.GetStartPoint()[0];
  const double b = curve.GetEndPoint()[1];
  const EdgePointer edge =
    this->Edges.MakeCutEdge(sheet, curve, this->Edges.GetVertex(sheet.Sides[low ? BOTTOM : TOP], a),
      this->Edges.GetVertex(sheet.Sides[low ? LEFT : RIGHT], b));
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
}

void Trimmer::BuildColumns(const Sheet& sheet, const std::vector<sm::TrimCurve>& curves)
{
  const std::size_t count = curves.size();
  std::vector<EdgePointer> edges;
  for (const sm::TrimCurve& curve : curves)
  {
    edges.push_back(this->Edges.MakeCutEdge(sheet, curve,
      this->Edges.GetVertex(sheet.Sides[BOTTOM], curve.GetStartPoint()[0]),
      this->Edges.GetVertex(sheet.Sides[TOP], curve.GetEndPoint()[0])));
  }
  for (std::size_t i = 0; i <= count; ++i)
  {
    sm::Loop loop;
    const double low[2] = { i == 0 ? 0.0 : curves[i - 1].GetStartPoint()[0],
      i == 0 ? 0.0 : curves[i - 1].GetEndPoint()[0] };
    const double high[2] = { i == count ? 1.0 : curves[i].GetStartPoint()[0],
      i == count ? 1.0 : curves[i].GetEndPoint()[0] };
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
      this->AddCut(loop, sheet, edges[i], curves[i], false);
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
      this->AddCut(loop, sheet, edges[i - 1], curves[i - 1], true);
    }
    this->AddFace(sheet, { loop });
  }
}

void Trimmer::BuildSheet(const Sheet& sheet, const Split& split)
{
  switch (split.How)
  {
    case Split::Kind::None:
      this->AddFace(sheet, { this->MakeFrame(sheet) });
      break;
    case Split::Kind::Holes:
      this->BuildHoles(sheet, split);
      break;
    case Split::Kind::Columns:
      this->BuildColumns(sheet, split.Curves);
      break;
    case Split::Kind::LowCorner:
    case Split::Kind::HighCorner:
      this->BuildCorner(sheet, split.Curves[0], split.How == Split::Kind::LowCorner);
      break;
  }
}

TrimmedSolid Trimmer::Build()
{
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
  this->Edges.BuildRails();
  for (std::size_t i = 0; i < this->Source.Sheets.size(); ++i)
  {
    this->BuildSheet(this->Source.Sheets[i], this->Splits[i]);
  }
  this->Result.Description += this->Edges.Describe();
  return this->Result;
}
}

TrimmedSolid TrimShape(const Shape& shape, bool insideOut, Random& random)
{
  return Trimmer(shape, insideOut, random).Build();
}
}
