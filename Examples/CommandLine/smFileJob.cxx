#include "smFileJob.h"

#include "smMassPropertyNames.h"
#include "smMessageCollector.h"
#include "smMessageList.h"
#include "smOptions.h"
#include "smPicture.h"
#include "smQuantities.h"
#include "smText.h"
#include "smUserIntegrals.h"
#ifdef SM_HAS_BUOYANCY
#include "smBuoyancyJob.h"
#endif
#ifdef SM_HAS_MOMENT_SCHEMES
#include "smSchemeJob.h"
#endif
#ifdef SM_HAS_STABILITY
#include "smStabilityJob.h"
#endif

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCallbackCommand.h"
#include "vtkComputeContext.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkLogger.h"
#include "vtkMassPropertiesGPU.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSTEPReader.h"
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

// --- from tables to JSON -----------------------------------------------------------------------

/// The quantities of a row of field data or of a table.
Json GetQuantities(vtkFieldData* data, vtkIdType row)
{
  Json quantities = sm::GetQuantities(data, row);
  // A build without the schemes has the same keys.
  quantities.update({ { "paper_error_estimate", nullptr }, { "paper_error_estimate_with_boundary", nullptr },
    { "sub_patches", nullptr } });
#ifdef SM_HAS_MOMENT_SCHEMES
  quantities.update(sm::GetSchemeQuantities(data, row));
#endif
  return quantities;
}

/// For each solid the edges with the widest gaps, at most five, without those that have no gap. The table has the widest first.
std::vector<Json> WorstEdges(vtkTable* table, vtkIdType solids)
{
  const size_t most = 5;
  std::vector<Json> worst(static_cast<size_t>(solids), Json::array());
  vtkDataSetAttributes* columns = table->GetRowData();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const Json widest = sm::GetNumber(columns, row, names::MaxGap);
    if (widest.is_null() || widest == 0.0)
    {
      break;
    }
    Json& edges = worst.at(sm::GetCount(columns, row, names::Solid).get<size_t>());
    if (edges.size() == most)
    {
      continue;
    }
    Json edge;
    edge["id"] = sm::GetCount(columns, row, names::EdgeId);
    edge["name"] = sm::GetText(columns, row, names::Name);
    edge["uses"] = sm::GetCount(columns, row, names::Uses);
    edge["open"] = sm::GetCount(columns, row, names::Open) != 0;
    edge["max_gap"] = widest;
    edge["gap_area"] = sm::GetNumber(columns, row, names::GapArea);
    edge["gap_squared"] = sm::GetNumber(columns, row, names::GapSquared);
    edges.push_back(std::move(edge));
  }
  return worst;
}

Json Solids(vtkTable* table, vtkTable* edges)
{
  Json solids = Json::array();
  const std::vector<Json> worst = WorstEdges(edges, table->GetNumberOfRows());
  vtkDataSetAttributes* columns = table->GetRowData();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    Json solid;
    solid["name"] = sm::GetText(columns, row, names::Name);
    solid["id"] = sm::GetText(columns, row, names::Id);
    solid["status"] = sm::GetText(columns, row, names::Status);
    solid.update(GetQuantities(columns, row));
    solid["worst_edges"] = worst[static_cast<size_t>(row)];
    solids.push_back(std::move(solid));
  }
  return solids;
}

Json EmptyFile(const std::string& fileName)
{
  vtkNew<vtkFieldData> nothing;
  Json file;
  sm::SetFileName(file, fileName);
  file["length_unit"] = nullptr;
  file["status"] = names::StatusUnreadable;
  file["messages"] = Json::array();
  file["scheme"] = nullptr;
  file["scheme_options"] = nullptr;
  file["backend"] = nullptr;
  file["renderer"] = nullptr;
  file["total"] = GetQuantities(nothing, 0);
  file["solids"] = Json::array();
  file["integrals"] = Json::object();
  file["waterlines"] = Json::array();
  file["faces"] = nullptr;
  file["free_faces"] = nullptr;
  file["diagonal"] = nullptr;
  file["evaluations"] = nullptr;
  file["dispatches"] = nullptr;
  file["seconds"] = { { "start", nullptr }, { "read", nullptr }, { "prepare", nullptr },
    { "integrate", nullptr } };
  return file;
}

/// The diagonal of the bounding box of all display meshes; null where there are none.
Json Diagonal(vtkDataObject* input)
{
  vtkBoundingBox box;
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(input);
  for (unsigned int i = 0; parts && i < parts->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int j = 0; j < parts->GetNumberOfPartitions(i); ++j)
    {
      auto* mesh = vtkDataSet::SafeDownCast(parts->GetPartitionAsDataObject(i, j));
      if (mesh && mesh->GetNumberOfPoints() > 0)
      {
        box.AddBounds(mesh->GetBounds());
      }
    }
  }
  return box.IsValid() ? Json(box.GetDiagonalLength()) : Json();
}

// --- progress ----------------------------------------------------------------------------------

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

// --- the job -----------------------------------------------------------------------------------

/// Reads the file; false when there is nothing to integrate, for the reason that status and messages of the entry give.
bool Read(vtkSTEPReader* reader, const sm::JobOptions& options, const sm::JobListener& send, Json& file,
  sm::MessageList& messages)
{
  reader->SetFileName(options.FileName.c_str());
  reader->SetOutputUnit(options.Unit);
  reader->SetRepair(options.Repair == "needed" ? vtkSTEPReader::ON_NEED : vtkSTEPReader::ALWAYS);
  {
    ProgressScope progress(reader, sm::stages::Read, send);
    reader->Update();
  }
  file["seconds"]["read"] = reader->GetReadSeconds();
  // "prepare" begins when OpenCASCADE has the shape in memory, so it includes the display mesh.
  file["seconds"]["prepare"] = reader->GetMeshSeconds() + reader->GetConversionSeconds();
  file["status"] = reader->GetStatusAsString();
  messages.AddReader(reader);
  if (reader->GetStatus() != vtkSTEPReader::OK && reader->GetStatus() != vtkSTEPReader::EMPTY)
  {
    file["status"] = names::StatusUnreadable;
    return false;
  }
  file["length_unit"] = reader->GetLengthUnit();
  file["faces"] = 0;
  file["free_faces"] = reader->GetNumberOfFreeFaces();
  return reader->GetStatus() == vtkSTEPReader::OK;
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

vtkSmartPointer<vtkMassPropertiesBase> MakeFilter(vtkSTEPReader* reader, const sm::JobOptions& options)
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
  filter->SetDensity(options.Density);
  return filter;
}

void Integrate(
  vtkMassPropertiesBase* filter, const sm::JobListener& send, Json& file, sm::MessageList& messages)
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
  file["total"] = GetQuantities(fields, 0);
  file["solids"] = Solids(vtkTable::SafeDownCast(filter->GetOutputDataObject(1)),
    vtkTable::SafeDownCast(filter->GetOutputDataObject(4)));
  file["faces"] = filter->GetNumberOfFaces();
  file["diagonal"] = Diagonal(filter->GetInputDataObject(0, 0));
  file["evaluations"] = filter->GetEvaluations();
  file["dispatches"] = filter->GetDispatches();
  file["seconds"]["start"] = filter->GetStartSeconds();
  file["seconds"]["prepare"] = file["seconds"]["prepare"].get<double>() + filter->GetPrepareSeconds();
  file["seconds"]["integrate"] = filter->GetIntegrateSeconds();
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

std::string Draw(vtkSTEPReader* reader, vtkMassPropertiesBase* filter, vtkPolyData* stability,
  const sm::JobOptions& options, const Json& file)
{
  vtkComputeContext* context = filter->GetComputeContext();
  context->Start();
  sm::Picture picture;
  picture.Window = context->GetRenderWindow();
  picture.Body = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  picture.Mark = filter->GetOutput();
  picture.Stability = stability;
  picture.Result = &file;
  return picture.Window ? sm::WritePicture(picture, options.PictureName)
                        : "there is no OpenGL context to draw in: " + context->GetReason();
}

/// What the options ask for beside the mass properties. Sends the results after every stage. Returns the drawing of the stability.
vtkSmartPointer<vtkPolyData> IntegrateMore(vtkSTEPReader* reader, const sm::JobOptions& options,
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
  // Last: an expression can crash a shader compiler.
  if (!options.Integrals.empty() || options.MomentDegree >= 0)
  {
    SendResult(send, file, messages, false);
    sm::IntegrateUsers(reader, options, makeUpdate(sm::stages::Integrals), file, messages);
  }
  return drawing;
}

void Run(const sm::JobOptions& options, const sm::JobListener& send, vtkSTEPReader* reader)
{
  vtkNew<smMessageCollector> collector;
  vtkOutputWindow::SetInstance(collector);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkSMPTools::SetBackend("STDThread");

  Json file = EmptyFile(options.FileName);
  sm::MessageList messages;
  const bool isRead = Read(reader, options, send, file, messages);
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
    Integrate(filter, send, file, messages);
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
  if (!options.PictureName.empty() && isRead)
  {
    send({ { "progress", { sm::stages::Draw, 0.0 } } });
    send({ { "picture", Draw(reader, filter, stability, options, file) } });
  }
  vtkOutputWindow::SetInstance(nullptr);
}
}

namespace sm
{
bool ParseDirection(const std::string& text, std::array<double, 3>& direction)
{
  direction = { 0.0, 0.0, 0.0 };
  const bool sign = !text.empty() && (text[0] == '+' || text[0] == '-');
  if (text.size() == (sign ? 2u : 1u) && text.back() >= 'x' && text.back() <= 'z')
  {
    direction[text.back() - 'x'] = text[0] == '-' ? -1.0 : 1.0;
    return true;
  }
  const std::vector<double> numbers = ParseNumbers(text);
  if (numbers.size() != 3 ||
    !std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
  {
    return false;
  }
  std::copy(numbers.begin(), numbers.end(), direction.begin());
  return direction[0] != 0.0 || direction[1] != 0.0 || direction[2] != 0.0;
}

bool ParseQuantityTolerance(
  const std::string& text, std::string& quantity, double& relative, double& absolute)
{
  const std::string::size_type equals = text.find('=');
  if (equals == std::string::npos)
  {
    return false;
  }
  quantity = text.substr(0, equals);
  if (quantity != "volume" && quantity != "area" && quantity != "center" && quantity != "inertia")
  {
    return false;
  }
  const std::vector<double> numbers = ParseNumbers(text.substr(equals + 1));
  if (numbers.empty() || numbers.size() > 2)
  {
    return false;
  }
  relative = numbers[0];
  absolute = numbers.size() == 2 ? numbers[1] : 0.0;
  return relative >= 0.0 && relative <= 1.0 && absolute >= 0.0 && std::isfinite(absolute);
}

void RunFileJob(const JobOptions& given, const JobListener& send, vtkSTEPReader* reader)
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
  Json sent; ///< results that are not complete
  bool isComplete = false;
  const auto listener = [&](const Json& message)
  {
    send(message);
    if (message.contains("result"))
    {
      isComplete = message["complete"].get<bool>();
      // An assembly of thousands of solids is large.
      sent = isComplete ? Json() : message["result"];
    }
  };
  try
  {
    const auto own = reader ? vtkSmartPointer<vtkSTEPReader>(reader) : vtkSmartPointer<vtkSTEPReader>::New();
    Run(options, listener, own);
  }
  catch (const std::exception& error)
  {
    const std::string reason = DescribeException(error);
    if (isComplete)
    {
      send({ { options.PictureName.empty() ? "textures" : "picture", reason } });
      return;
    }
    if (sent.is_null())
    {
      sent = UnreadableFile(options.FileName, reason);
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

Json UnreadableFile(const std::string& fileName, const std::string& message)
{
  Json file = EmptyFile(fileName);
  file["messages"].push_back(message);
  return file;
}
}
