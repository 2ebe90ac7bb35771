#include "smCommonParameter.h"

#include "Geometry/smChebyshevFit.h"
#include "smCellSurface.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sm
{
namespace
{
constexpr double MinLag = 1e-7;
constexpr double LagOverGap = 3.0;
constexpr int FittedDegree = 9;

/// Evaluates polynomial `k` of a curve at t, which may lie beyond its range.
template <int Dimension>
std::array<double, Dimension> EvaluateIn(const PolynomialCurve<Dimension>& curve, int k, double t,
  std::array<double, Dimension>* derivative = nullptr)
{
  const double width = curve.Breaks[k + 1] - curve.Breaks[k];
  const auto point = curve.GetPiece(k).Evaluate((t - curve.Breaks[k]) / width, derivative);
  if (derivative)
  {
    for (double& d : *derivative)
    {
      d /= width;
    }
  }
  return point;
}

/// Fits one trim curve, reparametrised by the parameter of its edge.
class Restorer
{
public:
  Restorer(CellSurface& surface, const EdgeCurve& edge, const TrimCurve& trim,
    const std::array<double, 2>& tolerance)
    : Surface(surface)
    , Edge(edge)
    , Trim(trim)
    , Tolerance(tolerance)
    , Start(trim.GetStart())
    , End(trim.GetEnd())
  {
    for (int d = 0; d < 2; ++d)
    {
      const double value = trim.Coefficients[0][d];
      this->Constant[d] = std::all_of(trim.Coefficients.begin(), trim.Coefficients.end(),
        [d, value](const Point2& p) { return p[d] == value; });
    }
  }

  bool Restore(TrimCurve& result)
  {
    // tau at both ends of the edge.
    double ends[2];
    if (!this->Solve(this->Start, 0, this->Start, ends[0]) ||
      !this->Solve(this->End, this->Edge.GetNumberOfPieces() - 1, this->End, ends[1]))
    {
      return false;
    }
    this->Offset[0] = ends[0] - this->Start;
    this->Offset[1] = ends[1] - this->End;
    this->Most = 20 * this->Trim.GetNumberOfPieces() + 400;
    this->Result.Breaks.push_back(this->Start);
    std::vector<double> breaks;
    if (!this->FindBreaks(breaks))
    {
      return false;
    }
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
      const int piece = this->Edge.FindPiece(0.5 * (breaks[i] + breaks[i + 1]));
      if (!this->Fit(breaks[i], breaks[i + 1], piece, 0, std::numeric_limits<double>::infinity()))
      {
        return false;
      }
    }
    // The ends of the curve remain bitwise those of its neighbours in the loop.
    this->Result.Coefficients.back() = this->Trim.GetEndPoint();
    this->Result.Breaks.back() = this->End;
    for (int d = 0; d < 2; ++d)
    {
      this->Result.AddResidual(d, this->Trim.Residual[d]);
    }
    result = std::move(this->Result);
    return true;
  }

private:
  /// (S(c(tau)) - target) . tangent, and its slope.
  double EvaluateOffset(const Point3& target, const Point3& tangent, double tau, double& slope) const
  {
    Point2 duv;
    const Point2 uv = this->Trim.Evaluate(tau, &duv);
    Point3 du;
    Point3 dv;
    const Point3 position = this->Surface.Evaluate(uv, &du, &dv);
    double offset = 0.0;
    slope = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      offset += (position[c] - target[c]) * tangent[c];
      slope += (du[c] * duv[0] + dv[c] * duv[1]) * tangent[c];
    }
    return offset;
  }

  /// Solves (S(c(tau)) - C(t)) . C'(t) = 0 for tau by Newton's method from a guess, where C is the edge's
  /// polynomial `piece`. The steps are confined to the bracket of points that are known to lie before and
  /// behind, because a curve of uneven speed may make them too long.
  bool Solve(double t, int piece, double guess, double& tau) const
  {
    Point3 tangent;
    const Point3 target = EvaluateIn<3>(this->Edge, piece, t, &tangent);
    const double range = this->End - this->Start;
    const double infinity = std::numeric_limits<double>::infinity();
    double low = -infinity;
    double high = infinity;
    double last = infinity;
    double reach = range / 64.0;
    tau = guess;
    for (int i = 0; i < 60; ++i)
    {
      double slope;
      const double offset = this->EvaluateOffset(target, tangent, tau, slope);
      (offset > 0.0 ? high : low) = tau;
      double next = tau - offset / slope;
      if (!std::isfinite(offset))
      {
        return false;
      }
      const bool isNear = slope > 0.0 && std::abs(next - tau) <= Near * range;
      if (!isNear && (!(slope > 0.0) || !(next > low && next < high) || std::abs(next - tau) > reach))
      {
        // Bisects the bracket, or, as long as there is none, takes increasing steps.
        const bool bracketed = std::isfinite(low) && std::isfinite(high);
        next = bracketed ? 0.5 * (low + high) : offset > 0.0 ? tau - reach : tau + reach;
        reach *= bracketed ? 1.0 : 2.0;
      }
      const double step = std::abs(next - tau);
      if (!(std::abs(next - t) <= 0.5 * range))
      {
        return false;
      }
      tau = next;
      // Convergence is quadratic until rounding stops it.
      if (step <= 4.0 * UnitRoundoff * range || (step <= Near * range && step >= last))
      {
        return true;
      }
      last = step;
    }
    return last <= Near * range;
  }

  bool Map(double t, int piece, double& tau) const
  {
    if (t == this->Start || t == this->End)
    {
      tau = t;
      return true;
    }
    const double x = (t - this->Start) / (this->End - this->Start);
    const double offset = (1.0 - x) * this->Offset[0] + x * this->Offset[1];
    if (!this->Solve(t, piece, std::clamp(t + offset, this->Start, this->End), tau))
    {
      return false;
    }
    tau -= offset;
    return tau >= this->Start && tau <= this->End;
  }

  /// Returns the parameters between which c is one polynomial and stays in one cell of the surface.
  std::vector<double> FindTrimBreaks() const
  {
    std::vector<double> breaks;
    const auto cell = [this](const Point2& p, int d) { return this->Surface.FindCell(d, p[d]); };
    for (int k = 0; k < this->Trim.GetNumberOfPieces(); ++k)
    {
      const double a = this->Trim.Breaks[k];
      const double width = this->Trim.Breaks[k + 1] - a;
      for (int d = 0; d < 2; ++d)
      {
        for (int i = 0; !this->Constant[d] && i < FitOrder; ++i)
        {
          double low = a + GetFitNodes()[i] * width;
          double high = a + GetFitNodes()[i + 1] * width;
          const auto first = cell(EvaluateIn<2>(this->Trim, k, low), d);
          if (first == cell(EvaluateIn<2>(this->Trim, k, high), d))
          {
            continue;
          }
          for (int n = 0; n < 60 && high > low; ++n)
          {
            const double middle = 0.5 * (low + high);
            (cell(EvaluateIn<2>(this->Trim, k, middle), d) == first ? low : high) = middle;
          }
          breaks.push_back(high);
        }
      }
      breaks.push_back(this->Trim.Breaks[k + 1]);
    }
    return breaks;
  }

  /// Solves Map(t) = tau for t by the Illinois variant of regula falsi.
  bool Invert(double tau, double& t) const
  {
    double low = this->Start;
    double high = this->End;
    double atLow = low - tau;
    double atHigh = high - tau;
    int side = 0;
    t = tau;
    for (int n = 0; n < 100 && high - low > 1e-15 * (this->End - this->Start); ++n)
    {
      t = n == 0 ? tau : low - atLow * (high - low) / (atHigh - atLow);
      t = t > low && t < high && n % 4 != 3 ? t : 0.5 * (low + high);
      double mapped;
      if (!(t > low && t < high))
      {
        break;
      }
      if (!this->Map(t, this->Edge.FindPiece(t), mapped))
      {
        return false;
      }
      const double value = mapped - tau;
      if (std::abs(value) <= 1e-15 * (this->End - this->Start))
      {
        break;
      }
      if (value < 0.0)
      {
        low = t;
        atLow = value;
        atHigh *= side < 0 ? 0.5 : 1.0;
        side = -1;
      }
      else
      {
        high = t;
        atHigh = value;
        atLow *= side > 0 ? 0.5 : 1.0;
        side = 1;
      }
    }
    return true;
  }

  /// Finds the parameters t at which the map or the curve has a knot, including the ends.
  bool FindBreaks(std::vector<double>& breaks) const
  {
    breaks = this->Edge.Breaks;
    breaks.front() = this->Start;
    breaks.back() = this->End;
    for (const double tau : this->FindTrimBreaks())
    {
      double t;
      if (tau > this->Start && tau < this->End)
      {
        if (!this->Invert(tau, t))
        {
          return false;
        }
        breaks.push_back(t);
      }
    }
    std::sort(breaks.begin(), breaks.end());
    std::vector<double> kept{ this->Start };
    for (const double t : breaks)
    {
      if (t - kept.back() > 1e-12 * (this->End - this->Start) &&
        this->End - t > 1e-12 * (this->End - this->Start))
      {
        kept.push_back(t);
      }
    }
    kept.push_back(this->End);
    breaks = std::move(kept);
    return true;
  }

  bool Fit(double a, double b, int edgePiece, int depth, double parentExcess)
  {
    std::array<Point2, FitOrder + 1> samples;
    double last = this->Start;
    for (int i = 0; i <= FitOrder; ++i)
    {
      const double t = i == FitOrder ? b : a + GetFitNodes()[i] * (b - a);
      double tau;
      if (!this->Map(t, edgePiece, tau) || (i > 0 && !(tau > last)))
      {
        return false;
      }
      last = tau;
      samples[i] = this->Trim.Evaluate(tau);
    }
    std::array<double, 2> tolerance = this->Tolerance;
    for (int d = 0; d < 2; ++d)
    {
      const double largest = std::max(std::abs(samples[0][d]), std::abs(samples[FitOrder][d]));
      tolerance[d] = std::max(tolerance[d], 8.0 * UnitRoundoff * largest);
    }
    FittedPiece<2> piece;
    const bool met = FitPiece<2>(samples, FittedDegree, tolerance, piece);
    const double excess = std::max(piece.Residual[0] / tolerance[0], piece.Residual[1] / tolerance[1]);
    const bool noise = excess > NoiseRatio * parentExcess && excess < MaximumNoise;
    const double middle = 0.5 * (a + b);
    if (!met && !noise && depth < MaximumDepth && middle > a && middle < b)
    {
      return this->Fit(a, middle, edgePiece, depth + 1, excess) &&
        this->Fit(middle, b, edgePiece, depth + 1, excess);
    }
    for (int d = 0; d < 2; ++d)
    {
      for (int i = 0; this->Constant[d] && i <= piece.Degree; ++i)
      {
        piece.Coefficients[i][d] = this->Trim.Coefficients[0][d];
      }
      this->Result.RaiseResidual(d, this->Constant[d] ? 0.0 : piece.Residual[d]);
    }
    // A residual far above the tolerance would move the border of the face too much.
    if (this->Result.GetNumberOfPieces() >= this->Most || !(met || excess < MaximumExcess))
    {
      return false;
    }
    this->Result.AppendPiece(b, piece.Coefficients.data(), piece.Degree);
    return true;
  }

  /// Length of Newton's steps, relative to the range, below which rounding dominates them.
  static constexpr double Near = 1e-9;
  /// Largest accepted residual, in tolerances.
  static constexpr double MaximumExcess = 100.0;

  CellSurface& Surface;
  const EdgeCurve& Edge;
  const TrimCurve& Trim;
  std::array<double, 2> Tolerance;
  double Start;
  double End;
  double Offset[2] = { 0.0, 0.0 };
  bool Constant[2] = { false, false };
  int Most = 0;
  TrimCurve Result;
};

Step MeasureStep(CellSurface& surface, const TrimCurve& trim, const EdgeCurve& edge)
{
  Step step;
  for (int k = 0; k < trim.GetNumberOfPieces(); ++k)
  {
    for (const double x : { 0.2, 0.5, 0.8 })
    {
      const double t = trim.Breaks[k] + x * (trim.Breaks[k + 1] - trim.Breaks[k]);
      const Point2 uv = trim.GetPiece(k).Evaluate(x);
      const Point3 position = surface.Evaluate(uv);
      Point3 tangent;
      const Point3 target = edge.Evaluate(t, &tangent);
      const Point3 gap = { target[0] - position[0], target[1] - position[1], target[2] - position[2] };
      const double speed = std::sqrt(Dot(tangent, tangent));
      const double along = speed > 0.0 ? Dot(gap, tangent) / speed : 0.0;
      step.Lag = std::max(step.Lag, std::abs(along));
      step.Gap = std::max(step.Gap, std::sqrt(std::max(0.0, Dot(gap, gap) - along * along)));
    }
  }
  return step;
}

bool IsLagging(const Step& step, double size)
{
  return step.Lag > MinLag * size && step.Lag > LagOverGap * step.Gap;
}
}

Step MeasureStep(const NURBSSurface& surface, const TrimCurve& trim, const EdgeCurve& edge)
{
  CellSurface cells(surface);
  return MeasureStep(cells, trim, edge);
}

StepResult RestoreCommonParameter(const NURBSSurface& surface, const EdgeCurve& edge, double size,
  const std::array<double, 2>& tolerance, TrimCurve& trim)
{
  CellSurface cells(surface);
  const Step before = MeasureStep(cells, trim, edge);
  if (!IsLagging(before, size))
  {
    return StepResult::InStep;
  }
  TrimCurve restored;
  try
  {
    if (!Restorer(cells, edge, trim, tolerance).Restore(restored))
    {
      return StepResult::Failed;
    }
  }
  catch (const std::runtime_error&)
  {
    // A sample is not finite.
    return StepResult::Failed;
  }
  if (!(MeasureStep(cells, restored, edge).Lag <= 0.5 * before.Lag))
  {
    return StepResult::Failed;
  }
  trim = std::move(restored);
  return StepResult::Restored;
}
}
