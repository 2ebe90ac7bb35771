#include "smReversedShells.h"

#include "smFormat.h"

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
  bool IsReversed = false;
  bool IsKept = false;
  /// Entity number of a face.
  std::int64_t Face = 0;
  /// The file's shells that its faces come from.
  std::unordered_set<const ShellShape*> Sources;
};

struct ReversedShells
{
  int Reversed = 0;
  int Kept = 0;
  /// Reversed shells that the file has as such, so that it says which is the outer one and which are voids.
  /// Others were parts of one shell.
  int Declared = 0;
  /// Entity number of a face of the first reversed shell that is not declared, else of the first one.
  std::int64_t Face = 0;
};

RepairedShell ExamineShell(const RepairLog& log, const ShellUse& shell)
{
  RepairedShell result;
  int reversed = 0;
  int kept = 0;
  for (const FaceUse& use : shell.Shell->Faces)
  {
    const auto before = log.Sides.find(use.Face->Source.get());
    if (before == log.Sides.end())
    {
      continue;
    }
    const bool isReversed = before->second.Reversed != (use.Reversed != shell.Reversed);
    result.Face = result.Face == 0 ? use.Face->Data.FileId : result.Face;
    result.Sources.insert(before->second.Shell.get());
    ++(isReversed ? reversed : kept);
  }
  result.IsReversed = reversed > 0 && kept == 0;
  result.IsKept = kept > 0 && reversed == 0;
  return result;
}

ReversedShells FindReversedShells(const RepairLog& log, const BodyShape& solid)
{
  std::vector<RepairedShell> shells;
  std::unordered_map<const ShellShape*, int> parts;
  for (const ShellUse& shell : solid.Shells)
  {
    shells.push_back(ExamineShell(log, shell));
    for (const ShellShape* source : shells.back().Sources)
    {
      ++parts[source];
    }
  }
  ReversedShells result;
  for (const RepairedShell& shell : shells)
  {
    result.Kept += shell.IsKept ? 1 : 0;
    if (!shell.IsReversed)
    {
      continue;
    }
    const bool isDeclared = shell.Sources.size() == 1 && parts[*shell.Sources.begin()] == 1;
    const bool isFirst = isDeclared ? result.Reversed == 0 : result.Reversed == result.Declared;
    result.Face = isFirst ? shell.Face : result.Face;
    ++result.Reversed;
    result.Declared += isDeclared ? 1 : 0;
  }
  return result;
}
}

void ReportReversedShells(const RepairLog& log, Document& document)
{
  std::unordered_set<const ShellShape*> sound;
  for (const ShellPointer& shell : log.ReversedShells)
  {
    sound.insert(shell.get());
  }
  std::set<std::int64_t> whole;
  for (const PartBody& body : document.Bodies)
  {
    if (!body.Solid || (log.Sides.empty() && sound.empty()))
    {
      continue;
    }
    const ReversedShells shells = FindReversedShells(log, body.Shape);
    if (shells.Declared > 0 && shells.Reversed == shells.Declared && shells.Kept > 0)
    {
      document.Messages.push_back(FormatCount(shells.Reversed, "shell of solid", "shells of solid") + " #" +
        std::to_string(body.FileId) + (shells.Reversed > 1 ? " are" : " is") +
        " inside out in the file, and reversed, that with face #" + std::to_string(shells.Face) +
        (shells.Reversed > 1 ? " first." : "."));
    }
    else if (shells.Reversed > 0 && shells.Kept > 0)
    {
      document.Defects.push_back("In solid #" + std::to_string(body.FileId) +
        " of the file a shell is inside out, that with face #" + std::to_string(shells.Face) +
        ": OpenCASCADE reversed it, against what the file states. Correct the file.");
    }
    else if (shells.Reversed > 0 || sound.count(body.Shape.Shells.front().Shell.get()) > 0)
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
