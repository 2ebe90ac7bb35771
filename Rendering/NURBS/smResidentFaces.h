/**
 * @file smResidentFaces.h
 * @brief Cut faces kept on the GPU by id, in pages
 */
#ifndef smResidentFaces_h
#define smResidentFaces_h

#include "smRenderingNURBSModule.h"

#include "smFacePanelsCache.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkComputeContext;

namespace sm
{
/// Where a face lies on the GPU. Indices in its FacePanels are relative to the face: add the bases.
struct ResidentFace
{
  int Page = -1;
  std::uint32_t FirstPatch = 0;
  std::uint32_t FirstCoefficient = 0;
  std::uint32_t FirstCap = 0;
  /// The face itself: an id stands for one face only. What is resident keeps no face alive.
  std::weak_ptr<const Face> Source;
  /// Not empty: the face is too large for a storage block of this GPU and nothing of it is there.
  std::string Error;
};

/**
 * Uploads what the shaders read of cut faces: control points, patches, polynomial coefficients and caps. Faces are
 * packed into pages, each a set of buffers within the driver's limit of a storage block. A face that is resident is found
 * again by its id and costs nothing. A page whose faces nobody has any more, as after an edit, is dropped by the next upload. When
 * the bytes exceed the budget, the pages used longest ago are dropped as a whole.
 *
 * When the GL context ends everything is forgotten and the next Acquire() starts anew.
 * Storage and bindings: see glsl/smResident.glsl. Methods enter the context by themselves, except Bind();
 * progress is reported outside of it.
 */
class SMRENDERINGNURBS_EXPORT ResidentFaces
{
public:
  explicit ResidentFaces(vtkComputeContext* context);
  ~ResidentFaces();
  ResidentFaces(const ResidentFaces&) = delete;
  ResidentFaces& operator=(const ResidentFaces&) = delete;

  /// Bytes of GPU memory that pages may take together; default 1 GiB. One request may exceed it.
  void SetBudget(std::size_t bytes);

  /// Work items (panels, ribbons, caps) of one page at most; default 262144. A larger face has a page of its own.
  void SetMaximumItemsPerPage(std::size_t items);

  /// Makes `faces` resident; `locations` gets one entry per face. `progress` (may be empty) gets a fraction
  /// and returns false to stop. False when stopped or out of GPU memory, with GetError().
  bool Acquire(const std::vector<CutFacePointer>& faces, std::vector<ResidentFace>& locations,
    const std::function<bool(double)>& progress);

  /// Binds a page's buffers to storage bindings 0 (control points), 1 (patches), 2 (coefficients).
  bool Bind(int page);
  /// Binds a page's caps to storage binding 2.
  bool BindCaps(int page);

  ///@{
  /// Counters: faces and bytes resident now, faces uploaded and pages dropped since construction.
  std::size_t GetNumberOfFaces() const;
  std::size_t GetBytes() const;
  std::uint64_t GetNumberOfUploads() const;
  std::uint64_t GetNumberOfEvictions() const;
  ///@}

  const std::string& GetError() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};

/// Texts of the chunks smPortable, smBernstein, smDisplayPoint, smPatch, smPatchRecord, smPatchSecond and smResident, by name; null
/// for another name.
SMRENDERINGNURBS_EXPORT const char* GetNURBSShaderChunk(const std::string& name);
}

#endif
