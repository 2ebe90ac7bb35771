#include "vtkSurfaceIntegralGPU.h"

#include "smBodyIntegrals.h"
#include "smBodyMeshes.h"
#include "smFormat.h"
#include "smIntegralNames.h"
#include "smSurfaceIntegrator.h"
#include "vtkSurfaceIntegralGPUInternals.h"

#include "vtkAutoInit.h"
#include "vtkBoundingBox.h"
#include "vtkComputeContext.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNURBSDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>

// Whoever loads this library has display points evaluated by OpenGL, too, and needs no vtk_module_autoinit for it.
VTK_MODULE_INIT(smRenderingNURBS)

vtkStandardNewMacro(vtkSurfaceIntegralGPU);

namespace
{
/// Field data want a point: VTK sends polydata without points as text, and cannot read the NaN of what was not computed from that.
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
}

vtkSurfaceIntegralGPU::vtkSurfaceIntegralGPU()
  : Implementation(new Internals)
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(6);
  this->Implementation->Controller = vtkMultiProcessController::GetGlobalController();
}

vtkSurfaceIntegralGPU::~vtkSurfaceIntegralGPU() = default;

void vtkSurfaceIntegralGPU::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n"
     << indent << "Backend: " << this->Backend << "\n"
     << indent << "MaximumEvaluations: " << this->MaximumEvaluations << "\n"
     << indent << "MaximumSeconds: " << this->MaximumSeconds << "\n"
     << indent << "KeepFaces: " << this->KeepFaces << "\n"
     << indent << "Integrands: " << this->GetNumberOfIntegrands() << "\n"
     << indent << "Constants: " << this->Implementation->Constants.size() << "\n"
     << indent << "FaceIds: " << this->Implementation->FaceIds.size() << "\n"
     << indent << "Selectors: " << this->Implementation->Selectors.size() << "\n"
     << indent << "AssemblyName: " << this->Implementation->AssemblyName << "\n"
     << indent << "Status: " << this->GetStatus() << "\n"
     << indent << "BackendName: " << this->GetBackendName() << "\n"
     << indent << "Renderer: " << this->GetRenderer() << "\n"
     << indent << "Controller: " << this->GetController() << "\n";
}

void vtkSurfaceIntegralGPU::SetRelativeTolerance(double tolerance)
{
  if (std::isnan(tolerance))
  {
    vtkErrorMacro("SetRelativeTolerance: not a number; give a value in (0, 1], for example 1e-9.");
    return;
  }
  const double clamped = std::clamp(tolerance, 1e-15, 1.0);
  if (this->RelativeTolerance != clamped)
  {
    this->RelativeTolerance = clamped;
    this->Modified();
  }
}

void vtkSurfaceIntegralGPU::RemoveAllIntegrands()
{
  Internals& self = *this->Implementation;
  if (!self.Integrands.empty() || !self.IntegrandText.empty())
  {
    self.Integrands.clear();
    self.Waterlines.clear();
    self.WaterlineNames.clear();
    self.Switched.clear();
    self.IntegrandText.clear();
    self.MomentDegree = -1;
    self.BendingEnergy = false;
    std::fill_n(self.ProjectedAreaDirection, 3, 0.0);
    self.HasWaterline = false;
    this->Modified();
  }
}

int vtkSurfaceIntegralGPU::GetNumberOfIntegrands() const
{
  return static_cast<int>(this->Implementation->Integrands.size());
}

std::string vtkSurfaceIntegralGPU::GetIntegrandName(int index) const
{
  return index >= 0 && index < this->GetNumberOfIntegrands() ? this->Implementation->Integrands[index].Name
                                                             : "";
}

void vtkSurfaceIntegralGPU::SetRenderWindow(vtkRenderWindow* window)
{
  if (this->Implementation->Context->GetWindow() != window)
  {
    this->Implementation->Context->SetWindow(window);
    this->Modified();
  }
}

vtkRenderWindow* vtkSurfaceIntegralGPU::GetRenderWindow()
{
  return this->Implementation->Context->GetWindow();
}

vtkComputeContext* vtkSurfaceIntegralGPU::GetComputeContext()
{
  return this->Implementation->Context;
}

double vtkSurfaceIntegralGPU::GetIntegral(const std::string& name) const
{
  const auto found = this->Implementation->Last.Integrals.find(name);
  return found == this->Implementation->Last.Integrals.end() ? vtkMath::Nan() : found->second.first;
}

double vtkSurfaceIntegralGPU::GetIntegralBound(const std::string& name) const
{
  const auto found = this->Implementation->Last.Integrals.find(name);
  return found == this->Implementation->Last.Integrals.end() ? vtkMath::Nan() : found->second.second;
}

std::string vtkSurfaceIntegralGPU::GetStatus() const
{
  return this->Implementation->Last.Status;
}

int vtkSurfaceIntegralGPU::GetNumberOfMessages() const
{
  return static_cast<int>(this->Implementation->Last.Messages.size());
}

std::string vtkSurfaceIntegralGPU::GetMessage(int index) const
{
  return index >= 0 && index < this->GetNumberOfMessages() ? this->Implementation->Last.Messages[index] : "";
}

std::string vtkSurfaceIntegralGPU::GetBackendName() const
{
  return this->Implementation->Last.Backend;
}

std::string vtkSurfaceIntegralGPU::GetRenderer() const
{
  return this->Implementation->Last.Renderer;
}

vtkTypeInt64 vtkSurfaceIntegralGPU::GetEvaluations() const
{
  return this->Implementation->Last.Evaluations;
}

vtkTypeInt64 vtkSurfaceIntegralGPU::GetDispatches() const
{
  return this->Implementation->Last.Dispatches;
}

int vtkSurfaceIntegralGPU::GetNumberOfSolids() const
{
  return this->Implementation->Last.Solids;
}

int vtkSurfaceIntegralGPU::GetNumberOfFaces() const
{
  return this->Implementation->Last.Faces;
}

double vtkSurfaceIntegralGPU::GetStartSeconds() const
{
  return this->Implementation->Last.StartSeconds;
}

double vtkSurfaceIntegralGPU::GetPrepareSeconds() const
{
  return this->Implementation->Last.PrepareSeconds;
}

double vtkSurfaceIntegralGPU::GetIntegrateSeconds() const
{
  return this->Implementation->Last.IntegrateSeconds;
}

int vtkSurfaceIntegralGPU::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkSurfaceIntegralGPU::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    port == 0     ? "vtkPolyData"
      : port == 5 ? "vtkPartitionedDataSetCollection"
                  : "vtkTable");
  return 1;
}

bool vtkSurfaceIntegralGPU::IntegrateBodies(std::vector<sm::BodyIntegrals>& bodies)
{
  return this->Implementation->Integrate(this, bodies);
}

void vtkSurfaceIntegralGPU::ForgetAbort()
{
  if (this->GetAbortExecute())
  {
    this->SetAbortExecute(0);
  }
}

std::string vtkSurfaceIntegralGPU::FindReason(
  const std::vector<sm::BodyIntegrals>& bodies, const std::string& status) const
{
  const Internals::Run& last = this->Implementation->Last;
  const auto worst = std::find_if(bodies.begin(), bodies.end(),
    [&status](const sm::BodyIntegrals& body) { return body.Status == status && !body.Reason.empty(); });
  return !last.Reason.empty() ? last.Reason
    : worst == bodies.end()   ? last.Note
                              : (worst->Name.empty() ? "" : worst->Name + ": ") + worst->Reason;
}

void vtkSurfaceIntegralGPU::ForgetLastRun()
{
  this->Implementation->Last = Internals::Run();
  this->Implementation->Displaced.clear();
}

int vtkSurfaceIntegralGPU::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals::Run& last = this->Implementation->Last;
  this->ForgetLastRun();
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  sm::RejectedInput rejected;
  std::vector<sm::BodyIntegrals> bodies = sm::CollectBodies(input, rejected);
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  const int pieces = outputVector->GetInformationObject(port)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
  const bool anyBody = !bodies.empty();
  if (anyBody)
  {
    this->Implementation->ChooseBodies(input, bodies);
  }
  int root = 0;
  const Internals::Role role = this->Implementation->ChooseRole(
    this->CanShareFaces(), pieces, anyBody || rejected.Plain + rejected.Withheld > 0, !bodies.empty(), root);
  if (role == Internals::Role::Worker)
  {
    this->Implementation->RunAsWorker(this, root);
    this->ForgetAbort();
  }
  if (role != Internals::Role::Owner)
  {
    return 1;
  }
  if (!anyBody && rejected.Plain + rejected.Withheld > 0)
  {
    last.Status = sm::names::StatusEmpty;
    last.Messages.push_back(rejected.Withheld > 0 ? "the points of the input were changed after it was read, "
                                                    "so its exact geometry no longer describes it"
                                                  : "the input is a mesh without exact geometry");
    vtkErrorMacro(
      "No exact geometry in the input: " << last.Messages.back()
                                         << ". Connect the output of vtkSTEPReader directly: filters "
                                            "that move or rebuild points drop the NURBS model. "
                                            "vtkNURBSTransform moves a part and keeps it.");
    return 0;
  }
  if (rejected.Plain + rejected.Withheld > 0)
  {
    last.Messages.push_back(
      std::to_string(rejected.Plain + rejected.Withheld) + " meshes without exact geometry were left out");
  }
  last.Solids = static_cast<int>(bodies.size());
  for (const sm::BodyIntegrals& body : bodies)
  {
    last.Faces += static_cast<int>(body.Model->GetNumberOfFaces());
  }
  last.Status = bodies.empty() ? sm::names::StatusEmpty : sm::names::StatusOk;
  if (bodies.empty())
  {
    this->Implementation->SetReason(
      anyBody ? "no solid is chosen" : "the input holds no solid and no surface");
  }
  const bool computed = !bodies.empty() && this->IntegrateBodies(bodies);
  const bool isShared = this->Implementation->Exchange != nullptr;
  this->Implementation->Exchange = nullptr;
  last.Ranks = computed ? std::max(last.Ranks, 1) : 0;
  for (sm::BodyIntegrals& body : bodies)
  {
    if (computed)
    {
      sm::SumFaces(body, this->Implementation->Integrands);
    }
    else
    {
      // What was not computed has no bound, so no tolerance is met.
      const double nan = vtkMath::Nan();
      const std::size_t count = this->Implementation->Integrands.size();
      body.Value.assign(count, nan);
      body.FaceValue.assign(count, nan);
      body.Bound.assign(count, nan);
      body.GapSquared = body.GapArea = body.MaxGap = nan;
      sm::CheckTopology(body);
      body.Flag(sm::names::StatusToleranceNotMet, "nothing was computed");
    }
  }
  if (computed)
  {
    sm::MeasureEdges(bodies);
  }
  this->ProduceOutputs(bodies, vtkPolyData::GetData(outputVector, 0), vtkTable::GetData(outputVector, 1),
    vtkTable::GetData(outputVector, 2), vtkTable::GetData(outputVector, 3));
  AddPlaceholderPoint(bodies, vtkPolyData::GetData(outputVector, 0));
  sm::columns::AddEdgeRows(bodies, vtkTable::GetData(outputVector, 4));
  sm::MakeBodyMeshes(
    bodies, this->GetMeshArrays(bodies), input, vtkPartitionedDataSetCollection::GetData(outputVector, 5));
  for (const sm::BodyIntegrals& body : bodies)
  {
    if (sm::IsWorse(body.Status, last.Status))
    {
      last.Status = body.Status;
    }
  }
  const std::string reason = this->FindReason(bodies, last.Status);
  for (const sm::BodyIntegrals& body : bodies)
  {
    last.Estimated = last.Estimated || body.IsEstimated();
    for (const std::string& message : body.Messages)
    {
      last.Messages.push_back((body.Name.empty() ? "" : body.Name + ": ") + message);
    }
  }
  if (!last.Note.empty())
  {
    last.Messages.push_back(last.Note);
  }
  if (last.Status != sm::names::StatusOk && !last.Messages.empty())
  {
    vtkWarningMacro("Status " << last.Status << (reason.empty() ? "" : ": ") << reason
                              << (last.Messages.size() > 1 ? " (and more, see GetMessage())" : ""));
  }
  // Last, for it is nothing that is wrong with the result.
  if (!last.FallbackReason.empty())
  {
    last.Messages.push_back("computed on the CPU, without OpenGL: " + last.FallbackReason);
  }
  this->Implementation->FillRunData(vtkPolyData::GetData(outputVector, 0)->GetFieldData());
  if (isShared)
  {
    this->ForgetAbort();
  }
  return 1;
}

void vtkSurfaceIntegralGPU::Internals::FillRunData(vtkFieldData* data) const
{
  sm::columns::SetString(data, sm::names::Status, this->Last.Status);
  sm::columns::SetString(data, sm::names::Backend, this->Last.Backend);
  sm::columns::SetString(data, sm::names::Renderer, this->Last.Renderer);
  sm::columns::SetInteger(data, sm::names::Evaluations, this->Last.Evaluations);
  sm::columns::SetInteger(data, sm::names::Dispatches, this->Last.Dispatches);
  sm::columns::SetInteger(data, sm::names::Faces, this->Last.Faces);
  sm::columns::SetInteger(data, sm::names::Ranks, this->Last.Ranks);
  sm::columns::SetInteger(data, sm::names::BoundsEstimated, this->Last.Estimated ? 1 : 0);
}

void vtkSurfaceIntegralGPU::ProduceOutputs(std::vector<sm::BodyIntegrals>& bodies, vtkPolyData* totals,
  vtkTable* solids, vtkTable* text, vtkTable* faces)
{
  const std::vector<sm::Integrand>& integrands = this->Implementation->Integrands;
  std::string summary;
  for (std::size_t k = 0; k < integrands.size(); ++k)
  {
    const std::string& name = integrands[k].Name;
    double total = bodies.empty() ? vtkMath::Nan() : 0.0;
    double bound = total;
    sm::columns::Column values(name, 1);
    sm::columns::Column bounds(name + sm::names::BoundSuffix, 1);
    for (sm::BodyIntegrals& body : bodies)
    {
      const double scale = Internals::GetScale(integrands[k], *body.Model, Internals::GetReach(body));
      if (body.Faces && !this->Implementation->GetObstacle(k).empty())
      {
        body.Flag(sm::names::StatusToleranceNotMet, name + " was not computed");
      }
      else if (body.Faces && !std::isfinite(body.Value[k]))
      {
        body.Flag(sm::names::StatusSuspect, name + " is not a finite number somewhere on the faces");
      }
      else if (body.Faces && !(body.Bound[k] <= this->RelativeTolerance * scale))
      {
        body.Flag(sm::names::StatusToleranceNotMet, "the bound of " + name + " is above the tolerance");
      }
      values.Append(&body.Value[k]);
      bounds.Append(&body.Bound[k]);
      total += body.Value[k];
      bound += body.Bound[k];
    }
    values.AddTo(solids->GetRowData());
    bounds.AddTo(solids->GetRowData());
    sm::columns::SetDoubles(totals->GetFieldData(), name, &total, 1);
    sm::columns::SetDoubles(totals->GetFieldData(), name + sm::names::BoundSuffix, &bound, 1);
    this->Implementation->Last.Integrals[name] = { total, bound };
    summary += name + " = " + sm::FormatWithBound(total, bound, "") + "\n";
  }
  this->Implementation->AddCenters(bodies, totals, solids, summary);
  sm::columns::AddBodyColumns(bodies, solids);
  sm::columns::SetString(text->GetRowData(), sm::names::Text, summary);
  std::vector<int> all(integrands.size());
  std::iota(all.begin(), all.end(), 0);
  sm::columns::AddFaceRows(bodies, integrands, faces, all);
}
