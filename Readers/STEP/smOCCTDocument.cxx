#include "smOCCTDocument.h"

#include "smLengthUnits.h"
#include "smMemoryBuffer.h"
#include "smOCCTAssemblies.h"
#include "smOCCTCompatibility.h"
#include "smOCCTContradictions.h"
#include "smOCCTDamage.h"
#include "smOCCTFailure.h"
#include "smOCCTFile.h"
#include "smOCCTModel.h"
#include "smOCCTParameterCurves.h"
#include "smOCCTProducts.h"
#include "smOCCTRecords.h"
#include "smOCCTRepair.h"
#include "smOCCTTable.h"
#include "smOCCTTrimmedCurves.h"
#include "smOCCTTurnedShells.h"
#include "smPart21File.h"
#include "smPart21Remains.h"
#include "smPart21Unparsable.h"
#include "smSTEPDirect.h"
#include "smSTEPExplicit.h"
#include "smSTEPFaceStatements.h"
#include "smSTEPReconciliation.h"
#include "smSTEPTessellations.h"

#include "vtkTimerLog.h"

#include <STEPCAFControl_Reader.hxx>
#include <StepAP214_AppliedDocumentReference.hxx>
#include <StepBasic_HArray1OfDocument.hxx>
#include <StepBasic_ObjectRole.hxx>
#include <StepBasic_ProductDefinitionWithAssociatedDocuments.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_ToroidalSurface.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TDocStd_Document.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cmath>
#include <istream>
#include <memory>
#include <utility>

namespace sm
{
namespace
{
/// Fraction of the progress for parsing; the transfer takes the rest.
constexpr double ParsingShare = 0.3;

void Configure(STEPCAFControl_Reader& reader)
{
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  reader.SetMatMode(true);
  reader.SetPropsMode(true);
  reader.SetGDTMode(false);
  reader.SetViewMode(false);
  reader.SetSHUOMode(false);
}

/// Keeps the session from checking the entities of the model that it will read: the result is not used, and
/// the check takes half as long as the loading and does not survive all damage. After ComputeGraph() a
/// session takes the next model for checked.
void SkipChecks(const Handle(XSControl_WorkSession) & session)
{
  const Handle(StepData_StepModel) other = new StepData_StepModel();
  other->AddEntity(new StepBasic_ObjectRole());
  session->SetModel(other);
  session->ComputeGraph(true);
}

/// Reads the entities of the file. `completed` gets what was made explicit for OpenCASCADE. Returns false,
/// with document.Problem, if OpenCASCADE cannot.
bool Parse(const FileCheck& check, const Part21File& file, const std::vector<bool>& unparsable,
  STEPCAFControl_Reader& reader, STEPExplicit& completed, Document& document)
{
  // Behind damage OpenCASCADE's lexer loses more than the census does, or makes entities of it that crash its
  // translation.
  std::string remains = GetRemains(file, unparsable);
  Part21File sound;
  const bool isBroken = !remains.empty() && sound.Parse(std::move(remains));
  const Part21File& whole = isBroken ? sound : file;
  completed = MakeSTEPExplicit(whole);
  Part21File changed;
  const bool isChanged = !completed.Text.empty() && changed.Parse(std::move(completed.Text));
  const Part21File& complete = isChanged ? changed : whole;
  std::string replaced = ReplaceUndefinedReferences(complete);
  Part21File bounded;
  const bool isBounded = !replaced.empty() && bounded.Parse(std::move(replaced));
  const Part21File& text = isBounded ? bounded : complete;
  // If OpenCASCADE knows tessellations, KernelSession has a setting by which it skips them.
  KernelRecords records;
  const bool isPlain = records.Make(text,
    KernelReadsTessellations ? std::vector<bool>(text.GetTypeNames().size()) : FindTessellationTypes(text));
  const std::string reduced = isPlain || KernelReadsTessellations ? std::string() : RemoveTessellations(text);
  MemoryBuffer buffer(reduced.empty() ? text.GetText().substr(isBroken ? 0 : check.JunkBytes) : reduced);
  std::istream stream(&buffer);
  const Handle(XSControl_WorkSession) session = reader.Reader().WS();
  const Handle(IFSelect_WorkLibrary) library = session->WorkLibrary();
  SkipChecks(session);
  session->SetLibrary(isPlain ? MakeRecordLibrary(records) : library);
  const IFSelect_ReturnStatus status = reader.ChangeReader().ReadStream("STEP", stream);
  session->SetLibrary(library);
  if (status != IFSelect_RetDone)
  {
    document.Problem = std::string("OpenCASCADE cannot parse it") +
      (check.Truncated ? "; it ends in the middle: copy or export it again" : "; export it again");
    return false;
  }
  return true;
}

/// Switches off the reading of attributes whose entities are damaged, on which OpenCASCADE would crash.
void SkipDamagedAttributes(const ModelEntities& entities, STEPCAFControl_Reader& reader, Document& document)
{
  const Attributes damaged = FindDamagedAttributes(entities);
  if (damaged.Colors)
  {
    reader.SetColorMode(false);
    document.Messages.push_back("Entities of its colours are damaged: colours were not read.");
  }
  if (damaged.Properties)
  {
    reader.SetPropsMode(false);
    reader.SetMatMode(false);
    document.Messages.push_back(
      "Entities of its properties are damaged: volumes and materials it states were not read.");
  }
}

/**
 * Replaces a negative major radius of a torus by the positive one and reverses its faces: this is the same
 * surface with the opposite normal. OpenCASCADE would reverse the loops of such a face but not the face.
 */
void TurnNegativeTori(const ModelEntities& entities)
{
  std::vector<Handle(StepGeom_ToroidalSurface)> negative;
  entities.ForEach<StepShape_FaceSurface>(
    [&negative](const Handle(StepShape_FaceSurface) & face)
    {
      const auto torus = Handle(StepGeom_ToroidalSurface)::DownCast(GetBasisOfFace(face));
      if (!torus.IsNull() && torus->MajorRadius() < 0.0)
      {
        face->SetSameSense(!face->SameSense());
        negative.push_back(torus);
      }
    });
  for (const Handle(StepGeom_ToroidalSurface) & torus : negative)
  {
    torus->SetMajorRadius(std::abs(torus->MajorRadius()));
  }
}

/// Keeps OpenCASCADE from reading other files, which it would seek in the working directory: their bodies
/// would have numbers that are none of this file, and nothing would show whether they are complete.
/// Reconcile() reports the products that lack them.
void ForgetOtherFiles(const ModelEntities& entities)
{
  entities.ForEach<StepBasic_ProductDefinitionWithAssociatedDocuments>(
    [](const Handle(StepBasic_ProductDefinitionWithAssociatedDocuments) & definition)
    { definition->SetDocIds(nullptr); });
  for (const int i : entities.Find({ STANDARD_TYPE(StepAP214_AppliedDocumentReference) }))
  {
    entities.GetModel()->ReplaceEntity(i, new StepBasic_ObjectRole);
  }
}

/// Sets the status after the transfer, by the bodies that it made.
void Conclude(const ModelEntities& entities, Document& document)
{
  if (!document.Bodies.empty())
  {
    document.Status = ReadStatus::Ok;
  }
  else if (HasGeometry(entities))
  {
    document.Problem =
      "it has faces, but OpenCASCADE makes no shape of them: its product structure or its geometry "
      "is malformed; export it again";
  }
  else
  {
    document.Status = ReadStatus::Empty;
    document.Problem =
      "it has no solid, shell or face; export the part as a boundary representation (AP203, AP214 "
      "or AP242)";
  }
}

/// The text of the file, and its census.
struct DeclaredContent
{
  Part21File Text;
  STEPCensus Census;
  std::unordered_map<std::uint64_t, std::string> Perils;
  std::vector<bool> Unparsable;
  /// Entities with references that lead nowhere, for which OpenCASCADE's parser gives no message with the
  /// entity: it has a null for them.
  std::unordered_map<std::uint64_t, const char*> BrokenReferences;

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
    this->Unparsable = FindUnparsable(this->Text);
    for (const CensusProblem& peril : this->Census.Perils)
    {
      this->Perils.emplace(
        peril.Id, std::string(GetName(peril.Defect)) + (*peril.Place ? ", " : "") + peril.Place);
    }
    for (Part21File::Index i = 0; i < this->Text.GetNumberOfInstances(); ++i)
    {
      for (const Part21File::Index to : this->Text.GetReferences(i))
      {
        if (to == Part21File::None || this->Text.IsMalformed(to) ||
          (!this->Unparsable.empty() && this->Unparsable[to]))
        {
          this->BrokenReferences.emplace(this->Text.GetId(i),
            to == Part21File::None ? "undefined reference" : "reference to a damaged entity");
        }
      }
    }
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

  /// Returns a message about an oriented edge that is part of itself; empty if there is none. Such a file is
  /// not given to OpenCASCADE.
  std::string FindCycle() const
  {
    for (const CensusProblem& peril : this->Census.Perils)
    {
      const std::uint32_t type = this->Text.GetType(this->Text.Find(peril.Id));
      if (peril.Defect == CensusDefect::CyclicReference && this->Text.GetTypeNames()[type] == "ORIENTED_EDGE")
      {
        return "its entity #" + std::to_string(peril.Id) + " is part of itself (cyclic reference to #" +
          std::to_string(peril.Other) + "); export it again";
      }
    }
    return {};
  }

  /// Returns a message about a file whose bodies are all of kinds that are not supported, though valid; empty
  /// for others. OpenCASCADE has no types for some of them and would call them damaged.
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

  /// Returns a message about an entity that bodies depend on and whose number is too long for OpenCASCADE;
  /// empty if there is none.
  std::string FindLongNumber() const
  {
    for (Part21File::Index i = 0; i < this->Text.GetNumberOfInstances(); ++i)
    {
      if (this->Text.GetId(i) > LargestParsedNumber && this->Census.Uses[i] != 0)
      {
        return "the number of its entity #" + std::to_string(this->Text.GetId(i)) + " exceeds " +
          std::to_string(LargestParsedNumber) + ", the largest one that is read; number its entities anew";
      }
    }
    return {};
  }

  /// Returns a message about entities that are nested too deeply for OpenCASCADE, which recurses over them;
  /// empty if there are none.
  std::string FindDeepNesting() const
  {
    const std::string limit = ", and at most " + std::to_string(MostLevels) + " are read; export ";
    if (this->Census.Assemblies.Levels > MostLevels)
    {
      return "its assemblies are nested in " + std::to_string(this->Census.Assemblies.Levels) +
        " levels (down to entity #" + std::to_string(this->Census.Assemblies.Id) + ")" + limit +
        "its sub-assemblies one by one";
    }
    if (this->Census.Geometry.Levels > MostLevels)
    {
      return "its entity #" + std::to_string(this->Census.Geometry.Id) + " refers to others in " +
        std::to_string(this->Census.Geometry.Levels) + " levels" + limit + "it again";
    }
    return {};
  }

  /// Returns the reason why OpenCASCADE cannot process the entity; empty if it can.
  std::string GetPeril(int id, bool isPlacing) const
  {
    const auto number = static_cast<std::uint64_t>(std::max(id, 0));
    const auto peril = this->Perils.find(number);
    const auto reference = this->BrokenReferences.find(number);
    return peril != this->Perils.end()                          ? peril->second
      : reference != this->BrokenReferences.end() && !isPlacing ? reference->second
                                                                : "";
  }

  /// Returns true if a body, its placement or its unit depends on the entity.
  bool Matters(int id) const
  {
    const Part21File::Index index =
      id > 0 ? this->Text.Find(static_cast<std::uint64_t>(id)) : Part21File::None;
    return index == Part21File::None || this->Census.Uses[index] != 0;
  }
};

/// Takes the sound faces, defects and messages of the repairs over into the document.
void ApplyLog(const RepairLog& log, Document& document)
{
  for (const auto& [shape, face] : log.SoundFaces)
  {
    document.Table[shape].AsInFile = face;
  }
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

/// Transfers all shapes of the file; returns false if `progress` stopped it.
bool Transfer(STEPCAFControl_Reader& reader, Handle(TDocStd_Document) & xde, RepairMode repair,
  const ProgressCallback& progress, Document& document, RepairLog& log)
{
  const Handle(KernelProgress) indicator =
    new KernelProgress([&progress](double x) { return progress(ParsingShare + (1.0 - ParsingShare) * x); });
  {
    const auto label = [&reader](const TopoDS_Shape& shape)
    { return GetShapeLabel(reader.Reader().WS(), shape); };
    const std::unique_ptr<RepairOnNeed> selective =
      repair == RepairMode::OnNeed ? std::make_unique<RepairOnNeed>(log, label) : nullptr;
    const std::unique_ptr<RepairAlways> full =
      repair == RepairMode::Always ? std::make_unique<RepairAlways>(log, label) : nullptr;
    reader.Transfer(xde, indicator->Start());
  }
  indicator->Rethrow();
  ApplyLog(log, document);
  return progress(1.0);
}

/// Reads the file without OpenCASCADE's reader. Returns false if that has to read it.
bool ReadDirectly(const DeclaredContent& declared, RepairMode repair, const ProgressCallback& progress,
  double start, Document& document)
{
  RepairLog log;
  bool isAborted = false;
  const double parsed = vtkTimerLog::GetUniversalTime() - start;
  const std::string reason =
    ReadSTEPDirectly(declared.Text, declared.Census, repair, progress, document, log, isAborted);
  if (!reason.empty())
  {
    return false;
  }
  if (isAborted)
  {
    document.Status = ReadStatus::Aborted;
    return true;
  }
  document.ParseSeconds = parsed;
  ApplyLog(log, document);
  ReportTurnedShells(log, document);
  Reconcile(declared.Census, document);
  document.Statements = ReadFaceStatements(declared.Text, declared.Census);
  document.Status = document.Bodies.empty() ? ReadStatus::Empty : ReadStatus::Ok;
  return true;
}

void Read(std::string content, const FileCheck& check, RepairMode repair, ReaderMode mode,
  const ProgressCallback& progress, Document& document)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const DeclaredContent declared(std::move(content), document);
  const CensusCount instances = CountDeclaredInstances(declared.Census);
  if (instances > MaxInstances)
  {
    document.Problem = "it declares " +
      (instances == CensusMaximum ? "more than 10^19" : std::to_string(instances)) +
      " instances of bodies and sub-assemblies, and at most " + std::to_string(MaxInstances) +
      " are read; export its sub-assemblies one by one";
    return;
  }
  document.Problem = declared.FindCycle();
  document.Problem = document.Problem.empty() ? declared.FindDeepNesting() : document.Problem;
  document.Problem = document.Problem.empty() ? declared.FindLongNumber() : document.Problem;
  document.Problem = document.Problem.empty() ? declared.FindUnsupported() : document.Problem;
  if (!document.Problem.empty())
  {
    return;
  }
  const KernelSession kernel;
  if (mode == ReaderMode::Direct && ReadDirectly(declared, repair, progress, start, document))
  {
    return;
  }
  STEPCAFControl_Reader reader;
  Configure(reader);
  STEPExplicit completed;
  if (!Parse(check, declared.Text, declared.Unparsable, reader, completed, document))
  {
    return;
  }
  if (!progress(ParsingShare))
  {
    document.Status = ReadStatus::Aborted;
    return;
  }
  const ModelEntities entities(Handle(StepData_StepModel)::DownCast(reader.Reader().WS()->Model()));
  document.FileUnit = ReadLengthUnit(reader.ChangeReader(), entities, document.Messages);
  const double factor = GetUnitInMillimetres(document.FileUnit);
  const auto used = std::find_if(declared.Census.Contexts.begin(), declared.Census.Contexts.end(),
    [](const CensusContext& context)
    { return context.Used && context.Length.Status == CensusUnit::State::Stated; });
  // A unit whose name is not known ("SMOOT") has its size in the file.
  document.FileUnitInMillimetres = factor > 0.0 ? factor
    : used != declared.Census.Contexts.end()    ? used->Length.Factor
                                                : 1.0;
  const std::vector<Handle(Standard_Transient)> operators = CheckOperators(entities, document.Messages);
  LostFaces lost;
  const EntityFilter matters = [&declared](int id) { return declared.Matters(id); };
  const EntityPeril getPeril = [&declared](int id, bool isPlacing)
  { return declared.GetPeril(id, isPlacing); };
  const bool hasPerils = !declared.Perils.empty() || !declared.BrokenReferences.empty();
  document.Problem = DropDamagedFaces(
    reader.Reader().WS(), entities, matters, hasPerils ? getPeril : EntityPeril(), document.Messages, lost);
  if (!document.Problem.empty())
  {
    return;
  }
  SkipDamagedAttributes(entities, reader, document);
  CheckSpindleTori(entities, document.Defects);
  CheckShortArcs(entities, document.FileUnitInMillimetres, document.Messages, document.Defects);
  CheckCompositeEdges(entities, matters, document.Messages);
  const bool isAngleKnown =
    used != declared.Census.Contexts.end() && used->Angle.Status == CensusUnit::State::Stated;
  const double angle = isAngleKnown ? used->Angle.Factor : 1.0;
  CheckApexes(entities, document.FileUnitInMillimetres, angle, matters, document.Defects);
  CheckParameterCurves(
    entities, document.FileUnitInMillimetres, angle, matters, document.Messages, document.Defects);
  FlattenTrims(entities);
  KeepRevolvedConics(entities, angle);
  TurnNegativeTori(entities);
  ForgetOtherFiles(entities);
  ClearClosedFlags(entities);
  ShortenAssemblies(reader.Reader().WS(), entities);
  document.ParseSeconds = vtkTimerLog::GetUniversalTime() - start;
  Handle(TDocStd_Document) xde = new TDocStd_Document("BinXCAF");
  SetMillimetres(xde);
  RepairLog log;
  if (!Transfer(reader, xde, repair, progress, document, log))
  {
    document.Status = ReadStatus::Aborted;
    return;
  }
  const Handle(XSControl_WorkSession) session = reader.Reader().WS();
  FillTable(session, xde, lost, document.Table);
  const bool found = operators.empty() || MarkMisplaced(session, operators, document.Table);
  AddProducts(xde, document);
  for (PartBody& body : document.Bodies)
  {
    body.Misplaced = body.Misplaced || !found;
  }
  ReportTurnedShells(log, document);
  Reconcile(declared.Census, document);
  document.Statements = ReadFaceStatements(declared.Text, declared.Census);
  CompareUnits(entities, completed.Contexts, document.Defects);
  for (const STEPDoubt& doubt : completed.Doubts)
  {
    if (declared.Matters(static_cast<int>(doubt.Id)))
    {
      document.Defects.push_back(
        "Entity #" + std::to_string(doubt.Id) + " of the file: " + doubt.Reason + ". Export the file again.");
    }
  }
  Conclude(entities, document);
}
}

Document ReadSTEP(std::string content, RepairMode repair, ReaderMode reader, const ProgressCallback& progress)
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
    CatchFailure([&]() { Read(std::move(content), check, repair, reader, progress, document); });
  if (!failure.empty())
  {
    document.Status = ReadStatus::Unreadable;
    document.Problem = "it could not be read (" + failure + "); export it again";
  }
  return document;
}
}
