#include "smCurveFit.h"

#include "smChebyshevFit.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace sm
{
namespace
{
constexpr int EdgeDegree = 12;
}

EdgeCurve FitEdge(
  const std::function<Vector3(double)>& position, const std::vector<double>& breaks, double magnitude)
{
  using Samples = std::array<Vector3, FitOrder + 1>;
  const auto sample = [&position](double a, double b, Samples& samples)
  {
    for (int i = 0; i <= FitOrder; ++i)
    {
      samples[i] = position(i == FitOrder ? b : a + GetFitNodes()[i] * (b - a));
    }
  };
  struct Interval
  {
    double Start;
    double End;
    int Depth;
    double ParentResidual;
  };
  Samples samples;
  Vector3 low = position(breaks.front());
  Vector3 high = low;
  std::vector<Interval> stack;
  for (std::size_t i = breaks.size() - 1; i > 0; --i)
  {
    stack.push_back({ breaks[i - 1], breaks[i], 0, std::numeric_limits<double>::infinity() });
    sample(breaks[i - 1], breaks[i], samples);
    for (const Vector3& p : samples)
    {
      for (int c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
    }
  }
  double size = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    size = std::max(size, high[c] - low[c]);
    magnitude = std::max({ magnitude, std::abs(low[c]), std::abs(high[c]) });
  }
  // The evaluation of a rational spline has several roundings relative to the size of its control points.
  const double floor = std::max(1e-14 * size, 8.0 * UnitRoundoff * magnitude);
  EdgeCurve result;
  result.Breaks.push_back(breaks.front());
  while (!stack.empty())
  {
    const Interval interval = stack.back();
    stack.pop_back();
    sample(interval.Start, interval.End, samples);
    FittedPiece<3> piece;
    const bool met = FitPiece<3>(samples, EdgeDegree, { floor, floor, floor }, piece);
    const Vector3& r = piece.Residual;
    const double residual = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    const bool noise = residual > NoiseRatio * interval.ParentResidual && residual < MaximumNoise * floor;
    const double middle = 0.5 * (interval.Start + interval.End);
    if (!met && !noise && interval.Depth < MaximumDepth && middle > interval.Start && middle < interval.End)
    {
      stack.push_back({ middle, interval.End, interval.Depth + 1, residual });
      stack.push_back({ interval.Start, middle, interval.Depth + 1, residual });
      continue;
    }
    for (int d = 0; d < 3; ++d)
    {
      result.RaiseResidual(d, r[d]);
    }
    if (result.GetNumberOfPieces() >= MaximumPieces)
    {
      throw std::runtime_error("its curve needs more than " + std::to_string(MaximumPieces) + " pieces");
    }
    result.AppendPiece(interval.End, piece.Coefficients.data(), piece.Degree);
  }
  return result;
}
}
