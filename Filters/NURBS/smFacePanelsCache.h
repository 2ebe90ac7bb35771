/**
 * @file smFacePanelsCache.h
 * @brief Faces cut into work items, kept by face id
 */
#ifndef smFacePanelsCache_h
#define smFacePanelsCache_h

#include "smFiltersNURBSModule.h"
#include "smProgressCallback.h"

#include "smFacePanels.h"

#include <cstddef>
#include <cstdint>
#include <functional>
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

/**
 * Cuts faces (BuildFacePanels) in parallel, by vtkSMPTools, and keeps them by their ids, so that a face is cut once. Faces that
 * nobody else has any more, as after an edit, are forgotten before others are cut. When the bytes exceed the budget, the faces
 * asked for longest ago are forgotten, those of the last request last; whoever holds a pointer keeps its face alive. What a face is cut into depends on the face alone: forgotten and cut again,
 * it is the same.
 *
 * Not thread safe: one thread at a time calls Acquire().
 */
class SMFILTERSNURBS_EXPORT FacePanelsCache
{
public:
  FacePanelsCache();
  ~FacePanelsCache();
  FacePanelsCache(const FacePanelsCache&) = delete;
  FacePanelsCache& operator=(const FacePanelsCache&) = delete;

  /// Bytes that cut faces may take together; default 1 GiB. One request may exceed it while it is used.
  void SetBudget(std::size_t bytes);

  /// `cut` gets one entry per face, never null. `progress` (may be empty) gets the fraction done, between cuts, and
  /// returns false to stop. False, with GetError() and an empty `cut`, when stopped or when two different faces have one id;
  /// what was cut until then is kept.
  bool Acquire(const std::vector<FacePointer>& faces, std::vector<CutFacePointer>& cut,
    const ProgressCallback& progress);

  ///@{
  /// Counters: faces and bytes kept now; faces cut and faces forgotten, for either reason, since construction.
  std::size_t GetNumberOfFaces() const;
  std::size_t GetBytes() const;
  std::uint64_t GetNumberOfCuts() const;
  std::uint64_t GetNumberOfEvictions() const;
  ///@}

  const std::string& GetError() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
