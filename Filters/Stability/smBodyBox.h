/**
 * @file smBodyBox.h
 * @brief Enclosures of the bounding boxes of bodies: of the trimmed surfaces themselves, not of their control
 * points
 */
#ifndef smBodyBox_h
#define smBodyBox_h

#include "smFiltersStabilityModule.h"

#include <array>
#include <vector>

class vtkDataObject;

namespace sm
{
/// xmin, xmax, ymin ... in world coordinates, and how far any of them may be from the true one; NaN if a face
/// cannot be cut.
struct BodyBox
{
  std::array<double, 6> Bounds;
  double Bound;
};

/// Returns the box of every body of the input, in the order of CollectBodies(). Each side is the minimum
/// height of the body's faces in its direction (smGroundContact.h); the bound includes the residuals of
/// fitted surfaces.
SMFILTERSSTABILITY_EXPORT std::vector<BodyBox> ComputeBodyBoxes(vtkDataObject* input);
}

#endif
