#include "smPanelPlanner.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// Radii of the ellipses tried: the least bound counts.
constexpr double Radii[] = { 1.3, 1.5, 1.75, 2.05, 2.4, 2.8, 3.3, 4.0, 5.0, 6.5, 9.0, 13.0, 20.0, 40.0,
  100.0 };
// Halvings of a panel, and parts of it, before the area is compared instead of bounded. An isolated point without a
// normal needs some 12 halvings in both directions until what is left is below its share.
constexpr int LargestDepth = 30;
constexpr std::size_t MostParts = 128;
// The same where moments, too, want more points than one part may have: weights that differ a lot.
constexpr std::size_t MostPartsOfMoments = 8192;
// A higher exact order costs more than the one that a bound asks for.
constexpr int LargestExactOrder = 10;
// Rounding of a crossing's parameter, in units of u times its largest coordinate: 2 (degree + 2) for trim pieces up to degree 25.
constexpr double EndRounding = 54.0;
// An end this close to a patch's corner is that corner: cuts at knots are the knots themselves.
constexpr double RowBorder = 1e-15;
constexpr int LeastCompared = 4;
constexpr int MostCompared = 15;

/// What the normal of a prismatic panel may change by along its straight lines, relative to the largest normal: 1e-14 at the samples of
/// smFacePanels.cxx, times Lebesgue's constant, which is at most 2^n / n for n <= 20 equal steps.
double GetPrismaticDeviation(int q)
{
  return 1e-14 * (q <= 5 ? std::exp2(4 * q) / (4 * q) : 5.0);
}
}

PanelPlanner::PanelPlanner(const FacePanels& panels, const PlanRequest& request, FacePlan& plan)
  : Panels(panels)
  , Request(request)
  , Result(plan)
  , Traits(panels.Patches.size())
  , HasTraits(panels.Patches.size(), false)
{
  for (const BoundClass& c : request.Classes)
  {
    // A height is one degree more than x.n along a straight ruling.
    this->Degree = std::max(this->Degree, c.Degree + (c.Kind == BoundClass::HeightMoment ? 1 : 0));
  }
}

const PatchTraits& PanelPlanner::GetTraits(std::uint32_t patch)
{
  if (!this->HasTraits[patch])
  {
    const Patch& source = this->Panels.Patches[patch];
    this->Traits[patch] =
      FindPatchTraits(this->Panels.Points.data() + source.FirstPoint, source.Degree[0], source.Degree[1]);
    this->HasTraits[patch] = true;
  }
  return this->Traits[patch];
}

void PanelPlanner::AddFlatError(const Patch& patch, double reach)
{
  // With d = P00 - P10 - P01 + P11, a position is within |d| / 4 of the parallelogram's, and Ss and Sr are within |d| / 2 of their
  // means. A rule is off by at most twice the largest difference from what it is exact for.
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
  const double rotated = 0.5 * moved * (patch.Stretch[0] + patch.Stretch[1] + moved);
  const double area = patch.Stretch[0] * patch.Stretch[1];
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    const int k = c.Degree;
    const double shifted = 0.25 * moved * area * (c.Kind == BoundClass::AreaMoment ? k : k + 1);
    const double error = c.Kind == BoundClass::VectorArea ? rotated
      : c.Kind == BoundClass::AreaMoment
      ? rotated * std::pow(reach, k) + (k > 0 ? shifted * std::pow(reach, k - 1) : 0.0)
      : (rotated * reach + shifted) * std::pow(reach, k) / (c.Kind == BoundClass::VolumeMoment ? 3 + k : 1);
    this->Result.QuadratureBound[i] += 2.0 * error;
  }
}

bool PanelPlanner::PlanExactly(std::uint32_t index)
{
  // A parallelogram: x.n and |n| are constant, so g(x(t)) of degree D d times s of degree d times r' of degree d - 1 in
  // t, and xi^(D+1) .. across.
  const Panel& panel = this->Panels.Panels[index];
  const int trimDegree = std::max<int>(panel.TrimDegree, 1);
  const int along = ((this->Degree + 2) * trimDegree + 1) / 2;
  if (panel.Shape != PanelShape::Flat || along > LargestExactOrder)
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
  const double reach = std::sqrt(center) + 2.0 * patch.Radius;
  this->Reach = std::max(this->Reach, reach);
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    const double area = 4.0 * patch.Radius * patch.Radius;
    this->Result.Magnitude[i] += c.Kind == BoundClass::VectorArea ? area
      : c.Kind == BoundClass::AreaMoment                          ? area * std::pow(reach, c.Degree)
      : c.Kind == BoundClass::HeightMoment                        ? area * std::pow(reach, c.Degree + 1)
                                           : area * std::pow(reach, c.Degree + 1) / (3 + c.Degree);
  }
  PlannedItem item{ ItemKind::Panel, index };
  item.Along = along;
  item.Across = (this->Degree + 2) / 2;
  this->AddFlatError(patch, reach);
  this->Result.Items.push_back(item);
  this->Result.Evaluations += item.Along * item.Across;
  return true;
}

void PanelPlanner::SetPolynomialOrders(const Patch& patch)
{
  // Numerators have degree 3p-2 in s and 3q-2 in r, heights times normals one more, positions p and q; in t all of these times
  // the trim's degree, and s(t) r'(t).
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  const int d = this->Trim.GetDegree();
  const bool straight = this->Trim.IsConstantInS();
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    if (c.Kind != BoundClass::AreaMoment)
    {
      const int more = c.Kind == BoundClass::HeightMoment ? 1 : 0;
      const int inS = 3 * p - 2 + more + c.Degree * p;
      const int inR = 3 * q - 2 + more + c.Degree * q;
      const int inT = straight ? inR * d + d - 1 : (inS + inR) * d + 2 * d - 1;
      this->AcrossXi.SetExactOrder(i, inS / 2 + 1);
      this->AlongT.SetExactOrder(i, std::max(inT, 0) / 2 + 1);
    }
  }
}

void PanelPlanner::BoundDirections(const Panel& panel, const Part& part, double jacobian)
{
  const std::size_t count = this->Request.Classes.size();
  const Patch& patch = this->Panels.Patches[panel.Patch];
  const ParameterBox box = this->Trim.GetBox(part.XiStart, part.XiEnd);
  const Ellipse real = Ellipse::FromRadius(1.0);
  const double share = std::exp2(-part.Depth);
  this->AlongT.Reset(count);
  this->AcrossXi.Reset(count);
  this->Best.assign(count, LargestOrder + 1);
  if (panel.Shape == PanelShape::General)
  {
    for (const double radius : Radii)
    {
      if (!this->Majorants.Evaluate(Ellipse::FromRadius(radius), real, this->Request.Classes, this->Bounds))
      {
        break;
      }
      for (double& bound : this->Bounds)
      {
        bound *= jacobian;
      }
      this->AcrossXi.AddEllipse(radius, this->Bounds);
      if (!this->MayImprove(this->AcrossXi, share))
      {
        break;
      }
    }
  }
  else
  {
    // Along a straight ruling x.n is linear, |n| too unless it vanishes somewhere, and g has its degree.
    const int order = (this->Degree + 3) / 2;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->Request.Classes[i].Kind != BoundClass::AreaMoment || panel.Shape == PanelShape::Prismatic ||
        this->Majorants.HasLength())
      {
        this->AcrossXi.SetExactOrder(i, order);
      }
    }
  }
  this->Best.assign(count, LargestOrder + 1);
  for (const double radius : Radii)
  {
    const Ellipse t = Ellipse::FromRadius(radius);
    const Ellipse s = this->Trim.Map(t, 0, box, part.XiStart, part.XiEnd);
    const Ellipse r = this->Trim.Map(t, 1, box, part.XiStart, part.XiEnd);
    if (!this->Majorants.Evaluate(s, r, this->Request.Classes, this->Bounds))
    {
      break;
    }
    const double factor =
      this->Trim.GetLargestS(t) * (part.XiEnd - part.XiStart) * this->Trim.GetLargestSlope(t);
    for (double& bound : this->Bounds)
    {
      bound *= factor;
    }
    this->AlongT.AddEllipse(radius, this->Bounds);
    if (!this->MayImprove(this->AlongT, share))
    {
      break;
    }
  }
  if (this->GetTraits(panel.Patch).Polynomial)
  {
    this->SetPolynomialOrders(patch);
  }
}

bool PanelPlanner::MayImprove(const DirectionBound& direction, double share)
{
  bool may = false;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const double half = 0.5 * share * this->Request.Tolerances[i];
    if (half > 0.0 && !(this->Supremum[i] <= half))
    {
      // Orders fall with the radius until the bounds rise faster.
      const int order = direction.FindLastOrder(i, half, LargestOrder);
      may = may || (order <= this->Best[i] && order > 1);
      this->Best[i] = std::min(this->Best[i], order);
    }
  }
  return may;
}

double PanelPlanner::GetError(std::size_t integrand, int along, int across) const
{
  // The rule's weights are positive: it cannot be off by more than twice the largest value.
  return std::min(2.0 * this->Supremum[integrand],
    this->AlongT.GetError(integrand, along) + this->AcrossXi.GetError(integrand, across));
}

bool PanelPlanner::FindOrders(double share, bool withArea, int& along, int& across) const
{
  along = across = 1;
  const std::size_t count = this->Request.Classes.size();
  const auto wanted = [&](std::size_t i)
  {
    const double tolerance = share * this->Request.Tolerances[i];
    return (withArea || this->Request.Classes[i].Kind != BoundClass::AreaMoment) && tolerance > 0.0 &&
      !(2.0 * this->Supremum[i] <= tolerance);
  };
  for (std::size_t i = 0; i < count; ++i)
  {
    if (wanted(i))
    {
      const double half = 0.5 * share * this->Request.Tolerances[i];
      along = std::max(along, this->AlongT.FindOrder(i, half, LargestOrder));
      across = std::max(across, this->AcrossXi.FindOrder(i, half, LargestOrder));
    }
  }
  if (along > LargestOrder || across > LargestOrder)
  {
    return false;
  }
  // One direction may leave the other more than half.
  const auto enough = [&](int t, int xi)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (wanted(i) && !(this->GetError(i, t, xi) <= share * this->Request.Tolerances[i]))
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

bool PanelPlanner::IsSmall(double kink, double share) const
{
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    const double tolerance = share * this->Request.Tolerances[i];
    if (c.Kind == BoundClass::AreaMoment && tolerance > 0.0 &&
      kink * std::pow(this->Reach, c.Degree) > 0.25 * tolerance)
    {
      return false;
    }
  }
  return true;
}

void PanelPlanner::AddEndError(const Panel& panel, const Part& part)
{
  // The covered part of a patch's right edge ends where a trim curve crosses it: known to the rounding of that curve.
  if (!panel.Covered)
  {
    return;
  }
  const Patch& patch = this->Panels.Patches[panel.Patch];
  const double width = this->Trim.GetHigh(1) - this->Trim.GetLow(1);
  const double largest = std::max(std::abs(patch.Start[1]), std::abs(patch.Start[1] + patch.Width[1]));
  const double rounding = EndRounding * UnitRoundoff * largest / patch.Width[1];
  int ends = 0;
  ends += part.Start == 0.0 && std::abs(this->Trim.GetLow(1)) > RowBorder ? 1 : 0;
  ends += part.End == 1.0 && std::abs(this->Trim.GetHigh(1) - 1.0) > RowBorder ? 1 : 0;
  if (ends == 0 || !(width > 0.0))
  {
    return;
  }
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    this->Result.QuadratureBound[i] += ends * rounding / width * this->Supremum[i];
  }
}

int PanelPlanner::ChooseDirection(const Part& part, double share) const
{
  // The direction that no order satisfies; where neither does, the one in which the patch varies more.
  bool failsT = false;
  bool failsXi = false;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const double half = 0.5 * share * this->Request.Tolerances[i];
    if (half > 0.0 && !(this->Supremum[i] <= half))
    {
      failsT = failsT || this->AlongT.FindOrder(i, half, LargestOrder) > LargestOrder;
      failsXi = failsXi || this->AcrossXi.FindOrder(i, half, LargestOrder) > LargestOrder;
    }
  }
  const bool anyway = (failsT && failsXi) || !this->Majorants.HasLength();
  const bool alongT = anyway ? this->Majorants.GetVaryingDirection() == 1 : failsT;
  if (alongT)
  {
    return 0;
  }
  // Halving xi narrows the box unless the piece itself runs across it.
  const double middle = 0.5 * (part.XiStart + part.XiEnd);
  const double whole = this->Trim.GetBox(part.XiStart, part.XiEnd).Half[0];
  const double half =
    std::max(this->Trim.GetBox(part.XiStart, middle).Half[0], this->Trim.GetBox(middle, part.XiEnd).Half[0]);
  return half < 0.8 * whole ? 1 : 0;
}

void PanelPlanner::Keep(
  std::uint32_t index, const Part& part, int along, int across, bool compared, double noise)
{
  PlannedItem item{ ItemKind::Panel, index };
  item.Start = part.Start;
  item.End = part.End;
  item.XiStart = part.XiStart;
  item.XiEnd = part.XiEnd;
  item.Along = along;
  item.Across = across;
  item.Share = std::exp2(-part.Depth);
  item.Compared = compared;
  const int last = compared ? 2 : 1;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    this->Result.Magnitude[i] += this->Supremum[i];
    const double error = this->GetError(i, last * along, last * across);
    if (c.Kind != BoundClass::AreaMoment)
    {
      this->Result.QuadratureBound[i] += error;
    }
    else
    {
      this->Result.QuadratureBound[i] +=
        (compared && !(error <= this->Request.Tolerances[i] * item.Share) ? 0.0 : error) +
        2.0 * noise * std::pow(this->Reach, c.Degree);
    }
  }
  this->Result.Estimated = this->Result.Estimated || compared;
  const Ellipse real = Ellipse::FromRadius(1.0);
  const double jacobian =
    this->Trim.GetLargestS(real) * (part.XiEnd - part.XiStart) * this->Trim.GetLargestSlope(real);
  this->Majorants.GetDropped(this->Request.Classes, this->Bounds);
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    // A rule is off by at most twice the largest value.
    this->Result.QuadratureBound[i] += this->Bounds[i] > 0.0 ? 2.0 * this->Bounds[i] * jacobian : 0.0;
  }
  this->AddEndError(this->Panels.Panels[index], part);
  this->Result.Evaluations += static_cast<std::int64_t>(along) * across * (compared ? 5 : 1);
  this->Result.Items.push_back(item);
}

void PanelPlanner::PlanPart(std::uint32_t index, const Part& part)
{
  const Panel& panel = this->Panels.Panels[index];
  const Patch& patch = this->Panels.Patches[panel.Patch];
  const PatchTraits& traits = this->GetTraits(panel.Patch);
  const double width = panel.End - panel.Start;
  this->Trim.Expand(this->Panels.Coefficients.data() + panel.Trim, panel.TrimDegree, patch,
    panel.Start + width * part.Start, panel.Start + width * part.End);
  std::array<double, 3> origin;
  for (int c = 0; c < 3; ++c)
  {
    origin[c] = patch.Center[c] + this->Request.Shift[c];
  }
  const ParameterBox box = this->Trim.GetBox(part.XiStart, part.XiEnd);
  this->Majorants.Expand(
    this->Panels.Points.data() + patch.FirstPoint, patch.Degree[0], patch.Degree[1], traits, box, origin);

  const Ellipse real = Ellipse::FromRadius(1.0);
  const double jacobian =
    this->Trim.GetLargestS(real) * (part.XiEnd - part.XiStart) * this->Trim.GetLargestSlope(real);
  if (this->Majorants.Evaluate(real, real, this->Request.Classes, this->Supremum))
  {
    this->Reach = std::max(this->Reach, this->Majorants.GetReach());
    for (double& value : this->Supremum)
    {
      value *= jacobian;
    }
  }
  else
  {
    this->Supremum.assign(this->Request.Classes.size(), std::numeric_limits<double>::infinity());
  }
  this->BoundDirections(panel, part, jacobian);

  const double share = std::exp2(-part.Depth);
  double noise = jacobian * this->Majorants.GetLengthDeviation();
  // |n| and its factored form differ beyond a collapsed edge.
  const double kinks[2] = { this->Majorants.GetKink(0), this->Majorants.GetKink(1) };
  double kink = 0.0;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    if (this->Request.Classes[i] == PlainArea && kinks[0] + kinks[1] > 0.0)
    {
      kink = (kinks[0] + kinks[1]) * this->Supremum[i];
      noise += kink;
    }
    if (this->Request.Classes[i] == PlainArea && panel.Shape == PanelShape::Prismatic &&
      !this->Majorants.HasLength())
    {
      noise += GetPrismaticDeviation(patch.Degree[1]) * this->Supremum[i];
    }
  }
  int along = 1;
  int across = 1;
  const bool found = this->FindOrders(share, true, along, across);
  if (found && this->IsSmall(kink, share))
  {
    this->Keep(index, part, along, across, false, noise);
    return;
  }
  const std::size_t most = this->FindOrders(share, false, along, across) ? MostParts : MostPartsOfMoments;
  if (part.Depth < LargestDepth && this->Pending.size() + this->Parts < most)
  {
    const bool inXi = found ? kinks[0] >= kinks[1] : this->ChooseDirection(part, share) == 1;
    Part halves[2] = { part, part };
    (inXi ? halves[0].XiEnd : halves[0].End) = (inXi ? halves[1].XiStart : halves[1].Start) =
      inXi ? 0.5 * (part.XiStart + part.XiEnd) : 0.5 * (part.Start + part.End);
    for (Part& half : halves)
    {
      ++half.Depth;
      this->Pending.push_back(half);
    }
    return;
  }
  // Points for the moments; along a kink of the length few points on many parts do best.
  this->Keep(index, part, std::clamp(along, LeastCompared, MostCompared),
    std::clamp(across, LeastCompared, MostCompared), true, noise);
}

void PanelPlanner::Plan(std::uint32_t index)
{
  if (this->PlanExactly(index))
  {
    return;
  }
  this->Pending.assign(1, { 0.0, 1.0, 0.0, 1.0, 0 });
  this->Parts = 0;
  // The shallowest first, so that the limit of parts cuts off the deepest.
  for (std::size_t next = 0; next < this->Pending.size(); ++next)
  {
    const Part part = this->Pending[next];
    const std::size_t before = this->Pending.size();
    this->PlanPart(index, part);
    this->Parts += this->Pending.size() == before ? 1 : 0;
  }
}
}
