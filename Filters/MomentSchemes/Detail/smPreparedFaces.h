/**
 * @file smPreparedFaces.h
 * @brief Faces prepared for the paper's schemes, kept from run to run
 */
#ifndef smPreparedFaces_h
#define smPreparedFaces_h

#include "smFaceCache.h"
#include "smFiltersMomentSchemesModule.h"
#include "smProgressCallback.h"
#include "smSubPatches.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace sm
{
/// A face to prepare.
struct SchemeTask
{
  FacePointer Source;
  /// Largest distance between the trim curves of a planar face and their chords, a length above 0.
  double ChordTolerance = 0.0;
};

using PreparedFace = std::shared_ptr<const SubPatchFace>;

/**
 * Prepares faces, and the sub-patches within a face, with vtkSMPTools, in portions of about a tenth of a
 * second; between two portions the calling thread calls the progress callback, which may stop it. Prepared
 * faces of the last run are cached by their id, within the budget, so that after an edit only the changed
 * faces are prepared. Not thread safe.
 */
class SMFILTERSMOMENTSCHEMES_EXPORT PreparedFaces
{
public:
  explicit PreparedFaces(CacheBudget& budget = CacheBudget::GetProcessBudget())
    : Kept(budget, 1)
  {
  }

  /// Prepares a face per task, with the task's ChordTolerance instead of that of the options. Returns false
  /// if `progress` stopped it; then there are no faces.
  bool Prepare(
    const std::vector<SchemeTask>& tasks, const SchemeOptions& options, const ProgressCallback& progress);
  const std::vector<PreparedFace>& Get() const { return this->Faces; }
  /// Releases all faces that are not cached for the next run.
  void Release() { this->Faces.clear(); }

  /// Numbers of the last Prepare(): sub-patches whose deviation was computed, and the largest number of them
  /// in one portion.
  std::int64_t GetDeviations() const { return this->Deviations; }
  std::int64_t GetMaxPortion() const { return this->MaxPortion; }

private:
  std::vector<std::size_t> FindMissing(const std::vector<SchemeTask>& tasks, const SchemeOptions& options);
  bool PrepareMissing(const std::vector<SchemeTask>& tasks, const std::vector<std::size_t>& missing,
    const SchemeOptions& options, const ProgressCallback& progress);

  /// The options on which a prepared face depends, with the task's ChordTolerance.
  struct Key
  {
    SchemeOptions Options;
    bool operator==(const Key& other) const;
  };
  static Key GetKey(const SchemeTask& task, const SchemeOptions& options);

  FaceCache<Key, PreparedFace> Kept;
  std::vector<PreparedFace> Faces;
  std::int64_t Deviations = 0;
  std::int64_t MaxPortion = 0;
};
}

#endif
