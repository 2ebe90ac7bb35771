#include "smOCCTRepair.h"

#include "smFormat.h"
#include "smOCCTFailure.h"
#include "smOCCTFoldedFaces.h"
#include "smOCCTOutsideFaces.h"

#include "vtkTimerLog.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <utility>

namespace sm
{
namespace
{
/// Largest number of reasons that are listed.
constexpr std::size_t MostReasons = 10;

bool IsSoundOutside(const TopoDS_Shape& face, const RepairLog& log)
{
  const auto found = log.SoundFaces.find(face.TShape().get());
  return found != log.SoundFaces.end() && found->second->IsOutside();
}

/// Keeps the sides of the faces, which a repair may turn.
void KeepSides(const TopoDS_Shape& shape, RepairLog& log)
{
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next())
  {
    for (TopExp_Explorer it(shell.Current(), TopAbs_FACE); it.More(); it.Next())
    {
      TopLoc_Location location;
      const Handle(Geom_Surface)& surface = BRep_Tool::Surface(TopoDS::Face(it.Current()), location);
      const FaceSide side{ surface, shell.Current(), it.Current().Orientation() == TopAbs_REVERSED, false };
      const auto [known, isNew] = log.Sides.emplace(surface.get(), side);
      known->second.Ambiguous = !isNew;
    }
  }
}

/// Adds the faces to the log of which a repair may have taken the wrong part.
void AddOutsideFaces(const TopoDS_Shape& shape, RepairLog& log, const ShapeLabel& label)
{
  for (const TopoDS_Shape& face : FindOutsideFaces(shape))
  {
    const std::string name = label(face);
    if (!IsSoundOutside(face, log) &&
      std::find(log.FoldedFaces.begin(), log.FoldedFaces.end(), name) == log.FoldedFaces.end())
    {
      log.OutsideFaces.push_back(name);
    }
  }
}

/// Adds faces whose sense contradicts their neighbours' to the log. Returns the reason why a body with faces
/// outside their loops is repaired all the same; empty if there is none. OpenCASCADE's repair takes the part
/// inside.
std::string FindContradiction(
  const TopoDS_Shape& original, const TopoDS_Shape& shape, RepairLog& log, const ShapeLabel& label)
{
  std::string problem;
  for (const TopoDS_Shape& face : FindFoldedFaces(shape, log.SoundFaces))
  {
    log.FoldedFaces.push_back(label(face));
    problem =
      IsSoundOutside(face, log) ? log.FoldedFaces.back() + ": its outer loop runs the wrong way" : problem;
  }
  // The sides of a body that is inside out are taken to be wrong, and so may be the directions of its loops.
  const bool isReversed = shape.Orientation() != original.Orientation();
  for (TopExp_Explorer it(shape, TopAbs_FACE); isReversed && problem.empty() && it.More(); it.Next())
  {
    problem = IsSoundOutside(it.Current(), log)
      ? label(it.Current()) + ": it lies outside its loops, and its solid is inside out"
      : problem;
  }
  for (TopExp_Explorer it(shape, TopAbs_FACE); !problem.empty() && it.More(); it.Next())
  {
    log.SoundFaces.erase(it.Current().TShape().get());
  }
  return problem;
}

}

bool IsSoundBody(TopoDS_Shape& shape, RepairLog& log, const ShapeLabel& label, const FaceRepair& repair)
{
  if (shape.IsNull() || (shape.ShapeType() != TopAbs_SOLID && shape.ShapeType() != TopAbs_SHELL))
  {
    return false;
  }
  // Labels are made for listed reasons only.
  const bool isTold = log.Reasons.size() < MostReasons;
  const ShapeLabel none = [](const TopoDS_Shape&) { return std::string(); };
  const TopoDS_Shape original = shape;
  ShapeDamage damage;
  const double start = vtkTimerLog::GetUniversalTime();
  double repairSeconds = 0.0;
  const FaceRepair timed = [&](const TopoDS_Shape& whole, const std::vector<TopoDS_Shape>& damaged,
                             std::vector<TopoDS_Shape>& repaired)
  {
    const double begin = vtkTimerLog::GetUniversalTime();
    TopoDS_Shape result = repair(whole, damaged, repaired);
    repairSeconds = vtkTimerLog::GetUniversalTime() - begin;
    return result;
  };
  const std::string failure =
    CatchFailure([&] { damage = FindShapeDamage(shape, isTold ? label : none, log.SoundFaces, timed); });
  log.Seconds += vtkTimerLog::GetUniversalTime() - start - repairSeconds;
  damage.Problem = failure.empty() ? damage.Problem : failure;
  bool isPatched = failure.empty() && damage.RepairedFaces > 0;
  const std::string contradiction =
    damage.Problem.empty() || isPatched ? FindContradiction(original, shape, log, label) : std::string();
  if (!contradiction.empty())
  {
    damage.Problem = contradiction;
    isPatched = false;
  }
  if (!damage.Problem.empty())
  {
    AddOutsideFaces(original, log, label);
  }
  if (isTold && !damage.Problem.empty())
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
    log.ReversedBodies.push_back(shape);
  }
  log.PatchedBodies += isPatched ? 1 : 0;
  log.RepairedFaces += damage.RepairedFaces;
  log.TurnedBodies += damage.TurnedEdges > 0 ? 1 : 0;
  log.TurnedEdges += damage.TurnedEdges;
  return true;
}

void LogBeforeRepair(const TopoDS_Shape& shape, RepairLog& log, const ShapeLabel& label)
{
  KeepSides(shape, log);
  // A face with the wrong sense lies outside its loops.
  AddOutsideFaces(shape, log, label);
}

std::vector<std::string> Describe(const RepairLog& log)
{
  const std::string all =
    std::to_string(log.RepairedBodies + log.SoundBodies) + " solids and shells of the file";
  std::vector<std::string> messages;
  if (log.TurnedBodies > 0)
  {
    messages.push_back(std::to_string(log.TurnedBodies) + " of " + all +
      " have edges that run against their loops: " + FormatCount(log.TurnedEdges, "use was", "uses were") +
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
    const auto told = static_cast<int>(log.Reasons.size());
    messages.push_back(text + (told < log.RepairedBodies + log.PatchedBodies ? "; ..." : "."));
  }
  return messages;
}
}
