/**
 * @file smFaceResultCache.h
 * @brief Integrals of faces, cached by face id and request, so that after an edit only the changed faces are
 * evaluated
 */
#ifndef smFaceResultCache_h
#define smFaceResultCache_h

#include "smFaceCache.h"
#include "smFaceIntegrals.h"
#include "smQuadraturePlan.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace sm
{
/// Cache key of the result of a face. The result depends only on the face and this key, and not on other
/// faces, so that a cached result is bitwise equal to that of a full run.
struct FaceResultKey
{
  std::vector<double> Tolerances;
  /// Placement; zero if results do not depend on it.
  std::array<double, 12> Placement{};
  PlacementError PlacementBound;
  /// Request of the plan; empty if nothing is planned.
  PlanRequest Request;

  bool operator==(const FaceResultKey& other) const
  {
    return this->Tolerances == other.Tolerances && this->Placement == other.Placement &&
      this->PlacementBound == other.PlacementBound && this->Request == other.Request;
  }
};

using FaceResultCache = FaceCache<FaceResultKey, std::shared_ptr<const FaceIntegrals>>;

/// Returns the number of bytes of a result.
std::size_t CountBytes(const FaceIntegrals& result);
}

#endif
