#include "smPatchPlans.h"

#include "Detail/smPanelPlanner.h"
#include "Detail/smPatchSeries.h"
#include "Detail/smRibbonPlanner.h"

#include <limits>

namespace sm
{
namespace
{
/// The factor makes up for the rounding of the terms of a bound. NaN, for example a difference of infinite
/// values, is not a bound.
double Raise(double bound)
{
  constexpr double growth = 1.0 + 1e-12;
  return bound >= 0.0 ? growth * bound : std::numeric_limits<double>::infinity();
}

FacePlan MakeEmptyPlan(std::size_t classes)
{
  FacePlan plan;
  plan.QuadratureBound.assign(classes, 0.0);
  plan.ConversionBound.assign(classes, 0.0);
  plan.Magnitude.assign(classes, 0.0);
  return plan;
}
}

std::vector<PatchPlan> PlanPatches(const FacePanels& panels, const PlanRequest& request)
{
  std::vector<std::vector<std::uint32_t>> members(panels.Patches.size());
  for (std::uint32_t i = 0; i < panels.Panels.size(); ++i)
  {
    members[panels.Panels[i].Patch].push_back(i);
  }
  FaceSeries series(panels, request);
  std::vector<PatchPlan> plans(panels.Patches.size());
  for (std::size_t k = 0; k < plans.size(); ++k)
  {
    if (members[k].empty())
    {
      plans[k].QuadratureBound.assign(request.Classes.size(), 0.0);
      continue;
    }
    PlanRequest shares = request;
    for (double& tolerance : shares.Tolerances)
    {
      tolerance /= static_cast<double>(members[k].size());
    }
    FacePlan plan = MakeEmptyPlan(request.Classes.size());
    PanelPlanner planner(panels, shares, series, plan);
    for (const std::uint32_t panel : members[k])
    {
      planner.Plan(panel);
    }
    plans[k].Items = std::move(plan.Items);
    plans[k].Reach = planner.GetReach();
    for (const double bound : plan.QuadratureBound)
    {
      plans[k].QuadratureBound.push_back(Raise(bound));
    }
  }
  return plans;
}

std::vector<StripBound> BoundStrips(
  const Face& face, const FacePanels& panels, const std::array<double, 3>& shift, double tolerance)
{
  PlanRequest request;
  request.Classes = { { BoundClass::VectorArea, 0 }, PlainArea };
  request.Tolerances = { tolerance, 0.0 };
  request.Shift = shift;
  std::vector<StripBound> bounds(panels.Ribbons.size());
  for (std::uint32_t i = 0; i < bounds.size(); ++i)
  {
    FacePlan plan = MakeEmptyPlan(request.Classes.size());
    RibbonPlanner(face, panels, request, plan).Plan(i);
    // The supremum bounds |X_l x X_t|; what its series lack is in the bound of the quadrature.
    bounds[i] = { Raise(plan.Magnitude[0] + plan.QuadratureBound[0]), Raise(plan.ConversionBound[1]) };
  }
  return bounds;
}
}
