/**
 * @file smResidentStore.h
 * @brief The pages of faces of one OpenGL context, which all its ResidentFaces share; not installed
 */
#ifndef smResidentStore_h
#define smResidentStore_h

#include "smComputeBuffer.h"
#include "smProgressCallback.h"
#include "smResidentFaces.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace sm
{
struct PageData;

/**
 * A page is a set of buffers that hold several faces, and it has a list of users. It is deleted when the list
 * becomes empty. Pages of the last request of a user are pinned: they are not deleted until that user ends
 * its run, requests other faces, or is removed.
 *
 * A shared store has its own compute context on the window, so that it does not depend on the lifetime of its
 * users' contexts.
 */
class ResidentStore
{
public:
  /// Identifies a user.
  using User = const ResidentFaces*;

  /// Returns the store that all users of the window of `context` share, or makes one for a single user.
  /// Returns null, with `error`, without OpenGL.
  static std::shared_ptr<ResidentStore> Open(vtkComputeContext* context, bool isShared, std::string& error);

  /// Returns true while the OpenGL context lasts in which the store was made.
  bool IsAlive() const { return this->Host->GetGeneration() == this->Generation; }

  /// See ResidentFaces::Acquire(). `uploads` is increased by the faces that were uploaded for it.
  bool Acquire(User user, const std::vector<CutFacePointer>& faces, std::vector<ResidentFace>& locations,
    const ProgressCallback& progress, std::size_t itemsPerPage, std::uint64_t& uploads);
  void Unpin(User user);
  void Leave(User user);
  bool Bind(int page, bool caps);

  std::size_t Budget = std::size_t{ 1 } << 30;
  /// Bytes of all pages.
  std::size_t Bytes = 0;
  std::unordered_map<std::uint64_t, ResidentFace> Faces;
  std::uint64_t Evictions = 0;
  std::string Error;

private:
  struct Page
  {
    ComputeBuffer Points;
    ComputeBuffer Patches;
    ComputeBuffer Coefficients;
    ComputeBuffer Caps;
    std::size_t Bytes = 0;
    std::vector<std::pair<std::uint64_t, std::weak_ptr<const Face>>> Faces;
    std::set<User> Users;
    std::set<User> Pins;
    std::uint64_t LastUse = 0;
  };
  using Pages = std::map<int, Page>;

  /// A request in progress: the user, and the data packed for the next page.
  struct Request
  {
    User Asker;
    std::size_t ItemsPerPage;
    std::vector<std::pair<std::uint64_t, ResidentFace>> Packed;
  };

  bool Fail(const std::string& what);
  bool FindMissing(User user, const std::vector<CutFacePointer>& faces, std::vector<CutFacePointer>& missing);
  void Use(User user, Page& page);
  Pages::iterator Drop(Pages::iterator page);
  void DropDead();
  void Evict();
  bool Upload(const PageData& data, Page& page);
  bool Flush(Request& request, PageData& data);
  bool UploadAll(
    Request& request, const std::vector<CutFacePointer>& faces, const ProgressCallback& progress);

  vtkSmartPointer<vtkComputeContext> Host;
  vtkTypeUInt64 Generation = 0;
  Pages AllPages;
  int NextPage = 0;
  std::uint64_t Clock = 0;
};
}

#endif
