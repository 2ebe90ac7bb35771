#include "smRepair.h"

#include "Loops/smFaceInspection.h"
#include "Loops/smFoldedFaces.h"
#include "Loops/smOutsideFaces.h"
#include "smCatchFailure.h"
#include "smFormat.h"

#include "vtkTimerLog.h"

#include <algorithm>

namespace sm
{
namespace
{
/// Largest number of reasons that are listed.
constexpr std::size_t MaxReasons = 10;

bool IsSoundOutside(const FaceShape* face, const RepairLog& log)
{
  const auto found = log.SoundFaces.find(face);
  return found != log.SoundFaces.end() && found->second->IsOutside();
}

/// Keeps the sides of the faces, which a repair may reverse.
void KeepSides(const BodyShape& body, RepairLog& log)
{
  for (const ShellUse& shell : body.Shells)
  {
    for (const FaceUse& face : shell.Shell->Faces)
    {
      log.Sides[face.Face.get()] = { shell.Shell, face.Reversed != shell.Reversed };
    }
  }
}

/// Adds the faces to the log of which a repair may have taken the wrong part.
void AddOutsideFaces(const BodyShape& body, RepairLog& log)
{
  for (const FaceShape* face : FindOutsideFaces(body))
  {
    const std::string name = GetLabel(*face);
    if (!IsSoundOutside(face, log) &&
      std::find(log.FoldedFaces.begin(), log.FoldedFaces.end(), name) == log.FoldedFaces.end())
    {
      log.OutsideFaces.push_back(name);
    }
  }
}

/// Adds faces whose sense contradicts their neighbours' to the log. Returns the reason why a body with faces
/// outside their loops is repaired all the same; empty if there is none. The repair takes the part inside.
std::string FindContradiction(const BodyShape& body, bool isReversed, RepairLog& log)
{
  std::string problem;
  for (const FaceShape* face : FindFoldedFaces(body, log.SoundFaces))
  {
    log.FoldedFaces.push_back(GetLabel(*face));
    problem =
      IsSoundOutside(face, log) ? log.FoldedFaces.back() + ": its outer loop runs the wrong way" : problem;
  }
  // The sides of a body that is inside out are taken to be wrong, and so may be the directions of its loops.
  body.VisitFaces(
    [&](const FaceUse& use)
    {
      problem = isReversed && problem.empty() && IsSoundOutside(use.Face.get(), log)
        ? GetLabel(*use.Face) + ": it lies outside its loops, and its solid is inside out"
        : problem;
    });
  if (!problem.empty())
  {
    body.VisitFaces([&log](const FaceUse& use) { log.SoundFaces.erase(use.Face.get()); });
  }
  return problem;
}
}

bool MakeSoundBody(BodyShape& body, RepairLog& log, const FaceRepair& repair)
{
  if (body.Shells.empty())
  {
    return false;
  }
  const BodyShape original = body;
  ShapeDamage damage;
  const double start = vtkTimerLog::GetUniversalTime();
  double repairSeconds = 0.0;
  const FaceRepair timed = [&](const BodyShape& whole, const std::vector<const FaceShape*>& damaged,
                             std::vector<const FaceShape*>& repaired)
  {
    const double begin = vtkTimerLog::GetUniversalTime();
    BodyShape result = repair(whole, damaged, repaired);
    repairSeconds = vtkTimerLog::GetUniversalTime() - begin;
    return result;
  };
  const std::string failure = CatchFailure([&] { damage = FindShapeDamage(body, log.SoundFaces, timed); });
  log.Seconds += vtkTimerLog::GetUniversalTime() - start - repairSeconds;
  damage.Problem = failure.empty() ? damage.Problem : failure;
  bool isPatched = failure.empty() && damage.RepairedFaces > 0;
  const std::string contradiction =
    damage.Problem.empty() || isPatched ? FindContradiction(body, damage.IsReversed, log) : std::string();
  if (!contradiction.empty())
  {
    damage.Problem = contradiction;
    isPatched = false;
  }
  if (!damage.Problem.empty())
  {
    AddOutsideFaces(original, log);
  }
  if (log.Reasons.size() < MaxReasons && !damage.Problem.empty())
  {
    log.Reasons.push_back(damage.Problem);
  }
  if (!damage.Problem.empty() && !isPatched)
  {
    ++log.RepairedBodies;
    KeepSides(original, log);
    return false;
  }
  ++log.SoundBodies;
  if (damage.IsReversed)
  {
    log.ReversedShells.push_back(body.Shells.front().Shell);
  }
  log.PatchedBodies += isPatched ? 1 : 0;
  log.RepairedFaces += damage.RepairedFaces;
  log.BodiesWithReversedEdges += damage.ReversedEdges > 0 ? 1 : 0;
  log.ReversedEdges += damage.ReversedEdges;
  return true;
}

void LogBeforeRepair(const BodyShape& body, RepairLog& log)
{
  KeepSides(body, log);
  // A face with the wrong sense lies outside its loops.
  AddOutsideFaces(body, log);
}

void CompleteFaces(const BodyShape& body, double precision, RepairLog& log)
{
  body.VisitFaces(
    [&](const FaceUse& use)
    {
      CatchFailure(
        [&]
        {
          EdgeIndex edges;
          DraftFace face = CollectFace(*use.Face, false, edges, MissingTrim::Feet);
          if (InspectFace(face, Vector3{}, precision, precision).Problem.empty())
          {
            log.SoundFaces[use.Face.get()] = std::make_shared<const DraftFace>(std::move(face));
          }
        });
    });
}

std::vector<std::string> Describe(const RepairLog& log)
{
  const std::string all =
    std::to_string(log.RepairedBodies + log.SoundBodies) + " solids and shells of the file";
  std::vector<std::string> messages;
  if (log.BodiesWithReversedEdges > 0)
  {
    messages.push_back(std::to_string(log.BodiesWithReversedEdges) + " of " + all +
      " have edges that run against their loops: " + FormatCount(log.ReversedEdges, "use was", "uses were") +
      " reversed, so that the loops close and each edge has a use in either direction.");
  }
  if (log.RepairedBodies + log.PatchedBodies > 0)
  {
    std::string text = log.RepairedBodies > 0 ? std::to_string(log.RepairedBodies) + " of " + all : "";
    if (log.PatchedBodies > 0)
    {
      text += (text.empty() ? "" : ", and ") + FormatCount(log.RepairedFaces, "single face", "single faces") +
        " of " + std::to_string(log.PatchedBodies) + " of " + (text.empty() ? all : "them");
    }
    text += " were repaired by OpenCASCADE: ";
    for (const std::string& reason : log.Reasons)
    {
      text += (&reason == &log.Reasons[0] ? "" : "; ") + reason;
    }
    const auto reported = static_cast<int>(log.Reasons.size());
    messages.push_back(text + (reported < log.RepairedBodies + log.PatchedBodies ? "; ..." : "."));
  }
  return messages;
}
}
