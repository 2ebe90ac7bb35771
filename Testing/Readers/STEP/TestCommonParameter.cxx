// Trim curves out of step with their edge: the parameter in common comes back, the points of the face stay
// what they were, and where there is no such parameter the curve is left alone. Residuals cover what is
// between trim curves and edges.
#include "Geometry/smChebyshevFit.h"
#include "Trims/smCommonParameter.h"
#include "Trims/smTrimResidual.h"
#include "smTesting.h"

#include <cmath>
#include <functional>

namespace
{
using smtest::Check;
using smtest::CheckRange;
using smtest::CheckTrue;
using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;

/// S(u,v) = (u, v, u v / 10) on [0,4] x [0,2], cut into 8 x 2 cells: bilinear, as a B-spline of degree 1.
sm::NURBSSurface MakeSurface()
{
  sm::NURBSSurface surface;
  surface.Knots[0] = { 0.0, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.0 };
  surface.Knots[1] = { 0.0, 0.0, 1.0, 2.0, 2.0 };
  surface.NumberOfControlPoints[0] = 9;
  surface.NumberOfControlPoints[1] = 3;
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 9; ++i)
    {
      surface.ControlPoints.push_back({ 0.5 * i, 1.0 * j, 0.05 * i * j, 1.0 });
    }
  }
  return surface;
}

/// A function as pieces of degree 15, to rounding.
template <int Dimension>
sm::PolynomialCurve<Dimension> Fit(
  const std::vector<double>& breaks, const std::function<std::array<double, Dimension>(double)>& f)
{
  sm::PolynomialCurve<Dimension> curve;
  curve.Breaks = { breaks[0] };
  std::array<double, Dimension> tolerance;
  tolerance.fill(1e-16);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    std::array<std::array<double, Dimension>, sm::FitOrder + 1> samples;
    for (int i = 0; i <= sm::FitOrder; ++i)
    {
      samples[i] = f(breaks[k] + sm::GetFitNodes()[i] * (breaks[k + 1] - breaks[k]));
    }
    sm::FittedPiece<Dimension> piece;
    sm::FitPiece<Dimension>(samples, 15, tolerance, piece);
    curve.AppendPiece(breaks[k + 1], piece.Coefficients.data(), piece.Degree);
  }
  return curve;
}

/// Integral of u dv by Simpson's rule, whose error of 400 steps a piece is far below the limit for these
/// curves.
double EnclosedArea(const sm::TrimCurve& curve)
{
  double sum = 0.0;
  for (int k = 0; k < curve.GetNumberOfPieces(); ++k)
  {
    const int n = 400;
    for (int i = 0; i <= n; ++i)
    {
      Point2 d;
      const Point2 p = curve.GetPiece(k).Evaluate(static_cast<double>(i) / n, &d);
      sum += (i == 0 || i == n ? 1.0 : i % 2 ? 4.0 : 2.0) / (3.0 * n) * p[0] * d[1];
    }
  }
  return sum;
}

struct Case
{
  const char* Name;
  std::function<Point2(double)> Trim;
  /// The edge's point at t is the face's at c(Lead(t)), plus Offset.
  std::function<double(double)> Lead;
  Point3 Offset;
  sm::StepResult Expected;
};

void CheckCase(const Case& c)
{
  std::printf("--- %s\n", c.Name);
  const sm::NURBSSurface surface = MakeSurface();
  sm::TrimCurve trim = Fit<2>({ 0.0, 0.4, 1.0 }, c.Trim);
  const sm::EdgeCurve edge = Fit<3>({ 0.0, 0.25, 0.7, 1.0 },
    [&c](double t)
    {
      const Point2 p = c.Trim(c.Lead(t));
      return Point3{ p[0] + c.Offset[0], p[1] + c.Offset[1], 0.1 * p[0] * p[1] + c.Offset[2] };
    });
  const sm::TrimCurve before = trim;
  const sm::Step lagging = sm::MeasureStep(surface, trim, edge);
  const sm::StepResult result = sm::RestoreCommonParameter(surface, edge, 5.0, { 4e-13, 2e-13 }, trim);
  CheckTrue("the result", result == c.Expected, std::to_string(static_cast<int>(result)));
  if (c.Expected != sm::StepResult::Restored)
  {
    CheckTrue(
      "the curve is as it was", trim.Coefficients == before.Coefficients && trim.Breaks == before.Breaks);
    return;
  }
  CheckTrue("it lagged", lagging.Lag > 1e-3);
  const sm::Step step = sm::MeasureStep(surface, trim, edge);
  const double offset = std::hypot(c.Offset[0], c.Offset[1], c.Offset[2]);
  // The ends of an edge off the face keep what the offset has along the edge, and the middle some of that.
  CheckRange("the lag that is left", 0.0, step.Lag, 2e-12 + offset);
  CheckRange("the gap", 0.0, step.Gap, 2e-12 + 1.01 * offset);
  CheckTrue(
    "the ends", trim.GetStartPoint() == before.GetStartPoint() && trim.GetEndPoint() == before.GetEndPoint());
  CheckTrue("the range", trim.GetStart() == 0.0 && trim.GetEnd() == 1.0);
  CheckRange("the residual", 0.0, trim.GetMaxResidual(), 1e-12, "some tolerances");
  // Every point of the new curve is one of the old: the area next to it is the same.
  Check("the area", EnclosedArea(before), EnclosedArea(trim), 4e-12,
    "the residual times the length, Simpson's error");
  bool joined = trim.Breaks.size() == static_cast<std::size_t>(trim.GetNumberOfPieces()) + 1;
  for (int k = 1; k < trim.GetNumberOfPieces(); ++k)
  {
    joined = joined && trim.Coefficients[trim.Offsets[k]] == trim.Coefficients[trim.Offsets[k] - 1] &&
      trim.Breaks[k] > trim.Breaks[k - 1];
  }
  CheckTrue("pieces join to the bit", joined);
}

/// The residual of a slanted line in u alone covers what is between it and an edge that is displaced in u:
/// the distance across the edge is a twentieth of that, and counts for u and v together only.
void CheckResidual(const char* name, double moved, bool isPerPiece)
{
  std::printf("--- %s\n", name);
  constexpr double stated = 1e-3;
  const auto point = [](double t) { return Point2{ 0.5 + 3.0 * t, 0.5 + 0.15 * t }; };
  sm::TrimCurve trim = Fit<2>({ 0.0, 0.4, 1.0 }, point);
  const sm::EdgeCurve edge = Fit<3>({ 0.0, 0.25, 0.7, 1.0 },
    [&](double t)
    {
      const Point2 p = point(t);
      return Point3{ p[0] - moved, p[1], 0.1 * (p[0] - moved) * p[1] };
    });
  trim.Residual = { stated, 0.0 };
  trim.PieceResiduals.assign(isPerPiece ? trim.GetNumberOfPieces() : 0, trim.Residual);
  sm::LowerResidual(MakeSurface(), edge, trim);
  CheckRange("the area of the parameters between them", (1.0 - 1e-9) * moved * 0.15, sm::GetSweptArea(trim),
    (1.0 + 1e-9) * moved * 0.15 + 1e-14);
}
}

int TestCommonParameter(int, char*[])
{
  const auto line = [](double t) { return Point2{ 0.25 + 3.5 * t, 0.5 }; };
  const auto slanted = [](double t) { return Point2{ 0.25 + 3.5 * t, 1.75 - 1.5 * t }; };
  const auto bent = [](double t) {
    return Point2{ 0.25 + 3.5 * t, 0.5 + 1.2 * t * (1.0 - t) + 0.3 * t * t * t };
  };
  const auto late = [](double t) { return t - 0.1 * t * (1.0 - t); };
  const auto swaying = [](double t) { return t + 0.02 * std::sin(6.2831853071795862 * t); };
  const auto same = [](double t) { return t; };
  const auto turning = [](double t) { return t + 0.4 * std::sin(6.2831853071795862 * t); };
  const Point3 none = { 0.0, 0.0, 0.0 };
  CheckCase({ "a line of constant parameter, late", line, late, none, sm::StepResult::Restored });
  CheckCase({ "a slanted line, late", slanted, late, none, sm::StepResult::Restored });
  CheckCase({ "a bent curve, late", bent, late, none, sm::StepResult::Restored });
  CheckCase({ "a bent curve, early and late", bent, swaying, none, sm::StepResult::Restored });
  CheckCase({ "an edge off its face", bent, swaying, { 0.0, 1e-6, -2e-6 }, sm::StepResult::Restored });
  CheckCase({ "in step", bent, same, none, sm::StepResult::InStep });
  CheckCase({ "a gap is not a lag", bent, same, { 0.0, 1e-3, -2e-3 }, sm::StepResult::InStep });
  CheckCase({ "an edge that runs back", bent, turning, none, sm::StepResult::Failed });
  CheckCase({ "an edge that starts elsewhere", line, [](double t) { return 0.1 + 0.9 * t; }, none,
    sm::StepResult::Failed });
  for (const bool isPerPiece : { false, true })
  {
    CheckResidual("a slanted line off its edge", 1e-3, isPerPiece);
    CheckResidual("a slanted line on its edge", 0.0, isPerPiece);
  }
  return smtest::Finish();
}
