// Faces on the GPU: uploaded once, packed into pages, dropped with their models and by age within a budget,
// gone with their context.
#include "smContextScope.h"
#include "smFacePanelsCache.h"
#include "smResidentFaces.h"
#include "smTestFaces.h"
#include "smTesting.h"

#include <vtkComputeContext.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>

#include <memory>

namespace
{
using namespace smtest;

std::vector<sm::CutFacePointer> MakeFaces(sm::FacePanelsCache& cache, int count)
{
  std::vector<sm::FacePointer> faces;
  for (int i = 0; i < count; ++i)
  {
    faces.push_back(MakeSquare(1 + i, 4));
  }
  std::vector<sm::CutFacePointer> cut;
  CheckTrue("cut", cache.Acquire(faces, cut, nullptr), cache.GetError());
  return cut;
}

void CheckPages(vtkComputeContext* context)
{
  sm::FacePanelsCache cache;
  const std::vector<sm::CutFacePointer> faces = MakeFaces(cache, 10);
  sm::ResidentFaces resident(context);
  // 16 items a face: three faces reach the limit of a page.
  resident.SetMaximumItemsPerPage(40);
  std::vector<sm::ResidentFace> places;
  CheckTrue("acquire", resident.Acquire(faces, places, nullptr), resident.GetError());
  CheckEqual("places", 10, static_cast<long long>(places.size()));
  bool isPacked = true;
  for (int i = 0; i < 10; ++i)
  {
    const sm::ResidentFace& place = places[i];
    isPacked = isPacked && place.Error.empty() && place.Page == places[0].Page + i / 3 &&
      place.FirstPatch == 16u * (i % 3) && place.Source.lock() == faces[i]->Source;
  }
  CheckTrue("three faces a page, one after another", isPacked);
  CheckEqual("uploads", 10, static_cast<long long>(resident.GetNumberOfUploads()));
  CheckEqual("faces", 10, static_cast<long long>(resident.GetNumberOfFaces()));
  CheckTrue("the same face twice", resident.Acquire({ faces[4], faces[4] }, places, nullptr));
  CheckTrue(
    "has one place", places[0].Page == places[1].Page && places[0].FirstPatch == places[1].FirstPatch);
  CheckEqual("and costs nothing", 10, static_cast<long long>(resident.GetNumberOfUploads()));
  {
    const sm::ContextScope scope(context);
    CheckTrue("a page can be bound", resident.Bind(places[0].Page) && resident.BindCaps(places[0].Page));
  }

  // Room for two of four pages: the one used last stays, and one of the others.
  const std::size_t bytes = resident.GetBytes();
  resident.SetBudget(bytes * 6 / 10);
  CheckTrue("acquire within a budget", resident.Acquire({ faces[5] }, places, nullptr));
  CheckTrue("bytes", resident.GetBytes() <= bytes * 6 / 10 && resident.GetBytes() > 0);
  CheckTrue("pages dropped", resident.GetNumberOfEvictions() >= 2);
  const std::uint64_t uploads = resident.GetNumberOfUploads();
  CheckTrue("the face used last", resident.Acquire({ faces[5] }, places, nullptr));
  CheckEqual(
    "is still there", static_cast<long long>(uploads), static_cast<long long>(resident.GetNumberOfUploads()));
  CheckTrue("all again, above the budget", resident.Acquire(faces, places, nullptr), resident.GetError());
  CheckTrue("what was dropped is uploaded again", resident.GetNumberOfUploads() > uploads);
}

/// A long drag: every edit replaces one face of a model of ten.
void CheckEdits(vtkComputeContext* context)
{
  std::vector<sm::FacePointer> model;
  for (int i = 0; i < 10; ++i)
  {
    model.push_back(MakeSquare(1 + i, 4));
  }
  sm::ResidentFaces resident(context);
  std::vector<sm::ResidentFace> places;
  sm::FacePanelsCache cache;
  std::vector<sm::CutFacePointer> cut;
  std::size_t bytes = 0;
  for (int edit = 0; edit <= 100; ++edit)
  {
    cache.Acquire(model, cut, nullptr);
    CheckTrue("acquire", resident.Acquire(cut, places, nullptr), resident.GetError());
    bytes = edit == 0 ? resident.GetBytes() : bytes;
    model[edit % 3] = MakeSquare(100 + edit, 4);
    cut.clear();
  }
  CheckEqual("after 100 edits: uploads", 110, static_cast<long long>(resident.GetNumberOfUploads()));
  // The first page has seven faces that live, and three that do not; three faces of edits have a page each.
  CheckEqual("faces", 13, static_cast<long long>(resident.GetNumberOfFaces()));
  CheckEqual(
    "bytes", static_cast<long long>(bytes + 3 * (bytes / 10)), static_cast<long long>(resident.GetBytes()));
  const std::uint64_t uploads = resident.GetNumberOfUploads();
  model.clear();
  model.push_back(MakeSquare(1000, 4));
  cache.Acquire(model, cut, nullptr);
  resident.Acquire(cut, places, nullptr);
  CheckEqual("another model: uploads", static_cast<long long>(uploads + 1),
    static_cast<long long>(resident.GetNumberOfUploads()));
  CheckEqual("and nothing of the first", 1, static_cast<long long>(resident.GetNumberOfFaces()));
}

/// Two users of one window, each with a context of its own: a face is on the GPU once, until both have
/// released it.
void CheckSharing(vtkComputeContext* context)
{
  const long long before = context->GetAllocatedBytes();
  sm::FacePanelsCache cache;
  const std::vector<sm::CutFacePointer> faces = MakeFaces(cache, 10);
  std::vector<sm::ResidentFace> places;
  std::vector<sm::ResidentFace> others;
  auto first = std::make_unique<sm::ResidentFaces>(context);
  CheckTrue("first user", first->Acquire(faces, places, nullptr), first->GetError());
  const long long bytes = context->GetAllocatedBytes();
  CheckTrue("the faces take memory", bytes > before);
  vtkNew<vtkComputeContext> context2;
  context2->SetSource(vtkComputeContext::WINDOW);
  context2->SetWindow(context->GetRenderWindow());
  CheckEqual("second context", vtkComputeContext::READY, context2->Start());
  sm::ResidentFaces second(context2);
  CheckTrue("second user", second.Acquire(faces, others, nullptr), second.GetError());
  CheckEqual("nothing is uploaded twice", 0, static_cast<long long>(second.GetNumberOfUploads()));
  CheckEqual("allocated bytes stay", bytes, context2->GetAllocatedBytes());
  CheckTrue("one place", others[3].Page == places[3].Page && others[3].FirstPatch == places[3].FirstPatch);

  // Pages of a run of the one are not dropped for the other.
  second.SetBudget(1);
  CheckTrue("above the budget", second.Acquire({ faces[0] }, others, nullptr));
  CheckEqual("pinned by the first", bytes, context->GetAllocatedBytes());
  first = nullptr;
  CheckEqual("the second still has them", bytes, context->GetAllocatedBytes());
  {
    const sm::ContextScope scope(context2);
    CheckTrue("and can bind them", second.Bind(others[0].Page));
  }
  {
    sm::ResidentFaces alone(context, sm::ResidentFaces::Sharing::None);
    CheckTrue("a user with pages of its own", alone.Acquire(faces, places, nullptr), alone.GetError());
    CheckEqual("uploads", 10, static_cast<long long>(alone.GetNumberOfUploads()));
    CheckEqual("twice the bytes", 2 * bytes - before, context->GetAllocatedBytes());
  }
  second.Release();
  CheckEqual("nobody has them", before, context->GetAllocatedBytes());
  CheckTrue("they can be had again", second.Acquire(faces, others, nullptr), second.GetError());
  CheckEqual("at the same cost", bytes, context->GetAllocatedBytes());
  context2->Stop();
  CheckEqual("the end of the context frees them", before, context->GetAllocatedBytes());
  CheckEqual("no faces", 0, static_cast<long long>(second.GetNumberOfFaces()));
  context2->Start();
  CheckTrue("and again", second.Acquire(faces, others, nullptr), second.GetError());
}

void CheckMistakes(vtkComputeContext* context)
{
  sm::FacePanelsCache cache;
  const std::vector<sm::CutFacePointer> faces = MakeFaces(cache, 3);
  sm::ResidentFaces resident(context);
  std::vector<sm::ResidentFace> places;
  auto source = std::make_shared<sm::Face>(*faces[0]->Source);
  auto other = std::make_shared<sm::CutFace>(*faces[0]);
  other->Source = source;
  CheckTrue("one id for two faces of a request is refused",
    !resident.Acquire({ faces[0], other }, places, nullptr) &&
      resident.GetError().find("NewId") != std::string::npos);
  CheckTrue("acquire", resident.Acquire(faces, places, nullptr));
  CheckTrue("and for one that is resident", !resident.Acquire({ other }, places, nullptr));
  source->Id = sm::NewId();
  CheckTrue("an id of its own", resident.Acquire({ other }, places, nullptr), resident.GetError());
  source = std::make_shared<sm::Face>(*source);
  source->Id = sm::NewId();
  auto more = std::make_shared<sm::CutFace>(*other);
  more->Source = source;
  CheckTrue("stopped", !resident.Acquire({ more }, places, [](double) { return false; }));
  CheckEqual("it says so", "aborted", resident.GetError());
}
}

int TestResidentFaces(int, char*[])
{
  vtkNew<vtkComputeContext> context;
  if (context->Start() != vtkComputeContext::READY)
  {
    std::printf("no OpenGL: %s\n", context->GetReason().c_str());
    return Skipped;
  }
  CheckPages(context);
  CheckEdits(context);
  CheckSharing(context);
  CheckEqual("all is released", 0, context->GetAllocatedBytes());
  CheckMistakes(context);
  return Finish();
}
