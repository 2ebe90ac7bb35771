/**
 * @file smFacePanelsCache.h
 * @brief Faces cut into work items, kept by face id
 */
#ifndef smFacePanelsCache_h
#define smFacePanelsCache_h

#include "smFiltersNURBSModule.h"
#include "smProgressCallback.h"

#include "smFaceCache.h"
#include "smFacePanels.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sm
{
/// A bound that any thread may keep; negative before.
struct KeptBound
{
  KeptBound() = default;
  KeptBound(const KeptBound& other)
    : Value(other.Value.load())
  {
  }
  void operator=(const KeptBound& other) { this->Value = other.Value.load(); }
  std::atomic<double> Value{ -1.0 };
};

/// A face with the panels, ribbons and caps it was cut into. Immutable once it is made, except StripArea.
struct CutFace
{
  FacePointer Source;
  /// Empty when Error is not.
  FacePanels Panels;
  /// Degrees of all patches of the face, in s and r.
  int Degree[2] = { 1, 1 };
  /// The reason why the face could not be cut, with the name of the face; empty when it was cut.
  std::string Error;
  /// An upper bound of the area of ribbons and caps, kept by the first caller that computes the bound.
  mutable KeptBound StripArea;

  /// Panels, ribbons and caps.
  std::size_t GetNumberOfItems() const
  {
    return this->Panels.Panels.size() + this->Panels.Ribbons.size() + this->Panels.Caps.size();
  }
};
using CutFacePointer = std::shared_ptr<const CutFace>;

/// Bytes that a cut face takes in memory, without the face itself.
SMFILTERSNURBS_EXPORT std::size_t CountBytes(const CutFace& face);

/**
 * Cuts faces (BuildFacePanels) in parallel, by vtkSMPTools, and keeps them by their ids, so that a face is
 * cut once. Faces that only caches of the process still hold, as after an edit, are removed before others are
 * cut. When the budget is spent, the faces that were requested longest ago are removed; a pointer to a cut
 * face stays valid. Panels, ribbons and caps depend on the face alone: a face that was removed and is cut
 * again has the same ones, bit for bit.
 *
 * Not thread safe: one thread at a time calls Acquire().
 */
class SMFILTERSNURBS_EXPORT FacePanelsCache
{
public:
  explicit FacePanelsCache(CacheBudget& budget = CacheBudget::GetProcessBudget());
  ~FacePanelsCache();

  /// `cut` gets one entry per face, never null. `progress` (may be empty) gets the fraction done, between
  /// cuts, and returns false to stop. Returns false, with GetError() and an empty `cut`, when stopped or when
  /// two different faces have one id; faces cut until then stay in the cache. A single request may exceed the
  /// budget while Acquire() runs.
  bool Acquire(const std::vector<FacePointer>& faces, std::vector<CutFacePointer>& cut,
    const ProgressCallback& progress);

  /// Removes all faces.
  void Clear() { this->Faces.Clear(); }

  ///@{
  /// Counters: faces and bytes in the cache now; faces cut and faces removed, for either reason, since
  /// construction.
  std::size_t GetNumberOfFaces() const { return this->Faces.GetNumberOfFaces(); }
  std::size_t GetBytes() const { return this->Faces.GetBytes(); }
  std::uint64_t GetNumberOfCuts() const { return this->Cuts; }
  std::uint64_t GetNumberOfEvictions() const { return this->Cuts - this->Faces.GetNumberOfFaces(); }
  ///@}

  const std::string& GetError() const { return this->Error; }

private:
  bool Fail(const std::string& what);
  bool FindMissing(const std::vector<FacePointer>& faces, std::vector<FacePointer>& missing);

  /// An entry of a cache, for a face; it knows how many caches of the process keep it.
  class Kept;
  FaceCache<NoKey, std::shared_ptr<const Kept>> Faces;
  std::uint64_t Cuts = 0;
  std::string Error;
};
}

#endif
