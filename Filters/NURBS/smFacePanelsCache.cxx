#include "smFacePanelsCache.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <unordered_map>

namespace sm
{
namespace
{
// Faces cut between two reports of progress.
constexpr std::size_t CutsPerReport = 256;
constexpr vtkIdType CutsPerTask = 8;

template <typename Type>
std::size_t GetBytesOf(const std::vector<Type>& values)
{
  return values.capacity() * sizeof(Type);
}

std::size_t GetBytesOf(const FacePanels& panels)
{
  return sizeof(CutFace) + GetBytesOf(panels.Patches) + GetBytesOf(panels.Points) +
    GetBytesOf(panels.Coefficients) + GetBytesOf(panels.Panels) + GetBytesOf(panels.Ribbons) +
    GetBytesOf(panels.Caps);
}

CutFacePointer Cut(const FacePointer& face)
{
  auto cut = std::make_shared<CutFace>();
  cut->Source = face;
  // As BuildFacePanels: the inner direction is the one of lower degree.
  const bool turned = face->Surface.Degree[0] > face->Surface.Degree[1];
  cut->Degree[0] = face->Surface.Degree[turned ? 1 : 0];
  cut->Degree[1] = face->Surface.Degree[turned ? 0 : 1];
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

struct FacePanelsCache::Internals
{
  struct Entry
  {
    CutFacePointer Face;
    std::size_t Bytes = 0;
    std::uint64_t LastUse = 0;
  };

  std::unordered_map<std::uint64_t, Entry> Faces;
  std::size_t Budget = std::size_t{ 1 } << 30;
  std::size_t Bytes = 0;
  std::uint64_t Clock = 0;
  std::uint64_t Cuts = 0;
  std::uint64_t Evictions = 0;
  std::string Error;

  bool Fail(const std::string& what)
  {
    this->Error = what;
    return false;
  }

  void Keep(const CutFacePointer& face)
  {
    const std::size_t bytes = GetBytesOf(face->Panels);
    this->Faces[face->Source->Id] = { face, bytes, this->Clock };
    this->Bytes += bytes;
  }

  /// What only the cache holds: no model has the face, and nobody what it was cut into.
  void ForgetDead()
  {
    for (auto entry = this->Faces.begin(); entry != this->Faces.end();)
    {
      const CutFacePointer& face = entry->second.Face;
      if (face.use_count() > 1 || face->Source.use_count() > 1)
      {
        ++entry;
        continue;
      }
      this->Bytes -= entry->second.Bytes;
      entry = this->Faces.erase(entry);
      ++this->Evictions;
    }
  }

  /// The oldest first; of one age, the lower id first.
  void Evict()
  {
    if (this->Bytes <= this->Budget)
    {
      return;
    }
    std::vector<std::pair<std::uint64_t, std::uint64_t>> ages;
    for (const auto& [id, entry] : this->Faces)
    {
      ages.emplace_back(entry.LastUse, id);
    }
    std::sort(ages.begin(), ages.end());
    for (auto oldest = ages.begin(); this->Bytes > this->Budget && oldest != ages.end(); ++oldest)
    {
      const auto entry = this->Faces.find(oldest->second);
      this->Bytes -= entry->second.Bytes;
      this->Faces.erase(entry);
      ++this->Evictions;
    }
  }

  /// The faces that must be cut, each once, in the order of the request.
  bool FindMissing(const std::vector<FacePointer>& faces, std::vector<FacePointer>& missing)
  {
    std::unordered_map<std::uint64_t, FacePointer> asked;
    for (const FacePointer& face : faces)
    {
      const auto [first, isNew] = asked.emplace(face->Id, face);
      const auto found = this->Faces.find(face->Id);
      const bool isKept = found != this->Faces.end();
      if (first->second != face || (isKept && found->second.Face->Source != face))
      {
        return this->Fail("two different faces have the id " + std::to_string(face->Id) +
          "; give every new face an id of its own, sm::NewId()");
      }
      if (isKept)
      {
        found->second.LastUse = this->Clock;
      }
      else if (isNew)
      {
        missing.push_back(face);
      }
    }
    return true;
  }
};

FacePanelsCache::FacePanelsCache()
  : Implementation(new Internals)
{
}

FacePanelsCache::~FacePanelsCache() = default;

void FacePanelsCache::SetBudget(std::size_t bytes)
{
  this->Implementation->Budget = bytes;
}

bool FacePanelsCache::Acquire(
  const std::vector<FacePointer>& faces, std::vector<CutFacePointer>& cut, const ProgressCallback& progress)
{
  Internals& self = *this->Implementation;
  self.Error.clear();
  ++self.Clock;
  cut.clear();
  std::vector<FacePointer> missing;
  if (!self.FindMissing(faces, missing))
  {
    return false;
  }
  if (!missing.empty())
  {
    self.ForgetDead();
  }
  for (std::size_t begin = 0; begin < missing.size(); begin += CutsPerReport)
  {
    if (progress && !progress(static_cast<double>(begin) / missing.size()))
    {
      self.Evict();
      return self.Fail("aborted");
    }
    const std::size_t count = std::min(CutsPerReport, missing.size() - begin);
    std::vector<CutFacePointer> portion(count);
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), CutsPerTask,
      [&](vtkIdType from, vtkIdType to)
      {
        for (vtkIdType i = from; i < to; ++i)
        {
          portion[i] = Cut(missing[begin + i]);
        }
      });
    std::for_each(portion.begin(), portion.end(), [&self](const CutFacePointer& face) { self.Keep(face); });
    self.Cuts += count;
  }
  cut.reserve(faces.size());
  for (const FacePointer& face : faces)
  {
    cut.push_back(self.Faces.at(face->Id).Face);
  }
  self.Evict();
  return true;
}

void FacePanelsCache::Clear()
{
  this->Implementation->Faces.clear();
  this->Implementation->Bytes = 0;
}

std::size_t FacePanelsCache::GetNumberOfFaces() const
{
  return this->Implementation->Faces.size();
}

std::size_t FacePanelsCache::GetBytes() const
{
  return this->Implementation->Bytes;
}

std::uint64_t FacePanelsCache::GetNumberOfCuts() const
{
  return this->Implementation->Cuts;
}

std::uint64_t FacePanelsCache::GetNumberOfEvictions() const
{
  return this->Implementation->Evictions;
}

const std::string& FacePanelsCache::GetError() const
{
  return this->Implementation->Error;
}
}
