// The run of a filter: its input, its role among several processes, its outputs, and how it ends.
#include "vtkSurfaceIntegralBase.h"

#include "Engine/smBodySelection.h"
#include "Outputs/smEmptyRanges.h"
#include "Outputs/smFlaggedPlaces.h"
#include "smBodyMeshes.h"
#include "smBodyScales.h"
#include "smColumns.h"
#include "smFailureReason.h"
#include "smFileState.h"
#include "smIntegralEngine.h"

#include "vtkBoundingBox.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTimerLog.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <exception>
#include <map>
#include <new>
#include <set>

namespace
{
/// Number of messages that a warning has at most; GetMessage() has them all.
constexpr std::size_t MaxMessagesOfWarning = 8;

/// Number of flagged places that the summary names.
constexpr std::size_t MaxPlacesOfText = 5;

/// The reason of a status, and the messages that do not repeat it, a line each.
std::string ListMessages(const std::string& reason, const std::vector<std::string>& messages)
{
  std::string list = reason.empty() ? "" : ": " + reason;
  std::size_t shown = 0;
  std::size_t left = 0;
  for (const std::string& message : messages)
  {
    if (reason.find(message) == std::string::npos)
    {
      ++(shown < MaxMessagesOfWarning ? shown : left);
      list += shown + left > MaxMessagesOfWarning ? "" : "\n  " + message;
    }
  }
  return list + (left > 0 ? "\n  and " + std::to_string(left) + " more messages" : "");
}

/// Adds a point without a cell to an empty polydata: VTK sends polydata without points as text, and cannot
/// read NaN in the field data from it.
void AddPlaceholderPoint(const std::vector<sm::BodyIntegrals>& bodies, vtkPolyData* totals)
{
  if (totals->GetNumberOfPoints() > 0)
  {
    return;
  }
  vtkBoundingBox box;
  for (const sm::BodyIntegrals& body : bodies)
  {
    sm::AddPlacedBox(body, box);
  }
  double middle[3] = { 0.0, 0.0, 0.0 };
  if (box.IsValid())
  {
    box.GetCenter(middle);
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(middle);
  totals->SetPoints(points);
}

/// Returns the number of pieces of the update.
int GetNumberOfPieces(vtkInformation* request, vtkInformationVector* outputVector)
{
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  return outputVector->GetInformationObject(port)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
}

void AppendText(const std::string& text, vtkTable* table)
{
  auto* summary = vtkStringArray::SafeDownCast(table->GetRowData()->GetAbstractArray(sm::names::Text));
  if (summary && summary->GetNumberOfValues() > 0 && !text.empty())
  {
    const std::string before = summary->GetValue(0);
    summary->SetValue(0, before + (before.empty() || before.back() == '\n' ? "" : "\n") + text);
  }
}

/// The triangles of flagged faces are those that are shown, or those of the scale mesh.
std::size_t GetNumberOfTriangles(const sm::BodyIntegrals& body)
{
  vtkPolyData* const scales = body.Model->GetScaleMesh();
  return static_cast<std::size_t>(
    std::max(body.Mesh->GetNumberOfCells(), scales ? scales->GetNumberOfCells() : 0));
}

/// Throws std::bad_alloc unless there is memory for the outputs: VTK's arrays end the process where they find
/// none.
void CheckOutputMemory(const std::vector<sm::BodyIntegrals>& bodies, std::size_t arrays)
{
  // Columns of doubles with their bounds, twice as large while they grow; and the glyphs.
  constexpr std::size_t BytesOfValue = 4 * sizeof(double);
  constexpr std::size_t Columns = 64;
  constexpr std::size_t BytesOfFlaggedEdge = 2048;
  constexpr std::size_t BytesOfFlaggedTriangle = 512;
  std::size_t bytes = std::size_t{ 1 } << 20;
  // Instances of a model share the arrays of its cells.
  std::set<const vtkTrimmedNURBSModel*> models;
  for (const sm::BodyIntegrals& body : bodies)
  {
    const auto faces = static_cast<std::size_t>(body.Model->GetNumberOfFaces());
    const std::size_t edges = body.Edges ? body.Edges->size() : 0;
    const bool isFirst = models.insert(body.Model).second;
    const std::size_t cells = isFirst ? static_cast<std::size_t>(body.Mesh->GetNumberOfCells()) : 0;
    bytes += BytesOfValue * (Columns + faces * (arrays + 6) + edges * 10) + cells * arrays * sizeof(float);
    // At most: every edge and every face is drawn as a flagged one.
    bytes += body.Status >= sm::Status::Suspect ? edges * BytesOfFlaggedEdge : 0;
    bytes += body.FaceDefects.empty() ? 0 : GetNumberOfTriangles(body) * BytesOfFlaggedTriangle;
  }
  ::operator delete(::operator new(bytes));
}
}

void vtkSurfaceIntegralBase::ChooseBodies(
  vtkDataObject* input, std::vector<sm::BodyIntegrals>& bodies, sm::RejectedInput& rejected)
{
  if (this->Selectors.empty())
  {
    return;
  }
  std::vector<std::string>& messages = this->Engine->GetReport().Messages;
  std::set<sm::LeafPlace> chosen;
  std::vector<std::string> unmatched;
  const std::string problem = sm::SelectLeaves(input, this->AssemblyName, this->Selectors, chosen, unmatched);
  if (!problem.empty())
  {
    messages.push_back(problem);
  }
  for (const std::string& selector : unmatched)
  {
    messages.push_back("the selector \"" + selector + "\" names no solid");
  }
  auto& meshes = rejected.Meshes;
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(),
                 [&chosen](const auto& mesh)
                 {
                   // The places of a data object are numbered from 0.
                   const auto place = chosen.lower_bound({ mesh.first, 0 });
                   return place == chosen.end() || place->first != mesh.first;
                 }),
    meshes.end());
  // Bodies have the order of the leaves.
  std::map<vtkDataObject*, int> occurrences;
  std::vector<sm::BodyIntegrals> kept;
  for (sm::BodyIntegrals& body : bodies)
  {
    if (chosen.count({ body.Mesh, occurrences[body.Mesh]++ }) > 0)
    {
      kept.push_back(std::move(body));
    }
  }
  bodies = std::move(kept);
}

void vtkSurfaceIntegralBase::LeaveOutBodies(vtkDataObject* input, std::vector<sm::BodyIntegrals>& bodies)
{
  if (this->LeavesOut)
  {
    std::vector<std::string>& messages = this->Engine->GetReport().Messages;
    const std::vector<std::string> more = this->LeavesOut(input, bodies);
    messages.insert(messages.end(), more.begin(), more.end());
  }
}

int vtkSurfaceIntegralBase::RejectInput(bool isWithheld)
{
  sm::RunReport& report = this->Engine->GetReport();
  report.RejectInput(isWithheld);
  vtkErrorMacro(
    "No exact geometry in the input: " << report.Messages.back()
                                       << ". Take the output of STEP Reader or BREP Reader: filters "
                                          "that move or rebuild points drop the exact faces. "
                                          "NURBS Transform moves a part and keeps them.");
  return 0;
}

void vtkSurfaceIntegralBase::Analyze(
  const sm::IntegralRequest& request, bool computed, std::vector<sm::BodyIntegrals>& bodies)
{
  this->Engine->Sum(request, computed, this->GapLimit, bodies);
  this->AnalyzeBodies(bodies);
  this->Engine->GetReport().AddStatuses(bodies);
}

void vtkSurfaceIntegralBase::Write(
  const std::vector<sm::BodyIntegrals>& bodies, vtkDataObject* input, vtkInformationVector* outputVector)
{
  const std::vector<sm::MeshArray> arrays = this->GetMeshArrays(bodies);
  CheckOutputMemory(bodies, arrays.size());
  this->Arrays->Restart();
  const Outputs outputs{ *this->Arrays, vtkPolyData::GetData(outputVector, 0),
    vtkTable::GetData(outputVector, 1), vtkTable::GetData(outputVector, 2),
    vtkTable::GetData(outputVector, 3),
    this->GetNumberOfOutputPorts() > 7 ? vtkTable::GetData(outputVector, 7) : nullptr };
  sm::columns::AddBodyLabels(outputs.Arrays, bodies, outputs.Solids);
  this->WriteOutputs(bodies, outputs);
  sm::columns::AddBodyCounts(outputs.Arrays, bodies, outputs.Solids);
  sm::columns::Writer(outputs.Arrays, outputs.Text->GetFieldData())
    .SetString(sm::names::Status, this->GetStatus());
  AddPlaceholderPoint(bodies, outputs.Totals);
  sm::columns::AddEdgeRows(outputs.Arrays, bodies, vtkTable::GetData(outputVector, 4));
  sm::MakeBodyMeshes(bodies, arrays, input, vtkPartitionedDataSetCollection::GetData(outputVector, 5));
  const std::vector<sm::FlaggedPlace> places = sm::FindFlaggedPlaces(bodies);
  sm::DrawFlaggedPlaces(places, bodies, vtkPolyData::GetData(outputVector, 6));
  AppendText(sm::ListFlaggedPlaces(places, bodies, MaxPlacesOfText), outputs.Text);
  AppendText(
    sm::FormatNotes(this->FindReason(bodies), this->Engine->GetReport().ListNotes(bodies)), outputs.Text);
  this->Engine->GetReport().FillFieldData(
    sm::columns::Writer(outputs.Arrays, outputs.Totals->GetFieldData()));
}

void vtkSurfaceIntegralBase::WriteTotalRow(
  std::size_t bodies, std::size_t all, vtkInformationVector* outputVector) const
{
  const std::string part =
    bodies < all ? " of " + std::to_string(bodies) + " of " + std::to_string(all) + " solids" : std::string();
  sm::columns::AppendTotalRow(vtkPolyData::GetData(outputVector, 0)->GetFieldData(), "Total" + part,
    vtkTable::GetData(outputVector, 1));
}

/// The bodies and the state of a run's input.
struct vtkSurfaceIntegralBase::Input
{
  /// The bodies to integrate, and the integrals.
  std::vector<sm::BodyIntegrals> Bodies;
  sm::IntegralRequest Request;
  /// Number of bodies, selected or not.
  std::size_t AllBodies = 0;
  sm::RejectedInput Rejected;
  int GetNumberOfMeshes() const { return this->Rejected.Plain + this->Rejected.Withheld; }
  sm::FileState File;
};

void vtkSurfaceIntegralBase::FindBodies(vtkDataObject* input, Input& found)
{
  this->ResetResults();
  found.File = sm::GetFileState(input);
  found.Bodies = sm::CollectBodies(input, found.Rejected);
  found.AllBodies = found.Bodies.size();
  if (found.AllBodies > 0)
  {
    this->ChooseBodies(input, found.Bodies, found.Rejected);
    this->LeaveOutBodies(input, found.Bodies);
  }
  found.Request = this->MakeRequest();
  this->Engine->EstimateBackends(found.Request, found.Bodies);
}

int vtkSurfaceIntegralBase::Run(
  vtkInformation* request, vtkDataObject* input, vtkInformationVector* outputVector)
{
  const int pieces = GetNumberOfPieces(request, outputVector);
  Input found;
  std::exception_ptr failure;
  try
  {
    this->FindBodies(input, found);
  }
  catch (...)
  {
    // The other ranks wait for this one until the roles are chosen.
    failure = std::current_exception();
    found.Bodies.clear();
  }
  const bool hasInput = failure || found.AllBodies > 0 || found.GetNumberOfMeshes() > 0;
  const sm::IntegralEngine::Role role =
    this->Engine->ChooseRole(this->CanShareFaces(), pieces, hasInput, !found.Bodies.empty());
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  if (role == sm::IntegralEngine::Role::Worker)
  {
    this->RunAsWorker();
  }
  const bool done =
    role != sm::IntegralEngine::Role::Owner || this->RunAsOwner(found, input, outputVector) != 0;
  // Where ranks run together, what is downstream must run on all or on none.
  return done || pieces > 1 ? 1 : 0;
}

int vtkSurfaceIntegralBase::RunAsOwner(Input& found, vtkDataObject* input, vtkInformationVector* outputVector)
{
  sm::RunReport& report = this->Engine->GetReport();
  std::vector<sm::BodyIntegrals>& bodies = found.Bodies;
  if (found.AllBodies == 0 && found.GetNumberOfMeshes() > 0)
  {
    return this->RejectInput(found.Rejected.Withheld > 0);
  }
  report.AddBodies(bodies, found.Rejected);
  report.AddFile(found.File, found.AllBodies > 0, !bodies.empty());
  const bool computed = !bodies.empty() && this->IntegrateBodies(found.Request, bodies);
  this->Engine->FinishSharing();
  const double start = vtkTimerLog::GetUniversalTime();
  this->Analyze(found.Request, computed, bodies);
  this->Write(bodies, input, outputVector);
  if (this->TotalRow && computed && bodies.size() > 1)
  {
    this->WriteTotalRow(bodies.size(), found.AllBodies, outputVector);
  }
  this->AddMessages(bodies);
  report.AnalyseSeconds = vtkTimerLog::GetUniversalTime() - start;
  return 1;
}

void vtkSurfaceIntegralBase::RunAsWorker()
{
  std::exception_ptr failure;
  try
  {
    this->Engine->RunAsWorker(this->MakeRequest(), this->MakeLimits());
    return;
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  // The rank that has the bodies computes this share, so that the result is complete, and this rank's outputs
  // are empty.
  this->Engine->FinishSharing(failure);
  // Data kept between runs may be incomplete.
  this->ReleaseMemory();
  this->ResetResults();
  this->Engine->GetReport().Messages.push_back(
    std::string("other ranks computed the share of this one: ") + sm::GetReason(failure));
}

void vtkSurfaceIntegralBase::AddMessages(const std::vector<sm::BodyIntegrals>& bodies)
{
  sm::RunReport& report = this->Engine->GetReport();
  const std::string reason = this->FindReason(bodies);
  report.AddMessages(bodies);
  if (report.Status != sm::Status::Ok && !report.Messages.empty())
  {
    vtkWarningMacro("Status " << this->GetStatus() << ListMessages(reason, report.Messages));
  }
  // This message is the last one, as it does not indicate an error of the result.
  if (!report.FallbackReason.empty())
  {
    report.Messages.push_back("computed on the CPU, without OpenGL: " + report.FallbackReason);
  }
}

vtkTypeBool vtkSurfaceIntegralBase::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkTypeBool result = this->Superclass::ProcessRequest(request, inputVector, outputVector);
  if (result && request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    // Also of what subclasses have added to the outputs.
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
    {
      sm::MarkEmptyRanges(vtkDataObject::GetData(outputVector, port));
    }
  }
  return result;
}

int vtkSurfaceIntegralBase::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  int result = 1;
  std::exception_ptr failure;
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    sm::RemoveFileState(vtkDataObject::GetData(outputVector, port));
  }
  try
  {
    result = this->Run(request, vtkDataObject::GetData(inputVector[0], 0), outputVector);
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  this->Engine->FinishSharing(failure);
  if (failure)
  {
    this->Fail(failure, outputVector);
  }
  this->ShareBlocks(request, outputVector, 5);
  if (this->GetReleaseDataFlag())
  {
    this->ReleaseMemory();
  }
  return result;
}

void vtkSurfaceIntegralBase::ShareBlocks(
  vtkInformation* request, vtkInformationVector* outputVector, int port)
{
  this->Engine->ShareStructure(
    GetNumberOfPieces(request, outputVector), vtkPartitionedDataSetCollection::GetData(outputVector, port));
}

void vtkSurfaceIntegralBase::Fail(const std::exception_ptr& failure, vtkInformationVector* outputVector)
{
  // Data kept between runs may be incomplete.
  this->ReleaseMemory();
  this->ResetResults();
  sm::RunReport& report = this->Engine->GetReport();
  report.Status = sm::Status::NotComputed;
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject::GetData(outputVector, port)->Initialize();
  }
  try
  {
    const std::string reason = sm::GetReason(failure);
    report.SetReason("nothing was computed: " +
      (reason == sm::InsufficientMemory ? reason : "an error of the program: " + reason));
    vtkPolyData* totals = vtkPolyData::GetData(outputVector, 0);
    AddPlaceholderPoint({}, totals);
    report.FillFieldData(sm::columns::Writer(*this->Arrays, totals->GetFieldData()));
    vtkTable* text = vtkTable::GetData(outputVector, 2);
    sm::columns::Writer(*this->Arrays, text->GetRowData()).SetString(sm::names::Text, this->FormatStatus({}));
    sm::columns::Writer(*this->Arrays, text->GetFieldData()).SetString(sm::names::Status, this->GetStatus());
    vtkWarningMacro("Status " << this->GetStatus() << ": " << report.Reason);
  }
  catch (const std::bad_alloc&)
  {
    // The getters have the status.
  }
}
