/**
 * @file smBodyScales.h
 * @brief Boxes of bodies, the scales of their tolerances, and their common unit
 */
#ifndef smBodyScales_h
#define smBodyScales_h

#include "smFiltersSurfaceIntegralsModule.h"

#include <array>
#include <vector>

class vtkBoundingBox;
class vtkTrimmedNURBSModel;

namespace sm
{
struct BodyIntegrals;

/// Returns true if all bodies have the same length unit, without which values have no total.
SMFILTERSSURFACEINTEGRALS_EXPORT bool HaveOneUnit(const std::vector<BodyIntegrals>& bodies);
constexpr const char* MixedUnitsMessage =
  "the parts have different length units: there is no total; read all files in one output unit";
/// Returns xmin, xmax, ymin … about the model's origin; computed from the control points if the model has no
/// box.
SMFILTERSSURFACEINTEGRALS_EXPORT std::array<double, 6> GetBox(vtkTrimmedNURBSModel& model);
/// Adds the eight corners of a body's box, in the body's placement, to `box`.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddPlacedBox(const BodyIntegrals& body, vtkBoundingBox& box);
/// Returns half the diagonal of the model's box.
SMFILTERSSURFACEINTEGRALS_EXPORT double GetRadius(vtkTrimmedNURBSModel& model);
/// Returns the approximate largest distance of a placed body from the world origin.
SMFILTERSSURFACEINTEGRALS_EXPORT double GetReach(const BodyIntegrals& body);
/// Return the scales of relative tolerances; computed from the bounding box if the reader sets none.
SMFILTERSSURFACEINTEGRALS_EXPORT double GetVolumeScale(vtkTrimmedNURBSModel& model);
SMFILTERSSURFACEINTEGRALS_EXPORT double GetAreaScale(vtkTrimmedNURBSModel& model);
}

#endif
