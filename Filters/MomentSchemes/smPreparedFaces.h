/**
 * @file smPreparedFaces.h
 * @brief Faces prepared for the paper's schemes, kept from run to run
 */
#ifndef smPreparedFaces_h
#define smPreparedFaces_h

#include "smFiltersMomentSchemesModule.h"
#include "smProgressCallback.h"
#include "smSubPatches.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

namespace sm
{
struct SchemeTask
{
  FacePointer Source;
  /// A length, for planar faces; above 0.
  double ChordTolerance = 0.0;
};

using PreparedFace = std::shared_ptr<const SubPatchFace>;

/**
 * Prepares faces, and the sub-patches within a face, with vtkSMPTools, in portions of about a tenth of a second; between two
 * portions the calling thread asks whether to go on. Faces are kept by their id, while they are small, so that an edit prepares
 * only those that changed. Not thread safe.
 */
class SMFILTERSMOMENTSCHEMES_EXPORT PreparedFaces
{
public:
  /// A face per task; ChordTolerance of the options is not used. False when `ask` says so: then there are none.
  bool Prepare(
    const std::vector<SchemeTask>& tasks, const SchemeOptions& options, const ProgressCallback& progress);
  const std::vector<PreparedFace>& Get() const { return this->Faces; }
  /// Lets go of all that is not kept for the next run.
  void Release() { this->Faces.clear(); }

  /// Of the last Prepare(): sub-patches whose deviation was computed, and the most of them in one portion.
  std::int64_t GetDeviations() const { return this->Deviations; }
  std::int64_t GetLargestPortion() const { return this->LargestPortion; }

private:
  std::vector<std::size_t> FindMissing(const std::vector<SchemeTask>& tasks, const SchemeOptions& options);
  bool PrepareMissing(const std::vector<SchemeTask>& tasks, const std::vector<std::size_t>& missing,
    const SchemeOptions& options, const ProgressCallback& progress);
  void Keep(const std::vector<SchemeTask>& tasks);

  struct Kept
  {
    PreparedFace Face;
    double ChordTolerance;
  };
  std::unordered_map<std::uint64_t, Kept> Cache;
  SchemeOptions CachedOptions;
  std::vector<PreparedFace> Faces;
  std::int64_t Deviations = 0;
  std::int64_t LargestPortion = 0;
};
}

#endif
