#include "vtkCADReaderInternals.h"

#include "smAbortFlag.h"
#include "smCatchFailure.h"
#include "smDocument.h"
#include "smFailureReason.h"
#include "smFile.h"
#include "smFileState.h"
#include "smFormat.h"
#include "smLengthUnits.h"
#include "smSTEPLeaf.h"
#include "smSTEPTree.h"

#include "vtkCommunicator.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace
{
/// Fraction of the progress for reading.
constexpr double ReadingShare = 0.5;

/**
 * Returns the rank that updates the first piece if all ranks of `controller` update this reader together,
 * each a different piece; -1 if they do not. An update with another number of pieces than ranks concerns this
 * rank alone, and the others take no part.
 */
int FindFirstPiece(vtkMultiProcessController* controller, int piece, int pieces)
{
  if (!controller || pieces < 2 || controller->GetNumberOfProcesses() != pieces)
  {
    return -1;
  }
  const int own = piece == 0 ? controller->GetLocalProcessId() : -1;
  int root = -1;
  return controller->AllReduce(&own, &root, 1, vtkCommunicator::MAX_OP) != 0 ? root : -1;
}
}

vtkCADReader::vtkCADReader()
  : Last(new Results)
{
  sm::ClearAbortAtStart(this);
  this->SetNumberOfInputPorts(0);
}

vtkCADReader::~vtkCADReader()
{
  this->SetFileName(nullptr);
}

const char* vtkCADReader::GetStatusAsString() const
{
  static const char* const words[] = { "ok", "empty", "unreadable", "aborted", "failed" };
  return words[this->Status];
}

std::string vtkCADReader::GetFileUnit() const
{
  return this->Last->FileUnit;
}

std::string vtkCADReader::GetLengthUnit() const
{
  return this->Last->LengthUnit;
}

int vtkCADReader::GetNumberOfMessages() const
{
  return static_cast<int>(this->Last->Messages.size());
}

std::string vtkCADReader::GetMessage(int index) const
{
  return index >= 0 && index < this->GetNumberOfMessages() ? this->Last->Messages[index] : std::string();
}

int vtkCADReader::GetNumberOfBodies() const
{
  return this->Last->Bodies;
}

int vtkCADReader::GetNumberOfInstances() const
{
  return this->Last->Instances;
}

int vtkCADReader::GetNumberOfFreeFaces() const
{
  return this->Last->FreeFaces;
}

double vtkCADReader::GetReadSeconds() const
{
  return this->Last->ReadSeconds;
}

double vtkCADReader::GetParseSeconds() const
{
  return this->Last->ParseSeconds;
}

double vtkCADReader::GetTransferSeconds() const
{
  return this->Last->ReadSeconds - this->Last->ParseSeconds - this->Last->TrimSeconds;
}

double vtkCADReader::GetTrimSeconds() const
{
  return this->Last->TrimSeconds;
}

double vtkCADReader::GetMeshSeconds() const
{
  return this->Last->MeshSeconds;
}

double vtkCADReader::GetConversionSeconds() const
{
  return this->Last->ConversionSeconds;
}

int vtkCADReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkCADReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // Every rank of a parallel run may request a piece; pieces after the first have no leaves.
  outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

bool vtkCADReader::Report(double fraction)
{
  this->UpdateProgress(fraction);
  this->IsTimeOver = this->IsTimeOver ||
    (this->MaximumSeconds > 0.0 && vtkTimerLog::GetUniversalTime() - this->Start > this->MaximumSeconds);
  return !this->IsTimeOver && !this->GetAbortExecute();
}

void vtkCADReader::Fail(int status, std::string_view problem) noexcept
{
  this->Status = status;
  this->SetErrorCode(vtkErrorCode::FileFormatError);
  sm::HasMemoryFor(
    [&]()
    {
      const std::string sentence = std::string("Cannot read ") +
        (this->FileName ? this->FileName : std::string("a ") + this->GetFormatName() + " file") + ": " +
        std::string(problem) + ".";
      this->Last->Messages.push_back(sentence);
      this->Last->Problem = sentence;
      vtkErrorMacro(<< sentence);
    });
}

void vtkCADReader::Stop()
{
  this->Status = ABORTED;
  this->Last->Problem = std::string("Reading ") + (this->FileName ? this->FileName : "the content") +
    " was stopped" + (this->IsTimeOver ? ": the maximum seconds were over." : ".");
  if (this->IsTimeOver)
  {
    this->Last->Messages.push_back(this->Last->Problem);
  }
}

int vtkCADReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(info->Get(vtkDataObject::DATA_OBJECT()));
  if (!this->IsReadingCurrent())
  {
    this->Kept.reset();
  }
  this->SettledTime = this->GetMTime();
  this->HasMesh = this->IsMeshWanted();
  this->IsMeshDue = false;
  this->MeshIsCoarse = false;
  *this->Last = Results();
  this->Status = EMPTY;
  this->Start = vtkTimerLog::GetUniversalTime();
  this->IsTimeOver = false;
  this->SetErrorCode(vtkErrorCode::NoError);
  const int piece = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const int pieces = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int root = FindFirstPiece(controller, piece, pieces);
  if (piece == 0)
  {
    this->ReadGuarded(output);
  }
  else
  {
    this->Status = OK;
  }
  std::string_view problem;
  if (root >= 0)
  {
    problem = this->ShareTree(controller, root, output);
  }
  else if (!sm::HasMemoryFor([&]() { this->WriteState(output); }))
  {
    problem = sm::InsufficientMemory;
  }
  if (!problem.empty())
  {
    output->Initialize();
    this->Kept.reset();
    *this->Last = Results();
    this->Fail(FAILED, problem);
    sm::HasMemoryFor([&]() { this->WriteState(output); });
  }
  if (this->GetReleaseDataFlag() || vtkDataObject::GetGlobalReleaseDataFlag())
  {
    this->Kept.reset();
  }
  // A failed update would leave the results of the previous file in the filters downstream.
  return 1;
}

bool vtkCADReader::IsReadingCurrent()
{
  // If the application has edited a model in place, the file is read again.
  if (!this->Kept || this->GetMTime() > this->SettledTime)
  {
    return false;
  }
  const bool isAsRead = this->Kept->FindModelTime() == this->Kept->ModelTime;
  if (!isAsRead)
  {
    vtkWarningMacro("The file is read again: models of the output were edited in place, which is lost.");
  }
  return isAsRead;
}

void vtkCADReader::WriteState(vtkPartitionedDataSetCollection* output) const
{
  sm::CheckMemory(sm::SpareMemory);
  sm::FileState state{ this->GetStatusAsString(), this->Last->Problem, this->Last->Defects, {} };
  const std::vector<std::string>& defects = state.Defects;
  for (const std::string& message : this->Last->Messages)
  {
    // The models have the messages about single bodies, which begin like this (LeafMaker).
    const bool isOfBody = message.rfind("Body \"", 0) == 0;
    if (!isOfBody && message != state.Problem &&
      std::find(defects.begin(), defects.end(), message) == defects.end())
    {
      state.Notes.push_back(message);
    }
  }
  sm::SetFileState(output, state);
  std::vector<sm::DrawingTolerance> tolerances = this->Last->Tolerances;
  const double unit = sm::GetUnitInMillimetres(this->Last->LengthUnit);
  for (sm::DrawingTolerance& tolerance : tolerances)
  {
    tolerance.Lower /= unit;
    tolerance.Upper /= unit;
  }
  sm::SetDrawingTolerances(output, tolerances);
}

void vtkCADReader::ReadGuarded(vtkPartitionedDataSetCollection* output) noexcept
{
  std::string problem;
  const bool hasMemory =
    sm::HasMemoryFor([&]() { problem = sm::CatchEverything([this, output]() { this->Read(output); }); });
  if (!hasMemory || !problem.empty())
  {
    output->Initialize();
    this->Kept.reset();
    const std::string_view reason = hasMemory ? std::string_view(problem) : sm::InsufficientMemory;
    this->Fail(reason == sm::InsufficientMemory ? FAILED : UNREADABLE, reason);
  }
}

void vtkCADReader::Read(vtkPartitionedDataSetCollection* output)
{
  if (this->Kept)
  {
    *this->Last = this->Kept->Last;
    this->FillOutput(output);
    return;
  }
  const std::string mistake = this->FindMistake();
  if (!mistake.empty())
  {
    this->Fail(UNREADABLE, mistake);
    return;
  }
  this->ReadFile(output);
}

bool vtkCADReader::Load(sm::Document& document, std::string& content)
{
  if (this->IsContentGiven)
  {
    content = this->Content;
    document.Problem = content.empty() ? "it is empty; export it again" : "";
  }
  else
  {
    // The head is checked first, so that a large file of another format is not read completely.
    const std::string head = sm::LoadHead(this->FileName);
    document.Problem = head.empty() ? std::string() : this->FindMistakeOfHead(head);
    const auto report = [this]() { return this->Report(0.0); };
    if (document.Problem.empty() && !sm::LoadFile(this->FileName, report, content, document.Problem))
    {
      document.Status = sm::ReadStatus::Aborted;
      return false;
    }
  }
  return document.Problem.empty();
}

void vtkCADReader::SetContent(const std::string& bytes)
{
  this->Content = bytes;
  this->IsContentGiven = true;
  this->Modified();
}

void vtkCADReader::ClearContent()
{
  if (this->IsContentGiven)
  {
    this->Content = std::string();
    this->IsContentGiven = false;
    this->Modified();
  }
}

void vtkCADReader::ReadFile(vtkPartitionedDataSetCollection* output)
{
  const double start = vtkTimerLog::GetUniversalTime();
  this->Start = start;
  sm::Document document;
  std::string content;
  const bool isLoaded = this->Load(document, content);
  this->Last->ParseSeconds = vtkTimerLog::GetUniversalTime() - start;
  if (isLoaded)
  {
    document =
      this->ReadDocument(std::move(content), [this](double x) { return this->Report(ReadingShare * x); });
  }
  this->Last->ReadSeconds = vtkTimerLog::GetUniversalTime() - start;
  this->Last->ParseSeconds += document.ParseSeconds;
  this->Last->TrimSeconds = document.TrimSeconds;
  this->Last->Messages.insert(this->Last->Messages.end(), document.Messages.begin(), document.Messages.end());
  this->Last->FileUnit = document.FileUnit;
  if (document.Status == sm::ReadStatus::Aborted)
  {
    this->Stop();
    return;
  }
  if (document.Status != sm::ReadStatus::Ok)
  {
    this->Fail(document.Status == sm::ReadStatus::Empty ? EMPTY
        : document.Status == sm::ReadStatus::Failed     ? FAILED
                                                        : UNREADABLE,
      document.Problem);
    return;
  }
  this->Last->FreeFaces = document.FreeFaces;
  if (document.FreeFaces > 0)
  {
    this->Last->Messages.push_back(sm::FormatCount(document.FreeFaces,
      "face of the file lies outside its solids; it belongs to no body and is left out.",
      "faces of the file lie outside its solids; they belong to no body and are left out."));
  }
  this->Last->Defects = document.Defects;
  this->Last->Tolerances = document.Tolerances;
  this->Last->Messages.insert(this->Last->Messages.end(), document.Defects.begin(), document.Defects.end());
  const sm::LeafOptions options = this->ChooseOptions(document);
  std::vector<std::unique_ptr<sm::LeafMaker>> makers;
  if (!this->MakeBodies(document, options, makers))
  {
    this->Stop();
    return;
  }
  auto reading = std::make_unique<Reading>();
  for (const sm::BodyInstance& instance : document.Instances)
  {
    reading->Sources.push_back(makers[instance.Body]->MakeSource(instance));
    reading->Names.push_back(instance.Name);
  }
  reading->Assembly = sm::MakeAssembly(
    document.Root, this->GetFormatName(), this->FileName ? this->FileName : "", options.Unit);
  reading->NameInstances();
  this->Last->Bodies = static_cast<int>(document.Bodies.size());
  this->Last->Instances = static_cast<int>(document.Instances.size());
  reading->Last = *this->Last;
  reading->ModelTime = reading->FindModelTime();
  this->Kept = std::move(reading);
  if (this->FillOutput(output))
  {
    this->InspectDocument(document);
  }
}

std::string vtkCADReader::FindMistake() const
{
  if ((!this->FileName || !*this->FileName) && !this->IsContentGiven)
  {
    return "no file name was given; call SetFileName first";
  }
  if (this->OutputUnit != "file" && sm::GetShortUnit(sm::GetUnitInMillimetres(this->OutputUnit)).empty())
  {
    return "OutputUnit \"" + this->OutputUnit + "\" is not known; use mm, cm, m, um, inch, ft or file";
  }
  return this->FindMistakeOfFormat();
}

sm::LeafOptions vtkCADReader::ChooseOptions(const sm::Document& document)
{
  double millimetres = sm::GetUnitInMillimetres(this->OutputUnit);
  if (this->OutputUnit == "file")
  {
    millimetres = document.FileUnitInMillimetres;
    if (sm::GetShortUnit(millimetres).empty())
    {
      this->Last->Messages.push_back(
        "The file's length unit (" + document.FileUnit + ") has no name here; lengths are in mm.");
      millimetres = 1.0;
    }
  }
  this->Last->LengthUnit = sm::GetShortUnit(millimetres);
  sm::LeafOptions options;
  options.Unit = document.UnitInMillimetres / millimetres;
  options.UnitName = this->Last->LengthUnit;
  options.FileUnitName = document.FileUnit.empty() ? "" : sm::GetShortUnit(document.FileUnitInMillimetres);
  return options;
}

bool vtkCADReader::MakeBodies(const sm::Document& document, const sm::LeafOptions& options,
  std::vector<std::unique_ptr<sm::LeafMaker>>& makers)
{
  const std::vector<sm::EqualPart> equal =
    sm::FindEqualParts(document.Bodies, options.GetRoundings(), options.Unit != 1.0);
  for (std::size_t i = 0; i < document.Bodies.size(); ++i)
  {
    const auto report = [this, i, &document](double x)
    {
      return this->Report(
        ReadingShare + (Reading::MeshStart - ReadingShare) * (i + x) / document.Bodies.size());
    };
    if (!report(0.0))
    {
      return false;
    }
    const sm::LeafMaker* const first = equal[i].First < i ? makers[equal[i].First].get() : nullptr;
    makers.emplace_back(
      new sm::LeafMaker(document.Bodies[i], document.Statements, options, equal[i], first, report));
    if (makers.back()->IsAborted())
    {
      return false;
    }
    this->Last->MeshSeconds += makers.back()->GetMeshSeconds();
    this->Last->ConversionSeconds += makers.back()->GetConversionSeconds();
    const std::vector<std::string>& messages = makers.back()->GetMessages();
    this->Last->Messages.insert(this->Last->Messages.end(), messages.begin(), messages.end());
  }
  return true;
}

void vtkCADReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "DisplayMesh: " << this->DisplayMesh << "\n"
     << indent << "CoarseAbove: " << this->CoarseAbove << (this->Refined ? ", refined\n" : "\n") << indent
     << "LinearDeflection: " << this->LinearDeflection << (this->RelativeDeflection ? " relative\n" : "\n")
     << indent << "AngularDeflection: " << this->AngularDeflection << "\n"
     << indent << "OutputUnit: " << this->OutputUnit << "\n"
     << indent << "Content: " << this->Content.size() << " bytes\n"
     << indent << "MaximumSeconds: " << this->MaximumSeconds << "\n"
     << indent << "Status: " << this->GetStatusAsString() << "\n";
}
