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
/// Position of a face on the GPU: its page, and the bases that are added to the indices in its FacePanels,
/// which are relative to the face.
struct ResidentFace
{
  int Page = -1;
  std::uint32_t FirstPatch = 0;
  std::uint32_t FirstCoefficient = 0;
  std::uint32_t FirstCap = 0;
  /// The face, to detect that an id is reused for another one. The page does not keep the face alive.
  std::weak_ptr<const Face> Source;
  /// The reason why the face is not on the GPU: it is too large for a storage block. Empty if it is there.
  std::string Error;
};

/**
 * Uploads control points, patches, polynomial coefficients and caps of cut faces, which the shaders read.
 * Faces are packed into pages, each a set of buffers within the driver's limit of a storage block. A face
 * that is resident is found again by its id and costs nothing. A page whose faces no longer exist, as after
 * an edit, is dropped by the next upload. When the bytes exceed the budget, the pages used longest ago are
 * dropped as a whole.
 *
 * All users of one OpenGL context share the pages: a face that two filters of a window integrate is stored
 * once. A page is dropped when its last user has released it. The faces of a user's last request stay until
 * its EndRun(), whatever others ask for.
 *
 * When the OpenGL context ends, all pages are lost, and the next Acquire() uploads again.
 * Storage and bindings: see glsl/smResident.glsl. All methods except Bind() and BindCaps() enter the context
 * themselves; progress is reported outside of it.
 */
class SMRENDERINGNURBS_EXPORT ResidentFaces
{
public:
  enum class Sharing
  {
    Context, ///< one set of pages for all users of the OpenGL context; a face is always cut in the same way
    None     ///< pages of this user alone, for faces that are cut for its purpose
  };

  /// The context must be READY when Acquire() is called.
  explicit ResidentFaces(vtkComputeContext* context, Sharing sharing = Sharing::Context);
  ~ResidentFaces();
  ResidentFaces(const ResidentFaces&) = delete;
  ResidentFaces& operator=(const ResidentFaces&) = delete;

  /// Bytes of GPU memory that the pages may take together, of all users that share them; default 1 GiB. One
  /// request may exceed it.
  void SetBudget(std::size_t bytes);

  /// Work items (panels, ribbons, caps) of one page at most; default 262144. A larger face has a page of its
  /// own.
  void SetMaximumItemsPerPage(std::size_t items);

  /// Makes `faces` resident; `locations` gets one entry per face. `progress` (may be empty) gets a fraction
  /// and returns false to stop. Returns false, with GetError(), if stopped or if GPU memory is insufficient.
  bool Acquire(const std::vector<CutFacePointer>& faces, std::vector<ResidentFace>& locations,
    const std::function<bool(double)>& progress);

  /// Ends the use of the locations of the last Acquire(): their pages may be dropped from now on.
  void EndRun();

  /// Releases all faces: pages without another user are freed. The next Acquire() uploads again.
  void Release();

  /// Binds a page's buffers to storage bindings 0 (control points), 1 (patches), 2 (coefficients).
  bool Bind(int page);
  /// Binds a page's caps to storage binding 2.
  bool BindCaps(int page);

  ///@{
  /// Counters: faces and bytes resident now, and pages dropped, of all users that share them; faces uploaded
  /// by this one.
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

/// Texts of the chunks smBernstein, smDisplayPoint, smPatch, smPatchRecord, smPatchSecond and smResident, by
/// name; null for another name.
SMRENDERINGNURBS_EXPORT const char* GetNURBSShaderChunk(const std::string& name);
}

#endif
