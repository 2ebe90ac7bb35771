#include "smOCCTRepair.h"

#include "smFormat.h"
#include "smOCCTFailure.h"

#include "vtkTimerLog.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <utility>

namespace sm
{
namespace
{
/// Largest number of reasons that are listed.
constexpr std::size_t MostReasons = 10;

/// Keeps the sides of the faces, which a repair may turn.
void KeepSides(const TopoDS_Shape& shape, RepairLog& log)
{
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
  {
    TopLoc_Location location;
    const Handle(Geom_Surface)& surface = BRep_Tool::Surface(TopoDS::Face(it.Current()), location);
    const FaceSide side{ surface, it.Current().Orientation() == TopAbs_REVERSED, false };
    const auto [known, isNew] = log.Sides.emplace(surface.get(), side);
    known->second.Ambiguous = !isNew;
  }
}

/// Returns true if the body needs no repair, or no more after some of its faces were repaired; the result is added to `log`.
bool IsSoundBody(TopoDS_Shape& shape, RepairLog& log, const ShapeLabel& label, const FaceRepair& repair)
{
  if (shape.IsNull() || (shape.ShapeType() != TopAbs_SOLID && shape.ShapeType() != TopAbs_SHELL))
  {
    return false;
  }
  // Labels are made for listed reasons only, because each needs a search through all transferred entities.
  const bool isTold = log.Reasons.size() < MostReasons;
  const ShapeLabel none = [](const TopoDS_Shape&) { return std::string(); };
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
  const bool isPatched = failure.empty() && damage.RepairedFaces > 0;
  if (isTold && !damage.Problem.empty())
  {
    log.Reasons.push_back(damage.Problem);
  }
  if (!damage.Problem.empty() && !isPatched)
  {
    ++log.RepairedBodies;
    KeepSides(shape, log);
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
}

RepairOnNeed::RepairOnNeed(RepairLog& log, ShapeLabel label)
  : Filter([&log, label = std::move(label)](TopoDS_Shape& shape, const FaceRepair& repair)
      { return IsSoundBody(shape, log, label, repair); })
{
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
