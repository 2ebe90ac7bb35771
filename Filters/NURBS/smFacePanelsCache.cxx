#include "smFacePanelsCache.h"

#include "smParallelFor.h"

#include <algorithm>
#include <mutex>
#include <new>
#include <unordered_map>

namespace sm
{
namespace
{
// Faces cut between two reports of progress.
constexpr std::size_t CutsPerReport = 256;
constexpr std::size_t CutsPerTask = 8;

template <typename Type>
std::size_t GetBytesOf(const std::vector<Type>& values)
{
  return values.capacity() * sizeof(Type);
}

CutFacePointer Cut(const FacePointer& face)
{
  auto cut = std::make_shared<CutFace>();
  cut->Source = face;
  // As BuildFacePanels: the inner direction is the one of lower degree.
  const bool transposed = face->Surface.Degree[0] > face->Surface.Degree[1];
  cut->Degree[0] = face->Surface.Degree[transposed ? 1 : 0];
  cut->Degree[1] = face->Surface.Degree[transposed ? 0 : 1];
  try
  {
    cut->Panels = BuildFacePanels(*face);
  }
  catch (const std::bad_alloc&)
  {
    throw; // a fault of the machine, not of the face
  }
  catch (const std::exception& error)
  {
    cut->Error = error.what();
  }
  return cut;
}
}

std::size_t CountBytes(const CutFace& face)
{
  const FacePanels& panels = face.Panels;
  return sizeof(CutFace) + GetBytesOf(panels.Patches) + GetBytesOf(panels.Points) +
    GetBytesOf(panels.Coefficients) + GetBytesOf(panels.Panels) + GetBytesOf(panels.Ribbons) +
    GetBytesOf(panels.Caps);
}

/// Owns a cut face and, with it, a reference to the face itself. Every cache has an owner of its own. The
/// owners of each face are counted in the process: a face with no other references than theirs belongs to no
/// model any more.
class FacePanelsCache::Kept
{
public:
  explicit Kept(CutFacePointer cut)
    : Cut(std::move(cut))
  {
    Registry& registry = GetRegistry();
    const std::lock_guard<std::mutex> lock(registry.Mutex);
    ++registry.Owners[this->Cut->Source.get()];
  }
  ~Kept()
  {
    Registry& registry = GetRegistry();
    const std::lock_guard<std::mutex> lock(registry.Mutex);
    const auto owners = registry.Owners.find(this->Cut->Source.get());
    if (--owners->second == 0)
    {
      registry.Owners.erase(owners);
    }
  }
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;

  const CutFacePointer& Get() const { return this->Cut; }
  /// Returns true if only caches have the cut face and its source.
  bool IsDead() const
  {
    Registry& registry = GetRegistry();
    const std::lock_guard<std::mutex> lock(registry.Mutex);
    return this->Cut.use_count() == 1 &&
      this->Cut->Source.use_count() <= registry.Owners[this->Cut->Source.get()];
  }

private:
  struct Registry
  {
    std::mutex Mutex;
    std::unordered_map<const Face*, long> Owners;
  };
  static Registry& GetRegistry()
  {
    // Never destroyed: caches may outlive static objects.
    static auto* const registry = new Registry;
    return *registry;
  }

  CutFacePointer Cut;
};

FacePanelsCache::FacePanelsCache(CacheBudget& budget)
  // RunsKept has no effect with this value: only the budget, and IsDead(), remove faces.
  : Faces(budget, std::uint64_t{ 1 } << 62)
{
}

FacePanelsCache::~FacePanelsCache() = default;

bool FacePanelsCache::Fail(const std::string& what)
{
  this->Error = what;
  return false;
}

/// The faces that must be cut, each once, in the order of the request.
bool FacePanelsCache::FindMissing(const std::vector<FacePointer>& faces, std::vector<FacePointer>& missing)
{
  std::unordered_map<std::uint64_t, FacePointer> asked;
  for (const FacePointer& face : faces)
  {
    const auto [first, isNew] = asked.emplace(face->Id, face);
    const auto* kept = this->Faces.Find(face->Id, {});
    if (first->second != face || (kept && (*kept)->Get()->Source != face))
    {
      return this->Fail("two different faces have the id " + std::to_string(face->Id) +
        "; give every new face an id of its own, sm::NewId()");
    }
    if (!kept && isNew)
    {
      missing.push_back(face);
    }
  }
  return true;
}

bool FacePanelsCache::Acquire(
  const std::vector<FacePointer>& faces, std::vector<CutFacePointer>& cut, const ProgressCallback& progress)
{
  this->Error.clear();
  cut.clear();
  std::vector<FacePointer> missing;
  if (!this->FindMissing(faces, missing))
  {
    return false;
  }
  if (!missing.empty())
  {
    // Removes faces that no model holds any more and whose panels nobody uses.
    this->Faces.RemoveIf([](const std::shared_ptr<const Kept>& face) { return face->IsDead(); });
  }
  for (std::size_t begin = 0; begin < missing.size(); begin += CutsPerReport)
  {
    if (progress && !progress(static_cast<double>(begin) / missing.size()))
    {
      this->Faces.EndRun();
      return this->Fail("aborted");
    }
    const std::size_t count = std::min(CutsPerReport, missing.size() - begin);
    std::vector<CutFacePointer> portion(count);
    ParallelFor(count, CutsPerTask,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t i = from; i < to; ++i)
        {
          portion[i] = Cut(missing[begin + i]);
        }
      });
    for (const CutFacePointer& face : portion)
    {
      this->Faces.Store(face->Source->Id, {}, std::make_shared<const Kept>(face), CountBytes(*face));
    }
    this->Cuts += count;
  }
  cut.reserve(faces.size());
  for (const FacePointer& face : faces)
  {
    cut.push_back((*this->Faces.Find(face->Id, {}))->Get());
  }
  this->Faces.EndRun();
  return true;
}
}
