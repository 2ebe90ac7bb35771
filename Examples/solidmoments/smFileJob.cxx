#include "smFileJob.h"

#include "smComparisonJob.h"
#include "smCountedBodies.h"
#include "smExtras.h"
#include "smFileReader.h"
#include "smFilterSetUp.h"
#include "smLengthUnits.h"
#include "smMassPropertyNames.h"
#include "smMessageCollector.h"
#include "smMessageList.h"
#include "smOptionValues.h"
#include "smOptions.h"
#include "smOutputPlans.h"
#include "smPicture.h"
#include "smProductBodies.h"
#include "smProducts.h"
#include "smResults.h"
#include "smRobotFile.h"
#include "smSafeFile.h"
#include "smValidationFile.h"

#include "vtkAlgorithm.h"
#include "vtkCADReader.h"
#include "vtkCallbackCommand.h"
#include "vtkFieldData.h"
#include "vtkLogger.h"
#include "vtkMassPropertiesGPU.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <system_error>
#include <utility>

namespace
{
using sm::FileResult;
using sm::JobMessage;
namespace names = sm::names;

/// Sends the progress of an algorithm to the listener, from construction to destruction.
class ProgressScope
{
public:
  ProgressScope(vtkAlgorithm* algorithm, const char* stage, const sm::JobListener& send)
    : Algorithm(algorithm)
    , Stage(stage)
    , Send(send)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* client, void*) { static_cast<ProgressScope*>(client)->Report(); });
    this->Tag = algorithm->AddObserver(vtkCommand::ProgressEvent, this->Command);
    this->Report();
  }
  ~ProgressScope() { this->Algorithm->RemoveObserver(this->Tag); }
  ProgressScope(const ProgressScope&) = delete;
  ProgressScope& operator=(const ProgressScope&) = delete;

private:
  void Report()
  {
    const double fraction = this->Algorithm->GetProgress();
    if (std::abs(fraction - this->Last) >= 0.01)
    {
      this->Last = fraction;
      this->Send(JobMessage::OfProgress(this->Stage, fraction));
    }
  }

  vtkAlgorithm* Algorithm;
  const char* Stage;
  const sm::JobListener& Send;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag = 0;
  double Last = -1.0;
};

/// Reads the file. Returns false if there is nothing to integrate; status and messages of the entry then have
/// the reason.
bool Read(vtkCADReader* reader, const sm::JobOptions& options, const sm::JobListener& send, FileResult& file,
  sm::MessageList& messages)
{
  sm::SetUpReader(reader, options.GetSource(), options);
  const bool isShown =
    !options.MeshName.empty() || !options.PictureName.empty() || !options.RobotName.empty();
  reader->SetDisplayMesh(isShown ? vtkCADReader::MESH_ALWAYS : vtkCADReader::MESH_NEVER);
  {
    ProgressScope progress(reader, sm::stages::Read, send);
    reader->Update();
  }
  file.Seconds.Read = reader->GetReadSeconds();
  file.Seconds.Parse = reader->GetParseSeconds();
  file.Seconds.Transfer = reader->GetTransferSeconds();
  file.Seconds.Trims = reader->GetTrimSeconds();
  // The time of "prepare" begins when OpenCASCADE has the shape in memory, so it includes the display mesh.
  file.Seconds.Prepare = reader->GetMeshSeconds() + reader->GetConversionSeconds();
  file.Seconds.Mesh = reader->GetMeshSeconds();
  file.Seconds.Convert = reader->GetConversionSeconds();
  file.Status = reader->GetStatusAsString();
  messages.AddReader(reader);
  if (reader->GetStatus() != vtkCADReader::OK && reader->GetStatus() != vtkCADReader::EMPTY)
  {
    file.Status =
      reader->GetStatus() == vtkCADReader::UNREADABLE ? names::StatusUnreadable : names::StatusNotComputed;
    return false;
  }
  file.LengthUnit = reader->GetLengthUnit();
  file.Faces = 0;
  file.FreeFaces = reader->GetNumberOfFreeFaces();
  return reader->GetStatus() == vtkCADReader::OK;
}

/// The text was checked when the arguments were parsed.
void SetQuantityTolerance(vtkMassPropertiesGPU* filter, const std::string& text)
{
  std::string quantity;
  double relative = 0.0;
  double absolute = 0.0;
  if (!sm::ParseQuantityTolerance(text, quantity, relative, absolute))
  {
    return;
  }
  if (quantity == "volume")
  {
    filter->SetVolumeTolerance(relative, absolute);
  }
  else if (quantity == "area")
  {
    filter->SetSurfaceAreaTolerance(relative, absolute);
  }
  else if (quantity == "center")
  {
    filter->SetCenterOfMassTolerance(relative, absolute);
  }
  else
  {
    filter->SetInertiaTolerance(relative, absolute);
  }
}

vtkSmartPointer<vtkMassPropertiesBase> MakeFilter(vtkCADReader* reader, const sm::JobOptions& options)
{
  vtkSmartPointer<vtkMassPropertiesBase> filter;
  if (options.Scheme.IsAdaptive())
  {
    auto adaptive = vtkSmartPointer<vtkMassPropertiesGPU>::New();
    adaptive->SetRelativeTolerance(options.Tolerance);
    for (const std::string& text : options.QuantityTolerances)
    {
      SetQuantityTolerance(adaptive, text);
    }
    filter = adaptive;
  }
  else
  {
    filter = options.Scheme.MakeFilter();
  }
  filter->SetInputConnection(reader->GetOutputPort());
  sm::SetUpFilter(filter, options);
  sm::SetUpMass(filter, options);
  if (!options.About.empty())
  {
    const std::vector<double>& about = options.About;
    filter->SetReferenceFrame(about.data(), about.data() + 3, about.data() + 6);
  }
  return filter;
}

void ReadSeconds(vtkMassPropertiesBase* filter, sm::StageSeconds& seconds)
{
  seconds.Start = filter->GetStartSeconds();
  seconds.Prepare += filter->GetPrepareSeconds();
  seconds.Cut = filter->GetCutSeconds();
  seconds.Plan = filter->GetPlanSeconds();
  seconds.Upload = filter->GetPrepareSeconds() - filter->GetCutSeconds() - filter->GetPlanSeconds();
  seconds.Integrate = filter->GetIntegrateSeconds();
  seconds.Analyse = filter->GetAnalyseSeconds();
}

void Integrate(vtkMassPropertiesBase* filter, const sm::JobOptions& options, const sm::JobListener& send,
  FileResult& file, sm::MessageList& messages)
{
  {
    ProgressScope progress(filter, sm::stages::Integrate, send);
    filter->Update();
  }
  vtkFieldData* fields = filter->GetOutput()->GetFieldData();
  file.LengthUnit = sm::GetText(fields, 0, names::LengthUnit);
  file.Status = filter->GetStatus();
  messages.AddFilter(filter);
  file.Backend = filter->GetBackendName();
  file.Renderer = filter->GetRenderer();
  const std::string reason = filter->GetBackendReason();
  file.BackendReason = reason.empty() ? std::nullopt : std::optional(reason);
  file.EstimatedEvaluations = filter->GetEstimatedEvaluations();
  file.EstimatedCPUSeconds = filter->GetEstimatedSeconds(vtkSurfaceIntegralBase::CPU);
  file.EstimatedOpenGLSeconds = filter->GetEstimatedSeconds(vtkSurfaceIntegralBase::OPENGL);
  sm::ReadTotal(fields, file.Total);
  file.Frame = options.About;
  sm::ReadSolids(vtkTable::SafeDownCast(filter->GetOutputDataObject(1)),
    vtkTable::SafeDownCast(filter->GetOutputDataObject(4)), file);
  file.Faces = filter->GetNumberOfFaces();
  file.Diagonal = sm::GetDiagonal(filter->GetInputDataObject(0, 0));
  file.Evaluations = filter->GetEvaluations();
  file.Dispatches = filter->GetDispatches();
  ReadSeconds(filter, file.Seconds);
}

void SendResult(
  const sm::JobListener& send, FileResult& file, const sm::MessageList& messages, bool isComplete)
{
  file.Messages = messages.Get();
  send(JobMessage::OfResult(file, isComplete));
}

std::string DescribeException(const std::exception& error)
{
  if (dynamic_cast<const std::bad_alloc*>(&error))
  {
    return "out of memory";
  }
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  return system && system->code() == std::errc::resource_unavailable_try_again
    ? "no thread can be started: out of memory, or of threads"
    : std::string("stopped by an error: ") + error.what();
}

/// What the picture shows in addition.
struct Drawn
{
  vtkSmartPointer<vtkPolyData> Lines;
  sm::FaceColors Colors;
};

std::string Draw(vtkPartitionedDataSetCollection* bodies, vtkMassPropertiesBase* filter, const Drawn& drawn,
  const sm::JobOptions& options, const FileResult& file)
{
  if (!bodies || bodies->GetNumberOfPoints() == 0)
  {
    return "there is nothing to draw";
  }
  std::string problem;
  sm::Picture picture;
  picture.Window = sm::StartWindow(filter, problem);
  picture.Body = drawn.Colors.Bodies ? drawn.Colors.Bodies.Get() : bodies;
  picture.FaceArray = drawn.Colors.Array;
  picture.FaceTitle = drawn.Colors.Title;
  picture.Mark = filter->GetOutput();
  picture.Stability = drawn.Lines;
  picture.Flagged = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(6));
  picture.Result = &file;
  return picture.Window ? sm::CallExtra(&sm::ExtraFunctions::WritePicture, picture, options.PictureName)
                        : problem;
}

/// Runs the requested analyses, those of bodies first. Sends the results before each.
Drawn RunAnalyses(vtkCADReader* reader, const sm::JobOptions& options, const sm::JobListener& send,
  FileResult& file, sm::MessageList& messages)
{
  Drawn drawn;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < options.Analyses.size(); ++i)
  {
    if (options.Analyses[i]->IsWanted())
    {
      order.push_back(i);
    }
  }
  std::stable_partition(
    order.begin(), order.end(), [&options](std::size_t i) { return options.Analyses[i]->IsOfBodies(); });
  std::stable_partition(
    order.begin(), order.end(), [&options](std::size_t i) { return !options.Analyses[i]->RunsLast(); });
  for (const std::size_t i : order)
  {
    const sm::Analysis& analysis = *options.Analyses[i];
    SendResult(send, file, messages, false);
    const auto update = [&send, &analysis](vtkAlgorithm* algorithm)
    {
      ProgressScope progress(algorithm, analysis.GetStage(), send);
      algorithm->Update();
    };
    const auto report = [&send, &analysis](const std::string& problem)
    { send(JobMessage::OfAnalysis(analysis.GetKey(), problem)); };
    analysis.Run({ reader, options, update, file, messages, drawn.Lines, drawn.Colors, i, report });
  }
  return drawn;
}

/// Removes the entries that are more than `depth` levels down.
void CutList(std::vector<sm::PartsListEntry>& entries, int depth)
{
  for (sm::PartsListEntry& entry : entries)
  {
    if (depth <= 1)
    {
      entry.Children.clear();
    }
    CutList(entry.Children, depth - 1);
  }
}

/// Adds the results of products: shapes, parts list and validation properties.
void AddProducts(vtkCADReader* reader, const vtkMassPropertiesBase* filter, const sm::JobOptions& options,
  const sm::JobListener& send, FileResult& file, sm::MessageList& messages)
{
  if (options.Shapes)
  {
    SendResult(send, file, messages, false);
    file.Shapes =
      sm::MeasureProduct(reader->GetOutputDataObject(0), file.GetProduct(), options.GetSecondsLeft());
  }
  if (options.PartsList)
  {
    file.Parts = filter->GetPartsList();
    if (options.Depth > 0)
    {
      CutList(*file.Parts, options.Depth);
    }
  }
  if (options.Validate)
  {
    file.Validation = sm::CompareValidation(sm::StatedFile(options.GetSource()).List(),
      sm::MakeProductTree(reader->GetOutputDataObject(0)), file.GetProduct(), options.ValidationLimit,
      sm::FindLeftOutNote(reader->GetOutputDataObject(0)));
  }
}

/// Writes trim textures, triangles, the file with validation properties, robot and picture.
void WriteOutputs(vtkCADReader* reader, vtkMassPropertiesBase* filter, const Drawn& drawn,
  sm::OutputPlans plans, const sm::JobOptions& options, const sm::JobListener& send, const FileResult& file)
{
  if (!options.TexturePrefix.empty())
  {
    send(JobMessage::OfProgress(sm::stages::Textures));
    send(JobMessage::OfOutput(
      JobMessage::Textures, sm::Scheme::WriteTrimPictures(filter, options.TexturePrefix)));
  }
  auto* const bodies = sm::GetShownBodies(reader, filter, options);
  if (!options.MeshName.empty())
  {
    send(JobMessage::OfProgress(sm::stages::Mesh));
    send(JobMessage::OfOutput(JobMessage::Mesh,
      sm::CallExtra(&sm::ExtraFunctions::WriteMesh, bodies, reader->GetLengthUnit(), plans.MeshOrigin,
        options.MeshName)));
  }
  if (!options.ValidationTarget.empty())
  {
    send(JobMessage::OfProgress(sm::stages::Validation));
    send(JobMessage::OfOutput(JobMessage::Validation,
      plans.Validation.Problem.empty() ? sm::SaveFile(options.ValidationTarget, plans.Validation.Text)
                                       : plans.Validation.Problem));
  }
  if (!options.RobotName.empty())
  {
    send(JobMessage::OfProgress(sm::stages::Robot));
    send(JobMessage::OfOutput(JobMessage::Robot,
      sm::WriteRobot(
        reader->GetOutputDataObject(0), sm::GetMetres(file.LengthUnit.value_or("")), options, plans.Robot)));
  }
  if (!options.PictureName.empty())
  {
    send(JobMessage::OfProgress(sm::stages::Draw));
    send(JobMessage::OfOutput(JobMessage::Picture, Draw(bodies, filter, drawn, options, file)));
  }
}

void Run(const sm::JobOptions& given, const sm::JobListener& send, vtkCADReader* reader)
{
  vtkNew<smMessageCollector> collector;
  vtkOutputWindow::SetInstance(collector);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkSMPTools::SetBackend("STDThread");

  if (given.Comparison)
  {
    sm::DrawComparison(given, send);
    vtkOutputWindow::SetInstance(nullptr);
    return;
  }
  FileResult file(given);
  sm::MessageList messages;
  const bool isRead = Read(reader, given, send, file, messages);
  sm::JobOptions options = given;
  for (const std::string& pattern : isRead ? given.Only : std::vector<std::string>())
  {
    const std::vector<std::string> selectors = sm::FindProducts(reader->GetOutputDataObject(0), pattern);
    options.Selectors.insert(options.Selectors.end(), selectors.begin(), selectors.end());
  }
  const auto filter = MakeFilter(reader, options);
  Drawn drawn;
  if (isRead)
  {
    file.Scheme = options.Scheme.GetName();
    sm::Scheme::ReadOptions(filter, file);
    file.Status = names::StatusNotComputed;
    SendResult(send, file, messages, false);
    Integrate(filter, options, send, file, messages);
    AddProducts(reader, filter, options, send, file, messages);
    drawn = RunAnalyses(reader, options, send, file, messages);
  }
  for (const std::string& message : collector->GetMessages())
  {
    messages.AddEcho(message);
  }
  sm::OutputPlans plans;
  if (isRead)
  {
    plans = sm::PlanOutputs(reader, filter, options, file, messages);
  }
  SendResult(send, file, messages, true);
  if (isRead)
  {
    WriteOutputs(reader, filter, drawn, std::move(plans), options, send, file);
  }
  vtkOutputWindow::SetInstance(nullptr);
}
}

namespace sm
{
void RunFileJob(const JobOptions& given, const JobListener& send, vtkCADReader* reader)
{
  JobOptions options = given;
  if (options.MaximumSeconds > 0.0)
  {
    using Clock = std::chrono::steady_clock;
    // A limit of centuries would overflow the clock.
    options.Deadline = Clock::now() +
      std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(std::min(options.MaximumSeconds, 1e9)));
  }
  std::optional<FileResult> sent;                  ///< last results, while they are not complete
  JobMessage::Kinds waiting = JobMessage::Picture; ///< the output other than results that is being made
  bool isComplete = false;
  const auto listener = [&](const JobMessage& message)
  {
    send(message);
    if (message.Kind == JobMessage::Progress)
    {
      waiting = message.Text == stages::Mesh ? JobMessage::Mesh
        : message.Text == stages::Textures   ? JobMessage::Textures
        : message.Text == stages::Validation ? JobMessage::Validation
        : message.Text == stages::Robot      ? JobMessage::Robot
                                             : JobMessage::Picture;
    }
    if (message.Kind == JobMessage::Result)
    {
      isComplete = message.IsComplete;
      // An assembly of thousands of solids is large.
      sent = isComplete ? std::nullopt : std::optional(*message.File);
    }
  };
  try
  {
    const auto own = reader ? vtkSmartPointer<vtkCADReader>(reader) : MakeReader(options.GetSource());
    Run(options, listener, own);
  }
  catch (const std::exception& error)
  {
    const std::string reason = DescribeException(error);
    if (isComplete)
    {
      send(JobMessage::OfOutput(waiting, reason));
      return;
    }
    if (!sent)
    {
      sent = UnreadableFile(options, reason);
    }
    else
    {
      MarkIncomplete(*sent, reason);
    }
    send(JobMessage::OfResult(*sent, true));
  }
}

bool JobOptions::LeavesOut() const
{
  return LeavesOutBodies(this->Materials);
}

double JobOptions::GetSecondsLeft() const
{
  const std::chrono::duration<double> left = this->Deadline - std::chrono::steady_clock::now();
  return this->MaximumSeconds > 0.0 ? std::max(left.count(), 1e-9) : 0.0;
}

void MarkIncomplete(FileResult& file, const std::string& reason)
{
  file.Messages.push_back(reason);
  if (file.Status == names::StatusOk)
  {
    file.Status = names::StatusNotComputed;
  }
}

int GetExitStatus(const FileResult& file)
{
  return file.Status == names::StatusOk      ? AllOk
    : file.Status == names::StatusUnreadable ? Unreadable
                                             : Flagged;
}

FileResult UnreadableFile(const JobOptions& options, const std::string& message)
{
  FileResult file(options);
  file.Messages.push_back(message);
  return file;
}
}
