/**
 * @file smFaceResultCache.h
 * @brief Integrals of faces kept by face id and by what they were asked for, so that an edit costs what it changed
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
/// The result of a face depends on the face and on this, and on no other face; so what is kept has the bits of a full run.
struct FaceResultKey
{
  std::vector<double> Tolerances;
  /// Zero where results do not depend on it.
  std::array<double, 12> Placement{};
  /// Empty where nothing is planned.
  PlanRequest Request;

  bool operator==(const FaceResultKey& other) const
  {
    return this->Tolerances == other.Tolerances && this->Placement == other.Placement &&
      this->Request == other.Request;
  }
};

using FaceResultCache = FaceCache<FaceResultKey, std::shared_ptr<const FaceIntegrals>>;

/// Bytes of a result.
std::size_t CountBytes(const FaceIntegrals& result);
}

#endif
