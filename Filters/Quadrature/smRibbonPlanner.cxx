#include "Detail/smRibbonPlanner.h"
#include "Detail/smHullBound.h"
#include "Detail/smIntegerPower.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
const EllipseRadius RibbonRadii[] = { EllipseRadius(1.3), EllipseRadius(1.6), EllipseRadius(2.0),
  EllipseRadius(2.5), EllipseRadius(3.2), EllipseRadius(4.2), EllipseRadius(6.0), EllipseRadius(9.0),
  EllipseRadius(15.0), EllipseRadius(30.0), EllipseRadius(100.0) };
constexpr int MaxRibbonDepth = 12;
// Points along a ribbon that also measures the gap between coedge and edge.
constexpr int MinGapPoints = 3;

// Estimated error of evaluating a ribbon: rounding of its width, in units of u times the patch's radius and
// its stretch.
constexpr double RibbonRoundings = 8.0;
constexpr double TrimRoundings = 3.0;
}

RibbonPlanner::RibbonPlanner(
  const Face& face, const FacePanels& panels, const PlanRequest& request, FacePlan& plan)
  : Panels(panels)
  , Request(request)
  , Result(plan)
  , Transposed(face.Surface.Degree[0] > face.Surface.Degree[1])
  , Gap(panels, request.Shift)
{
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      this->Coedges.push_back(&coedge);
    }
  }
}

void RibbonPlanner::Bound(const Majorants& m, std::vector<double>& bounds) const
{
  const double strip = m.Gap * (m.CurveSlope + m.GapSlope);
  bounds.assign(this->Request.Classes.size(), 0.0);
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    if (c.Kind == BoundClass::VolumeMoment)
    {
      bounds[i] = m.Curve * strip * IntegerPower(m.Curve + m.Gap, c.Degree) / (3 + c.Degree);
    }
    else if (c.Kind == BoundClass::HeightMoment)
    {
      bounds[i] = strip * IntegerPower(m.Curve + m.Gap, c.Degree + 1);
    }
    else if (c.Kind == BoundClass::VectorArea)
    {
      bounds[i] = strip;
    }
  }
}

bool RibbonPlanner::IsRounding(const Ribbon& ribbon, const Majorants& real) const
{
  // An estimate of the rounding bound of smRibbon.glsl; both bounds hold, this one is to be the smaller.
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const double rounding = UnitRoundoff *
    (RibbonRoundings * patch.Radius +
      TrimRoundings * (this->Gap.GetStretch()[0] + this->Gap.GetStretch()[1]));
  return real.Gap + this->Gap.GetRemainder(real).Gap <= rounding;
}

void RibbonPlanner::AddNoiseError(const Majorants& real)
{
  // The bounds of Bound() are polynomials in |C|, |C'|, |G| and |G'| with positive coefficients: where these
  // are off, the integrands change by the polynomials' derivatives at the upper ends. A rule errs by at most
  // twice that.
  const GapSeries::Remainder off = this->Gap.GetRemainder(real);
  const double gap = real.Gap + off.Gap;
  const double slopes = real.CurveSlope + off.CurveSlope + real.GapSlope + off.GapSlope;
  const double reach = real.Curve + off.Curve + gap;
  const double strip = off.Gap * slopes + gap * (off.CurveSlope + off.GapSlope);
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    const int degree = c.Degree + 1;
    const double moment = strip * IntegerPower(reach, degree) +
      gap * slopes * degree * IntegerPower(reach, degree - 1) * (off.Curve + off.Gap);
    this->Result.QuadratureBound[i] += c.Kind == BoundClass::AreaMoment ? 0.0
      : c.Kind == BoundClass::VectorArea                                ? 2.0 * strip
      : c.Kind == BoundClass::HeightMoment                              ? 2.0 * moment
                                                                        : 2.0 * moment / (3 + c.Degree);
  }
}

void RibbonPlanner::AddResidualError(const Ribbon& ribbon, bool sound, const Majorants& real)
{
  if (ribbon.Coedge < 0)
  {
    return;
  }
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const Coedge& coedge = *this->Coedges[ribbon.Coedge];
  const TrimCurve::Point& trim = coedge.Curve.GetResidual(ribbon.Piece);
  const double edge = Norm(coedge.Use->Curve.Residual.data());
  const double ds = trim[this->Transposed ? 1 : 0] / patch.Width[0];
  const double dr = trim[this->Transposed ? 0 : 1] / patch.Width[1];
  if (ds == 0.0 && dr == 0.0 && edge == 0.0)
  {
    return;
  }
  if (!sound)
  {
    this->HasUnboundedResidual = true;
    return;
  }
  // The faces' boundary moves by Ss ds + Sr dr, and sweeps |Ss x Sr| |ds r' - dr s'| of their area. The chain
  // stays closed, and its volume changes by what the ribbon sweeps: a triangle of the gap and the
  // displacement along the length.
  const double area =
    this->Gap.GetNormalLength() * (ds * this->Gap.GetTrimSlope()[1] + dr * this->Gap.GetTrimSlope()[0]);
  const double moved = ds * this->Gap.GetStretch()[0] + dr * this->Gap.GetStretch()[1] + edge;
  const double length = real.CurveSlope + real.GapSlope;
  const double reach = real.Curve + real.Gap;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    const double power = IntegerPower(reach, c.Degree);
    this->Result.ConversionBound[i] += c.Kind == BoundClass::AreaMoment ? area * power
      : c.Kind == BoundClass::VolumeMoment || c.Kind == BoundClass::HeightMoment
      ? moved * (real.Gap + moved) * length * power
      : 0.0;
  }
}

bool RibbonPlanner::FindShares(bool sound, const Majorants& real, double share)
{
  const std::size_t count = this->Request.Classes.size();
  this->Supremum.assign(count, std::numeric_limits<double>::infinity());
  if (sound)
  {
    this->Bound(real, this->Supremum);
  }
  this->Shares.resize(count);
  bool isAny = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double tolerance = share * this->Request.Tolerances[i];
    this->Shares[i] =
      this->Request.Classes[i].Kind == BoundClass::AreaMoment || 2.0 * this->Supremum[i] <= tolerance
      ? 0.0
      : tolerance;
    isAny = isAny || this->Shares[i] > 0.0;
  }
  return isAny;
}

void RibbonPlanner::BoundAlong(bool sound)
{
  this->AlongT.Reset(this->Shares, MaxOrder);
  if (!sound)
  {
    return;
  }
  SearchEllipses(RibbonRadii,
    [&](const EllipseRadius& radius)
    {
      Majorants majorants;
      if (!this->Gap.Evaluate(Ellipse::FromRadius(radius.GetValue()), majorants))
      {
        return EllipseGain::None;
      }
      this->Bound(majorants, this->Bounds);
      return this->AlongT.AddEllipse(radius, this->Bounds) || this->AlongT.IsLastBest(MinGapPoints)
        ? EllipseGain::Useful
        : EllipseGain::Worse;
    });
}

int RibbonPlanner::ChooseOrder() const
{
  int along = 1;
  for (std::size_t i = 0; i < this->Supremum.size(); ++i)
  {
    along = std::max(along, this->AlongT.GetOrder(i));
  }
  return along;
}

void RibbonPlanner::AddItem(const PlannedItem& item)
{
  for (std::size_t i = 0; i < this->Supremum.size(); ++i)
  {
    if (this->Request.Classes[i].Kind != BoundClass::AreaMoment)
    {
      this->Result.QuadratureBound[i] +=
        std::min(2.0 * this->Supremum[i], this->AlongT.GetError(i, item.Along));
      this->Result.Magnitude[i] += this->Supremum[i];
    }
  }
  this->Result.Evaluations += item.Along;
  this->Result.Items.push_back(item);
}

void RibbonPlanner::PlanPart(std::uint32_t index, double start, double end, int depth)
{
  const Ribbon& ribbon = this->Panels.Ribbons[index];
  this->Gap.Expand(ribbon, start, end);
  Majorants real;
  const bool sound =
    this->Gap.Evaluate(Ellipse::FromRadius(1.0), real) && std::isfinite(this->Gap.GetRemainder(real).Gap);
  const double share = std::exp2(-depth);
  // Where any order will do, and the ribbon is rounding, no ellipse is needed.
  const bool needsOrder = this->FindShares(sound, real, share) || this->Gap.IsRough();
  const bool isRounding = sound && this->IsRounding(ribbon, real);
  int along = 1;
  if (needsOrder || !isRounding)
  {
    this->BoundAlong(sound);
    along = this->ChooseOrder();
  }
  if ((along > MaxOrder || this->Gap.IsRough()) && depth < MaxRibbonDepth)
  {
    const double middle = 0.5 * (start + end);
    this->PlanPart(index, start, middle, depth + 1);
    this->PlanPart(index, middle, end, depth + 1);
    return;
  }
  if (isRounding)
  {
    for (std::size_t i = 0; i < this->Supremum.size(); ++i)
    {
      this->Result.QuadratureBound[i] += this->Supremum[i];
      this->Result.Magnitude[i] += this->Supremum[i];
    }
    this->AddNoiseError(real);
    this->AddResidualError(ribbon, true, real);
    return;
  }
  PlannedItem item{ ItemKind::Ribbon, index };
  item.Start = start;
  item.End = end;
  item.Along = std::clamp(along, ribbon.AlongEdge ? MinGapPoints : 1, MaxOrder);
  this->AddItem(item);
  if (sound)
  {
    this->AddNoiseError(real);
  }
  this->AddResidualError(ribbon, sound, real);
}

void RibbonPlanner::Plan(std::uint32_t index)
{
  const std::vector<double> before = this->Result.Magnitude;
  this->HasUnboundedResidual = false;
  this->PlanPart(index, 0.0, 1.0, 0);
  const HullBound hull = BoundRibbonByHull(this->Panels, this->Panels.Ribbons[index], this->Request.Shift);
  this->Result.LimitMagnitude(before, this->Request.Classes, hull);
  if (this->HasUnboundedResidual)
  {
    // The ribbon of the exact curves, and what lies between both trim curves on the patch, are in the same
    // hulls.
    const HullBound patch =
      BoundPatchByHull(this->Panels, this->Panels.Ribbons[index].Patch, this->Request.Shift);
    for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
    {
      const BoundClass& c = this->Request.Classes[i];
      this->Result.ConversionBound[i] += patch.GetMagnitude(c) +
        (c.Kind == BoundClass::AreaMoment ? 0.0
                                          : this->Result.Magnitude[i] - before[i] + hull.GetMagnitude(c));
    }
  }
}
}
