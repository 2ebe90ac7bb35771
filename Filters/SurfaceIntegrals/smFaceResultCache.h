/**
 * @file smFaceResultCache.h
 * @brief Integrals of faces kept by face id and by what they were asked for, so that an edit costs what it changed
 */
#ifndef smFaceResultCache_h
#define smFaceResultCache_h

#include "smQuadraturePlan.h"
#include "smSurfaceIntegrator.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
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

/// Forgets what was not asked for in the last 8 runs. Not thread safe.
class FaceResultCache
{
public:
  /// Null when it is not known. The pointer is good until the next Store(), EndRun() or Forget().
  const FaceIntegrals* Find(std::uint64_t face, const FaceResultKey& question);
  void Store(std::uint64_t face, const FaceResultKey& question, const FaceIntegrals& result);
  void EndRun();
  void Forget();
  std::size_t GetNumberOfFaces() const { return this->Faces.size(); }

private:
  struct Entry
  {
    FaceResultKey Question;
    FaceIntegrals Result;
    std::uint64_t LastRun;
  };
  /// A face that stands in several places has an entry for each.
  std::unordered_map<std::uint64_t, std::vector<Entry>> Faces;
  std::uint64_t Run = 0;
};
}

#endif
