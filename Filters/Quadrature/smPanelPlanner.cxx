#include "Detail/smPanelPlanner.h"
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
// Halvings of a panel, and parts of it, before the area is compared instead of bounded. An isolated point
// without a normal needs some 12 halvings in both directions until what is left is below its share, with a
// few parts of each depth. Along a line on which normals vanish the parts double with every other halving,
// and no depth is enough. Such a line is recognised by many parts at a depth at which other panels have no
// part left.
constexpr int MaxDepth = 30;
constexpr std::size_t MaxParts = 128;
constexpr std::size_t MaxAbreast = 16;
constexpr int DepthOfLines = 6;
// The same where an area's derivatives are bounded, whose bounds are never replaced by comparisons: where the
// normal has a direction everywhere and a rule's error is below MaxUnresolved of the largest values, and
// elsewhere. The bound of a part without a direction is that of the largest values: what is left of a pole or
// an isolated point has 2^-21 of them. Boxes of smaller parts would be no smaller (TrimSeries).
constexpr int DepthOfDirections = 4;
constexpr int DepthOfPoles = 21;
constexpr double MaxUnresolved = 1e-3;
constexpr std::size_t MaxPartsOfDirections = 1024;
constexpr std::size_t MaxDirectionsAbreast = 64;
// The limit of parts where the moments, too, need more points than one part may have, because weights differ
// much.
constexpr std::size_t MaxPartsOfMoments = 8192;
// Where an exact rule needs more points than this, the order that a bound gives costs less.
constexpr int MaxFlatOrder = 10;
// Rounding of a crossing's parameter, in units of u times its largest coordinate: 2 (degree + 2) for trim
// pieces up to degree 25.
constexpr double EndRounding = 54.0;
// An end this close to a patch's corner is that corner: cuts at knots are the knots themselves.
constexpr double RowBorder = 1e-15;
constexpr int MinCompared = 4;
constexpr int MaxCompared = 15;

/// Largest change of the normal of a prismatic panel along its straight lines, relative to the largest
/// normal: 1e-14 at the samples of smFacePanels.cxx, times Lebesgue's constant, which is at most 2^n / n for
/// n <= 20 equal steps.
double GetPrismaticDeviation(int q)
{
  return 1e-14 * (q <= 5 ? std::exp2(4 * q) / (4 * q) : 5.0);
}

/// Bound of the part of the parameters that a panel covers: |s| up to extent[0], times the way of r, which is
/// no longer than that of the coefficients of its trim piece.
double GetCovered(const FacePanels& panels, const Panel& panel, const double extent[2])
{
  double way = 0.0;
  const double* trim = panels.Coefficients.data() + panel.Trim;
  for (int i = 0; i < panel.TrimDegree; ++i)
  {
    way += std::abs(trim[2 * i + 3] - trim[2 * i + 1]);
  }
  return extent[0] * way / panels.Patches[panel.Patch].Width[1];
}

/// Highest degree of the factors g along a straight ruling. A height is one degree more than x.n, and so is a
/// Bernstein polynomial of the patch, which has degree 1 there.
int GetDegree(const PlanRequest& request)
{
  int degree = 0;
  for (const BoundClass& c : request.Classes)
  {
    degree = std::max(degree, c.Degree + (c.Kind == BoundClass::HeightMoment || c.HasBasis() ? 1 : 0));
  }
  return degree;
}

/// The same along a line of a parallelogram, where those polynomials have the degree 2: one of s times one of
/// r.
int GetFlatDegree(const PlanRequest& request)
{
  int degree = GetDegree(request);
  for (const BoundClass& c : request.Classes)
  {
    degree = std::max(degree, c.Degree + (c.HasBasis() ? 2 : 0));
  }
  return degree;
}
}

PanelPlanner::PanelPlanner(
  const FacePanels& panels, const PlanRequest& request, FaceSeries& series, FacePlan& plan)
  : Panels(panels)
  , Request(request)
  , Result(plan)
  , Degree(GetDegree(request))
  , FlatDegree(GetFlatDegree(request))
  , Bounds(panels, request, series, Degree)
  , Series(series)
{
}

void PanelPlanner::AddFlatError(const Panel& panel, const double extent[2], double reach)
{
  const Patch& patch = this->Panels.Patches[panel.Patch];
  // With d = P00 - P10 - P01 + P11, a position is within |d| / 4 of the parallelogram's, and Ss and Sr are
  // within |d| / 2 of their means; for s and r of up to an extent beyond 1, within that minus 1/2 times |d|,
  // and their product minus 3/4 times |d|. A rule is off by at most twice the largest difference from what it
  // is exact for.
  const std::array<double, 4>* p = this->Panels.Points.data() + patch.FirstPoint;
  double d[3];
  for (int c = 0; c < 3; ++c)
  {
    d[c] = (p[0][c] - p[1][c] - p[2][c] + p[3][c]) / p[0][3];
  }
  const double moved = Norm(d);
  if (!(moved > 0.0))
  {
    return;
  }
  const double rotated =
    (std::max(extent[0], extent[1]) - 0.5) * moved * (patch.Stretch[0] + patch.Stretch[1] + moved);
  const double area = patch.Stretch[0] * patch.Stretch[1];
  // Bernstein polynomials of degrees 1 and 1, over the weight.
  const double basis = extent[0] * extent[1] / p[0][3];
  const double position = (extent[0] * extent[1] - 0.75) * moved;
  // The derivatives of those polynomials, and the normal's direction, which changes by at most twice what the
  // normal does over the shorter one.
  double tangents[2][3];
  for (int c = 0; c < 3; ++c)
  {
    tangents[0][c] = 0.5 * (p[1][c] - p[0][c] + p[3][c] - p[2][c]) / p[0][3];
    tangents[1][c] = 0.5 * (p[2][c] - p[0][c] + p[3][c] - p[1][c]) / p[0][3];
  }
  const double shortest = Norm(Cross(tangents[0], tangents[1])) - rotated;
  const double stretch = patch.Stretch[0] + patch.Stretch[1];
  const double directionChange = shortest > rotated ? 2.0 * rotated / shortest : 2.0;
  const double slope = (std::max(extent[0], extent[1]) - 0.5) * moved;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    double change = 0.0;
    if (c.Kind == BoundClass::AreaBasis)
    {
      change = 2.0 * basis * (directionChange * (stretch + 2.0 * slope) + 2.0 * slope);
      change = c.Degree == 0
        ? change
        : change * reach + 2.0 * basis * (stretch + 2.0 * slope) * position + 2.0 * basis * rotated;
    }
    else
    {
      change = GetIntegrandChange(c, position, rotated, area, reach, basis);
    }
    this->Result.QuadratureBound[i] += 2.0 * GetCovered(this->Panels, panel, extent) * change;
  }
}

bool PanelPlanner::PlanExactly(std::uint32_t index)
{
  // A parallelogram: x.n and |n| are constant, so g(x(t)) of degree D d times s of degree d times r' of
  // degree d - 1 in t, and xi^(D+1) .. across.
  const Panel& panel = this->Panels.Panels[index];
  const int trimDegree = std::max<int>(panel.TrimDegree, 1);
  const int along = ((this->FlatDegree + 2) * trimDegree + 1) / 2;
  if (panel.Shape != PanelShape::Flat || along > MaxFlatOrder)
  {
    return false;
  }
  const Patch& patch = this->Panels.Patches[panel.Patch];
  double center = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double x = patch.Center[c] + this->Request.Shift[c];
    center += x * x;
  }
  // The patch is continued to trim curves beyond it.
  double extent[2] = { 1.0, 1.0 };
  for (int i = 0; i <= panel.TrimDegree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      const double local =
        (this->Panels.Coefficients[panel.Trim + 2 * i + d] - patch.Start[d]) / patch.Width[d];
      extent[d] = std::max({ extent[d], std::abs(local), std::abs(local - 1.0) });
    }
  }
  const double reach = std::sqrt(center) + 2.0 * std::max(extent[0], extent[1]) * patch.Radius;
  this->FlatReach = std::max(this->FlatReach, reach);
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    const double area = 4.0 * patch.Radius * patch.Radius * GetCovered(this->Panels, panel, extent);
    this->Result.Magnitude[i] += HullBound{ area, reach }.GetMagnitude(c);
  }
  PlannedItem item{ ItemKind::Panel, index };
  item.Along = along;
  item.Across = (this->Degree + 2) / 2;
  this->AddFlatError(panel, extent, reach);
  this->Result.Items.push_back(item);
  this->Result.Evaluations += item.Along * item.Across;
  return true;
}

bool PanelPlanner::FindOrders(double share, bool withArea, int& along, int& across) const
{
  along = across = 1;
  const std::size_t count = this->Request.Classes.size();
  const auto wanted = [&](std::size_t i)
  {
    const double tolerance = share * this->Request.Tolerances[i];
    return (withArea || !this->Request.Classes[i].HasLength()) && tolerance > 0.0 &&
      !(2.0 * this->Bounds.GetSupremum(i) <= tolerance);
  };
  for (std::size_t i = 0; i < count; ++i)
  {
    if (wanted(i))
    {
      along = std::max(along, this->Bounds.GetAlongT().GetOrder(i));
      across = std::max(across, this->Bounds.GetAcrossXi().GetOrder(i));
    }
  }
  if (along > MaxOrder || across > MaxOrder)
  {
    return false;
  }
  // A direction that errs by less than half of the tolerance leaves the rest to the other one.
  const auto enough = [&](int t, int xi)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (wanted(i) && !(this->Bounds.GetError(i, t, xi) <= share * this->Request.Tolerances[i]))
      {
        return false;
      }
    }
    return true;
  };
  if (along > 1 && along <= across && enough(along - 1, across))
  {
    --along;
  }
  else if (across > 1 && enough(along, across - 1))
  {
    --across;
  }
  return true;
}

PanelPlanner::DirectionError PanelPlanner::GetDirectionError(std::size_t integrand)
{
  const BoundClass& c = this->Request.Classes[integrand];
  if (c.Kind != BoundClass::AreaBasis)
  {
    return {};
  }
  const PatchMajorants& majorants = this->Bounds.GetMajorants();
  const PatchChange& change = this->Bounds.GetChange();
  // The direction of a vector changes by at most twice what the vector does over its length, and by 2.
  const double length = majorants.GetMinLength();
  double directionChange = majorants.GetDirectionDeviation();
  directionChange +=
    change.Rotated > 0.0 ? (length > change.Rotated ? 2.0 * change.Rotated / length : 2.0) : 0.0;
  directionChange = std::min(directionChange, 2.0);
  DirectionError error;
  if (!(directionChange > 0.0) && !(change.Rotated > 0.0))
  {
    return error;
  }
  const PatchMajorants::Slopes slopes = majorants.GetSlopes();
  const double reach = IntegerPower(this->GetReach() + change.Moved, c.Degree);
  error.OfTangents = (slopes.OfBasis[0] * change.Slope[1] + slopes.OfBasis[1] * change.Slope[0]) * reach +
    (c.Degree > 0 ? slopes.GetArea() * change.Moved + 2.0 * change.Basis * change.Rotated : 0.0);
  // A rule is off by at most twice the largest difference.
  error.OfTangents *= 2.0 * this->Bounds.GetJacobian();
  error.OfDirection = 2.0 * directionChange * slopes.GetArea() * reach * this->Bounds.GetJacobian() +
    (c.Degree > 0 && directionChange > 0.0 ? 4.0 * directionChange * this->Bounds.GetSupremum(integrand)
                                           : 0.0);
  return error;
}

double PanelPlanner::GetError(std::size_t integrand, int along, int across)
{
  const double error = this->Bounds.GetError(integrand, along, across);
  const DirectionError direction = this->GetDirectionError(integrand);
  // The largest values do not depend on the direction.
  return direction.OfTangents +
    std::min(error + direction.OfDirection,
      direction.OfDirection > 0.0 ? 2.0 * this->Bounds.GetSupremum(integrand) : error);
}

bool PanelPlanner::IsDirectionSmall(double share)
{
  for (std::size_t i = 0; this->Bounds.NeedsDirection() && i < this->Request.Classes.size(); ++i)
  {
    const double tolerance = share * this->Request.Tolerances[i];
    const DirectionError error = this->GetDirectionError(i);
    if (tolerance > 0.0 && !(error.OfTangents + error.OfDirection <= tolerance))
    {
      return false;
    }
  }
  return true;
}

bool PanelPlanner::ConvergesInArea(int along, int across) const
{
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    if (this->Request.Classes[i].Kind == BoundClass::AreaBasis &&
      !(this->Bounds.GetError(i, along, across) <= MaxUnresolved * this->Bounds.GetSupremum(i)))
    {
      return false;
    }
  }
  return true;
}

bool PanelPlanner::IsSmall(double kink, double share) const
{
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    const double tolerance = share * this->Request.Tolerances[i];
    if (c.Kind == BoundClass::AreaMoment && tolerance > 0.0 &&
      kink * IntegerPower(this->GetReach(), c.Degree) > 0.25 * tolerance)
    {
      return false;
    }
  }
  return true;
}

void PanelPlanner::AddEndError(const Panel& panel, const PanelPart& part)
{
  // The covered part of a patch's right edge ends where a trim curve crosses it: known to the rounding of
  // that curve.
  if (!panel.Covered)
  {
    return;
  }
  const Patch& patch = this->Panels.Patches[panel.Patch];
  const double width = this->Bounds.GetTrim().GetHigh(1) - this->Bounds.GetTrim().GetLow(1);
  const double largest = std::max(
    { std::abs(patch.Start[1]), std::abs(patch.Start[1] + patch.Width[1]), this->Panels.MaxTrim[1] });
  const double rounding = EndRounding * UnitRoundoff * largest / patch.Width[1];
  int ends = 0;
  ends += part.Start == 0.0 && std::abs(this->Bounds.GetTrim().GetLow(1)) > RowBorder ? 1 : 0;
  ends += part.End == 1.0 && std::abs(this->Bounds.GetTrim().GetHigh(1) - 1.0) > RowBorder ? 1 : 0;
  if (ends == 0 || !(width > 0.0))
  {
    return;
  }
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    this->Result.QuadratureBound[i] += ends * rounding / width * this->Bounds.GetSupremum(i);
  }
}

int PanelPlanner::ChooseDirection(const PanelPart& part) const
{
  // The direction that no order satisfies; where neither does, the one in which the patch varies more.
  bool failsT = false;
  bool failsXi = false;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    failsT = failsT || this->Bounds.GetAlongT().GetOrder(i) > MaxOrder;
    failsXi = failsXi || this->Bounds.GetAcrossXi().GetOrder(i) > MaxOrder;
  }
  const bool anyway = (failsT && failsXi) || !this->Bounds.GetMajorants().HasLength();
  const bool alongT = anyway ? this->Bounds.GetMajorants().GetVaryingDirection() == 1 : failsT;
  if (alongT)
  {
    return 0;
  }
  // Halving xi narrows the box unless the piece itself runs across it.
  const double middle = 0.5 * (part.XiStart + part.XiEnd);
  const double whole = this->Bounds.GetTrim().GetBox(part.XiStart, part.XiEnd).Half[0];
  const double half = std::max(this->Bounds.GetTrim().GetBox(part.XiStart, middle).Half[0],
    this->Bounds.GetTrim().GetBox(middle, part.XiEnd).Half[0]);
  return half < 0.8 * whole ? 1 : 0;
}

void PanelPlanner::Keep(
  std::uint32_t index, const PanelPart& part, int along, int across, bool compared, double noise)
{
  // Where weights differ much, or no order suffices for the moments, |n| may have peaks between the points of
  // two orders.
  const bool mayEstimate =
    compared && std::max(along, across) <= MaxOrder && this->Bounds.GetMajorants().HasEvenWeight();
  if (compared)
  {
    // The orders are those of the moments; where |n| has a kink, few points on many parts are most accurate.
    along = std::clamp(along, MinCompared, MaxCompared);
    across = std::clamp(across, MinCompared, MaxCompared);
  }
  PlannedItem item{ ItemKind::Panel, index };
  item.Start = part.Start;
  item.End = part.End;
  item.XiStart = part.XiStart;
  item.XiEnd = part.XiEnd;
  item.Along = along;
  item.Across = across;
  item.Compared = compared;
  const int last = compared ? 2 : 1;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    this->Result.Magnitude[i] += this->Bounds.GetSupremum(i);
    const double error = this->GetError(i, last * along, last * across);
    if (c.Kind != BoundClass::AreaMoment)
    {
      this->Result.QuadratureBound[i] += error;
    }
    else
    {
      this->Result.QuadratureBound[i] +=
        (mayEstimate && !(error <= this->Request.Tolerances[i] * std::exp2(-part.Depth)) ? 0.0 : error) +
        2.0 * noise * IntegerPower(this->GetReach(), c.Degree);
    }
  }
  this->Result.Estimated = this->Result.Estimated || compared;
  this->Bounds.GetMajorants().GetDropped(this->Request.Classes, this->Dropped);
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    // A rule is off by at most twice the largest value.
    this->Result.QuadratureBound[i] +=
      this->Dropped[i] > 0.0 ? 2.0 * this->Dropped[i] * this->Bounds.GetJacobian() : 0.0;
  }
  const std::vector<double>& change = this->Bounds.GetChange().Integrands;
  for (std::size_t i = 0; i < change.size(); ++i)
  {
    this->Result.QuadratureBound[i] += 2.0 * change[i] * this->Bounds.GetJacobian();
    this->Result.Magnitude[i] += change[i] * this->Bounds.GetJacobian();
  }
  this->AddEndError(this->Panels.Panels[index], part);
  this->Result.Evaluations += static_cast<std::int64_t>(along) * across * (compared ? 5 : 1);
  this->Result.Items.push_back(item);
}

bool PanelPlanner::PlanByPatch(std::uint32_t index, const PanelPart& part, bool withForm)
{
  return this->Bounds.ExpandByPatch(this->Panels.Panels[index], part, withForm) &&
    this->KeepIfSmall(index, part);
}

bool PanelPlanner::PlanByStrip(std::uint32_t index, const PanelPart& part)
{
  return this->Bounds.ExpandByStrip(this->Panels.Panels[index], part) && this->KeepIfSmall(index, part);
}

bool PanelPlanner::KeepIfSmall(std::uint32_t index, const PanelPart& part)
{
  const Panel& panel = this->Panels.Panels[index];
  int along = 1;
  int across = 1;
  if (!this->FindOrders(1.0, true, along, across))
  {
    return false;
  }
  const double noise = this->GetNoise(panel, 0.0);
  if (!this->IsSmall(2.0 * noise, 1.0) || !this->IsDirectionSmall(1.0))
  {
    return false;
  }
  this->Keep(index, part, along, across, false, noise);
  return true;
}

double PanelPlanner::GetNoise(const Panel& panel, double kink) const
{
  const PatchMajorants& majorants = this->Bounds.GetMajorants();
  double noise = this->Bounds.GetJacobian() * majorants.GetLengthDeviation();
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    if (this->Request.Classes[i] == PlainArea)
    {
      noise += kink > 0.0 ? kink * this->Bounds.GetSupremum(i) : 0.0;
      noise += panel.Shape == PanelShape::Prismatic && !majorants.HasLength()
        ? GetPrismaticDeviation(this->Panels.Patches[panel.Patch].Degree[1]) * this->Bounds.GetSupremum(i)
        : 0.0;
    }
  }
  return noise;
}

void PanelPlanner::PlanPart(std::uint32_t index, const PanelPart& part)
{
  const Panel& panel = this->Panels.Panels[index];
  this->Bounds.ExpandByPart(panel, part);
  const PatchMajorants& majorants = this->Bounds.GetMajorants();
  const double share = std::exp2(-part.Depth);
  // |n| and its factored form differ beyond a collapsed edge.
  const double kinks[2] = { majorants.GetKink(0), majorants.GetKink(1) };
  const double kink = kinks[0] + kinks[1];
  double kinkArea = 0.0;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    kinkArea =
      this->Request.Classes[i] == PlainArea && kink > 0.0 ? kink * this->Bounds.GetSupremum(i) : kinkArea;
  }
  double noise = this->GetNoise(panel, kink);
  if (!this->IsSmall(2.0 * this->GetNoise(panel, 0.0), share))
  {
    // |n| may be a polynomial whose bound of the deviation is too large for the tolerance: tried again
    // without this form.
    this->Bounds.ExpandByPart(panel, part, false);
    noise = this->GetNoise(panel, kink);
  }
  int along = 1;
  int across = 1;
  const bool found = this->FindOrders(share, true, along, across);
  const bool hasDirection = this->IsDirectionSmall(share);
  if (found && this->IsSmall(kinkArea, share) && hasDirection)
  {
    this->Keep(index, part, along, across, false, noise);
    return;
  }
  // Where only the bounds of an area's derivatives are too large, few parts must do, with the orders of the
  // other integrands.
  const bool isDirection = !(found && hasDirection) && this->Bounds.NeedsDirection() &&
    this->FindOrders(share, false, along, across);
  const int pole = this->Bounds.GetPoleDirection();
  const bool isEven =
    majorants.HasLength() && (hasDirection || pole < 0) && this->ConvergesInArea(along, across);
  const bool isLine = part.Depth >= DepthOfLines && this->Abreast > MaxDirectionsAbreast;
  if (isDirection && (isLine || part.Depth >= (isEven ? DepthOfDirections : DepthOfPoles)))
  {
    this->Keep(index, part, along, across, false, noise);
    return;
  }
  const bool canCompare =
    !isDirection && this->FindOrders(share, false, along, across) && majorants.HasEvenWeight();
  const std::size_t maxParts = isDirection ? MaxPartsOfDirections : canCompare ? MaxParts : MaxPartsOfMoments;
  if (part.Depth < MaxDepth && this->Pending.size() + this->Parts < maxParts &&
    (!canCompare || part.Depth < DepthOfLines || this->Abreast <= MaxAbreast))
  {
    const bool inXi = isDirection && pole >= 0 && !hasDirection ? pole == 0
      : found                                                   ? kinks[0] >= kinks[1]
                                                                : this->ChooseDirection(part) == 1;
    PanelPart halves[2] = { part, part };
    (inXi ? halves[0].XiEnd : halves[0].End) = (inXi ? halves[1].XiStart : halves[1].Start) =
      inXi ? 0.5 * (part.XiStart + part.XiEnd) : 0.5 * (part.Start + part.End);
    for (PanelPart& half : halves)
    {
      ++half.Depth;
      this->Pending.push_back(half);
    }
    return;
  }
  this->Keep(index, part, along, across, true, noise);
}

void PanelPlanner::Plan(std::uint32_t index)
{
  if (this->PlanExactly(index))
  {
    return;
  }
  const std::vector<double> before = this->Result.Magnitude;
  // An expensive form of |n| costs more than the points that it saves where few are needed without it.
  const bool isCheap = this->Series.HasCheapForm(this->Panels.Panels[index].Patch);
  bool isPlanned = !isCheap && this->PlanByPatch(index, {}, false);
  isPlanned = isPlanned || this->PlanByPatch(index, {}, true) || this->PlanByStrip(index, {});
  if (!isPlanned)
  {
    this->PlanInParts(index);
  }
  this->Result.LimitMagnitude(before, this->Request.Classes,
    BoundPanelByHull(this->Panels, this->Panels.Panels[index], this->Request.Shift));
}

void PanelPlanner::PlanInParts(std::uint32_t index)
{
  this->Pending.assign(1, {});
  this->Parts = 0;
  // Parts of small depth come first, so that the limit of parts affects the deepest ones.
  for (std::size_t next = 0; next < this->Pending.size(); ++next)
  {
    const PanelPart part = this->Pending[next];
    if (next == 0 || part.Depth != this->Pending[next - 1].Depth)
    {
      this->Abreast = this->Pending.size() - next;
    }
    const std::size_t before = this->Pending.size();
    this->PlanPart(index, part);
    this->Parts += this->Pending.size() == before ? 1 : 0;
  }
}
}
