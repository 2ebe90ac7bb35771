#include "smTrimProjection.h"

#include "smChebyshevFit.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace sm
{
namespace
{
using Point2 = TrimCurve::Point;

constexpr int FittedDegree = 9;
// Largest residual that is put up with, in tolerances.
constexpr double MaximumExcess = 100.0;
// Newton's steps are rounding below the first of these parts of the edge's length, or the second of its coordinates; no foot point is
// farther from the curve than the third of its length.
constexpr double SmallestStep = 1e-13;
constexpr double StepRoundings = 64.0 * UnitRoundoff;
constexpr double LargestMove = 1e-3;
constexpr int MostSteps = 20;

bool IsConstant(const TrimCurve& trim, int direction)
{
  const double value = trim.Coefficients[0][direction];
  return std::all_of(trim.Coefficients.begin(), trim.Coefficients.end(),
    [=](const Point2& p) { return p[direction] == value; });
}

class Projector
{
public:
  Projector(const NURBSSurface& surface, const EdgeCurve& edge, const std::array<double, 2>& tolerance,
    const TrimCurve& trim)
    : Surface(surface)
    , Edge(edge)
    , Trim(trim)
    , Tolerance(tolerance)
  {
    for (std::size_t i = 1; i < edge.Coefficients.size(); ++i)
    {
      this->Length += Norm(Subtract(edge.Coefficients[i], edge.Coefficients[i - 1]));
      this->Floor = std::max(this->Floor, StepRoundings * Norm(edge.Coefficients[i]));
    }
    this->Floor = std::max(this->Floor, SmallestStep * this->Length);
  }

  bool Project(TrimCurve& result)
  {
    this->Most = 20 * static_cast<std::size_t>(this->Trim.GetNumberOfPieces()) + 400;
    std::vector<double> breaks = this->Edge.Breaks;
    breaks.insert(breaks.end(), this->Trim.Breaks.begin(), this->Trim.Breaks.end());
    breaks.front() = this->Trim.GetStart();
    std::sort(breaks.begin(), breaks.end());
    const double end = this->Trim.GetEnd();
    const double least = 1e-12 * (end - this->Trim.GetStart());
    double start = this->Trim.GetStart();
    this->Result.Breaks.push_back(start);
    for (const double next : breaks)
    {
      if (next - start > least && (end - next > least || next == end))
      {
        if (!this->Fit(start, next, 0, std::numeric_limits<double>::infinity()))
        {
          return false;
        }
        start = next;
      }
    }
    if (start != end)
    {
      return false;
    }
    this->KeepEnd(this->Trim.GetStartPoint(), this->Result.Coefficients.front());
    this->KeepEnd(this->Trim.GetEndPoint(), this->Result.Coefficients.back());
    result = std::move(this->Result);
    return true;
  }

  /// The largest distance of the curve from the points of the surface that are nearest to the edge, to first order, and of these
  /// points from the edge.
  double MeasureMove(const TrimCurve& trim, double* across = nullptr)
  {
    double largest = 0.0;
    for (int k = 0; k < trim.GetNumberOfPieces(); ++k)
    {
      for (const double x : { 0.0, 0.2, 0.5, 0.8, 1.0 })
      {
        const double t = trim.Breaks[k] + x * (trim.Breaks[k + 1] - trim.Breaks[k]);
        Point2 uv = trim.GetPiece(k).Evaluate(x);
        Vector3 gap;
        const double step = this->Step(this->Edge.Evaluate(t), uv, gap);
        if (across)
        {
          *across = std::max(*across, std::sqrt(std::max(0.0, Dot(gap, gap) - step * step)));
        }
        // Not std::max, which loses a NaN.
        largest = step <= largest ? largest : step;
      }
    }
    return largest;
  }

  /// Moves below this are rounding.
  double GetFloor() const { return this->Floor; }

private:
  /// One step of Gauss-Newton's method for the nearest point. Returns its length in space; NaN at a pole.
  double Step(const Vector3& target, Point2& uv, Vector3& gap)
  {
    Vector3 position;
    Vector3 du;
    Vector3 dv;
    this->Surface.Evaluate(uv[0], uv[1], position.data(), du.data(), dv.data());
    gap = Subtract(target, position);
    const double a = Dot(du, du);
    const double b = Dot(du, dv);
    const double c = Dot(dv, dv);
    const double determinant = a * c - b * b;
    if (!(determinant > 1e-8 * a * c))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const double u = (c * Dot(du, gap) - b * Dot(dv, gap)) / determinant;
    const double v = (a * Dot(dv, gap) - b * Dot(du, gap)) / determinant;
    uv[0] += u;
    uv[1] += v;
    return std::sqrt(std::max(0.0, a * u * u + 2.0 * b * u * v + c * v * v));
  }

  bool FindFoot(double t, Point2& uv)
  {
    const Vector3 target = this->Edge.Evaluate(t);
    uv = this->Trim.Evaluate(t);
    double moved = 0.0;
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < MostSteps; ++i)
    {
      Vector3 gap;
      const double step = this->Step(target, uv, gap);
      moved += step;
      if (!(moved <= LargestMove * this->Length))
      {
        return false;
      }
      // Until rounding stops it.
      if (step <= this->Floor && (step >= 0.5 * last || step <= 1e-3 * this->Floor))
      {
        return true;
      }
      last = step;
    }
    return last <= this->Floor;
  }

  bool Fit(double a, double b, int depth, double parentExcess)
  {
    std::array<Point2, FitOrder + 1> samples;
    for (int i = 0; i <= FitOrder; ++i)
    {
      if (!this->FindFoot(i == FitOrder ? b : a + GetFitNodes()[i] * (b - a), samples[i]))
      {
        return false;
      }
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
    const bool noise = excess > NoiseRatio * parentExcess && excess < MaximumExcess;
    const double middle = 0.5 * (a + b);
    if (!met && !noise && depth < MaximumDepth && middle > a && middle < b)
    {
      return this->Fit(a, middle, depth + 1, excess) && this->Fit(middle, b, depth + 1, excess);
    }
    if (this->Result.Breaks.size() > this->Most || !(met || excess < MaximumExcess))
    {
      return false;
    }
    for (int d = 0; d < 2; ++d)
    {
      this->Result.RaiseResidual(d, piece.Residual[d]);
    }
    this->Result.AppendPiece(b, piece.Coefficients.data(), piece.Degree);
    return true;
  }

  /// Neighbours in a loop end in the same number where they did before.
  void KeepEnd(const Point2& before, Point2& now) const
  {
    for (int d = 0; d < 2; ++d)
    {
      const double slack = std::max(this->Tolerance[d], 8.0 * UnitRoundoff * std::abs(before[d]));
      now[d] = std::abs(now[d] - before[d]) <= slack ? before[d] : now[d];
    }
  }

  NURBSSurface::Walker Surface;
  const EdgeCurve& Edge;
  const TrimCurve& Trim;
  std::array<double, 2> Tolerance;
  double Length = 0.0;
  double Floor = 0.0;
  std::size_t Most = 0;
  TrimCurve Result;
};
}

bool ProjectEdge(
  const NURBSSurface& surface, const EdgeCurve& edge, const std::array<double, 2>& tolerance, TrimCurve& trim)
{
  if (IsConstant(trim, 0) || IsConstant(trim, 1))
  {
    return false;
  }
  Projector projector(surface, edge, tolerance, trim);
  double across = 0.0;
  const double before = projector.MeasureMove(trim, &across);
  if (!(before > std::max(projector.GetFloor(), across)))
  {
    return false;
  }
  TrimCurve projected;
  try
  {
    if (!projector.Project(projected))
    {
      return false;
    }
  }
  catch (const std::runtime_error&)
  {
    // A sample is not finite.
    return false;
  }
  if (!(projector.MeasureMove(projected) <= 0.1 * before))
  {
    return false;
  }
  trim = std::move(projected);
  return true;
}
}
