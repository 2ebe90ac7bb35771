#include "smSTEPEdgeDistance.h"

#include "Geometry/smCurveFoot.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Number of samples in each span, and in each box.
constexpr int SpanSamples = 8;
constexpr std::size_t BlockSamples = 16;

/// Chebyshev points of a piece for each degree, and 1 / cos(pi / (2 PointsPerDegree)), rounded up.
constexpr int PointsPerDegree = 4;
constexpr double PointMargin = 1.0824;

/// A quarter of a turn is as smooth as a polynomial of this degree.
constexpr int ConicDegree = 4;
constexpr int ConicPieces = 4;

/// The pieces of a curve between its breaks.
struct PieceKind
{
  bool IsKnown = false;
  int Degree = 1;
  int Pieces = 1;
  double WeightRatio = 1.0;
};

PieceKind FindPieceKind(const GeometricCurve<3>& curve, double first, double last)
{
  PieceKind result;
  if (const auto* conic = curve.GetIf<ConicCurve<3>>())
  {
    result.Degree = ConicDegree;
    const double length = std::abs(last - first);
    const bool isEllipse = conic->Kind == ConicCurve<3>::Type::Ellipse;
    result.IsKnown = isEllipse || length <= 100.0;
    result.Pieces = isEllipse || !result.IsKnown ? ConicPieces : ConicPieces + static_cast<int>(length);
  }
  else if (const auto* spline = curve.GetIf<SplineCurve<3>>())
  {
    result.IsKnown = true;
    result.Degree = std::max(1, spline->Basis.Degree);
    if (!spline->Weights.empty())
    {
      const auto [low, high] = std::minmax_element(spline->Weights.begin(), spline->Weights.end());
      result.WeightRatio = *high / *low;
    }
  }
  else if (const auto* composite = curve.GetIf<CompositeCurve<3>>())
  {
    result.IsKnown = true;
    for (const CurveSegment<3>& segment : composite->Segments)
    {
      const PieceKind part = FindPieceKind(*segment.Curve, segment.First, segment.Last);
      result.IsKnown = result.IsKnown && part.IsKnown;
      result.Degree = std::max(result.Degree, part.Degree);
      result.Pieces = std::max(result.Pieces, part.Pieces);
      result.WeightRatio = std::max(result.WeightRatio, part.WeightRatio);
    }
  }
  else
  {
    result.IsKnown = curve.GetIf<LineCurve<3>>() != nullptr;
  }
  return result;
}

double Mix(double first, double last, double share)
{
  return (1.0 - share) * first + share * last;
}

double GetBoxDistance(const Vector3& point, const Vector3& low, const Vector3& high)
{
  Vector3 away{};
  for (int c = 0; c < 3; ++c)
  {
    away[c] = std::max({ low[c] - point[c], 0.0, point[c] - high[c] });
  }
  return Norm(away);
}

/// The distances of points of one part from the other one.
class DistanceMeter
{
public:
  DistanceMeter(const STEPEdgePart& from, const STEPEdgePart& to, double limit, STEPEdgeWork& work)
    : From(from)
    , To(to)
    , Limit(limit)
    , Work(work)
  {
  }

  double Bound() const
  {
    const GeometricCurve<3>& curve = *this->From.Samples->GetEdge().Curve;
    const PieceKind kind = FindPieceKind(curve, this->From.First, this->From.Last);
    const PieceKind other = FindPieceKind(*this->To.Samples->GetEdge().Curve, this->To.First, this->To.Last);
    if (!kind.IsKnown || !other.IsKnown)
    {
      return Infinity;
    }
    const double margin = PointMargin * kind.WeightRatio;
    const int count = PointsPerDegree * std::max({ kind.Degree, other.Degree, 2 });
    const std::vector<double> breaks = this->GetBreaks(kind.Pieces, other.Pieces);
    double largest = this->Measure(this->From.First);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    {
      for (int i = 0; i <= count; ++i)
      {
        const double share = 0.5 - 0.5 * std::cos((2 * i + 1) * vtkMath::Pi() / (2 * count));
        const double t = i < count ? Mix(breaks[k], breaks[k + 1], share) : breaks[k + 1];
        largest = std::max(largest, this->Measure(t));
        if (!(margin * largest <= this->Limit))
        {
          return Infinity;
        }
      }
    }
    return margin * largest;
  }

private:
  static std::vector<double> Divide(const STEPEdgePart& part, int pieces)
  {
    const std::vector<double> breaks = part.Samples->GetEdge().Curve->GetBreaks(part.First, part.Last);
    std::vector<double> result;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    {
      for (int i = 0; i < pieces; ++i)
      {
        result.push_back(Mix(breaks[k], breaks[k + 1], static_cast<double>(i) / pieces));
      }
    }
    result.push_back(part.Last);
    return result;
  }

  /// Returns the breaks of this part, and the places of those of the other one, in order.
  std::vector<double> GetBreaks(int pieces, int otherPieces) const
  {
    std::vector<double> result = Divide(this->From, pieces);
    const GeometricCurve<3>& other = *this->To.Samples->GetEdge().Curve;
    for (const double t : Divide(this->To, otherPieces))
    {
      const double foot = this->From.Samples->FindFoot(
        this->From.First, this->From.Last, other.Evaluate(t), this->Limit, this->Work);
      if (std::isfinite(foot))
      {
        result.push_back(foot);
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  double Measure(double t) const
  {
    const Vector3 point = this->From.Samples->GetEdge().Curve->Evaluate(t);
    const double foot =
      this->To.Samples->FindFoot(this->To.First, this->To.Last, point, this->Limit, this->Work);
    return std::isfinite(foot) ? Norm(Subtract(this->To.Samples->GetEdge().Curve->Evaluate(foot), point))
                               : Infinity;
  }

  const STEPEdgePart& From;
  const STEPEdgePart& To;
  const double Limit;
  STEPEdgeWork& Work;
};
}

STEPEdgeSamples::STEPEdgeSamples(const STEPEdge& edge)
  : Edge(edge)
{
  if (edge.Curve->GetIf<LineCurve<3>>() || edge.Curve->GetIf<ConicCurve<3>>())
  {
    return;
  }
  const std::vector<double> breaks = edge.Curve->GetBreaks(edge.First, edge.Last);
  this->Parameters.push_back(edge.First);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    for (int i = 1; i <= SpanSamples; ++i)
    {
      this->Parameters.push_back(breaks[k] + (breaks[k + 1] - breaks[k]) * i / SpanSamples);
    }
  }
  for (const double t : this->Parameters)
  {
    this->Points.push_back(edge.Curve->Evaluate(t));
  }
  for (std::size_t i = 0; i + 1 < this->Points.size(); i += BlockSamples)
  {
    this->AddBlock(i, std::min(i + BlockSamples, this->Points.size() - 1));
  }
}

void STEPEdgeSamples::AddBlock(std::size_t first, std::size_t last)
{
  Block block{ first, last, this->Points[first], this->Points[first], 0.0 };
  for (std::size_t i = first + 1; i <= last; ++i)
  {
    block.Reach = std::max(block.Reach, Norm(Subtract(this->Points[i], this->Points[i - 1])));
    for (int c = 0; c < 3; ++c)
    {
      block.Low[c] = std::min(block.Low[c], this->Points[i][c]);
      block.High[c] = std::max(block.High[c], this->Points[i][c]);
    }
  }
  this->Blocks.push_back(block);
}

double STEPEdgeSamples::FindFoot(
  double first, double last, const Vector3& point, double limit, STEPEdgeWork& work) const
{
  work.Take(this->Blocks.size() + 1);
  if (work.IsSpent())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const GeometricCurve<3>& curve = *this->Edge.Curve;
  if (this->Blocks.empty())
  {
    double t = FindCurveParameter<3>(curve, point);
    const double period = curve.GetPeriod();
    if (period > 0.0)
    {
      t -= std::floor((t - first) / period) * period;
      t = t - last > first + period - t ? first : t;
    }
    return std::clamp(t, first, last);
  }
  const auto getDistance = [&](double t) { return Norm(Subtract(curve.Evaluate(t), point)); };
  double start = first;
  double closest = Infinity;
  for (const Block& block : this->Blocks)
  {
    if (this->Parameters[block.Last] < first || this->Parameters[block.First] > last ||
      !(GetBoxDistance(point, block.Low, block.High) <= std::min(closest, limit + block.Reach)))
    {
      continue;
    }
    for (std::size_t i = block.First; i <= block.Last; ++i)
    {
      const double t = std::clamp(this->Parameters[i], first, last);
      const double distance =
        t == this->Parameters[i] ? Norm(Subtract(this->Points[i], point)) : getDistance(t);
      start = distance < closest ? t : start;
      closest = std::min(distance, closest);
    }
  }
  if (closest == Infinity)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  work.Take(STEPEdgeWork::Foot);
  return ImproveCurveParameter<3>(curve, point, start, first, last);
}

double BoundEdgeDistance(const STEPEdgePart& a, const STEPEdgePart& b, double limit, STEPEdgeWork& work)
{
  const double result = DistanceMeter(a, b, limit, work).Bound();
  return std::isfinite(result) ? std::max(result, DistanceMeter(b, a, limit, work).Bound()) : Infinity;
}
}
