#include "smCurveFoot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Number of parts into which each span is divided for the start of Newton's method.
constexpr int StartParts = 8;
constexpr int MaxSteps = 60;
/// Number of samples from which Newton's method starts: those of the smallest local minima of the distance.
constexpr int MaxStarts = 3;

template <int Dimension>
double GetProduct(const std::array<double, Dimension>& a, const std::array<double, Dimension>& b)
{
  double sum = 0.0;
  for (int c = 0; c < Dimension; ++c)
  {
    sum += a[c] * b[c];
  }
  return sum;
}

template <int Dimension>
std::array<double, Dimension> GetDifference(
  const std::array<double, Dimension>& a, const std::array<double, Dimension>& b)
{
  std::array<double, Dimension> result;
  for (int c = 0; c < Dimension; ++c)
  {
    result[c] = a[c] - b[c];
  }
  return result;
}

/// The parameter on a conic from the coordinates of the point along its axes.
template <int Dimension>
double FindOnConic(const ConicCurve<Dimension>& conic, const std::array<double, Dimension>& point)
{
  const auto away = GetDifference<Dimension>(point, conic.Center);
  const double xx = GetProduct<Dimension>(conic.X, conic.X);
  const double xy = GetProduct<Dimension>(conic.X, conic.Y);
  const double yy = GetProduct<Dimension>(conic.Y, conic.Y);
  const double determinant = xx * yy - xy * xy;
  const double p = GetProduct<Dimension>(away, conic.X);
  const double q = GetProduct<Dimension>(away, conic.Y);
  const double x = (yy * p - xy * q) / determinant;
  const double y = (xx * q - xy * p) / determinant;
  switch (conic.Kind)
  {
    case ConicCurve<Dimension>::Type::Ellipse:
      return std::atan2(y / conic.Radii[1], x / conic.Radii[0]);
    case ConicCurve<Dimension>::Type::Hyperbola:
      return GetHyperbolaParameter(y / conic.Radii[1]);
    default:
      return y;
  }
}

}

template <int Dimension>
double ImproveCurveParameter(const GeometricCurve<Dimension>& curve,
  const std::array<double, Dimension>& point, double t, double low, double high)
{
  typename GeometricCurve<Dimension>::Derivatives d;
  const int order = std::min(2, curve.GetMaxOrder());
  double minimum = std::numeric_limits<double>::infinity();
  double best = t;
  double step = 0.0;
  for (int i = 0; i < MaxSteps; ++i)
  {
    curve.Evaluate(t, order, d);
    const auto gap = GetDifference<Dimension>(point, d[0]);
    const double distance = GetProduct<Dimension>(gap, gap);
    if (!(distance < minimum))
    {
      // A step that leads away is halved.
      step *= 0.5;
      if (std::abs(step) <= 1e-16 * std::max(std::abs(low), std::abs(high)))
      {
        break;
      }
      t = std::clamp(best + step, low, high);
      continue;
    }
    minimum = distance;
    best = t;
    const double slope = GetProduct<Dimension>(gap, d[1]);
    const double square = GetProduct<Dimension>(d[1], d[1]);
    const double second = order > 1 ? GetProduct<Dimension>(gap, d[2]) : 0.0;
    step = slope / (square - second > 0.1 * square ? square - second : square);
    t = std::clamp(t + step, low, high);
    if (!(square > 0.0) || t == best)
    {
      break;
    }
  }
  return best;
}

template <int Dimension>
double FindCurveParameter(const GeometricCurve<Dimension>& curve, const std::array<double, Dimension>& point)
{
  if (const auto* line = curve.template GetIf<LineCurve<Dimension>>())
  {
    return GetProduct<Dimension>(GetDifference<Dimension>(point, line->Origin), line->Direction);
  }
  if (const auto* conic = curve.template GetIf<ConicCurve<Dimension>>())
  {
    return FindOnConic<Dimension>(*conic, point);
  }
  const ParameterRange& domain = curve.GetDomain();
  if (!std::isfinite(domain.Low) || !std::isfinite(domain.High))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  struct Start
  {
    double Square;
    double T;
  };
  std::vector<Start> samples;
  const std::vector<double> breaks = curve.GetBreaks(domain.Low, domain.High);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    for (int i = k == 0 ? 0 : 1; i <= StartParts; ++i)
    {
      const double t = breaks[k] + (breaks[k + 1] - breaks[k]) * i / StartParts;
      const auto gap = GetDifference<Dimension>(point, curve.Evaluate(t));
      samples.push_back({ GetProduct<Dimension>(gap, gap), t });
    }
  }
  // The sample that is closest may be on the wrong side of the end of a closed curve, or of a narrow bend.
  std::vector<Start> starts;
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    const bool isMinimum = (k == 0 || samples[k].Square <= samples[k - 1].Square) &&
      (k + 1 == samples.size() || samples[k].Square <= samples[k + 1].Square);
    if (isMinimum)
    {
      starts.push_back(samples[k]);
    }
  }
  const auto last = starts.begin() + std::min<std::ptrdiff_t>(MaxStarts, starts.end() - starts.begin());
  std::partial_sort(starts.begin(), last, starts.end(),
    [](const Start& a, const Start& b)
    { return a.Square < b.Square || (a.Square == b.Square && a.T < b.T); });
  Start best{ std::numeric_limits<double>::infinity(), domain.Low };
  for (auto start = starts.begin(); start != last; ++start)
  {
    const double t = ImproveCurveParameter<Dimension>(curve, point, start->T, domain.Low, domain.High);
    const auto gap = GetDifference<Dimension>(point, curve.Evaluate(t));
    const double square = GetProduct<Dimension>(gap, gap);
    if (square < best.Square)
    {
      best = { square, t };
    }
  }
  return best.T;
}

template double FindCurveParameter<2>(const GeometricCurve<2>&, const std::array<double, 2>&);
template double FindCurveParameter<3>(const GeometricCurve<3>&, const std::array<double, 3>&);
template double ImproveCurveParameter<3>(
  const GeometricCurve<3>&, const std::array<double, 3>&, double, double, double);
}
