#include "smDocument.h"

#include "smCatchFailure.h"
#include "smFile.h"
#include "smHiddenBodies.h"
#include "smPart21File.h"
#include "smRepair.h"
#include "smReversedShells.h"
#include "smSTEPCensusReport.h"
#include "smSTEPDirect.h"
#include "smSTEPDoubts.h"
#include "smSTEPFaceStatements.h"
#include "smSTEPTolerances.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <memory>
#include <utility>

namespace sm
{
namespace
{
/// Numbers of bodies and faces are signed.
constexpr std::uint64_t MaxNumber = std::numeric_limits<std::int64_t>::max();

/// The text of the file, and its census.
struct DeclaredContent
{
  Part21File Text;
  STEPCensus Census;

  DeclaredContent(std::string content, Document& document)
  {
    if (!this->Text.Parse(std::move(content)))
    {
      document.Defects.push_back("What the file declares could not be checked: its text could not be read.");
    }
    this->ReportUnread(Part21Defect::BehindEnd, "entities stand behind its end, END-ISO-10303-21", document);
    this->ReportUnread(Part21Defect::UnreadInstance,
      "text with numbers of entities is outside of all entities, or in a section that has none", document);
    this->Census = TakeSTEPCensus(this->Text);
  }

  /// Adds a defect with the first line of the file that has the problem, if one has.
  void ReportUnread(Part21Defect defect, const char* what, Document& document) const
  {
    const std::vector<Part21Problem>& problems = this->Text.GetProblems();
    const auto first = std::find_if(
      problems.begin(), problems.end(), [defect](const Part21Problem& p) { return p.Defect == defect; });
    if (first != problems.end())
    {
      document.Defects.push_back("Line " + std::to_string(this->Text.GetLine(first->Offset)) +
        " of the file: " + what + ", and was not read; export the file again.");
    }
  }

  /// Returns a message about a file whose bodies are all of kinds that are not supported, though valid; empty
  /// for others.
  std::string FindUnsupported() const
  {
    const CensusBody* first = nullptr;
    for (const CensusBody& body : this->Census.Bodies)
    {
      if (body.Kind == CensusBodyKind::Solid || body.Kind == CensusBodyKind::SurfaceModel)
      {
        return {};
      }
      const bool isBody = body.Kind == CensusBodyKind::OtherSolid ||
        (body.Kind == CensusBodyKind::Tessellated &&
          (body.Type.find("TESSELLATED_SOLID") != std::string::npos ||
            body.Type.find("TESSELLATED_SHELL") != std::string::npos));
      first = !first && isBody ? &body : first;
    }
    if (!first)
    {
      return {};
    }
    const auto has = [first](const char* word) { return first->Type.find(word) != std::string::npos; };
    const std::string what = first->Kind == CensusBodyKind::Tessellated ? "triangles only"
      : has("CSG") || has("BOOLEAN") ? "only constructive solid geometry (CSG), which is not supported"
      : has("SWEPT") || has("EXTRUDED") || has("REVOLVED") ? "only swept solids, which are not supported"
                                                           : "only solids of kinds that are not supported";
    return "it has " + what + ": body #" + std::to_string(first->Id) + " is of the type " + first->Type +
      "; export it as a boundary representation (AP203, AP214 or AP242)";
  }

  /// Returns a message about an entity that bodies depend on and whose number does not fit into the data of
  /// bodies and faces; empty if there is none.
  std::string FindLongNumber() const
  {
    for (Part21File::Index i = 0; i < this->Text.GetNumberOfInstances(); ++i)
    {
      if (this->Text.GetId(i) > MaxNumber && this->Census.Uses[i] != 0)
      {
        return "the number of its entity #" + std::to_string(this->Text.GetId(i)) + " exceeds " +
          std::to_string(MaxNumber) + ", the largest one that is read; number its entities anew";
      }
    }
    return {};
  }

  /// Returns a message about entities that are nested too deeply, for reading recurses over them; empty if
  /// there are none.
  std::string FindDeepNesting() const
  {
    const std::string limit = ", and at most " + std::to_string(MaxLevels) + " are read; export ";
    if (this->Census.Assemblies.Levels > MaxLevels)
    {
      return "its assemblies are nested in " + std::to_string(this->Census.Assemblies.Levels) +
        " levels (down to entity #" + std::to_string(this->Census.Assemblies.Id) + ")" + limit +
        "its sub-assemblies one by one";
    }
    if (this->Census.Geometry.Levels > MaxLevels)
    {
      return "its entity #" + std::to_string(this->Census.Geometry.Id) + " refers to others in " +
        std::to_string(this->Census.Geometry.Levels) + " levels" + limit + "it again";
    }
    return {};
  }

  /// Returns true if a body, its placement or its unit depends on the entity.
  bool Matters(std::uint64_t id) const { return this->Census.Uses[this->Text.Find(id)] != 0; }
};

/// Takes the defects and messages of the repairs over into the document.
void ApplyLog(const RepairLog& log, Document& document)
{
  for (const std::string& face : log.FoldedFaces)
  {
    document.Defects.push_back("The sense of " + face +
      " of the file contradicts its neighbours: the face folds back at their common edges. The other part of "
      "its surface may be meant.");
  }
  for (const std::string& face : log.OutsideFaces)
  {
    document.Defects.push_back("The direction of the loops of " + face +
      " of the file selects the part of its surface outside them. OpenCASCADE's repair may have taken the "
      "part "
      "inside.");
  }
  document.TrimSeconds = log.Seconds;
  for (std::string& message : Describe(log))
  {
    document.Messages.push_back(std::move(message));
  }
}

/// Sets the status by the bodies that were read.
void Conclude(const STEPCensus& census, Document& document)
{
  if (!document.Bodies.empty())
  {
    document.Status = ReadStatus::Ok;
    return;
  }
  // Without bodies nothing else passes the defects on.
  std::vector<std::string>& said = document.Messages;
  said.insert(said.end(), document.Defects.begin(), document.Defects.end());
  if (!census.Faces.empty())
  {
    document.Problem = "it has faces, but no shape can be made of them" +
      (said.empty() ? std::string() : " (" + said.front() + ")") + "; export it again";
  }
  else
  {
    document.Status = ReadStatus::Empty;
    document.Problem =
      "it has no solid, shell or face; export the part as a boundary representation (AP203, AP214 "
      "or AP242)";
  }
}

/// Returns the tolerances of the drawing that a file states.
std::vector<DrawingTolerance> ListTolerances(const Part21File& file)
{
  std::vector<DrawingTolerance> list;
  for (const STEPTolerance& given : ReadSTEPTolerances(file))
  {
    const bool isKnown = given.Problem.empty();
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    list.push_back(
      { static_cast<std::int64_t>(given.Id), given.Kind, { given.Faces.begin(), given.Faces.end() },
        given.IsForAll, isKnown ? given.Lower : unknown, isKnown ? given.Upper : unknown, given.Problem });
  }
  return list;
}

void Read(std::string content, RepairMode repair, HiddenMode hidden, const ProgressCallback& progress,
  Document& document)
{
  const double start = vtkTimerLog::GetUniversalTime();
  DeclaredContent declared(std::move(content), document);
  const CensusCount instances = declared.Census.CountNodes();
  if (instances > MaxInstances)
  {
    document.Problem = "it declares " +
      (instances == CensusMaximum ? "more than 10^19" : std::to_string(instances)) +
      " instances of bodies and sub-assemblies, and at most " + std::to_string(MaxInstances) +
      " are read; export its sub-assemblies one by one";
    return;
  }
  document.Problem = declared.FindDeepNesting();
  document.Problem = document.Problem.empty() ? declared.FindLongNumber() : document.Problem;
  document.Problem = document.Problem.empty() ? declared.FindUnsupported() : document.Problem;
  if (!document.Problem.empty())
  {
    return;
  }
  RepairLog log;
  document.ParseSeconds = vtkTimerLog::GetUniversalTime() - start;
  if (!ReadSTEPDirectly(declared.Text, declared.Census, repair, hidden, progress, document, log))
  {
    document.Status = ReadStatus::Aborted;
    return;
  }
  ApplyLog(log, document);
  ReportReversedShells(log, document);
  ReportCensus(declared.Census, document);
  for (const STEPDoubt& doubt : FindSTEPDoubts(STEPAttributes(declared.Text)))
  {
    if (declared.Matters(doubt.Id))
    {
      document.Defects.push_back(
        "Entity #" + std::to_string(doubt.Id) + " of the file: " + doubt.Reason + ". Export the file again.");
    }
  }
  document.Statements = ReadFaceStatements(declared.Text, declared.Census);
  for (const std::uint64_t face : document.ReversedFaces)
  {
    document.Statements[face].IsForward = !document.Statements[face].IsForward;
  }
  document.Tolerances = ListTolerances(declared.Text);
  LeaveOutHidden(hidden, document);
  if (document.Problem.empty())
  {
    Conclude(declared.Census, document);
  }
}
}

Document ReadSTEP(std::string content, RepairMode repair, HiddenMode hidden, const ProgressCallback& progress)
{
  Document document;
  const FileCheck check = CheckText(content);
  if (!check.Readable)
  {
    document.Problem = check.Problem;
    return document;
  }
  if (check.JunkBytes > 0)
  {
    document.Messages.push_back(std::to_string(check.JunkBytes) +
      " bytes before \"ISO-10303-21;\" do not belong to a STEP file and were skipped.");
  }
  if (check.Truncated)
  {
    document.Messages.push_back("The file does not end with END-ISO-10303-21: part of it may be missing.");
  }
  const std::string failure =
    CatchFailure([&]() { Read(std::move(content), repair, hidden, progress, document); });
  if (!failure.empty())
  {
    document.Status = ReadStatus::Unreadable;
    document.Problem = "it could not be read (" + failure + "); export it again";
  }
  return document;
}
}
