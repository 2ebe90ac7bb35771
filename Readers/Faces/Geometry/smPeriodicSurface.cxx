#include "smPeriodicSurface.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// A box may extend beyond the domain by this fraction of the period: the rounding of trim curves along the
/// border.
constexpr double DomainSlack = 1e-9;

/// Rows of control points within this distance, in millimetres, are the same.
constexpr double SameRow = 1e-7;

/// Relative difference of weights that are the same.
constexpr double SameWeight = 1e-9;

/// Relative difference of knots, in periods, that are the same a period apart.
constexpr double SameKnot = 1e-9;

/// A spline with fewer control points does not close.
constexpr int MinClosedCount = 4;

/// Rows of a net of control points across one direction.
struct NetRows
{
  const SplineSurface& Spline;
  int Direction;

  int GetCount() const { return this->Spline.Basis[this->Direction].GetCount(); }
  int GetLength() const { return this->Spline.Basis[1 - this->Direction].GetCount(); }
  std::size_t GetIndex(int row, int k) const
  {
    const std::size_t columns = this->Spline.Basis[0].GetCount();
    return this->Direction == 0 ? row + k * columns : k + row * columns;
  }
};

/// How the control points and knots of a direction repeat: those from First on, Count of them, are all.
struct Repetition
{
  int First = 0;
  /// 0: they do not repeat.
  int Count = 0;
  SplineBasis Basis;
};

/**
 * Finds the repetition that the knots of one direction allow. End knots of full multiplicity lose one, for
 * the last control point is the first. Other knots must repeat with the period of the domain, and then the
 * control points repeat with the number of knots in a period.
 */
Repetition FindRepetition(const SplineBasis& basis)
{
  Repetition result;
  const int count = basis.GetCount();
  const int degree = basis.Degree;
  if (basis.Periodic || count < MinClosedCount)
  {
    return result;
  }
  result.Basis.Degree = degree;
  result.Basis.Periodic = true;
  if (basis.Multiplicities.front() == degree + 1 && basis.Multiplicities.back() == degree + 1)
  {
    result.Count = count - 1;
    result.Basis.Knots = basis.Knots;
    result.Basis.Multiplicities = basis.Multiplicities;
    result.Basis.Multiplicities.front() = result.Basis.Multiplicities.back() = degree;
    return result;
  }
  std::vector<double> flat;
  for (std::size_t i = 0; i < basis.Knots.size(); ++i)
  {
    flat.insert(flat.end(), basis.Multiplicities[i], basis.Knots[i]);
  }
  const double start = basis.GetStart();
  const double end = basis.GetEnd();
  const auto last = std::upper_bound(flat.begin(), flat.end(), start) - flat.begin() - 1;
  const auto stop = std::upper_bound(flat.begin(), flat.end(), end) - flat.begin() - 1;
  const int period = static_cast<int>(stop - last);
  for (std::size_t i = 0; i + period < flat.size(); ++i)
  {
    if (!(std::abs(flat[i + period] - flat[i] - (end - start)) <= SameKnot * (end - start)))
    {
      return result;
    }
  }
  for (std::size_t i = 0; i < basis.Knots.size(); ++i)
  {
    if (basis.Knots[i] >= start && basis.Knots[i] <= end)
    {
      result.Basis.Knots.push_back(basis.Knots[i]);
      result.Basis.Multiplicities.push_back(basis.Multiplicities[i]);
    }
  }
  result.First = std::max(0, static_cast<int>(last) - degree);
  const bool isPossible = result.Basis.Multiplicities.front() == result.Basis.Multiplicities.back() &&
    result.Basis.Multiplicities.front() <= degree && period < count && result.First + period <= count;
  result.Count = isPossible ? period : 0;
  return result;
}

bool IsClosed(const NetRows& rows, const Repetition& repetition)
{
  const SplineSurface& spline = rows.Spline;
  for (int row = 0; repetition.Count > 0 && row + repetition.Count < rows.GetCount(); ++row)
  {
    for (int k = 0; k < rows.GetLength(); ++k)
    {
      const std::size_t a = rows.GetIndex(row, k);
      const std::size_t b = rows.GetIndex(row + repetition.Count, k);
      const bool isSameWeight = spline.Weights.empty() ||
        std::abs(spline.Weights[a] - spline.Weights[b]) <= SameWeight * spline.Weights[a];
      if (!isSameWeight || !(Norm(Subtract(spline.Poles[a], spline.Poles[b])) <= SameRow))
      {
        return false;
      }
    }
  }
  return repetition.Count > 0;
}

/// Drops the rows that repeat others. Raises `distance` by a bound of what that changes: with control points
/// P_i and P_i + d_i and weights w_i and w_i + e_i a point moves by at most the largest |d_i| + |e_i| /
/// min(w_i, w_i + e_i) diameter, because the basis functions B_i w_i / sum B_i w_i are at most 1 in total.
SplineSurface Close(const NetRows& rows, const Repetition& repetition, double diameter, double& distance)
{
  const SplineSurface& spline = rows.Spline;
  SplineSurface result;
  result.Basis[1 - rows.Direction] = spline.Basis[1 - rows.Direction];
  result.Basis[rows.Direction] = repetition.Basis;
  double moved = 0.0;
  const int columns = spline.Basis[0].GetCount();
  for (std::size_t k = 0; k < spline.Poles.size(); ++k)
  {
    const int place[2] = { static_cast<int>(k) % columns, static_cast<int>(k) / columns };
    const int row = place[rows.Direction];
    if (row >= repetition.First && row < repetition.First + repetition.Count)
    {
      result.Poles.push_back(spline.Poles[k]);
      if (!spline.Weights.empty())
      {
        result.Weights.push_back(spline.Weights[k]);
      }
      continue;
    }
    const int same = row < repetition.First ? row + repetition.Count : row - repetition.Count;
    const std::size_t other = rows.GetIndex(same, place[1 - rows.Direction]);
    double step = Norm(Subtract(spline.Poles[k], spline.Poles[other]));
    if (!spline.Weights.empty())
    {
      const double w[2] = { spline.Weights[k], spline.Weights[other] };
      step += std::abs(w[0] - w[1]) / std::min(w[0], w[1]) * diameter;
    }
    moved = std::max(moved, step);
  }
  distance += moved;
  return result;
}

double GetDiameter(const std::vector<Vector3>& points)
{
  Vector3 low = points[0];
  Vector3 high = points[0];
  for (const Vector3& p : points)
  {
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  }
  return Norm(Subtract(high, low));
}

/// Returns the surface along the periodic profile; null if the profile is not a whole closed spline.
template <class Swept>
SurfacePointer SweepPeriodic(const Swept& swept)
{
  const ParameterRange& domain = swept.Profile->GetDomain();
  const bool isWhole = !(swept.Range.Low > domain.Low || swept.Range.High < domain.High);
  Swept result = swept;
  result.Profile = isWhole ? MakePeriodic(swept.Profile, 0.0) : nullptr;
  result.Range = ParameterRange();
  std::string problem;
  return result.Profile ? GeometricSurface::Make(std::move(result), problem) : nullptr;
}
}

CurvePointer<3> MakePeriodic(const CurvePointer<3>& curve, double tolerance)
{
  const auto* spline = curve->GetIf<SplineCurve<3>>();
  const Repetition repetition = spline ? FindRepetition(spline->Basis) : Repetition();
  for (int i = 0; i + repetition.Count < (repetition.Count > 0 ? spline->Basis.GetCount() : 0); ++i)
  {
    const Vector3& a = spline->Poles[i];
    const Vector3& b = spline->Poles[i + repetition.Count];
    const bool isSameWeight = spline->Weights.empty() ||
      std::abs(spline->Weights[i] - spline->Weights[i + repetition.Count]) <= tolerance * spline->Weights[i];
    if (!isSameWeight || !(Norm(Subtract(a, b)) <= tolerance * (Norm(a) + Norm(b))))
    {
      return nullptr;
    }
  }
  if (repetition.Count == 0)
  {
    return nullptr;
  }
  SplineCurve<3> periodic;
  periodic.Basis = repetition.Basis;
  const auto first = spline->Poles.begin() + repetition.First;
  periodic.Poles.assign(first, first + repetition.Count);
  if (!spline->Weights.empty())
  {
    const auto weight = spline->Weights.begin() + repetition.First;
    periodic.Weights.assign(weight, weight + repetition.Count);
  }
  std::string problem;
  return GeometricCurve<3>::Make(std::move(periodic), problem);
}

SurfacePointer MakePeriodic(const SurfacePointer& surface, FileSurface& own)
{
  SurfacePointer swept;
  if (const auto* extruded = surface->GetIf<ExtrudedSurface>())
  {
    swept = SweepPeriodic(*extruded);
  }
  else if (const auto* revolved = surface->GetIf<RevolvedSurface>())
  {
    swept = SweepPeriodic(*revolved);
  }
  const auto* spline = surface->GetIf<SplineSurface>();
  if (!spline)
  {
    return swept ? swept : surface;
  }
  SurfacePointer periodic = surface;
  double distance = 0.0;
  for (int d = 0; d < 2; ++d)
  {
    const NetRows rows{ *periodic->GetIf<SplineSurface>(), d };
    const Repetition repetition = FindRepetition(rows.Spline.Basis[d]);
    if (IsClosed(rows, repetition))
    {
      std::string problem;
      const SurfacePointer closed =
        GeometricSurface::Make(Close(rows, repetition, GetDiameter(spline->Poles), distance), problem);
      periodic = closed ? closed : periodic;
    }
  }
  own = distance > 0.0 && periodic != surface ? FileSurface{ surface, distance } : FileSurface();
  return periodic;
}

SurfacePointer CoverBox(const FileSurface& file, const SurfacePointer& periodic, const NativeBox& box)
{
  SplineSurface moved = *file.Surface->GetIf<SplineSurface>();
  for (int d = 0; d < 2; ++d)
  {
    const double period = periodic->GetPeriod(d);
    const ParameterRange& domain = file.Surface->GetDomain(d);
    const double middle = 0.5 * (box.Low[d] + box.High[d]) - 0.5 * (domain.Low + domain.High);
    const double shift = period > 0.0 ? std::round(middle / period) * period : 0.0;
    if (period > 0.0 &&
      (box.Low[d] < domain.Low + shift - DomainSlack * period ||
        box.High[d] > domain.High + shift + DomainSlack * period))
    {
      return nullptr;
    }
    for (double& knot : moved.Basis[d].Knots)
    {
      knot += shift;
    }
  }
  std::string problem;
  return GeometricSurface::Make(std::move(moved), problem);
}
}
