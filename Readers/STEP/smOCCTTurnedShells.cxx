#include "smOCCTTurnedShells.h"

#include "smFormat.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_TShape.hxx>

#include <set>
#include <unordered_set>

namespace sm
{
namespace
{
/// Shells of a solid by what the repair did with the sides of all their faces.
struct TurnedShells
{
  int Turned = 0;
  int Kept = 0;
  /// Entity number of a face of the first turned shell.
  int Face = 0;
};

TurnedShells FindTurnedShells(const RepairLog& log, const Document& document, const TopoDS_Shape& solid)
{
  TurnedShells result;
  for (TopExp_Explorer shell(solid, TopAbs_SHELL); shell.More(); shell.Next())
  {
    int turned = 0;
    int kept = 0;
    int number = 0;
    for (TopExp_Explorer face(shell.Current(), TopAbs_FACE); face.More(); face.Next())
    {
      TopLoc_Location location;
      const Handle(Geom_Surface)& surface = BRep_Tool::Surface(TopoDS::Face(face.Current()), location);
      const auto before = log.Sides.find(surface.get());
      if (before == log.Sides.end() || before->second.Ambiguous)
      {
        continue;
      }
      const bool isTurned = before->second.Reversed != (face.Current().Orientation() == TopAbs_REVERSED);
      const auto info = document.Table.find(face.Current().TShape().get());
      number = number == 0 && info != document.Table.end() ? info->second.FileId : number;
      ++(isTurned ? turned : kept);
    }
    if (turned > 0 && kept == 0)
    {
      result.Face = result.Turned++ == 0 ? number : result.Face;
    }
    result.Kept += kept > 0 && turned == 0 ? 1 : 0;
  }
  return result;
}
}

void ReportTurnedShells(const RepairLog& log, Document& document)
{
  std::unordered_set<const TopoDS_TShape*> sound;
  for (const TopoDS_Shape& shape : log.ReversedBodies)
  {
    sound.insert(shape.TShape().get());
  }
  std::set<int> whole;
  for (const PartBody& body : document.Bodies)
  {
    if (!body.Solid || (log.Sides.empty() && sound.empty()))
    {
      continue;
    }
    const TurnedShells shells = FindTurnedShells(log, document, body.Shape);
    if (shells.Turned > 0 && shells.Kept > 0)
    {
      document.Defects.push_back("In solid #" + std::to_string(body.FileId) +
        " of the file a shell is inside out, that with face #" + std::to_string(shells.Face) +
        ": OpenCASCADE turned it, against what the file says. Correct the file.");
    }
    else if (shells.Turned > 0 || sound.count(body.Shape.TShape().get()) > 0)
    {
      whole.insert(body.FileId);
    }
  }
  if (!whole.empty())
  {
    document.Messages.push_back(FormatCount(whole.size(), "solid is", "solids are") +
      " inside out in the file, and turned: #" + std::to_string(*whole.begin()) +
      (whole.size() > 1 ? ", .." : "") + ".");
  }
}
}
