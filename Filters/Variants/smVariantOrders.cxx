#include "Detail/smVariantOrdersInternals.h"

#include "smGaussLegendre.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// Sums of half axes of the targets' ellipses.
constexpr double TargetRadii[] = { 1.3, 1.75, 2.4, 3.3, 4.6, 7.5, 18.0, 60.0 };
constexpr int MaxRulePoints = 32;
constexpr int MaxDivisions = 20;
// A constant parameter of a trim curve may have its rounding.
constexpr double ConstantAxis = 1.0 + 1e-9;

double GetHalfAxis(double radius)
{
  return 0.5 * (radius + 1.0 / radius);
}

/// The largest radius whose ellipse has this half axis, less what rounding may add.
double GetRadius(double axis)
{
  return axis > 1.0 ? std::min((axis + std::sqrt((axis - 1.0) * (axis + 1.0))) * (1.0 - 1e-12), 1e8) : 1.0;
}

/// The factor of |f| in the error of `points` points.
double GetRuleError(double radius, int points)
{
  if (!(radius > 1.0))
  {
    return NoBound;
  }
  return 32.0 / 15.0 * std::pow(radius, -2.0 * points) / (1.0 - 1.0 / (radius * radius)) * (1.0 + 1e-9);
}

/// The fewest points whose error is within `share`, if |f| <= size; MaxRulePoints + 1 if there are none.
int FindPoints(double radius, double size, double share)
{
  if (!(radius > 1.0) || !(size < NoBound))
  {
    return MaxRulePoints + 1;
  }
  const double wanted = share * (1.0 - 1.0 / (radius * radius)) / (32.0 / 15.0 * size);
  const double points = wanted > 0.0 ? std::ceil(-0.5 * std::log(wanted) / std::log(radius) + 1e-6) : NoBound;
  return static_cast<int>(std::clamp(points, 1.0, MaxRulePoints + 1.0));
}
}

VariantOrders::VariantOrders(
  VariantFaceChain& chain, const std::vector<Patch>& patches, const VariantChainOptions& options)
  : Chain(chain)
  , Patches(patches)
  , Options(options)
  , Ranges{ 1.0 }
  , Share(0.25 * options.Tolerance / options.Items)
{
  for (const int direction : chain.Directions)
  {
    this->Ranges.push_back(options.Ranges[direction]);
  }
  for (const VariantPatch& patch : chain.Patches)
  {
    this->States.push_back(std::make_unique<PatchState>(patch));
  }
}

VariantOrders::~VariantOrders() = default;

void VariantOrders::Announce(std::uint32_t patch, const double* trim, int degree, double start, double end)
{
  TrimSeries series;
  series.Expand(trim, degree, this->Patches[patch], start, end);
  for (int d = 0; d < 2; ++d)
  {
    // Panels begin at s = 0.
    const double beyond = std::max({ -series.GetLow(d), series.GetHigh(d) - 1.0, 0.0 });
    this->States[patch]->Outside[d] =
      std::max(this->States[patch]->Outside[d], beyond * (1.0 + 1e-9) + 1e-14);
  }
}

/// The largest bound of a moment's flux for variables in their ranges, relative to the moment's scale.
double VariantOrders::Measure(const TangentForms<double>& forms) const
{
  std::array<std::array<double, 3>, 3> sums{};
  const std::array<std::vector<double>, 3>* parts[3] = { &forms.Position, &forms.First, &forms.Second };
  for (int k = 0; k < 3; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (std::size_t a = 0; a < this->Ranges.size(); ++a)
      {
        sums[k][c] += this->Ranges[a] * (*parts[k])[c][a];
      }
    }
  }
  const std::array<double, NumberOfMoments> flux = GetFluxBounds(sums[0], sums[1], sums[2]);
  double largest = 0.0;
  for (int m = 0; m < NumberOfMoments; ++m)
  {
    largest = std::max(largest, flux[m] / this->Options.Scales[GetMomentDegree(m) - 3]);
  }
  return largest;
}

VariantOrders::PatchState& VariantOrders::GetState(std::uint32_t patch)
{
  PatchState& state = *this->States[patch];
  if (state.IsReady)
  {
    return state;
  }
  state.IsReady = true;
  state.Local = BoundSamples(state.Source, state.Outside, false);
  const VariantSeries series(state.Source);
  const double real[2] = { 1.0 + 2.0 * state.Outside[0], 1.0 + 2.0 * state.Outside[1] };
  for (const double radius : TargetRadii)
  {
    const double axis = GetHalfAxis(radius);
    state.Targets.push_back({ std::max(axis, real[0]), real[1], true, false, TangentForms<double>() });
    state.Targets.push_back(
      { std::max(axis, real[0]), std::max(axis, real[1]), false, false, TangentForms<double>() });
    state.Targets.push_back(
      { std::max(ConstantAxis, real[0]), std::max(axis, real[1]), false, false, TangentForms<double>() });
  }
  double smallest = NoBound;
  for (Target& target : state.Targets)
  {
    target.IsValid = series.Bound(
      Ellipse::FromHalfAxis(target.AxisS), Ellipse::FromHalfAxis(target.AxisR), true, target.Forms);
    if (!target.IsValid)
    {
      continue;
    }
    target.Size = this->Measure(target.Forms);
    // The ellipse reaches (A - 1) / 2 beyond [0,1] at the ends, and farther at its sides.
    const double distance =
      std::min(0.5 * (target.AxisS - 1.0) - state.Outside[0], 0.5 * (target.AxisR - 1.0) - state.Outside[1]);
    if (distance > 1e-3 && target.Size / distance < smallest)
    {
      smallest = target.Size / distance;
      state.Near = &target;
      state.NearDistance = distance;
    }
  }
  return state;
}

double VariantOrders::FindRadius(
  const TrimSeries& trim, const Target& target, double acrossStart, double acrossEnd) const
{
  const ParameterBox unit{ { 0.5, 0.5 }, { 0.5, 0.5 } };
  const auto isInside = [&](double radius)
  {
    const Ellipse t = Ellipse::FromRadius(radius);
    return trim.Map(t, 0, unit, acrossStart, acrossEnd).GetHalfAxis() <= target.AxisS &&
      trim.Map(t, 1, unit, acrossStart, acrossEnd).GetHalfAxis() <= target.AxisR;
  };
  double low = 0.0;
  double high = std::log(1e4);
  if (!isInside(std::exp(1e-3)))
  {
    return 1.0;
  }
  for (int i = 0; i < 12; ++i)
  {
    const double middle = 0.5 * (low + high);
    (isInside(std::exp(middle)) ? low : high) = middle;
  }
  return low > 0.0 ? std::exp(low) : 1.0;
}

void VariantOrders::AddPanel(const VariantPanel& panel, const double* trim)
{
  this->DividePanel(panel, trim, 0);
}

void VariantOrders::DividePanel(const VariantPanel& panel, const double* trim, int depth)
{
  PatchState& state = this->GetState(panel.Patch);
  const VariantPatch& patch = state.Source;
  TrimSeries series;
  series.Expand(trim, panel.TrimDegree, this->Patches[panel.Patch], panel.Start, panel.End);
  const Ellipse real = Ellipse::FromRadius(1.0);
  const double largestS = series.GetMaxS(real);
  const double slope = series.GetMaxSlope(real, 1);
  const double across = panel.AcrossEnd - panel.AcrossStart;
  if (largestS * slope == 0.0)
  {
    return;
  }
  struct Choice
  {
    int Points = MaxRulePoints + 1;
    double Radius = 1.0;
    double Factor = 0.0;
    Target* Used = nullptr;
  };
  Choice along;
  Choice inside;
  if (patch.IsPolynomial)
  {
    const int degreeS = series.IsConstantInS() ? 0 : panel.TrimDegree;
    const int degreeR = panel.TrimDegree;
    along.Points =
      std::min((5 * patch.Degree[0] * degreeS + 5 * patch.Degree[1] * degreeR + 1) / 2, MaxRulePoints + 1);
    inside.Points = std::min((5 * patch.Degree[0] + 1) / 2, MaxRulePoints + 1);
  }
  const auto consider = [this](Choice& choice, Target& target, double radius, double factor)
  {
    const int points = FindPoints(radius, factor * target.Size, this->Share);
    if (points < choice.Points || (points > MaxRulePoints && radius > choice.Radius && !choice.Used))
    {
      choice = { points, radius, factor, &target };
    }
  };
  const double high = std::max(series.GetHigh(0), 0.0);
  const double low = std::max(-series.GetLow(0), 0.0);
  for (Target& target : state.Targets)
  {
    if (!target.IsValid)
    {
      continue;
    }
    if (target.IsAcross)
    {
      // xi in the ellipse of axis A around its range is in that of 1 + across (A - 1) around [0,1]; times s
      // in [0, high] in that of 1 + high (A - 1), or high A + high - 1 for high > 1; times s in [-low, 0] in
      // that of low (A + 1) + 1: sums of distances to 0 and 1.
      double axis = high > 1.0 ? (target.AxisS + 1.0 - high) / high
        : high > 0.0           ? 1.0 + (target.AxisS - 1.0) / high
                               : NoBound;
      axis = low > 0.0 ? std::min(axis, (target.AxisS - 1.0) / low - 1.0) : axis;
      consider(inside, target, GetRadius(1.0 + (axis - 1.0) / across), largestS * slope * across);
    }
    else
    {
      const double radius = this->FindRadius(series, target, panel.AcrossStart, panel.AcrossEnd);
      const Ellipse t = Ellipse::FromRadius(radius);
      consider(along, target, radius, series.GetMaxS(t) * series.GetMaxSlope(t, 1) * across);
    }
  }
  // Without any ellipse, smaller parts do not help.
  const bool isTooMany = (along.Points > MaxRulePoints && along.Radius > 1.0) ||
    (inside.Points > MaxRulePoints && inside.Radius > 1.0);
  if (isTooMany && depth < MaxDivisions)
  {
    for (int half = 0; half < 2; ++half)
    {
      VariantPanel part = panel;
      const bool isAlong = along.Points > MaxRulePoints && along.Radius > 1.0;
      double& start = isAlong ? part.Start : part.AcrossStart;
      double& end = isAlong ? part.End : part.AcrossEnd;
      (half == 0 ? end : start) = 0.5 * (start + end);
      this->DividePanel(part, trim, depth + 1);
    }
    return;
  }
  VariantPanel planned = panel;
  planned.Along = std::min(along.Points, MaxRulePoints);
  planned.Across = std::min(inside.Points, MaxRulePoints);
  this->Chain.Panels.push_back(planned);
  for (const Choice* choice : { &along, &inside })
  {
    if (choice->Used)
    {
      choice->Used->Factor +=
        choice->Factor * GetRuleError(choice->Radius, std::min(choice->Points, MaxRulePoints));
    }
    else if (choice->Points > MaxRulePoints)
    {
      state.Weight = NoBound;
    }
  }
  /*
   * A sample at parameters that are off by ds, dr: with F(s) = s f(xi s, r), |dF/ds| <= |f| + |s f_s|, and by
   * Cauchy's estimate a derivative is at most the bound on an ellipse over its distance.
   */
  const TrimReach reach = GetTrimReach(this->Chain.Coefficients.data() + panel.Trim, panel.TrimDegree);
  const double inverse = state.Near ? 1.0 / state.NearDistance : NoBound;
  const double ds = reach.GetError(0);
  const double dr = reach.GetError(1);
  state.Weight += largestS * slope * across;
  state.ParameterError += across *
    (ds * slope * (1.0 + largestS * inverse) + dr * largestS * slope * inverse +
      reach.GetSlopeError(1, panel.End - panel.Start) * largestS);
}

/// Bounds of a ribbon's position and of its two tangents, for t in the ellipse: x is between A and C, and the
/// tangents are C - A and between A' and C'.
TangentForms<double> VariantOrders::BoundRibbon(
  const VariantRibbon& ribbon, const TrimSeries& trim, const Target& target, double radius) const
{
  const VariantPatch& patch = this->Chain.Patches[ribbon.Patch];
  const Ellipse t = Ellipse::FromRadius(radius);
  const double slopes[2] = { trim.GetMaxSlope(t, 0), trim.GetMaxSlope(t, 1) };
  const int n = ribbon.EdgeDegree + 1;
  std::vector<double> majorants;
  t.GetMajorants(n, majorants);
  std::vector<double> series(3 * static_cast<std::size_t>(n));
  std::vector<double> derivative(n);
  TangentForms<double> forms(patch.Variables);
  for (int a = 0; a < patch.Variables; ++a)
  {
    const double* edge =
      this->Chain.Coefficients.data() + ribbon.Edge + 3 * static_cast<std::ptrdiff_t>(n) * a;
    ExpandBernstein<double>(edge, 3, ribbon.EdgeDegree, ribbon.EdgeStart, ribbon.EdgeEnd, series.data());
    for (int c = 0; c < 3; ++c)
    {
      double value = 0.0;
      double change = 0.0;
      double largest = 0.0;
      for (int k = 0; k < n; ++k)
      {
        value += std::abs(series[3 * k + c]) * majorants[k];
        largest = std::max(largest, std::abs(edge[3 * k + c]));
      }
      std::vector<double> own(n);
      for (int k = 0; k < n; ++k)
      {
        own[k] = series[3 * k + c];
      }
      DifferentiateChebyshev(own.data(), derivative.data(), n, 1);
      double noise = 0.0;
      for (int k = 0; k < n; ++k)
      {
        change += 2.0 * std::abs(derivative[k]) * majorants[k];
        noise += 64.0 * n * UnitRoundoff * largest * majorants[k];
      }
      value += noise;
      change += 2.0 * n * n * noise;
      const double center = std::abs(patch.Centers[a][c]);
      const double local = target.Forms.Position[c][a] - center;
      forms.Position[c][a] = center + std::max(local, value);
      forms.First[c][a] = local + value;
      forms.Second[c][a] =
        std::max(target.Forms.First[c][a] * slopes[0] + target.Forms.Second[c][a] * slopes[1], change);
    }
  }
  return forms;
}

void VariantOrders::AddRibbon(const VariantRibbon& ribbon, const double* trim)
{
  this->DivideRibbon(ribbon, trim, 0);
}

void VariantOrders::DivideRibbon(const VariantRibbon& ribbon, const double* trim, int depth)
{
  PatchState& state = this->GetState(ribbon.Patch);
  const VariantPatch& patch = state.Source;
  TrimSeries series;
  series.Expand(trim, ribbon.TrimDegree, this->Patches[ribbon.Patch], ribbon.Start, ribbon.End);
  int points = MaxRulePoints + 1;
  if (patch.IsPolynomial)
  {
    const bool isConstant[2] = { series.IsConstantInS(), series.GetLow(1) == series.GetHigh(1) };
    const int degree = std::max((isConstant[0] ? 0 : patch.Degree[0] * ribbon.TrimDegree) +
        (isConstant[1] ? 0 : patch.Degree[1] * ribbon.TrimDegree),
      ribbon.EdgeDegree);
    points = std::min(std::max((5 * degree + 1) / 2, 1), MaxRulePoints + 1);
  }
  double error = points > MaxRulePoints ? NoBound : 0.0;
  TangentForms<double> used;
  for (const Target& target : state.Targets)
  {
    if (!target.IsValid || target.IsAcross)
    {
      continue;
    }
    const double radius = this->FindRadius(series, target, 1.0, 1.0);
    if (!(radius > 1.0))
    {
      continue;
    }
    const TangentForms<double> forms = this->BoundRibbon(ribbon, series, target, radius);
    const int wanted = FindPoints(radius, this->Measure(forms), this->Share);
    const double remains = GetRuleError(radius, std::min(wanted, MaxRulePoints));
    if (wanted < points || (points > MaxRulePoints && error == NoBound && remains < NoBound))
    {
      points = wanted;
      error = remains;
      used = forms;
    }
  }
  if (points > MaxRulePoints && error < NoBound && depth < MaxDivisions)
  {
    for (int half = 0; half < 2; ++half)
    {
      VariantRibbon part = ribbon;
      (half == 0 ? part.End : part.Start) = 0.5 * (ribbon.Start + ribbon.End);
      (half == 0 ? part.EdgeEnd : part.EdgeStart) = 0.5 * (ribbon.EdgeStart + ribbon.EdgeEnd);
      this->DivideRibbon(part, trim, depth + 1);
    }
    return;
  }
  VariantRibbon planned = ribbon;
  planned.Along = std::min(points, MaxRulePoints);
  this->Chain.Ribbons.push_back(planned);
  if (error > 0.0)
  {
    VariantError remaining;
    remaining.ValueFactor = error;
    remaining.Forms = TangentForms<ErrorBound>(patch.Variables);
    if (!used.Position[0].empty())
    {
      SetBound(remaining.Forms, used);
    }
    else
    {
      remaining.ValueFactor = 1.0;
      for (auto* forms : { &remaining.Forms.Position, &remaining.Forms.First, &remaining.Forms.Second })
      {
        forms->fill(std::vector<ErrorBound>(patch.Variables, { NoBound, 0.0 }));
      }
    }
    this->Chain.Errors.push_back(std::move(remaining));
  }
}
}
