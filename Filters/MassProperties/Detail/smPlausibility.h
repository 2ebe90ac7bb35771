/**
 * @file smPlausibility.h
 * @brief Checks of a result against facts that hold for every solid
 */
#ifndef smPlausibility_h
#define smPlausibility_h

#include "smFiltersMassPropertiesModule.h"
#include "smMoments.h"

#include <array>
#include <string>
#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
/**
 * Returns xmin, xmax, ymin … about the model's origin of the control points of all surfaces and edge curves.
 * Weights are positive, so that this box contains every point of a face or an edge inside its domain. The
 * solid, and with it its centre of mass, lies in the convex hull of its boundary. The box of the display mesh
 * is not sufficient: a face without triangles is missing in it, so that the check could reject a correct
 * solid. If the vertices' box contains the point `inside`, that box is returned, which takes less time.
 */
SMFILTERSMASSPROPERTIES_EXPORT std::array<double, 6> GetHullBox(
  const vtkTrimmedNURBSModel& model, const std::array<double, 3>* inside = nullptr);

/**
 * Returns one sentence for each of these facts that the result violates by more than its bounds allow:
 * - the volume is positive: larger than its bound, unless the bound is too large for a decision;
 * - the centre of mass, `center` in the frame of the box, lies in the box, within the length `slack` and its
 * bound;
 * - the inertia is positive definite: no principal moment is below 0 by more than its bound;
 * - no principal moment exceeds the sum of the two others by more than their three bounds.
 * NaN violates none of them, as the reason for NaN is reported elsewhere.
 */
SMFILTERSMASSPROPERTIES_EXPORT std::vector<std::string> FindImplausibilities(const MassProperties& properties,
  const std::array<double, 3>& center, const std::array<double, 6>& box, double slack);
}

#endif
