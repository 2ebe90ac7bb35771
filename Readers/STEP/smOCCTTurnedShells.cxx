#include "smOCCTTurnedShells.h"

#include "smFormat.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_TShape.hxx>

#include <set>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace sm
{
namespace
{
/// A shell of a repaired solid by what the repair did with the sides of all its faces.
struct RepairedShell
{
  bool IsTurned = false;
  bool IsKept = false;
  /// Entity number of a face.
  int Face = 0;
  /// The file's shells that its faces come from.
  std::unordered_set<const TopoDS_TShape*> Sources;
};

struct TurnedShells
{
  int Turned = 0;
  int Kept = 0;
  /// Reversed shells that the file has as such, so that it says which is the outer one and which are voids.
  /// Others were parts of one shell.
  int Declared = 0;
  /// Entity number of a face of the first reversed shell that is not declared, else of the first one.
  int Face = 0;
};

RepairedShell ExamineShell(const RepairLog& log, const Document& document, const TopoDS_Shape& shell)
{
  RepairedShell result;
  int turned = 0;
  int kept = 0;
  for (TopExp_Explorer face(shell, TopAbs_FACE); face.More(); face.Next())
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
    result.Face = result.Face == 0 && info != document.Table.end() ? info->second.FileId : result.Face;
    result.Sources.insert(before->second.Shell.TShape().get());
    ++(isTurned ? turned : kept);
  }
  result.IsTurned = turned > 0 && kept == 0;
  result.IsKept = kept > 0 && turned == 0;
  return result;
}

TurnedShells FindTurnedShells(const RepairLog& log, const Document& document, const TopoDS_Shape& solid)
{
  std::vector<RepairedShell> shells;
  std::unordered_map<const TopoDS_TShape*, int> parts;
  for (TopExp_Explorer shell(solid, TopAbs_SHELL); shell.More(); shell.Next())
  {
    shells.push_back(ExamineShell(log, document, shell.Current()));
    for (const TopoDS_TShape* source : shells.back().Sources)
    {
      ++parts[source];
    }
  }
  TurnedShells result;
  for (const RepairedShell& shell : shells)
  {
    result.Kept += shell.IsKept ? 1 : 0;
    if (!shell.IsTurned)
    {
      continue;
    }
    const bool isDeclared = shell.Sources.size() == 1 && parts[*shell.Sources.begin()] == 1;
    const bool isFirst = isDeclared ? result.Turned == 0 : result.Turned == result.Declared;
    result.Face = isFirst ? shell.Face : result.Face;
    ++result.Turned;
    result.Declared += isDeclared ? 1 : 0;
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
    if (shells.Declared > 0 && shells.Turned == shells.Declared && shells.Kept > 0)
    {
      document.Messages.push_back(FormatCount(shells.Turned, "shell of solid", "shells of solid") + " #" +
        std::to_string(body.FileId) + (shells.Turned > 1 ? " are" : " is") +
        " inside out in the file, and reversed, that with face #" + std::to_string(shells.Face) +
        (shells.Turned > 1 ? " first." : "."));
    }
    else if (shells.Turned > 0 && shells.Kept > 0)
    {
      document.Defects.push_back("In solid #" + std::to_string(body.FileId) +
        " of the file a shell is inside out, that with face #" + std::to_string(shells.Face) +
        ": OpenCASCADE reversed it, against what the file states. Correct the file.");
    }
    else if (shells.Turned > 0 || sound.count(body.Shape.TShape().get()) > 0)
    {
      whole.insert(body.FileId);
    }
  }
  if (!whole.empty())
  {
    document.Messages.push_back(FormatCount(whole.size(), "solid is", "solids are") +
      " inside out in the file, and reversed: #" + std::to_string(*whole.begin()) +
      (whole.size() > 1 ? ", .." : "") + ".");
  }
}
}
