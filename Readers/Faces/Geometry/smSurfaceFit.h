/**
 * @file smSurfaceFit.h
 * @brief Fits a surface of which there is no exact rational form (offset surfaces)
 */
#ifndef smSurfaceFit_h
#define smSurfaceFit_h

#include "smNURBSSurface.h"
#include "smReadersFacesModule.h"
#include "smVector.h"

#include <functional>
#include <vector>

namespace sm
{
using SurfacePosition = std::function<Vector3(double, double)>;

/// Fits tensor Chebyshev series to a function that is smooth between the breaks of both directions, and sets
/// the residual. Throws std::runtime_error with a short reason if that fails.
SMREADERSFACES_EXPORT NURBSSurface FitSurface(
  const SurfacePosition& position, const std::vector<double>& u, const std::vector<double>& v);
}

#endif
