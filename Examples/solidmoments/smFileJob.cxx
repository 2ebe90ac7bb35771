#include "smFileJob.h"

#include "smComparisonPicture.h"
#include "smFileEntry.h"
#include "smFileReader.h"
#include "smMassPropertyNames.h"
#include "smMeshFile.h"
#include "smMessageCollector.h"
#include "smMessageList.h"
#include "smOptionValues.h"
#include "smOptions.h"
#include "smPartsReport.h"
#include "smPicture.h"
#include "smProductShapes.h"
#include "smProductTree.h"
#include "smQuantities.h"
#include "smText.h"
#include "smUserIntegrals.h"
#include "smValidation.h"
#ifdef SM_HAS_BUOYANCY
#include "smBuoyancyJob.h"
#endif
#ifdef SM_HAS_MOMENT_SCHEMES
#include "smSchemeJob.h"
#endif
#ifdef SM_HAS_SECTION
#include "smSectionJob.h"
#endif
#ifdef SM_HAS_STABILITY
#include "smStabilityJob.h"
#endif

#include "vtkAlgorithm.h"
#include "vtkCADReader.h"
#include "vtkCallbackCommand.h"
#include "vtkComputeContext.h"
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

namespace
{
using sm::Json;
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
      this->Send({ { "progress", { this->Stage, fraction } } });
    }
  }

  vtkAlgorithm* Algorithm;
  const char* Stage;
  const sm::JobListener& Send;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag = 0;
  double Last = -1.0;
};

const std::string& GetSource(const sm::JobOptions& options)
{
  return options.SourceName.empty() ? options.FileName : options.SourceName;
}

/// Reads the file. Returns false if there is nothing to integrate; status and messages of the entry then have the reason.
bool Read(vtkCADReader* reader, const sm::JobOptions& options, const sm::JobListener& send, Json& file,
  sm::MessageList& messages)
{
  sm::SetUpReader(reader, GetSource(options), options);
  const bool isShown = !options.MeshName.empty() || !options.PictureName.empty();
  reader->SetDisplayMesh(isShown ? vtkCADReader::MESH_ALWAYS : vtkCADReader::MESH_NEVER);
  {
    ProgressScope progress(reader, sm::stages::Read, send);
    reader->Update();
  }
  file["seconds"]["read"] = reader->GetReadSeconds();
  file["seconds"]["parse"] = reader->GetParseSeconds();
  file["seconds"]["transfer"] = reader->GetTransferSeconds();
  file["seconds"]["trims"] = reader->GetTrimSeconds();
  // The time of "prepare" begins when OpenCASCADE has the shape in memory, so it includes the display mesh.
  file["seconds"]["prepare"] = reader->GetMeshSeconds() + reader->GetConversionSeconds();
  file["seconds"]["mesh"] = reader->GetMeshSeconds();
  file["seconds"]["convert"] = reader->GetConversionSeconds();
  file["status"] = reader->GetStatusAsString();
  messages.AddReader(reader);
  if (reader->GetStatus() != vtkCADReader::OK && reader->GetStatus() != vtkCADReader::EMPTY)
  {
    file["status"] = names::StatusUnreadable;
    return false;
  }
  file["length_unit"] = reader->GetLengthUnit();
  file["faces"] = 0;
  file["free_faces"] = reader->GetNumberOfFreeFaces();
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
  if (options.Scheme == "adaptive")
  {
    auto adaptive = vtkSmartPointer<vtkMassPropertiesGPU>::New();
    adaptive->SetRelativeTolerance(options.Tolerance);
    for (const std::string& text : options.QuantityTolerances)
    {
      SetQuantityTolerance(adaptive, text);
    }
    filter = adaptive;
  }
#ifdef SM_HAS_MOMENT_SCHEMES
  else
  {
    filter = sm::MakeSchemeFilter(options);
  }
#endif
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

void Integrate(vtkMassPropertiesBase* filter, const sm::JobOptions& options, const sm::JobListener& send,
  Json& file, sm::MessageList& messages)
{
  {
    ProgressScope progress(filter, sm::stages::Integrate, send);
    filter->Update();
  }
  vtkFieldData* fields = filter->GetOutput()->GetFieldData();
  file["length_unit"] = sm::GetText(fields, 0, names::LengthUnit);
  file["status"] = filter->GetStatus();
  messages.AddFilter(filter);
  file["backend"] = filter->GetBackendName();
  file["renderer"] = filter->GetRenderer();
  const std::string reason = filter->GetBackendReason();
  file["backend_reason"] = reason.empty() ? Json() : Json(reason);
  file["estimate"] = { { "evaluations", static_cast<long long>(filter->GetEstimatedEvaluations()) },
    { "cpu_seconds", filter->GetEstimatedSeconds(vtkSurfaceIntegralBase::CPU) },
    { "opengl_seconds", filter->GetEstimatedSeconds(vtkSurfaceIntegralBase::OPENGL) } };
  file["total"] = sm::GetTotal(fields);
  if (!options.About.empty())
  {
    const auto get = [&options](size_t i) {
      return Json({ options.About[i], options.About[i + 1], options.About[i + 2] });
    };
    file["frame"] = { { "origin", get(0) }, { "z_axis", get(3) }, { "x_axis", get(6) } };
  }
  file["solids"] = sm::GetSolids(vtkTable::SafeDownCast(filter->GetOutputDataObject(1)),
    vtkTable::SafeDownCast(filter->GetOutputDataObject(4)));
  file["faces"] = filter->GetNumberOfFaces();
  file["diagonal"] = sm::GetDiagonal(filter->GetInputDataObject(0, 0));
  file["evaluations"] = filter->GetEvaluations();
  file["dispatches"] = filter->GetDispatches();
  file["seconds"]["start"] = filter->GetStartSeconds();
  file["seconds"]["prepare"] = file["seconds"]["prepare"].get<double>() + filter->GetPrepareSeconds();
  file["seconds"]["cut"] = filter->GetCutSeconds();
  file["seconds"]["plan"] = filter->GetPlanSeconds();
  file["seconds"]["upload"] =
    filter->GetPrepareSeconds() - filter->GetCutSeconds() - filter->GetPlanSeconds();
  file["seconds"]["integrate"] = filter->GetIntegrateSeconds();
  file["seconds"]["analyse"] = filter->GetAnalyseSeconds();
}

void SendResult(const sm::JobListener& send, Json& file, const sm::MessageList& messages, bool isComplete)
{
  file["messages"] = messages.Get();
  send({ { "result", file }, { "complete", isComplete } });
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

std::string Draw(vtkPartitionedDataSetCollection* bodies, vtkMassPropertiesBase* filter,
  vtkPolyData* stability, const sm::JobOptions& options, const Json& file)
{
  if (!bodies || bodies->GetNumberOfPoints() == 0)
  {
    return "there is nothing to draw";
  }
  vtkComputeContext* context = filter->GetComputeContext();
  context->Start();
  sm::Picture picture;
  picture.Window = context->GetRenderWindow();
  picture.Body = bodies;
  picture.Mark = filter->GetOutput();
  picture.Stability = stability;
  picture.Flagged = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(6));
  picture.Result = &file;
  return picture.Window ? sm::WritePicture(picture, options.PictureName)
                        : "there is no OpenGL context to draw in: " + context->GetReason();
}

/// Computes the other results that the options ask for. Sends the results after every stage. Returns the drawing of the stability.
vtkSmartPointer<vtkPolyData> IntegrateMore(vtkCADReader* reader, const sm::JobOptions& options,
  const sm::JobListener& send, Json& file, sm::MessageList& messages)
{
  const auto makeUpdate = [&send](const char* stage)
  {
    return [&send, stage](vtkAlgorithm* algorithm)
    {
      ProgressScope progress(algorithm, stage, send);
      algorithm->Update();
    };
  };
  sm::AddPlaceholders(options, file);
  vtkSmartPointer<vtkPolyData> drawing;
#ifdef SM_HAS_STABILITY
  if (!options.Stability.empty())
  {
    SendResult(send, file, messages, false);
    drawing = sm::FindStability(reader, options, makeUpdate(sm::stages::Stability), file, messages);
  }
#endif
#ifdef SM_HAS_BUOYANCY
  if (!options.Waterlines.empty())
  {
    SendResult(send, file, messages, false);
    sm::IntegrateBelowWaterlines(reader, options, makeUpdate(sm::stages::Buoyancy), file, messages);
  }
#endif
#ifdef SM_HAS_SECTION
  if (!options.Sections.empty())
  {
    SendResult(send, file, messages, false);
    sm::IntegrateSections(reader, options, makeUpdate(sm::stages::Section), file, messages);
  }
#endif
  // Expressions come last, because they may crash a shader compiler.
  if (!options.Integrals.empty() || options.MomentDegree >= 0)
  {
    SendResult(send, file, messages, false);
    sm::IntegrateUsers(reader, options, makeUpdate(sm::stages::Integrals), file, messages);
  }
  return drawing;
}

/// Adds the results of products: shapes, parts list and validation properties.
void AddProducts(vtkCADReader* reader, const vtkMassPropertiesBase* filter, const sm::JobOptions& options,
  const sm::JobListener& send, Json& file, sm::MessageList& messages)
{
  if (options.Shapes)
  {
    SendResult(send, file, messages, false);
    file[sm::ShapesKey] = sm::MeasureProduct(reader, options, file["solids"]);
  }
  if (!options.PartsList && !options.Validate && options.ValidationTarget.empty())
  {
    return;
  }
  const Json tree = sm::GetProductTree(reader);
  if (options.PartsList)
  {
    file["parts"] = sm::MakePartsJson(filter->GetPartsList(), options.Depth);
  }
  if (options.Validate)
  {
    file["validation"] = sm::CompareValidation(GetSource(options), tree, file, options.ValidationLimit);
  }
  if (!options.ValidationTarget.empty())
  {
    const std::string problem = sm::WriteValidation(GetSource(options), tree, file, options.ValidationTarget);
    if (!problem.empty())
    {
      messages.AddEcho(problem);
      file["status"] = names::StatusNotComputed;
    }
  }
}

void Run(const sm::JobOptions& given, const sm::JobListener& send, vtkCADReader* reader)
{
  vtkNew<smMessageCollector> collector;
  vtkOutputWindow::SetInstance(collector);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkSMPTools::SetBackend("STDThread");

  if (!given.Comparison.is_null())
  {
    sm::DrawComparison(given, send);
    vtkOutputWindow::SetInstance(nullptr);
    return;
  }
  Json file = sm::MakeEmptyFile(given.FileName);
  sm::AddPlaceholders(given, file);
  sm::MessageList messages;
  const bool isRead = Read(reader, given, send, file, messages);
  sm::JobOptions options = given;
  for (const std::string& pattern : isRead ? given.Only : std::vector<std::string>())
  {
    const std::vector<std::string> selectors = sm::FindProducts(reader, pattern);
    options.Selectors.insert(options.Selectors.end(), selectors.begin(), selectors.end());
  }
  const auto filter = MakeFilter(reader, options);
  vtkSmartPointer<vtkPolyData> stability;
  if (isRead)
  {
    file["scheme"] = options.Scheme;
#ifdef SM_HAS_MOMENT_SCHEMES
    file["scheme_options"] = sm::GetSchemeOptions(filter);
#endif
    file["status"] = names::StatusNotComputed;
    SendResult(send, file, messages, false);
    Integrate(filter, options, send, file, messages);
    AddProducts(reader, filter, options, send, file, messages);
#ifdef SM_HAS_STABILITY
    if (options.Box)
    {
      SendResult(send, file, messages, false);
      sm::AddBoxes(reader, file);
    }
#endif
    stability = IntegrateMore(reader, options, send, file, messages);
  }
  for (const std::string& message : collector->GetMessages())
  {
    messages.AddEcho(message);
  }
  SendResult(send, file, messages, true);
#ifdef SM_HAS_MOMENT_SCHEMES
  if (!options.TexturePrefix.empty() && isRead)
  {
    send({ { "progress", { sm::stages::Textures, 0.0 } } });
    send({ { "textures", sm::WriteTrimPictures(filter, options.TexturePrefix) } });
  }
#endif
  // Port 5 has the bodies that --only chooses.
  auto* const bodies = vtkPartitionedDataSetCollection::SafeDownCast(
    options.Only.empty() ? reader->GetOutputDataObject(0) : filter->GetOutputDataObject(5));
  if (!options.MeshName.empty() && isRead)
  {
    send({ { "progress", { sm::stages::Mesh, 0.0 } } });
    send({ { "mesh", sm::WriteMesh(bodies, reader->GetLengthUnit(), options.MeshName) } });
  }
  if (!options.PictureName.empty() && isRead)
  {
    send({ { "progress", { sm::stages::Draw, 0.0 } } });
    send({ { "picture", Draw(bodies, filter, stability, options, file) } });
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
  Json sent;           ///< last results, while they are not complete
  std::string waiting; ///< the output other than results that is being made
  bool isComplete = false;
  const auto listener = [&](const Json& message)
  {
    send(message);
    if (message.contains("progress"))
    {
      const std::string stage = message["progress"][0].get<std::string>();
      waiting = stage == stages::Mesh || stage == stages::Textures ? stage : "picture";
    }
    if (message.contains("result"))
    {
      isComplete = message["complete"].get<bool>();
      // An assembly of thousands of solids is large.
      sent = isComplete ? Json() : message["result"];
    }
  };
  try
  {
    const auto own = reader ? vtkSmartPointer<vtkCADReader>(reader) : MakeReader(GetSource(options));
    Run(options, listener, own);
  }
  catch (const std::exception& error)
  {
    const std::string reason = DescribeException(error);
    if (isComplete)
    {
      send({ { waiting.empty() ? "picture" : waiting, reason } });
      return;
    }
    if (sent.is_null())
    {
      sent = UnreadableFile(options, reason);
    }
    else
    {
      MarkIncomplete(sent, reason);
    }
    send({ { "result", sent }, { "complete", true } });
  }
}

void MarkIncomplete(Json& file, const std::string& reason)
{
  file["messages"].push_back(reason);
  if (file["status"] == names::StatusOk)
  {
    file["status"] = names::StatusNotComputed;
  }
}

int GetExitStatus(const Json& file)
{
  return file["status"] == names::StatusOk      ? AllOk
    : file["status"] == names::StatusUnreadable ? Unreadable
                                                : Flagged;
}

Json UnreadableFile(const JobOptions& options, const std::string& message)
{
  Json file = sm::MakeEmptyFile(options.FileName);
  AddPlaceholders(options, file);
  file["messages"].push_back(message);
  return file;
}
}
