// Faces that are prismatic or flat to 1e-14 only, which the samples of their normals let pass: the rules that
// are exact for such faces err by no more than the plan's bound.
#include "smReferencePanels.h"
#include "smTesting.h"

#include <string>

namespace
{
using namespace smtest;
using Homogeneous = std::array<double, 4>;

sm::Face MakeFace(int q, const std::vector<Homogeneous>& points)
{
  sm::Face face;
  sm::NURBSSurface& surface = face.Surface;
  const int degrees[2] = { 1, q };
  for (int d = 0; d < 2; ++d)
  {
    surface.Degree[d] = degrees[d];
    surface.NumberOfControlPoints[d] = degrees[d] + 1;
    surface.Knots[d].assign(degrees[d] + 1, 0.0);
    surface.Knots[d].insert(surface.Knots[d].end(), degrees[d] + 1, 1.0);
  }
  surface.ControlPoints = points;
  return face;
}

/// Checks the plans for all moments up to each degree that the reference integrates.
void CheckFace(const std::string& name, const sm::Face& face, sm::PanelShape shape)
{
  const sm::FacePanels panels = sm::BuildFacePanels(face);
  CheckEqual(name + ", shape", static_cast<int>(shape), static_cast<int>(panels.Panels[0].Shape));
  const ReferencePanels reference(panels);
  for (int highest = 0; highest <= 2; ++highest)
  {
    sm::PlanRequest request;
    request.Classes.assign(Classes.begin(), Classes.begin() + highest + 1);
    request.Tolerances.assign(request.Classes.size(), 1e-9);
    const sm::FacePlan plan = sm::PlanFace(face, panels, request);
    Values error{};
    for (const sm::PlannedItem& item : plan.Items)
    {
      const Values rule = reference.Integrate(item, item.Along, item.Across);
      const Values exact = reference.IntegrateFinely(item);
      for (int k = 0; k < Count; ++k)
      {
        error[k] += rule[k] - exact[k];
      }
    }
    for (int k = 0; k <= highest; ++k)
    {
      // 1e-17: rounding of the reference, whose values are about 10.
      Check(name + ", degrees to " + std::to_string(highest) + ", degree " + std::to_string(k), 0.0,
        static_cast<double>(error[k]), plan.QuadratureBound[k] + 1e-17);
      CheckRange("which is small", 0.0, plan.QuadratureBound[k], 1e-11);
    }
  }
}
}

int TestPanelShapes(int, char*[])
{
  const double off = 6e-15;
  CheckFace("prismatic",
    MakeFace(2,
      { { 0.0, 0.0, 0.5, 1.0 }, { 1.0, 1.0, 3.5, 1.0 }, { 1.0, 1.0, 0.5, 1.0 }, { 2.0, 2.0 + off, 3.5, 1.0 },
        { 2.0, 0.25, 0.5, 1.0 }, { 3.0, 1.25, 3.5, 1.0 } }),
    sm::PanelShape::Prismatic);
  CheckFace("flat",
    MakeFace(1,
      { { 0.0, 0.0, 0.5, 1.0 }, { 1.0, 1.0, 3.5, 1.0 }, { 2.0, 0.25, 0.5, 1.0 },
        { 3.0, 1.25 + off, 3.5, 1.0 } }),
    sm::PanelShape::Flat);
  return Finish();
}
