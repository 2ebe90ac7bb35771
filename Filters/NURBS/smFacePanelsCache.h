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

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sm
{
/// A face and what it was cut into. Never changes once it is made.
struct CutFace
{
  FacePointer Source;
  /// Empty when Error is not.
  FacePanels Panels;
  /// Degrees of all patches of the face, in s and r.
  int Degree[2] = { 1, 1 };
  /// Not empty: the face could not be cut; it says why and names the face.
  std::string Error;

  /// Panels, ribbons and caps.
  std::size_t GetNumberOfItems() const
  {
    return this->Panels.Panels.size() + this->Panels.Ribbons.size() + this->Panels.Caps.size();
  }
};
using CutFacePointer = std::shared_ptr<const CutFace>;

/// Bytes of what a face was cut into.
SMFILTERSNURBS_EXPORT std::size_t CountBytes(const CutFace& face);

/**
 * Cuts faces (BuildFacePanels) in parallel, by vtkSMPTools, and keeps them by their ids, so that a face is cut once. Faces that
 * nobody has any more but caches of the process, as after an edit, are forgotten before others are cut. When the budget is spent, the faces asked for
 * longest ago are forgotten; whoever holds a pointer keeps its face alive. What a face is cut into depends on the face alone: forgotten
 * and cut again, it is the same.
 *
 * Not thread safe: one thread at a time calls Acquire().
 */
class SMFILTERSNURBS_EXPORT FacePanelsCache
{
public:
  explicit FacePanelsCache(CacheBudget& budget = CacheBudget::GetProcessBudget());
  ~FacePanelsCache();

  /// `cut` gets one entry per face, never null. `progress` (may be empty) gets the fraction done, between cuts, and
  /// returns false to stop. False, with GetError() and an empty `cut`, when stopped or when two different faces have one id;
  /// what was cut until then is kept. One request may exceed the budget while it is used.
  bool Acquire(const std::vector<FacePointer>& faces, std::vector<CutFacePointer>& cut,
    const ProgressCallback& progress);

  /// Forgets all faces.
  void Clear() { this->Faces.Clear(); }

  ///@{
  /// Counters: faces and bytes kept now; faces cut and faces forgotten, for either reason, since construction.
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
