#include "Detail/smResidentStore.h"

#include "smContextResources.h"
#include "smContextScope.h"
#include "smWindowResources.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace sm
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

/// The content of a page while it is being packed.
struct PageData
{
  std::vector<std::array<double, 4>> Points;
  std::vector<PatchRecord> Patches;
  std::vector<double> Coefficients;
  std::vector<double> Caps;
  std::size_t Items = 0;

  std::size_t GetMaxBlock() const
  {
    return std::max(
      { this->Points.size() * sizeof(this->Points[0]), this->Patches.size() * sizeof(PatchRecord),
        this->Coefficients.size() * sizeof(double), this->Caps.size() * sizeof(double) });
  }
};

namespace
{
// Faces packed between two reports of progress.
constexpr std::size_t FacesPerReport = 256;

constexpr const char* CacheName = "sm::ResidentStore";

std::size_t GetMaxBlock(const FacePanels& panels)
{
  return std::max(
    { panels.Points.size() * sizeof(panels.Points[0]), panels.Patches.size() * sizeof(PatchRecord),
      panels.Coefficients.size() * sizeof(double), panels.Caps.size() * 9 * sizeof(double) });
}

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

std::shared_ptr<ResidentStore> ResidentStore::Open(
  vtkComputeContext* context, bool isShared, std::string& error)
{
  if (context->GetStatus() != vtkComputeContext::READY)
  {
    error = "the compute context is not ready";
    return nullptr;
  }
  std::weak_ptr<void>& known = context->GetResources()->Window->Caches[CacheName];
  auto store = isShared ? std::static_pointer_cast<ResidentStore>(known.lock()) : nullptr;
  if (store && store->IsAlive())
  {
    return store;
  }
  store = std::make_shared<ResidentStore>();
  store->Host = context;
  if (isShared)
  {
    store->Host = vtkSmartPointer<vtkComputeContext>::New();
    store->Host->SetSource(vtkComputeContext::WINDOW);
    store->Host->SetWindow(context->GetRenderWindow());
    if (store->Host->Start() != vtkComputeContext::READY)
    {
      error = store->Host->GetReason();
      return nullptr;
    }
    known = store;
  }
  store->Generation = store->Host->GetGeneration();
  return store;
}

bool ResidentStore::Fail(const std::string& what)
{
  this->Error = what;
  return false;
}

void ResidentStore::Use(User user, Page& page)
{
  page.Users.insert(user);
  page.Pins.insert(user);
  page.LastUse = this->Clock;
}

void ResidentStore::Unpin(User user)
{
  for (auto& [id, page] : this->AllPages)
  {
    page.Pins.erase(user);
  }
}

void ResidentStore::Leave(User user)
{
  for (auto page = this->AllPages.begin(); page != this->AllPages.end();)
  {
    page->second.Pins.erase(user);
    const bool wasUsed = page->second.Users.erase(user) != 0;
    page = wasUsed && page->second.Users.empty() ? this->Drop(page) : std::next(page);
  }
}

/// Returns the page behind the dropped one.
ResidentStore::Pages::iterator ResidentStore::Drop(Pages::iterator page)
{
  for (const auto& [id, source] : page->second.Faces)
  {
    // A later face may have the same id as one that no longer exists.
    const auto found = this->Faces.find(id);
    if (found != this->Faces.end() && found->second.Page == page->first)
    {
      this->Faces.erase(found);
    }
  }
  this->Bytes -= page->second.Bytes;
  ++this->Evictions;
  return this->AllPages.erase(page);
}

/// Drops the pages of which no face exists any more. An edit's faces have pages of their own, so that the
/// next edit frees them.
void ResidentStore::DropDead()
{
  for (auto page = this->AllPages.begin(); page != this->AllPages.end();)
  {
    const auto& faces = page->second.Faces;
    const bool isDead = page->second.Pins.empty() &&
      std::all_of(faces.begin(), faces.end(), [](const auto& face) { return face.second.expired(); });
    page = isDead ? this->Drop(page) : std::next(page);
  }
}

/// Drops the pages used longest ago, but none that is pinned, until the budget holds.
void ResidentStore::Evict()
{
  while (this->Bytes > this->Budget)
  {
    auto oldest = this->AllPages.end();
    for (auto page = this->AllPages.begin(); page != this->AllPages.end(); ++page)
    {
      if (page->second.Pins.empty() &&
        (oldest == this->AllPages.end() || page->second.LastUse < oldest->second.LastUse))
      {
        oldest = page;
      }
    }
    if (oldest == this->AllPages.end())
    {
      return;
    }
    this->Drop(oldest);
  }
}

bool ResidentStore::Upload(const PageData& data, Page& page)
{
  const ContextScope scope(this->Host);
  if (!scope)
  {
    return this->Fail(this->Host->GetReason());
  }
  const auto upload = [this, &page](ComputeBuffer& buffer, const auto& values)
  {
    buffer = ComputeBuffer(this->Host);
    const bool done = buffer.Upload(values);
    page.Bytes += buffer.GetSize();
    return done || this->Fail("The faces do not fit on the GPU: " + buffer.GetError());
  };
  return upload(page.Points, data.Points) && upload(page.Patches, data.Patches) &&
    upload(page.Coefficients, data.Coefficients) && upload(page.Caps, data.Caps);
}

/// Uploads the packed faces as a page of their own.
bool ResidentStore::Flush(Request& request, PageData& data)
{
  if (request.Packed.empty())
  {
    return true;
  }
  Page page;
  if (!this->Upload(data, page))
  {
    return false;
  }
  this->Use(request.Asker, page);
  for (auto& [id, location] : request.Packed)
  {
    location.Page = this->NextPage;
    page.Faces.emplace_back(id, location.Source);
    this->Faces[id] = std::move(location);
  }
  this->Bytes += page.Bytes;
  this->AllPages.emplace(this->NextPage++, std::move(page));
  request.Packed.clear();
  data = PageData();
  return true;
}

bool ResidentStore::UploadAll(
  Request& request, const std::vector<CutFacePointer>& faces, const ProgressCallback& progress)
{
  const auto blockLimit = static_cast<std::size_t>(this->Host->GetMaximumStorageBlockSize());
  PageData data;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (i % FacesPerReport == 0 && progress && !progress(static_cast<double>(i) / faces.size()))
    {
      return this->Fail("aborted");
    }
    const CutFace& face = *faces[i];
    ResidentFace location;
    location.Source = face.Source;
    const std::size_t size = GetMaxBlock(face.Panels);
    if (size > blockLimit)
    {
      location.Error = "face #" + std::to_string(face.Source->FileId) + " has " + std::to_string(size >> 20) +
        " MiB of geometry, more than a storage block of this GPU may have";
    }
    else
    {
      if (data.GetMaxBlock() + size > blockLimit && !this->Flush(request, data))
      {
        return false;
      }
      Append(face.Panels, data, location);
      data.Items += face.GetNumberOfItems();
    }
    request.Packed.emplace_back(face.Source->Id, std::move(location));
    if (data.Items >= request.ItemsPerPage && !this->Flush(request, data))
    {
      return false;
    }
  }
  return this->Flush(request, data);
}

/// Pins the pages of resident faces; `missing` gets the others, each once, in the order of the request.
bool ResidentStore::FindMissing(
  User user, const std::vector<CutFacePointer>& faces, std::vector<CutFacePointer>& missing)
{
  std::unordered_map<std::uint64_t, FacePointer> asked;
  for (const CutFacePointer& face : faces)
  {
    const std::uint64_t id = face->Source->Id;
    const auto [first, isNew] = asked.emplace(id, face->Source);
    const auto found = this->Faces.find(id);
    const FacePointer resident = found == this->Faces.end() ? nullptr : found->second.Source.lock();
    if (first->second != face->Source || (resident && resident != face->Source))
    {
      return this->Fail("two different faces have the id " + std::to_string(id) +
        "; give every new face an id of its own, sm::NewId()");
    }
    if (resident)
    {
      this->Use(user, this->AllPages.at(found->second.Page));
    }
    else if (isNew)
    {
      missing.push_back(face);
    }
  }
  return true;
}

bool ResidentStore::Acquire(User user, const std::vector<CutFacePointer>& faces,
  std::vector<ResidentFace>& locations, const ProgressCallback& progress, std::size_t itemsPerPage,
  std::uint64_t& uploads)
{
  ++this->Clock;
  this->Unpin(user);
  std::vector<CutFacePointer> missing;
  if (!this->FindMissing(user, faces, missing))
  {
    return false;
  }
  if (!missing.empty())
  {
    this->DropDead();
  }
  Request request{ user, itemsPerPage, {} };
  if (!this->UploadAll(request, missing, progress))
  {
    return false;
  }
  uploads += missing.size();
  locations.clear();
  locations.reserve(faces.size());
  for (const CutFacePointer& face : faces)
  {
    locations.push_back(this->Faces.at(face->Source->Id));
  }
  this->Evict();
  return true;
}

bool ResidentStore::Bind(int page, bool caps)
{
  const auto found = this->AllPages.find(page);
  if (found == this->AllPages.end())
  {
    return this->Fail("the faces are no longer on the GPU");
  }
  Page& bound = found->second;
  return caps ? bound.Caps.Bind(2)
              : bound.Points.Bind(0) && bound.Patches.Bind(1) && bound.Coefficients.Bind(2);
}
}
