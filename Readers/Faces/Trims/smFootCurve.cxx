#include "smFootCurve.h"

#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sm
{
namespace
{
/// Largest motion of a foot point between two samples, relative to the period; a full circle has 64 samples.
constexpr double MaxStep = 0.15;

/// Largest number of samples that are added where foot points move fast, close to a pole.
constexpr int MaxAddedParts = 64;

/// A curve that ends so close to a pole, relative to its size, is taken to end at the pole.
constexpr double PoleTolerance = 1e-5;

/// Largest distance of a foot from a straight line that replaces its curve, relative to the curve's size,
/// away from poles. It is charged to the bounds, so it has to be small.
constexpr double StraightTolerance = 1e-10;

/// Distance from a pole, relative to the curve's size, at which foot points are not smooth enough to be
/// followed to rounding.
constexpr double PoleReach = 0.05;

/// Part of a curve between its last sample near a pole and the one before.
constexpr double PoleShare = 2.0 * PoleTolerance;

/// Number of pieces of a spline between two samples.
constexpr int SplineParts = 8;

/// What may be missed between samples.
constexpr double BetweenSamples = 1.25;

/// Returns the length below which distances are ignored: 1e-9 of the size or, if larger, 1e-7 mm (the
/// tolerance of many CAD systems), but at most 1e-6 of the size.
double GetSlack(double size)
{
  return std::max(1e-9 * size, std::min(1e-7, 1e-6 * size));
}
}

std::shared_ptr<const FootCurve> FootCurve::Make(const std::shared_ptr<const FootPointFinder>& finder,
  const CurvePointer<3>& curve, const Placement& placement, double first, double last)
{
  if (!finder || !curve || !(last > first))
  {
    return nullptr;
  }
  auto result = std::make_shared<FootCurve>();
  result->Finder = finder;
  result->Curve = MoveCurve(curve, placement);
  result->Breaks = result->Curve->GetBreaks(first, last);
  if (!result->Follow())
  {
    return nullptr;
  }
  result->Straighten();
  result->Refine();
  if (!result->IsEven())
  {
    return nullptr;
  }
  result->AddKnotCrossings();
  return result;
}

bool FootCurve::Follow()
{
  const std::size_t pieces = this->Breaks.size() - 1;
  const int steps = static_cast<int>(std::clamp<std::size_t>(64 / pieces, 4, 32));
  for (std::size_t k = 0; k < pieces; ++k)
  {
    for (int i = 0; i < steps; ++i)
    {
      const double x = static_cast<double>(i) / steps;
      this->Samples.push_back({ (1.0 - x) * this->Breaks[k] + x * this->Breaks[k + 1], {}, {} });
    }
  }
  this->Samples.push_back({ this->Breaks.back(), {}, {} });
  const std::size_t middle = this->Samples.size() / 2;
  std::vector<Vector3> points;
  Vector3 low{ 1e300, 1e300, 1e300 };
  Vector3 high{ -1e300, -1e300, -1e300 };
  double magnitude = 0.0;
  for (const Sample& sample : this->Samples)
  {
    points.push_back(this->Curve->Evaluate(sample.T));
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], points.back()[c]);
      high[c] = std::max(high[c], points.back()[c]);
      magnitude = std::max(magnitude, std::abs(points.back()[c]));
    }
  }
  this->Size = Norm(Subtract(high, low));
  this->Rounding = 32.0 * UnitRoundoff * magnitude;
  this->Slack = GetSlack(this->Size) + this->Rounding;
  const auto find = [&](std::size_t i, const Sample* neighbour)
  { return this->FindFoot(points[i], neighbour, this->Samples[i]); };
  bool found = find(middle, nullptr);
  for (std::size_t i = middle; found && i > 0; --i)
  {
    found = find(i - 1, &this->Samples[i]);
  }
  for (std::size_t i = middle + 1; found && i < this->Samples.size(); ++i)
  {
    found = find(i, &this->Samples[i - 1]);
  }
  return found;
}

bool FootCurve::FindFoot(const Vector3& point, const Sample* neighbour, Sample& sample)
{
  if (!this->Finder->Find(point, neighbour ? neighbour->UV.data() : nullptr, sample.UV.data()))
  {
    return false;
  }
  GeometricSurface::Derivatives foot;
  this->Finder->GetSurface()->Evaluate(sample.UV[0], sample.UV[1], 1, foot);
  sample.Speed[0] = Norm(foot[1][0]);
  sample.Speed[1] = Norm(foot[0][1]);
  this->Distance = std::max(this->Distance, Norm(Subtract(foot[0][0], point)));
  if (neighbour)
  {
    this->ContinueAtPole(neighbour->UV, sample.Speed, sample.UV);
  }
  return true;
}

/// Adds samples where a foot moves by a large part of a period.
void FootCurve::Refine()
{
  int added = 0;
  for (std::size_t i = 0; i + 1 < this->Samples.size() && added < MaxAddedParts;)
  {
    const Sample a = this->Samples[i];
    const Sample b = this->Samples[i + 1];
    Sample middle{ 0.5 * (a.T + b.T), {}, {} };
    if (!this->IsFar(a, b))
    {
      ++i;
    }
    else if (this->FindFoot(this->Curve->Evaluate(middle.T), &a, middle))
    {
      this->Samples.insert(this->Samples.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
      ++added;
    }
    else
    {
      return;
    }
  }
}

bool FootCurve::IsFar(const Sample& a, const Sample& b) const
{
  for (int d = 0; d < 2; ++d)
  {
    const double period = this->Finder->GetPeriod(d);
    if (period > 0.0 && std::abs(b.UV[d] - a.UV[d]) > MaxStep * period)
    {
      return true;
    }
  }
  return false;
}

/// Returns true if no step between samples is a large part of a period. Large steps occur close to a pole,
/// where polynomials cannot approximate the curve.
bool FootCurve::IsEven() const
{
  for (std::size_t i = 0; i + 1 < this->Samples.size(); ++i)
  {
    if (this->IsFar(this->Samples[i], this->Samples[i + 1]))
    {
      return false;
    }
  }
  return true;
}

void FootCurve::ContinueAtPole(
  const std::array<double, 2>& neighbour, const double speed[2], std::array<double, 2>& uv) const
{
  for (const FootPointFinder::Pole& pole : this->Finder->GetPoles())
  {
    if (std::abs(uv[pole.Direction] - pole.Value) * speed[pole.Direction] <= this->Slack)
    {
      uv[pole.Direction] = pole.Value;
      uv[1 - pole.Direction] = neighbour[1 - pole.Direction];
    }
  }
}

bool FootCurve::IsNear(const FootPointFinder::Pole& pole, const Sample& sample, double distance)
{
  return std::abs(sample.UV[pole.Direction] - pole.Value) * sample.Speed[pole.Direction] <= distance;
}

/// Returns true if the curve has a sample close to a pole. If `onlyUneven`, poles that it reaches along a
/// line of the surface do not count: the coordinate towards them is smooth.
bool FootCurve::PassesPole(bool onlyUneven) const
{
  for (const FootPointFinder::Pole& pole : this->Finder->GetPoles())
  {
    const double slope = this->Slope[1 - pole.Direction];
    if ((!onlyUneven || slope != slope) &&
      std::any_of(this->Samples.begin(), this->Samples.end(),
        [&](const Sample& s) { return IsNear(pole, s, PoleReach * this->Size); }))
    {
      return true;
    }
  }
  return false;
}

bool FootCurve::IsBesidePole(const Sample& sample) const
{
  return std::none_of(this->Finder->GetPoles().begin(), this->Finder->GetPoles().end(),
           [&](const FootPointFinder::Pole& pole) { return sample.UV[pole.Direction] == pole.Value; }) &&
    std::any_of(this->Finder->GetPoles().begin(), this->Finder->GetPoles().end(),
      [&](const FootPointFinder::Pole& pole) { return IsNear(pole, sample, PoleTolerance * this->Size); });
}

/// The end of a curve close to a pole may lie on the other side of it, so it is not used.
void FootCurve::Straighten()
{
  const auto first = this->Samples.begin() + (this->IsBesidePole(this->Samples.front()) ? 1 : 0);
  const auto last = this->Samples.end() - (this->IsBesidePole(this->Samples.back()) ? 1 : 0);
  const bool passesPole = this->PassesPole(false);
  const double close = std::min(this->Slack, StraightTolerance * this->Size + this->Rounding);
  const double tolerance = 2.0 * (passesPole ? this->Slack : close);
  for (int d = 0; d < 2; ++d)
  {
    const auto fastest = std::max_element(
      first, last, [d](const Sample& a, const Sample& b) { return a.Speed[d] < b.Speed[d]; });
    this->Slope[d] = std::numeric_limits<double>::quiet_NaN();
    const double border = this->Finder->SnapToBorder(d, fastest->UV[d], this->Slack / fastest->Speed[d]);
    for (const auto& [slope, offset] :
      { std::make_pair(0.0, border), std::make_pair(0.0, fastest->UV[d]),
        std::make_pair(1.0, fastest->UV[d] - fastest->T), std::make_pair(-1.0, fastest->UV[d] + fastest->T) })
    {
      this->Slope[d] = slope;
      this->Offset[d] = offset;
      const bool isLine = std::all_of(first, last,
        [this, d, tolerance](const Sample& s)
        { return std::abs(s.UV[d] - this->GetLineValue(d, s.T)) * s.Speed[d] <= tolerance; });
      this->Slope[d] = std::numeric_limits<double>::quiet_NaN();
      if (isLine)
      {
        this->Slope[d] = slope;
        this->Offset[d] = offset;
        const double speed = fastest->Speed[d];
        this->SetLine(d, static_cast<std::size_t>(first - this->Samples.begin()),
          static_cast<std::size_t>(last - this->Samples.begin()));
        this->Disturbed = this->Disturbed || this->Residual[d] * speed > 2.0 * BetweenSamples * close;
        break;
      }
    }
  }
  this->Disturbed = this->Disturbed || this->PassesPole(true);
}

double FootCurve::GetLineValue(int d, double t) const
{
  return this->Offset[d] + this->Slope[d] * t;
}

/// Moves the samples to the line of coordinate d. Samples near a pole, which are not in [first, last), may
/// be on its other side: their displacement counts as a length.
void FootCurve::SetLine(int d, std::size_t first, std::size_t last)
{
  double fastest = 0.0;
  for (std::size_t i = first; i < last; ++i)
  {
    fastest = std::max(fastest, this->Samples[i].Speed[d]);
  }
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    Sample& s = this->Samples[i];
    const double value = this->GetLineValue(d, s.T);
    const double moved =
      std::abs(s.UV[d] - value) * (i >= first && i < last ? 1.0 : PoleShare * s.Speed[d] / fastest);
    this->Residual[d] = std::max(this->Residual[d], BetweenSamples * moved);
    s.UV[d] = value;
  }
}

/// Returns the parameter between two samples at which a coordinate passes a value, to the next numbers: by
/// the Illinois method, a secant whose end that stays is halved, as every evaluation is a search for a foot
/// point.
double FootCurve::FindCrossing(int direction, double value, const Sample& from, const Sample& to) const
{
  double a = from.T;
  double b = to.T;
  double before = from.UV[direction] - value;
  double after = to.UV[direction] - value;
  const bool rising = after > 0.0;
  int stays = 0;
  for (int n = 0; n < 72; ++n)
  {
    const double middle = 0.5 * (a + b);
    if (!(middle > a && middle < b))
    {
      break;
    }
    // Rounding stops secants before the ends are neighbours.
    const double secant = n < 12 ? a + (b - a) * (before / (before - after)) : middle;
    const double t = secant > a && secant < b ? secant : middle;
    const double miss = this->Evaluate(t)[direction] - value;
    if ((miss > 0.0) == rising)
    {
      b = t;
      after = miss;
      before *= stays < 0 ? 0.5 : 1.0;
      stays = -1;
    }
    else
    {
      a = t;
      before = miss;
      after *= stays > 0 ? 0.5 : 1.0;
      stays = 1;
    }
  }
  return 0.5 * (a + b);
}

/// The foot point is less smooth where the surface has a knot.
void FootCurve::AddKnotCrossings()
{
  std::vector<double> crossings;
  for (int d = 0; d < 2; ++d)
  {
    if (this->Slope[d] == 0.0)
    {
      continue;
    }
    for (const double knot : this->Finder->GetKnots(d))
    {
      for (std::size_t i = 0; i + 1 < this->Samples.size(); ++i)
      {
        const Sample& a = this->Samples[i];
        const Sample& b = this->Samples[i + 1];
        if ((a.UV[d] > knot) != (b.UV[d] > knot))
        {
          crossings.push_back(this->FindCrossing(d, knot, a, b));
        }
      }
    }
  }
  const double minimum = 1e-10 * (this->Breaks.back() - this->Breaks.front());
  std::sort(crossings.begin(), crossings.end());
  for (const double t : crossings)
  {
    const auto after = std::lower_bound(this->Breaks.begin(), this->Breaks.end(), t);
    if (after != this->Breaks.begin() && after != this->Breaks.end() && *after - t > minimum &&
      t - *(after - 1) > minimum)
    {
      this->Breaks.insert(after, t);
    }
  }
}

CurvePointer<2> FootCurve::GetLine() const
{
  // A line is parametrised by its length, so one slope must be 1 and the other 0.
  std::string problem;
  return std::abs(this->Slope[0]) + std::abs(this->Slope[1]) == 1.0
    ? GeometricCurve<2>::Make(
        LineCurve<2>{ { this->Offset[0], this->Offset[1] }, { this->Slope[0], this->Slope[1] } }, problem)
    : nullptr;
}

double FootCurve::GetOverhang() const
{
  double overhang = 0.0;
  for (const Sample& s : this->Samples)
  {
    overhang = std::max(overhang,
      std::hypot(
        this->Finder->GetExcess(0, s.UV[0]) * s.Speed[0], this->Finder->GetExcess(1, s.UV[1]) * s.Speed[1]));
  }
  return overhang;
}

void FootCurve::VisitExtremes(const std::function<void(double, double)>& visit) const
{
  for (std::size_t i = 1; i + 1 < this->Samples.size(); ++i)
  {
    const Sample& a = this->Samples[i - 1];
    const Sample& b = this->Samples[i];
    const Sample& c = this->Samples[i + 1];
    for (int d = 0; d < 2; ++d)
    {
      const double before = (b.UV[d] - a.UV[d]) / (b.T - a.T);
      const double after = (c.UV[d] - b.UV[d]) / (c.T - b.T);
      if (this->Slope[d] == this->Slope[d] || !(before * after < 0.0))
      {
        continue;
      }
      // The vertex of the parabola through the three samples, and the curve at its parameter.
      const double turn = (after - before) / (c.T - a.T);
      const double slope = before + turn * (b.T - a.T);
      const double t = b.T - 0.5 * slope / turn;
      const double expected = b.UV[d] - 0.25 * slope * slope / turn;
      std::array<double, 2> uv = this->Evaluate(t);
      const double miss = std::abs(uv[d] - expected);
      uv[d] += before > 0.0 ? miss : -miss;
      visit(uv[0], uv[1]);
    }
  }
}

/// Replaces feet by closer ones near those of their neighbours: where the surface is folded, the search may
/// have jumped from fold to fold.
void FootCurve::FindCloserFeet(
  const std::vector<double>& parameters, std::vector<std::array<double, 2>>& feet) const
{
  const auto getDistance = [this](const Vector3& point, const std::array<double, 2>& uv)
  { return Norm(Subtract(this->Finder->GetSurface()->Evaluate(uv[0], uv[1]), point)); };
  const std::size_t last = feet.size() - 1;
  const bool isLine = this->Slope[0] == this->Slope[0] || this->Slope[1] == this->Slope[1];
  for (std::size_t k = 1; k <= 2 * last && !isLine; ++k)
  {
    const bool isForward = k <= last;
    const std::size_t i = isForward ? k : 2 * last - k;
    const Vector3 point = this->Curve->Evaluate(parameters[i]);
    std::array<double, 2> uv{};
    if (this->Finder->Find(point, feet[isForward ? i - 1 : i + 1].data(), uv.data()))
    {
      uv = { this->Finder->ClampToDomain(0, uv[0]), this->Finder->ClampToDomain(1, uv[1]) };
      feet[i] = getDistance(point, uv) + this->Slack < getDistance(point, feet[i]) ? uv : feet[i];
    }
  }
}

CurvePointer<2> FootCurve::Approximate() const
{
  std::vector<double> parameters;
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    const int parts = i + 1 < this->Samples.size() ? SplineParts : 1;
    for (int k = 0; k < parts; ++k)
    {
      const double x = static_cast<double>(k) / SplineParts;
      parameters.push_back(
        k == 0 ? this->Samples[i].T : (1.0 - x) * this->Samples[i].T + x * this->Samples[i + 1].T);
      points.push_back(k == 0 ? this->Samples[i].UV : this->Evaluate(parameters.back()));
      for (int d = 0; d < 2; ++d)
      {
        points.back()[d] = this->Finder->ClampToDomain(d, points.back()[d]);
      }
    }
  }
  this->FindCloserFeet(parameters, points);
  // Hermite pieces between the points; knots are double. The slopes are those of parabolas through three
  // points, at most three times the lesser of the two adjacent ones, and 0 at an extreme: the spline exceeds
  // no point.
  const std::size_t last = points.size() - 1;
  const auto step = [&](std::size_t k, int d)
  { return (points[k + 1][d] - points[k][d]) / (parameters[k + 1] - parameters[k]); };
  const auto slope = [&](std::size_t i, int d)
  {
    const double before = step(i == 0 ? 0 : i - 1, d);
    const double after = step(i == last ? last - 1 : i, d);
    if (!(before * after > 0.0) || i == 0 || i == last)
    {
      return i == 0 || i == last ? after : 0.0;
    }
    const double widths[2] = { parameters[i] - parameters[i - 1], parameters[i + 1] - parameters[i] };
    const double middle = (widths[1] * before + widths[0] * after) / (widths[0] + widths[1]);
    const double limit = 3.0 * std::min(std::abs(before), std::abs(after));
    return std::clamp(middle, -limit, limit);
  };
  SplineCurve<2> spline;
  spline.Basis.Degree = 3;
  for (std::size_t i = 0; i <= last; ++i)
  {
    spline.Basis.Knots.push_back(parameters[i]);
    spline.Basis.Multiplicities.push_back(i == 0 || i == last ? 4 : 2);
    std::array<double, 2> before = points[i];
    std::array<double, 2> after = before;
    for (int d = 0; d < 2; ++d)
    {
      before[d] -= i == 0 ? 0.0 : slope(i, d) * (parameters[i] - parameters[i - 1]) / 3.0;
      after[d] += i == last ? 0.0 : slope(i, d) * (parameters[i + 1] - parameters[i]) / 3.0;
    }
    spline.Poles.push_back(before);
    spline.Poles.push_back(after);
  }
  std::string problem;
  return GeometricCurve<2>::Make(std::move(spline), problem);
}

std::array<double, 2> FootCurve::Evaluate(double t) const
{
  const auto after = std::upper_bound(this->Samples.begin() + 1, this->Samples.end() - 1, t,
    [](double value, const Sample& s) { return value < s.T; });
  const Sample& b = *after;
  const Sample& a = *(after - 1);
  const double x = (t - a.T) / (b.T - a.T);
  const std::array<double, 2> guess = { (1.0 - x) * a.UV[0] + x * b.UV[0],
    (1.0 - x) * a.UV[1] + x * b.UV[1] };
  std::array<double, 2> uv = guess;
  const bool isFound = this->Slope[0] == this->Slope[0] && this->Slope[1] == this->Slope[1];
  if (!isFound && this->Finder->Find(this->Curve->Evaluate(t), guess.data(), uv.data()))
  {
    this->ContinueAtPole(guess, a.Speed, uv);
  }
  for (int d = 0; d < 2; ++d)
  {
    uv[d] = this->Slope[d] == this->Slope[d] ? this->Offset[d] + this->Slope[d] * t : uv[d];
  }
  return uv;
}
}
