/**
 * @file smPatchPlans.h
 * @brief Gauss orders and error bounds of a face patch by patch, for integrals over the patches' own bases
 *
 * The derivative of a moment by a control point is an integral over the patches that the point moves. Its
 * error is the sum of theirs, so the bounds of a whole face (smQuadraturePlan.h) would be too large.
 */
#ifndef smPatchPlans_h
#define smPatchPlans_h

#include "smFacePanels.h"
#include "smFiltersQuadratureModule.h"
#include "smQuadraturePlan.h"

#include <vector>

namespace sm
{
/// The items of a patch's panels. An item that is Compared has no bound: it is to be evaluated once, with its
/// orders doubled.
struct PatchPlan
{
  std::vector<PlannedItem> Items;
  /// Bound of the quadrature error of all items together, per class of the request; infinite if unknown.
  std::vector<double> QuadratureBound;
  /// Largest distance of the panels from the point that moments are about.
  double Reach = 0.0;
};

/// Bounds of a ribbon, before a point is evaluated; infinite if unknown.
struct StripBound
{
  /// Area of the ribbon, parts that cover each other counted each.
  double Area = 0.0;
  /// Area of the face that residuals of trim and edge curves sweep.
  double Swept = 0.0;
};

/// Plans the panels of each patch of the face. Every panel gets an equal share of the tolerances of its
/// patch, which are those of the request. Thread safe.
SMFILTERSQUADRATURE_EXPORT std::vector<PatchPlan> PlanPatches(
  const FacePanels& panels, const PlanRequest& request);

/// Returns the bounds of each ribbon of the face, by `shift` of PlanRequest. A ribbon is halved until a rule
/// would integrate its area to `tolerance`, or 12 times: without an ellipse it has no bound. Thread safe.
SMFILTERSQUADRATURE_EXPORT std::vector<StripBound> BoundStrips(
  const Face& face, const FacePanels& panels, const std::array<double, 3>& shift, double tolerance);
}

#endif
