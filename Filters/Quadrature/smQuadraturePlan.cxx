#include "smQuadraturePlan.h"

#include "smHullBound.h"
#include "smPanelPlanner.h"
#include "smPatchSeries.h"
#include "smRibbonPlanner.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace sm
{
namespace
{
// The fewest panels, or ribbons, of a portion, and the maximum number of portions of either: enough to keep
// threads busy.
constexpr std::size_t MinOfPortion = 4;
constexpr std::size_t MaxPortions = 32;

// This factor makes up for the rounding of the terms that a bound is computed from.
constexpr double BoundGrowth = 1.0 + 1e-12;

/// Divides `count` items into portions of consecutive items.
struct Division
{
  std::size_t Size;
  std::size_t Count;

  explicit Division(std::size_t count)
    : Size(std::max(MinOfPortion, (count + MaxPortions - 1) / MaxPortions))
    , Count((count + Size - 1) / Size)
  {
  }
};

/// Adds the error of a fitted surface: it may move the solid by its residual over the area. The normals of a
/// fit are not bounded by its distance; Markov's inequality for the pieces' degree gives their size.
void AddFitError(const Face& face, const FacePanels& panels, const std::vector<BoundClass>& classes,
  double reach, double area, FacePlan& plan)
{
  const double residual = face.Surface.Residual;
  if (!(residual > 0.0))
  {
    return;
  }
  double steepest = 0.0;
  for (const Patch& patch : panels.Patches)
  {
    const int degree = std::max(patch.Degree[0], patch.Degree[1]);
    steepest = std::max(steepest, 4.0 * degree * degree / patch.Radius);
  }
  for (std::size_t i = 0; i < classes.size(); ++i)
  {
    const double power = std::pow(reach, classes[i].Degree);
    switch (classes[i].Kind)
    {
      case BoundClass::VolumeMoment:
      case BoundClass::HeightMoment:
        plan.ConversionBound[i] += residual * area * power;
        break;
      case BoundClass::AreaMoment:
        plan.ConversionBound[i] += residual * steepest * area * power;
        plan.Estimated = true;
        break;
      default:
        // The residual of a fitted surface does not move the boundary of the chain, so its vector area has no
        // such error.
        break;
    }
  }
}

/// Limits the effect of residuals of trim curves on areas. The face with its curves as they are and that with
/// exact ones both lie on the patches, and cover them once: their areas differ by no more than that of the
/// patches.
void LimitResidualError(const FacePanels& panels, const PlanRequest& request, FacePlan& plan)
{
  if (panels.CoverageDefects > 0 || panels.Outside.Distance > 0.0)
  {
    return;
  }
  std::vector<double> largest(request.Classes.size(), 0.0);
  for (std::uint32_t i = 0; i < panels.Patches.size(); ++i)
  {
    const HullBound hull = BoundPatchByHull(panels, i, request.Shift);
    for (std::size_t k = 0; k < largest.size(); ++k)
    {
      // Moments of degrees above 0 may have different signs.
      largest[k] += (request.Classes[k].Degree > 0 ? 2.0 : 1.0) * hull.GetMagnitude(request.Classes[k]);
    }
  }
  for (std::size_t k = 0; k < largest.size(); ++k)
  {
    if (request.Classes[k].Kind == BoundClass::AreaMoment)
    {
      plan.ConversionBound[k] = std::min(plan.ConversionBound[k], largest[k]);
    }
  }
}

/// Length of a control polygon: no shorter than the rational curve, whose weights are positive.
double GetPolygonLength(const std::array<double, 4>* points, int degree, int stride)
{
  double length = 0.0;
  for (int i = 0; i < degree; ++i)
  {
    const std::array<double, 4>& a = points[i * stride];
    const std::array<double, 4>& b = points[(i + 1) * stride];
    length += std::hypot(b[0] / b[3] - a[0] / a[3], b[1] / b[3] - a[1] / a[3], b[2] / b[3] - a[2] / a[3]);
  }
  return length;
}

double GetReach(const Patch& patch, const PlanRequest& request)
{
  return patch.Radius +
    std::hypot(patch.Center[0] + request.Shift[0], patch.Center[1] + request.Shift[1],
      patch.Center[2] + request.Shift[2]);
}

/**
 * Adds the error of rounding of the patches' control points, by d; a point of the patch is a convex sum of
 * theirs. The ribbons start from the same rounded patch, so the chain's moments change by the flux of d
 * through the area, `area` at most; but along interior knot lines each of two patches has moved by itself,
 * and a slit opens. The area changes with the tangents.
 */
void AddDisplacementError(const FacePanels& panels, const PlanRequest& request, double area, FacePlan& plan)
{
  for (const Patch& patch : panels.Patches)
  {
    const double* moved = patch.Displacement;
    const double d = std::hypot(moved[0], moved[1], moved[2]);
    // Each of the two is a bound by itself. fmin() passes over a NaN, which 0 times an infinite area is.
    const double swept = std::fmin(
      d * area, moved[0] * patch.Normal[0] + moved[1] * patch.Normal[1] + moved[2] * patch.Normal[2]);
    const double rotated = GetRotatedLength(patch);
    double border = 0.0;
    if (panels.Patches.size() > 1)
    {
      const std::array<double, 4>* points = panels.Points.data() + patch.FirstPoint;
      const int row = patch.Degree[0] + 1;
      border = GetPolygonLength(points, patch.Degree[0], 1) +
        GetPolygonLength(points + patch.Degree[1] * row, patch.Degree[0], 1) +
        GetPolygonLength(points, patch.Degree[1], row) +
        GetPolygonLength(points + patch.Degree[0], patch.Degree[1], row);
    }
    const double reach = GetReach(patch, request);
    for (std::size_t i = 0; i < request.Classes.size(); ++i)
    {
      const BoundClass& c = request.Classes[i];
      const double power = std::pow(reach, c.Degree);
      plan.ConversionBound[i] += c.Kind == BoundClass::VolumeMoment
        ? power * (swept + reach * d * border / (3 + c.Degree))
        : c.Kind == BoundClass::HeightMoment ? power * (swept + reach * d * border)
        : c.Kind == BoundClass::AreaMoment   ? d * power * rotated
                                             : d * border;
    }
  }
}

/// The face lies within its control points, or no farther beyond them than it leaves its patches.
double GetReach(const FacePanels& panels, const PlanRequest& request)
{
  double reach = 0.0;
  for (const Patch& patch : panels.Patches)
  {
    reach = std::max(reach, GetReach(patch, request));
  }
  return reach + panels.Outside.Distance;
}

/// Adds the bounds of integrals over a part of the closed chain that belongs to no face, so that it has no
/// area.
void AddChainMagnitude(
  const HullBound& part, const std::vector<BoundClass>& classes, std::vector<double>& bounds)
{
  for (std::size_t i = 0; i < classes.size(); ++i)
  {
    bounds[i] += classes[i].Kind == BoundClass::AreaMoment ? 0.0 : part.GetMagnitude(classes[i]);
  }
}

/// Adds a cap, and the bound of its integrals: |x| is largest at a corner.
void AddCap(const FacePanels& panels, const PlanRequest& request, std::uint32_t index, FacePlan& plan)
{
  PlannedItem item{ ItemKind::Cap, index };
  item.Along = item.Across = request.StripPoints;
  plan.Items.push_back(item);
  const Cap& cap = panels.Caps[index];
  double reach = 0.0;
  for (const Vector3& corner : { cap.Apex, cap.From, cap.To })
  {
    const Vector3 position{ corner[0] + request.Shift[0], corner[1] + request.Shift[1],
      corner[2] + request.Shift[2] };
    reach = std::max(reach, Norm(position));
  }
  const double area = 0.5 * Norm(Subtract(cap.From, cap.Apex)) * Norm(Subtract(cap.To, cap.Apex));
  AddChainMagnitude({ area, reach }, request.Classes, plan.Magnitude);
}

/**
 * Edges that do not meet leave a hole in the closed chain at their corner, whose border has as many sides as
 * faces meet there, n, and is closed by a surface of no more than its length squared over 4 pi, at most n /
 * (4 pi) times the sum of the squares of the sides. The factor 4 is for up to 50 faces.
 */
void AddOpenCorners(const FacePanels& panels, const PlanRequest& request, FacePlan& plan)
{
  const double area = 4.0 * panels.OpenCorners;
  const double reach = panels.VertexReach + Norm(request.Shift.data());
  if (area > 0.0)
  {
    AddChainMagnitude({ area, reach }, request.Classes, plan.ConversionBound);
  }
}

/// The request for one item: with a class for the area, and equal shares of the tolerances; ribbons have no
/// area.
PlanRequest MakeShares(const FacePanels& panels, const PlanRequest& request)
{
  PlanRequest all = request;
  if (std::find(all.Classes.begin(), all.Classes.end(), PlainArea) == all.Classes.end())
  {
    all.Classes.push_back(PlainArea);
    all.Tolerances.push_back(0.0);
  }
  const std::size_t strips = panels.Panels.size() + panels.Ribbons.size();
  for (std::size_t i = 0; i < all.Classes.size(); ++i)
  {
    const std::size_t items = all.Classes[i].Kind == BoundClass::AreaMoment ? panels.Panels.size() : strips;
    all.Tolerances[i] /= std::max<std::size_t>(items, 1);
  }
  return all;
}

FacePlan MakePlan(std::size_t classes)
{
  FacePlan plan;
  plan.QuadratureBound.assign(classes, 0.0);
  plan.ConversionBound.assign(classes, 0.0);
  plan.Magnitude.assign(classes, 0.0);
  return plan;
}

/// The rest of the areas' tolerances that the bounds leave, at least the share of one panel, is for the items
/// that are compared, in equal shares, since a line on which normals vanish needs the same of all its parts.
/// Half of it: each of the four parts of an item gets half of its share.
void ShareOut(const FacePanels& panels, const PlanRequest& request, FacePlan& plan)
{
  const auto compared = std::count_if(
    plan.Items.begin(), plan.Items.end(), [](const PlannedItem& item) { return item.Compared; });
  const auto count = static_cast<double>(std::max<std::size_t>(panels.Panels.size(), 1));
  double left = 1.0;
  for (std::size_t i = 0; i < request.Classes.size(); ++i)
  {
    const double tolerance = request.Tolerances[i];
    if (request.Classes[i].Kind == BoundClass::AreaMoment && tolerance > 0.0)
    {
      left = std::min(left, 1.0 - plan.QuadratureBound[i] / tolerance);
    }
  }
  for (PlannedItem& item : plan.Items)
  {
    item.Share = item.Compared ? 0.5 * std::max(left, 1.0 / count) / static_cast<double>(compared) : 1.0;
  }
}

/// Leaves out the panels if no moment of the face, whose tolerances are `shares` of one item, has a bound
/// that is less than its magnitude.
void LeaveOut(const PlanRequest& shares, FacePlan& plan)
{
  bool isUseless = plan.IsLimitedByHull;
  bool hasMoment = false;
  for (std::size_t i = 0; i < shares.Classes.size(); ++i)
  {
    const bool isMoment = shares.Classes[i].Kind != BoundClass::AreaMoment && shares.Tolerances[i] > 0.0;
    hasMoment = hasMoment || isMoment;
    isUseless = isUseless && !(isMoment && plan.QuadratureBound[i] <= plan.Magnitude[i]);
  }
  if (!isUseless || !hasMoment)
  {
    return;
  }
  plan.IsLeftOut = true;
  plan.Estimated = false;
  // One panel remains, because a face without items counts as 0.
  const auto isPanel = [](const PlannedItem& item) { return item.Kind == ItemKind::Panel; };
  const auto first = std::find_if(plan.Items.begin(), plan.Items.end(), isPanel);
  if (first != plan.Items.end())
  {
    first->Along = first->Across = 1;
    first->Compared = false;
    plan.Items.erase(std::remove_if(first + 1, plan.Items.end(), isPanel), plan.Items.end());
  }
  plan.QuadratureBound.assign(plan.QuadratureBound.size(), std::numeric_limits<double>::infinity());
  plan.Evaluations = 0;
  for (const PlannedItem& item : plan.Items)
  {
    plan.Evaluations +=
      static_cast<std::int64_t>(item.Along) * (item.Kind == ItemKind::Panel ? item.Across : 1);
  }
}

void Add(const std::vector<double>& values, std::vector<double>& sums)
{
  std::transform(values.begin(), values.end(), sums.begin(), sums.begin(), std::plus<>());
}
}

void FacePlan::LimitMagnitude(
  const std::vector<double>& before, const std::vector<BoundClass>& classes, const HullBound& hull)
{
  for (std::size_t i = 0; i < classes.size(); ++i)
  {
    const double largest = before[i] + hull.GetMagnitude(classes[i]);
    if (!(this->Magnitude[i] <= largest))
    {
      this->Magnitude[i] = largest;
      this->IsLimitedByHull = true;
    }
  }
}

FacePlanner::FacePlanner(const Face& face, const FacePanels& panels, const PlanRequest& request)
  : Source(face)
  , Panels(panels)
  , Request(request)
  , Shares(MakeShares(panels, request))
  , Series(std::make_unique<FaceSeries>(panels, this->Shares))
  , PanelPortionsLeft(Division(panels.Panels.size()).Count)
  , Portions(this->PanelPortionsLeft + Division(panels.Ribbons.size()).Count)
{
}

FacePlanner::~FacePlanner() = default;

void FacePlanner::PlanPortion(std::size_t portion)
{
  Portion& result = this->Portions[portion];
  result.Plan = MakePlan(this->Shares.Classes.size());
  const Division ofPanels(this->Panels.Panels.size());
  const Division ofRibbons(this->Panels.Ribbons.size());
  if (portion < ofPanels.Count)
  {
    PanelPlanner planner(this->Panels, this->Shares, *this->Series, result.Plan);
    const std::size_t end = std::min((portion + 1) * ofPanels.Size, this->Panels.Panels.size());
    for (std::size_t i = portion * ofPanels.Size; i < end; ++i)
    {
      planner.Plan(static_cast<std::uint32_t>(i));
    }
    result.Reach = planner.GetReach();
    if (--this->PanelPortionsLeft == 0)
    {
      this->Series.reset();
    }
    return;
  }
  portion -= ofPanels.Count;
  RibbonPlanner planner(this->Source, this->Panels, this->Shares, result.Plan);
  const std::size_t end = std::min((portion + 1) * ofRibbons.Size, this->Panels.Ribbons.size());
  for (std::size_t i = portion * ofRibbons.Size; i < end; ++i)
  {
    planner.Plan(static_cast<std::uint32_t>(i));
  }
}

FacePlan FacePlanner::Join() const
{
  const PlanRequest& all = this->Shares;
  const FacePanels& panels = this->Panels;
  const std::size_t areaClass =
    std::find(all.Classes.begin(), all.Classes.end(), PlainArea) - all.Classes.begin();
  FacePlan plan = MakePlan(all.Classes.size());
  double reach = 0.0;
  double area = 0.0;
  const std::size_t panelPortions = Division(panels.Panels.size()).Count;
  for (std::size_t i = 0; i < this->Portions.size(); ++i)
  {
    const FacePlan& part = this->Portions[i].Plan;
    plan.Items.insert(plan.Items.end(), part.Items.begin(), part.Items.end());
    plan.Evaluations += part.Evaluations;
    plan.Estimated = plan.Estimated || part.Estimated;
    plan.IsLimitedByHull = plan.IsLimitedByHull || part.IsLimitedByHull;
    Add(part.QuadratureBound, plan.QuadratureBound);
    Add(part.ConversionBound, plan.ConversionBound);
    Add(part.Magnitude, plan.Magnitude);
    reach = std::max(reach, this->Portions[i].Reach);
    area = i < panelPortions ? plan.Magnitude[areaClass] : area;
  }
  LeaveOut(all, plan);
  ShareOut(panels, this->Request, plan);
  for (std::uint32_t i = 0; i < panels.Caps.size(); ++i)
  {
    AddCap(panels, all, i, plan);
  }
  LimitResidualError(panels, all, plan);
  AddFitError(this->Source, panels, all.Classes, reach, area, plan);
  plan.ResidualBound = plan.ConversionBound;
  AddDisplacementError(panels, all, area, plan);
  AddOpenCorners(panels, all, plan);
  plan.Area = area;
  plan.Reading = ReadingError::Make(this->Source, panels, std::min(reach, GetReach(panels, this->Request)));
  for (std::vector<double>* values :
    { &plan.QuadratureBound, &plan.ConversionBound, &plan.ResidualBound, &plan.Magnitude })
  {
    values->resize(this->Request.Classes.size());
    // Bounds are computed with rounding to nearest. NaN, for example a difference of infinite values, is not
    // a bound.
    std::transform(values->begin(), values->end(), values->begin(),
      [](double bound)
      { return bound >= 0.0 ? BoundGrowth * bound : std::numeric_limits<double>::infinity(); });
  }
  return plan;
}

FacePlan PlanFace(const Face& face, const FacePanels& panels, const PlanRequest& request)
{
  FacePlanner planner(face, panels, request);
  for (std::size_t i = 0; i < planner.GetNumberOfPortions(); ++i)
  {
    planner.PlanPortion(i);
  }
  return planner.Join();
}
}
