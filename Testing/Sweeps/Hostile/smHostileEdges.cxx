#include "smHostileEdges.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace smhostile
{
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

SharedEdges::SharedEdges(const Shape& shape, Random& random)
  : Source(shape)
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
  for (const Point3& vertex : shape.Vertices)
  {
    this->Corners.push_back(this->DisplaceVertex(vertex));
  }
}

Point3 SharedEdges::DisplaceVertex(const Point3& point)
{
  Point3 result = point;
  for (double& x : result)
  {
    x += this->VertexOffset * this->Dice.Uniform(-1.0, 1.0);
  }
  return result;
}

EdgeQuality SharedEdges::ChooseQuality()
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

std::vector<std::array<double, 1>> SharedEdges::ChooseProgress(double start, double end)
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

void SharedEdges::AddBreak(int rail, double t)
{
  std::vector<double>& breaks = this->Rails[rail].Breaks;
  if (t > 0.0 && t < 1.0 && std::find(breaks.begin(), breaks.end(), t) == breaks.end())
  {
    breaks.push_back(t);
  }
}

void SharedEdges::BuildRail(int index)
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
                                                          : this->DisplaceVertex(rail.Evaluate(t)));
  }
  for (std::size_t i = 0; i + 1 < result.Breaks.size(); ++i)
  {
    auto edge = std::make_shared<sm::Edge>();
    edge->Id = sm::NewId();
    edge->FileId = this->NewFileId();
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

Point3 SharedEdges::GetVertex(int rail, double t) const
{
  const RailEdges& edges = this->Rails[rail];
  const auto at = std::find(edges.Breaks.begin(), edges.Breaks.end(), t);
  return edges.Vertices[at - edges.Breaks.begin()];
}

EdgePointer SharedEdges::MakeCutEdge(
  const Sheet& sheet, const sm::TrimCurve& curve, const Point3& start, const Point3& end)
{
  auto edge = std::make_shared<sm::Edge>();
  edge->Id = sm::NewId();
  edge->FileId = this->NewFileId();
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

void SharedEdges::BuildRails()
{
  for (std::size_t i = 0; i < this->Rails.size(); ++i)
  {
    this->BuildRail(static_cast<int>(i));
  }
}

std::string SharedEdges::Describe() const
{
  char text[96];
  std::snprintf(text, sizeof(text), "; edges off %.0e%s, vertices off %.0e (of the size)",
    this->EdgeOffset / this->Source.Size, this->PoorEdges ? " and poor" : "",
    this->VertexOffset / this->Source.Size);
  return text;
}
}
