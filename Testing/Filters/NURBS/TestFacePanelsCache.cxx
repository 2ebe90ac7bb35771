// Cut faces are kept by id: found again, forgotten with their models and by age within a budget, never taken
// from who holds them.
#include "smFacePanelsCache.h"
#include "smTestFaces.h"
#include "smTesting.h"

namespace
{
using namespace smtest;

void CheckFound()
{
  sm::FacePanelsCache cache;
  const std::vector<sm::FacePointer> faces = { MakeSquare(1, 2), MakeSquare(2, 3), MakeSquare(3, 1) };
  std::vector<sm::CutFacePointer> cut;
  // The same face twice in a request is cut once.
  CheckTrue("acquire", cache.Acquire({ faces[0], faces[1], faces[0] }, cut, nullptr), cache.GetError());
  CheckEqual("entries", 3, static_cast<long long>(cut.size()));
  CheckTrue("one object for one face", cut[0] == cut[2] && cut[0]->Source == faces[0]);
  CheckEqual("cells of the first", 4, static_cast<long long>(cut[0]->Panels.Panels.size()));
  CheckEqual("its items", 4, static_cast<long long>(cut[0]->GetNumberOfItems()));
  CheckEqual("cells of the second", 9, static_cast<long long>(cut[1]->Panels.Panels.size()));
  CheckEqual("patches and points are kept", 4, static_cast<long long>(cut[0]->Panels.Patches.size()));
  CheckEqual("faces cut", 2, static_cast<long long>(cache.GetNumberOfCuts()));
  const sm::CutFacePointer first = cut[0];
  CheckTrue("acquire again", cache.Acquire({ faces[2], faces[0] }, cut, nullptr));
  CheckTrue("found again", cut[1] == first);
  CheckEqual("faces cut", 3, static_cast<long long>(cache.GetNumberOfCuts()));
  CheckEqual("faces kept", 3, static_cast<long long>(cache.GetNumberOfFaces()));
}

void CheckBudget()
{
  sm::CacheBudget budget(std::size_t{ 1 } << 30);
  sm::FacePanelsCache cache(budget);
  std::vector<sm::FacePointer> faces;
  for (int i = 0; i < 10; ++i)
  {
    faces.push_back(MakeSquare(1 + i, 4));
  }
  std::vector<sm::CutFacePointer> cut;
  cache.Acquire({ faces[0] }, cut, nullptr);
  const std::size_t bytes = cache.GetBytes();
  CheckTrue("bytes of a face", bytes > 16 * (sizeof(sm::Patch) + sizeof(sm::Panel)), std::to_string(bytes));
  const sm::CutFacePointer held = cut[0];
  budget.SetLimit(3 * bytes + bytes / 2);
  for (const sm::FacePointer& face : faces)
  {
    cache.Acquire({ face }, cut, nullptr);
    // This face is asked for every time, so that it is never the one used longest ago.
    cache.Acquire({ faces[1] }, cut, nullptr);
  }
  CheckEqual("faces kept", 3, static_cast<long long>(cache.GetNumberOfFaces()));
  CheckTrue("bytes kept", cache.GetBytes() <= 3 * bytes + bytes / 2, std::to_string(cache.GetBytes()));
  CheckEqual("faces cut", 10, static_cast<long long>(cache.GetNumberOfCuts()));
  CheckEqual("faces forgotten", 7, static_cast<long long>(cache.GetNumberOfEvictions()));
  CheckEqual("a forgotten face that is held lives", 16, static_cast<long long>(held->Panels.Panels.size()));
  cache.Acquire({ faces[0] }, cut, nullptr);
  CheckEqual("it is cut again", 11, static_cast<long long>(cache.GetNumberOfCuts()));
  CheckTrue("into the same",
    cut[0] != held && cut[0]->Panels.Points == held->Panels.Points &&
      cut[0]->Panels.Coefficients == held->Panels.Coefficients);

  CheckTrue("a request above the budget", cache.Acquire(faces, cut, nullptr), cache.GetError());
  bool isComplete = cut.size() == faces.size();
  for (std::size_t i = 0; isComplete && i < faces.size(); ++i)
  {
    isComplete = cut[i] && cut[i]->Source == faces[i] && cut[i]->Panels.Panels.size() == 16;
  }
  CheckTrue("is complete", isComplete);
  CheckEqual("and kept in part", 3, static_cast<long long>(cache.GetNumberOfFaces()));
}

/// A long drag: every edit replaces one face of a model of ten.
void CheckEdits()
{
  sm::FacePanelsCache cache;
  std::vector<sm::FacePointer> faces;
  for (int i = 0; i < 10; ++i)
  {
    faces.push_back(MakeSquare(1 + i, 4));
  }
  std::vector<sm::CutFacePointer> cut;
  cache.Acquire(faces, cut, nullptr);
  const std::size_t bytes = cache.GetBytes();
  const sm::CutFacePointer held = cut[9];
  for (int edit = 0; edit < 100; ++edit)
  {
    faces[edit % 3] = MakeSquare(100 + edit, 4);
    cache.Acquire(faces, cut, nullptr);
  }
  CheckEqual("after 100 edits: faces cut", 110, static_cast<long long>(cache.GetNumberOfCuts()));
  CheckEqual("faces kept", 10, static_cast<long long>(cache.GetNumberOfFaces()));
  CheckEqual("bytes kept", static_cast<long long>(bytes), static_cast<long long>(cache.GetBytes()));
  faces.pop_back();
  faces[0] = MakeSquare(500, 4);
  cache.Acquire(faces, cut, nullptr);
  CheckEqual("what somebody holds is kept", 10, static_cast<long long>(cache.GetNumberOfFaces()));
  CheckTrue("and found", cache.Acquire({ held->Source }, cut, nullptr) && cut[0] == held);
}

/// Two filters on one model: an edit leaves nothing of the replaced face in either cache.
void CheckTwoCaches()
{
  sm::FacePanelsCache caches[2];
  std::vector<sm::FacePointer> faces = { MakeSquare(1, 4), MakeSquare(2, 4) };
  std::vector<sm::CutFacePointer> cut;
  for (int edit = 0; edit < 5; ++edit)
  {
    faces[0] = MakeSquare(10 + edit, 4);
    for (sm::FacePanelsCache& cache : caches)
    {
      CheckTrue("acquire", cache.Acquire(faces, cut, nullptr), cache.GetError());
      cut.clear();
    }
  }
  CheckEqual("two caches: faces kept by the first", 2, static_cast<long long>(caches[0].GetNumberOfFaces()));
  CheckEqual("by the second", 2, static_cast<long long>(caches[1].GetNumberOfFaces()));
  const std::weak_ptr<const sm::Face> replaced = faces[0];
  faces[0] = MakeSquare(20, 4);
  caches[0].Acquire(faces, cut, nullptr);
  caches[1].Acquire(faces, cut, nullptr);
  CheckTrue("a replaced face is freed", replaced.expired());
}

void CheckMistakes()
{
  sm::FacePanelsCache cache;
  const sm::FacePointer face = MakeSquare(1, 2);
  auto other = std::make_shared<sm::Face>(*MakeSquare(2, 2));
  other->Id = face->Id;
  std::vector<sm::CutFacePointer> cut;
  CheckTrue("one id for two faces of a request is refused",
    !cache.Acquire({ face, other }, cut, nullptr) && cache.GetError().find("NewId") != std::string::npos &&
      cut.empty(),
    cache.GetError());
  cache.Acquire({ face }, cut, nullptr);
  CheckTrue("and for a face that is kept",
    !cache.Acquire({ other }, cut, nullptr) && cache.GetError().find("NewId") != std::string::npos);

  auto broken = std::make_shared<sm::Face>(*MakeSquare(3, 2));
  broken->Id = sm::NewId();
  broken->FileId = 77;
  broken->Surface.ControlPoints[3][3] = -1.0;
  CheckTrue("a wrong face does not stop the others", cache.Acquire({ broken, face }, cut, nullptr));
  CheckTrue("it says why and is empty",
    cut[0]->Error.find("#77") != std::string::npos && cut[0]->GetNumberOfItems() == 0, cut[0]->Error);
  CheckTrue("the other is whole", cut[1]->Error.empty() && cut[1]->GetNumberOfItems() == 4);

  std::vector<sm::FacePointer> many;
  for (int i = 0; i < 600; ++i)
  {
    many.push_back(MakeSquare(1 + i, 1));
  }
  double last = -1.0;
  const auto stop = [&last](double fraction)
  {
    last = fraction;
    return fraction == 0.0;
  };
  CheckTrue("stopped", !cache.Acquire(many, cut, stop) && cut.empty());
  CheckEqual("it says so", "aborted", cache.GetError());
  CheckRange("at a fraction of", 0.1, last, 0.9);
  CheckTrue("and goes on where it was", cache.Acquire(many, cut, nullptr));
  CheckEqual("nothing was cut twice", 602, static_cast<long long>(cache.GetNumberOfCuts()));
}
}

int TestFacePanelsCache(int, char*[])
{
  CheckFound();
  CheckBudget();
  CheckEdits();
  CheckTwoCaches();
  CheckMistakes();
  return Finish();
}
