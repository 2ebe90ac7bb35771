#include "smQuadraturePlan.h"

#include "smPanelPlanner.h"
#include "smRibbonPlanner.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr BoundClass PlainArea = { BoundClass::AreaMoment, 0 };

/// What a fitted surface may move: the solid by its residual over the area. The normals of a fit are not bounded by its
/// distance; Markov's inequality for the pieces' degree gives their size.
void ChargeSurface(const Face& face, const FacePanels& panels, const std::vector<BoundClass>& classes,
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
        plan.ConversionBound[i] += residual * area * power;
        break;
      case BoundClass::AreaMoment:
        plan.ConversionBound[i] += residual * steepest * area * power;
        plan.Estimated = true;
        break;
      default:
        // The boundary of the chain stays where it is.
        break;
    }
  }
}
}

FacePlan PlanFace(const Face& face, const FacePanels& panels, const PlanRequest& request)
{
  FacePlan plan;
  PlanRequest all = request;
  std::size_t areaClass = std::find(all.Classes.begin(), all.Classes.end(), PlainArea) - all.Classes.begin();
  if (areaClass == all.Classes.size())
  {
    all.Classes.push_back(PlainArea);
    all.Tolerances.push_back(0.0);
  }
  const std::size_t count = all.Classes.size();
  plan.QuadratureBound.assign(count, 0.0);
  plan.ConversionBound.assign(count, 0.0);
  plan.Magnitude.assign(count, 0.0);

  // Equal shares; ribbons have no area.
  const std::size_t strips = panels.Panels.size() + panels.Ribbons.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t items = all.Classes[i].Kind == BoundClass::AreaMoment ? panels.Panels.size() : strips;
    all.Tolerances[i] /= std::max<std::size_t>(items, 1);
  }
  PanelPlanner panelPlanner(panels, all, plan);
  for (std::uint32_t i = 0; i < panels.Panels.size(); ++i)
  {
    panelPlanner.Plan(i);
  }
  const double area = plan.Magnitude[areaClass];
  RibbonPlanner ribbonPlanner(face, panels, all, plan);
  for (std::uint32_t i = 0; i < panels.Ribbons.size(); ++i)
  {
    ribbonPlanner.Plan(i);
  }
  for (std::uint32_t i = 0; i < panels.Caps.size(); ++i)
  {
    PlannedItem cap{ ItemKind::Cap, i };
    cap.Along = cap.Across = request.StripPoints;
    plan.Items.push_back(cap);
  }
  ChargeSurface(face, panels, all.Classes, panelPlanner.GetReach(), area, plan);
  for (std::vector<double>* values : { &plan.QuadratureBound, &plan.ConversionBound, &plan.Magnitude })
  {
    values->resize(request.Classes.size());
  }
  return plan;
}
}
