#include "smResidentFaces.h"

#include "smComputeBuffer.h"
#include "smContextScope.h"

#include "smBernstein.h"
#include "smDisplayPoint.h"
#include "smPatch.h"
#include "smPatchRecord.h"
#include "smPatchSecond.h"
#include "smPortable.h"
#include "smResident.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace sm
{
namespace
{
// As smPatchRecord in glsl/smPatchRecord.glsl, std430.
struct PatchRecord
{
  double CenterRadius[4];
  double Domain[4];
  std::uint32_t Shape[4];
  double Stretch[2];
};
static_assert(sizeof(PatchRecord) == 96, "layout of smPatchRecord");

// Faces packed between two reports of progress.
constexpr std::size_t FacesPerReport = 256;

/// What a page holds while it is being packed.
struct PageData
{
  std::vector<std::array<double, 4>> Points;
  std::vector<PatchRecord> Patches;
  std::vector<double> Coefficients;
  std::vector<double> Caps;
  std::size_t Items = 0;

  std::size_t GetLargestBlock() const
  {
    return std::max(
      { this->Points.size() * sizeof(this->Points[0]), this->Patches.size() * sizeof(PatchRecord),
        this->Coefficients.size() * sizeof(double), this->Caps.size() * sizeof(double) });
  }
};

std::size_t GetLargestBlock(const FacePanels& panels)
{
  return std::max(
    { panels.Points.size() * sizeof(panels.Points[0]), panels.Patches.size() * sizeof(PatchRecord),
      panels.Coefficients.size() * sizeof(double), panels.Caps.size() * 9 * sizeof(double) });
}

struct Page
{
  ComputeBuffer Points;
  ComputeBuffer Patches;
  ComputeBuffer Coefficients;
  ComputeBuffer Caps;
  std::vector<std::uint64_t> Faces;
  std::uint64_t LastUse = 0;

  std::size_t GetBytes() const
  {
    return this->Points.GetSize() + this->Patches.GetSize() + this->Coefficients.GetSize() +
      this->Caps.GetSize();
  }
};

void Append(const FacePanels& panels, PageData& page, ResidentFace& location)
{
  const auto firstPoint = static_cast<std::uint32_t>(page.Points.size());
  location.FirstPatch = static_cast<std::uint32_t>(page.Patches.size());
  location.FirstCoefficient = static_cast<std::uint32_t>(page.Coefficients.size());
  location.FirstCap = static_cast<std::uint32_t>(page.Caps.size() / 9);
  page.Points.insert(page.Points.end(), panels.Points.begin(), panels.Points.end());
  page.Coefficients.insert(page.Coefficients.end(), panels.Coefficients.begin(), panels.Coefficients.end());
  for (const Patch& patch : panels.Patches)
  {
    page.Patches.push_back({ { patch.Center[0], patch.Center[1], patch.Center[2], patch.Radius },
      { patch.Start[0], patch.Start[1], patch.Width[0], patch.Width[1] },
      { firstPoint + patch.FirstPoint, static_cast<std::uint32_t>(patch.Degree[0]),
        static_cast<std::uint32_t>(patch.Degree[1]), patch.Exchanged ? 1u : 0u },
      { patch.Stretch[0], patch.Stretch[1] } });
  }
  for (const Cap& cap : panels.Caps)
  {
    for (const std::array<double, 3>* point : { &cap.Apex, &cap.From, &cap.To })
    {
      page.Caps.insert(page.Caps.end(), point->begin(), point->end());
    }
  }
}
}

struct ResidentFaces::Internals
{
  vtkSmartPointer<vtkComputeContext> Context;
  vtkTypeUInt64 Generation = 0;
  std::size_t Budget = std::size_t{ 1 } << 30;
  std::size_t MaximumItems = 262144;
  std::map<int, Page> Pages;
  int NextPage = 0;
  /// Of all pages.
  std::size_t Bytes = 0;
  std::unordered_map<std::uint64_t, ResidentFace> Faces;
  std::uint64_t Clock = 0;
  std::uint64_t Uploads = 0;
  std::uint64_t Evictions = 0;
  std::string Error;

  void ForgetLostContext()
  {
    if (this->Context->GetGeneration() != this->Generation)
    {
      this->Pages.clear();
      this->Faces.clear();
      this->Bytes = 0;
      this->Generation = this->Context->GetGeneration();
    }
  }

  std::size_t GetBytes() const
  {
    std::size_t bytes = 0;
    for (const auto& [id, page] : this->Pages)
    {
      bytes += page.GetBytes();
    }
    return bytes;
  }

  /// Returns the page behind the dropped one.
  std::map<int, Page>::iterator Drop(std::map<int, Page>::iterator page)
  {
    for (const std::uint64_t id : page->second.Faces)
    {
      this->Faces.erase(id);
    }
    this->Bytes -= page->second.GetBytes();
    ++this->Evictions;
    return this->Pages.erase(page);
  }

  /// Drops the pages of which no face exists any more. An edit's faces have pages of their own, so that the next edit frees them.
  void DropDead()
  {
    const auto isDead = [this](std::uint64_t id) { return this->Faces.at(id).Source.expired(); };
    for (auto page = this->Pages.begin(); page != this->Pages.end();)
    {
      const std::vector<std::uint64_t>& faces = page->second.Faces;
      page = std::all_of(faces.begin(), faces.end(), isDead) ? this->Drop(page) : std::next(page);
    }
  }

  /// Drops the pages used longest ago until the budget holds, but none used at `now`.
  void Evict(std::uint64_t now)
  {
    while (this->Bytes > this->Budget)
    {
      const auto oldest = std::min_element(this->Pages.begin(), this->Pages.end(),
        [](const auto& a, const auto& b) { return a.second.LastUse < b.second.LastUse; });
      if (oldest == this->Pages.end() || oldest->second.LastUse == now)
      {
        return;
      }
      this->Drop(oldest);
    }
  }

  bool Upload(const PageData& data, Page& page)
  {
    const ContextScope scope(this->Context);
    if (!scope)
    {
      this->Error = this->Context->GetReason();
      return false;
    }
    page.Points = ComputeBuffer(this->Context);
    page.Patches = ComputeBuffer(this->Context);
    page.Coefficients = ComputeBuffer(this->Context);
    page.Caps = ComputeBuffer(this->Context);
    for (const auto& [ok, buffer] : { std::make_pair(page.Points.Upload(data.Points), &page.Points),
           std::make_pair(page.Patches.Upload(data.Patches), &page.Patches),
           std::make_pair(page.Coefficients.Upload(data.Coefficients), &page.Coefficients),
           std::make_pair(page.Caps.Upload(data.Caps), &page.Caps) })
    {
      if (!ok)
      {
        this->Error = "The faces do not fit on the GPU: " + buffer->GetError();
        return false;
      }
    }
    return true;
  }

  /// Uploads what was packed as a page of its own.
  bool Flush(std::uint64_t now, PageData& data, std::vector<std::pair<std::uint64_t, ResidentFace>>& packed)
  {
    if (packed.empty())
    {
      return true;
    }
    Page page;
    page.LastUse = now;
    if (!this->Upload(data, page))
    {
      return false;
    }
    for (auto& [id, location] : packed)
    {
      location.Page = this->NextPage;
      page.Faces.push_back(id);
      this->Faces[id] = std::move(location);
    }
    this->Uploads += packed.size();
    this->Bytes += page.GetBytes();
    this->Pages.emplace(this->NextPage++, std::move(page));
    packed.clear();
    data = PageData();
    return true;
  }

  bool UploadAll(
    const std::vector<CutFacePointer>& faces, std::uint64_t now, const std::function<bool(double)>& progress)
  {
    const auto blockLimit = static_cast<std::size_t>(this->Context->GetMaximumStorageBlockSize());
    PageData data;
    std::vector<std::pair<std::uint64_t, ResidentFace>> packed;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      if (i % FacesPerReport == 0 && progress && !progress(static_cast<double>(i) / faces.size()))
      {
        this->Error = "aborted";
        return false;
      }
      const CutFace& face = *faces[i];
      ResidentFace location;
      location.Source = face.Source;
      const std::size_t size = GetLargestBlock(face.Panels);
      if (size > blockLimit)
      {
        location.Error = "face #" + std::to_string(face.Source->FileId) + " has " +
          std::to_string(size >> 20) + " MiB of geometry, more than a storage block of this GPU may have";
      }
      else
      {
        if (data.GetLargestBlock() + size > blockLimit && !this->Flush(now, data, packed))
        {
          return false;
        }
        Append(face.Panels, data, location);
        data.Items += face.GetNumberOfItems();
      }
      packed.emplace_back(face.Source->Id, std::move(location));
      if (data.Items >= this->MaximumItems && !this->Flush(now, data, packed))
      {
        return false;
      }
    }
    return this->Flush(now, data, packed);
  }
};

ResidentFaces::ResidentFaces(vtkComputeContext* context)
  : Implementation(new Internals)
{
  this->Implementation->Context = context;
}

ResidentFaces::~ResidentFaces() = default;

void ResidentFaces::SetBudget(std::size_t bytes)
{
  this->Implementation->Budget = bytes;
}

void ResidentFaces::SetMaximumItemsPerPage(std::size_t items)
{
  this->Implementation->MaximumItems = std::max<std::size_t>(items, 1);
}

bool ResidentFaces::Acquire(const std::vector<CutFacePointer>& faces, std::vector<ResidentFace>& locations,
  const std::function<bool(double)>& progress)
{
  Internals& self = *this->Implementation;
  self.ForgetLostContext();
  const std::uint64_t now = ++self.Clock;

  // Faces to upload, each once, in the order of the request.
  std::vector<CutFacePointer> missing;
  std::unordered_map<std::uint64_t, FacePointer> asked;
  for (const CutFacePointer& face : faces)
  {
    const std::uint64_t id = face->Source->Id;
    const auto [first, isNew] = asked.emplace(id, face->Source);
    const auto found = self.Faces.find(id);
    const bool isResident = found != self.Faces.end();
    if (first->second != face->Source || (isResident && found->second.Source.lock() != face->Source))
    {
      self.Error = "two different faces have the id " + std::to_string(id) +
        "; give every new face an id of its own, sm::NewId()";
      return false;
    }
    if (isResident)
    {
      self.Pages.at(found->second.Page).LastUse = now;
    }
    else if (isNew)
    {
      missing.push_back(face);
    }
  }
  if (!missing.empty())
  {
    self.DropDead();
  }
  if (!self.UploadAll(missing, now, progress))
  {
    return false;
  }
  locations.clear();
  locations.reserve(faces.size());
  for (const CutFacePointer& face : faces)
  {
    locations.push_back(self.Faces.at(face->Source->Id));
  }
  self.Evict(now);
  return true;
}

bool ResidentFaces::Bind(int page)
{
  Page& bound = this->Implementation->Pages.at(page);
  return bound.Points.Bind(0) && bound.Patches.Bind(1) && bound.Coefficients.Bind(2);
}

bool ResidentFaces::BindCaps(int page)
{
  return this->Implementation->Pages.at(page).Caps.Bind(2);
}

std::size_t ResidentFaces::GetNumberOfFaces() const
{
  return this->Implementation->Faces.size();
}

std::size_t ResidentFaces::GetBytes() const
{
  return this->Implementation->GetBytes();
}

std::uint64_t ResidentFaces::GetNumberOfUploads() const
{
  return this->Implementation->Uploads;
}

std::uint64_t ResidentFaces::GetNumberOfEvictions() const
{
  return this->Implementation->Evictions;
}

const std::string& ResidentFaces::GetError() const
{
  return this->Implementation->Error;
}

const char* GetNURBSShaderChunk(const std::string& name)
{
  static const std::map<std::string, const char*> chunks = { { "smPortable", smPortable },
    { "smBernstein", smBernstein }, { "smDisplayPoint", smDisplayPoint }, { "smPatch", smPatch },
    { "smPatchRecord", smPatchRecord }, { "smPatchSecond", smPatchSecond }, { "smResident", smResident } };
  const auto found = chunks.find(name);
  return found == chunks.end() ? nullptr : found->second;
}
}
