#include "smResidentFaces.h"

#include "Detail/smResidentStore.h"
#include "smContextResources.h"

#include "smBernstein.h"
#include "smDisplayPoint.h"
#include "smPatch.h"
#include "smPatchRecord.h"
#include "smPatchSecond.h"
#include "smResident.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <map>

namespace sm
{
struct ResidentFaces::Internals
{
  vtkSmartPointer<vtkComputeContext> Context;
  std::shared_ptr<ContextResources> Resources;
  Sharing Share;
  std::shared_ptr<ResidentStore> Store;
  /// Budget of this user in bytes; 0: the default of the store.
  std::size_t Budget = 0;
  std::size_t MaximumItems = 262144;
  std::uint64_t Uploads = 0;
  std::string Error;

  bool Attach(const ResidentFaces* user)
  {
    if (this->Store && this->Store->IsAlive())
    {
      return true;
    }
    this->Detach(user);
    this->Store = ResidentStore::Open(this->Context, this->Share == Sharing::Context, this->Error);
    if (!this->Store)
    {
      return false;
    }
    if (this->Budget > 0)
    {
      this->Store->Budget = this->Budget;
    }
    // The store has a context of its own, so the end of the user's context must release the faces explicitly.
    this->Resources->AtEnd[user] = [this, user] { this->Detach(user); };
    return true;
  }

  void Detach(const ResidentFaces* user)
  {
    this->Resources->AtEnd.erase(user);
    if (const std::shared_ptr<ResidentStore> store = std::move(this->Store))
    {
      this->Store = nullptr;
      store->Leave(user);
    }
  }
};

ResidentFaces::ResidentFaces(vtkComputeContext* context, Sharing sharing)
  : Implementation(new Internals)
{
  this->Implementation->Context = context;
  this->Implementation->Resources = context->GetResources();
  this->Implementation->Share = sharing;
}

ResidentFaces::~ResidentFaces()
{
  this->Release();
}

void ResidentFaces::SetBudget(std::size_t bytes)
{
  this->Implementation->Budget = bytes;
  if (this->Implementation->Store)
  {
    this->Implementation->Store->Budget = bytes;
  }
}

void ResidentFaces::SetMaximumItemsPerPage(std::size_t items)
{
  this->Implementation->MaximumItems = std::max<std::size_t>(items, 1);
}

bool ResidentFaces::Acquire(const std::vector<CutFacePointer>& faces, std::vector<ResidentFace>& locations,
  const std::function<bool(double)>& progress)
{
  Internals& self = *this->Implementation;
  if (!self.Attach(this))
  {
    return false;
  }
  // A progress callback may end the context, and the store with it; this pointer keeps the store alive.
  const std::shared_ptr<ResidentStore> store = self.Store;
  const bool done = store->Acquire(this, faces, locations, progress, self.MaximumItems, self.Uploads);
  self.Error = done ? "" : store->Error;
  return done;
}

void ResidentFaces::EndRun()
{
  if (this->Implementation->Store)
  {
    this->Implementation->Store->Unpin(this);
  }
}

void ResidentFaces::Release()
{
  this->Implementation->Detach(this);
}

bool ResidentFaces::Bind(int page)
{
  return this->Implementation->Store && this->Implementation->Store->Bind(page, false);
}

bool ResidentFaces::BindCaps(int page)
{
  return this->Implementation->Store && this->Implementation->Store->Bind(page, true);
}

std::size_t ResidentFaces::GetNumberOfFaces() const
{
  return this->Implementation->Store ? this->Implementation->Store->Faces.size() : 0;
}

std::size_t ResidentFaces::GetBytes() const
{
  return this->Implementation->Store ? this->Implementation->Store->Bytes : 0;
}

std::uint64_t ResidentFaces::GetNumberOfUploads() const
{
  return this->Implementation->Uploads;
}

std::uint64_t ResidentFaces::GetNumberOfEvictions() const
{
  return this->Implementation->Store ? this->Implementation->Store->Evictions : 0;
}

const std::string& ResidentFaces::GetError() const
{
  return this->Implementation->Error;
}

const char* GetNURBSShaderChunk(const std::string& name)
{
  static const std::map<std::string, const char*> chunks = { { "smBernstein", smBernstein },
    { "smDisplayPoint", smDisplayPoint }, { "smPatch", smPatch }, { "smPatchRecord", smPatchRecord },
    { "smPatchSecond", smPatchSecond }, { "smResident", smResident } };
  const auto found = chunks.find(name);
  return found == chunks.end() ? nullptr : found->second;
}
}
