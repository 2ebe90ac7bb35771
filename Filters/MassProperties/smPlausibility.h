/**
 * @file smPlausibility.h
 * @brief What no solid can have: checks of a result against facts that hold for every body
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
 * xmin, xmax, ymin … about the model's origin, of the control points of all surfaces and edge curves. Weights are
 * positive, so every point of a face or an edge inside its domain lies in it; the solid, and with it its centre of mass, lies
 * in the convex hull of its boundary. The box of the display mesh is smaller, but a face without triangles is
 * missing in it, and then the check would accuse a sound solid.
 */
SMFILTERSMASSPROPERTIES_EXPORT std::array<double, 6> GetHullBox(const vtkTrimmedNURBSModel& model);

/**
 * One sentence for each fact that the result violates by more than its bounds allow, none for a sane one:
 * - the volume is positive: above its bound, unless that is too coarse to tell;
 * - the centre of mass, `center` in the frame of the box, lies in the box, give or take `slack`, a length, and its bound;
 * - the inertia is positive definite: no principal moment is below 0 by more than its bound;
 * - no principal moment exceeds the sum of the two others by more than their three bounds.
 * What is NaN violates nothing: other findings say why it is not there.
 */
SMFILTERSMASSPROPERTIES_EXPORT std::vector<std::string> FindImplausibilities(const MassProperties& properties,
  const std::array<double, 3>& center, const std::array<double, 6>& box, double slack);
}

#endif
