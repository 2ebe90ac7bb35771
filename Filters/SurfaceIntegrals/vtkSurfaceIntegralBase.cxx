#include "vtkSurfaceIntegralBase.h"

#include "smAbortFlag.h"
#include "smColumns.h"
#include "smFormat.h"
#include "smIntegralEngine.h"
#include "smMeshDemand.h"
#include "smShaderFault.h"
#include "smWeights.h"

#include "vtkAutoInit.h"
#include "vtkInformation.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>

// Initialises the OpenGL evaluation of display points for every user of this library, without
// vtk_module_autoinit in the application.
VTK_MODULE_INIT(smRenderingNURBS)

vtkSurfaceIntegralBase::vtkSurfaceIntegralBase()
  : Engine(new sm::IntegralEngine)
  , Arrays(new sm::columns::KeptArrays)
{
  sm::ClearAbortAtStart(this);
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(7);
  this->GetComputeContext()->AddObserver(
    vtkComputeContext::COMPILE_EVENT, this, &vtkSurfaceIntegralBase::ReportCompilation);
}

void vtkSurfaceIntegralBase::ReportCompilation()
{
  this->IsCompiling = true;
}

void vtkSurfaceIntegralBase::ReportProgress(double fraction)
{
  const std::string text = this->GetProgressText() ? this->GetProgressText() : this->GetClassName();
  if (this->IsCompiling)
  {
    this->SetProgressText((text + ": compiling shaders").c_str());
  }
  this->UpdateProgress(fraction);
  if (this->IsCompiling)
  {
    this->IsCompiling = false;
    this->SetProgressText(text.c_str());
  }
}

vtkSurfaceIntegralBase::~vtkSurfaceIntegralBase() = default;

void vtkSurfaceIntegralBase::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << this->Backend << "\n"
     << indent << "MaximumEvaluations: " << this->MaximumEvaluations << "\n"
     << indent << "MaximumSeconds: " << this->MaximumSeconds << "\n"
     << indent << "GapLimit: " << this->GapLimit << "\n"
     << indent << "Selectors: " << this->Selectors.size() << "\n"
     << indent << "TotalRow: " << this->TotalRow << "\n"
     << indent << "AssemblyName: " << this->AssemblyName << "\n"
     << indent << "Status: " << this->GetStatus() << "\n"
     << indent << "BackendName: " << this->GetBackendName() << "\n"
     << indent << "Renderer: " << this->GetRenderer() << "\n"
     << indent << "BackendReason: " << this->GetBackendReason() << "\n"
     << indent << "Controller: " << this->GetController() << "\n";
}

int vtkSurfaceIntegralBase::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, int port, vtkMTimeType* time)
{
  sm::PassMeshDemand(this, inputs, outputs, port);
  return this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, time);
}

int vtkSurfaceIntegralBase::FillInputPortInformation(int, vtkInformation* info)
{
  // All data, which is refused in one sentence; VTK says one for each request.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkSurfaceIntegralBase::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    port == 0 || port == 6 ? "vtkPolyData"
      : port == 5          ? "vtkPartitionedDataSetCollection"
                           : "vtkTable");
  if (port == 5)
  {
    sm::DeclareMeshOutput(info);
  }
  return 1;
}

void vtkSurfaceIntegralBase::Update(int port)
{
  sm::RequestMeshOutput(this, port);
  this->Superclass::Update(port);
}

vtkTypeBool vtkSurfaceIntegralBase::Update(int port, vtkInformationVector* requests)
{
  sm::RequestMeshOutput(this, port);
  return this->Superclass::Update(port, requests);
}

void vtkSurfaceIntegralBase::ChangeRelativeTolerance(double tolerance)
{
  const bool isValid = tolerance > 0.0 && tolerance <= 1.0;
  this->ChangeSetting(this->RelativeTolerance, isValid ? std::max(tolerance, 1e-15) : tolerance, isValid,
    "relative tolerance", "1e-15 to 1, for example 1e-9");
}

void vtkSurfaceIntegralBase::ChangeDensity(double& setting, double density)
{
  this->ChangeSetting(setting, density, density == 0.0 || sm::IsWeight(density), "density",
    (std::string("kg/m^3 from ") + sm::WeightRange + ", for example 7850 for steel, or 0").c_str());
}

void vtkSurfaceIntegralBase::ChangeSetting(
  double& setting, double value, bool isValid, const char* name, const char* advice)
{
  if (!isValid)
  {
    vtkErrorMacro("The " << name << " " << sm::FormatDigits(value, 6) << " is not used, "
                         << sm::FormatDigits(setting, 6) << " is kept: give " << advice << ".");
  }
  else if (setting != value)
  {
    setting = value;
    this->Modified();
  }
}

void vtkSurfaceIntegralBase::AddSelector(const std::string& selector)
{
  if (!selector.empty() &&
    std::find(this->Selectors.begin(), this->Selectors.end(), selector) == this->Selectors.end())
  {
    this->Selectors.push_back(selector);
    this->Modified();
  }
}

void vtkSurfaceIntegralBase::ClearSelectors()
{
  if (!this->Selectors.empty())
  {
    this->Selectors.clear();
    this->Modified();
  }
}

int vtkSurfaceIntegralBase::GetNumberOfSelectors() const
{
  return static_cast<int>(this->Selectors.size());
}

void vtkSurfaceIntegralBase::SetLeftOut(BodyFilter leaveOut)
{
  this->LeavesOut = std::move(leaveOut);
  this->Modified();
}

void vtkSurfaceIntegralBase::SetAssemblyName(const std::string& name)
{
  if (this->AssemblyName != name)
  {
    this->AssemblyName = name;
    this->Modified();
  }
}

std::string vtkSurfaceIntegralBase::GetAssemblyName() const
{
  return this->AssemblyName;
}

void vtkSurfaceIntegralBase::SetRenderWindow(vtkRenderWindow* window)
{
  if (this->GetComputeContext()->GetWindow() != window)
  {
    this->GetComputeContext()->SetWindow(window);
    this->Modified();
  }
}

vtkRenderWindow* vtkSurfaceIntegralBase::GetRenderWindow()
{
  return this->GetComputeContext()->GetWindow();
}

vtkComputeContext* vtkSurfaceIntegralBase::GetComputeContext()
{
  return this->Engine->GetContext();
}

void vtkSurfaceIntegralBase::SetController(vtkMultiProcessController* controller)
{
  if (this->Engine->GetController() != controller)
  {
    this->Engine->SetController(controller);
    this->Modified();
  }
}

vtkMultiProcessController* vtkSurfaceIntegralBase::GetController()
{
  return this->Engine->GetController();
}

void vtkSurfaceIntegralBase::ReleaseMemory()
{
  this->Engine->ReleaseMemory();
  this->Arrays->Clear();
  this->ReleaseKept();
}

std::string vtkSurfaceIntegralBase::GetStatus() const
{
  return sm::GetText(this->Engine->GetReport().Status);
}

int vtkSurfaceIntegralBase::GetNumberOfMessages() const
{
  return static_cast<int>(this->Engine->GetReport().Messages.size());
}

std::string vtkSurfaceIntegralBase::GetMessage(int index) const
{
  return index >= 0 && index < this->GetNumberOfMessages() ? this->Engine->GetReport().Messages[index] : "";
}

std::string vtkSurfaceIntegralBase::GetBackendName() const
{
  return this->Engine->GetReport().Backend;
}

std::string vtkSurfaceIntegralBase::GetRenderer() const
{
  return this->Engine->GetReport().Renderer;
}

std::string vtkSurfaceIntegralBase::GetBackendReason() const
{
  return this->Engine->GetReport().BackendReason;
}

double vtkSurfaceIntegralBase::GetEstimatedEvaluations() const
{
  return this->Engine->GetReport().Estimate.Size.Evaluations;
}

double vtkSurfaceIntegralBase::GetEstimatedSeconds(int backend) const
{
  const sm::BackendCost& estimate = this->Engine->GetReport().Estimate;
  return backend == OPENGL ? estimate.OpenGLSeconds : backend == CPU ? estimate.CPUSeconds : 0.0;
}

vtkTypeInt64 vtkSurfaceIntegralBase::GetEvaluations() const
{
  return this->Engine->GetReport().Evaluations;
}

vtkTypeInt64 vtkSurfaceIntegralBase::GetDispatches() const
{
  return this->Engine->GetReport().Dispatches;
}

int vtkSurfaceIntegralBase::GetNumberOfSolids() const
{
  return this->Engine->GetReport().Solids;
}

int vtkSurfaceIntegralBase::GetNumberOfFaces() const
{
  return this->Engine->GetReport().Faces;
}

int vtkSurfaceIntegralBase::GetNumberOfRanks() const
{
  return this->Engine->GetReport().Ranks;
}

double vtkSurfaceIntegralBase::GetStartSeconds() const
{
  return this->Engine->GetReport().StartSeconds;
}

double vtkSurfaceIntegralBase::GetPrepareSeconds() const
{
  return this->Engine->GetReport().PrepareSeconds;
}

double vtkSurfaceIntegralBase::GetCutSeconds() const
{
  return this->Engine->GetReport().CutSeconds;
}

double vtkSurfaceIntegralBase::GetPlanSeconds() const
{
  return this->Engine->GetReport().PlanSeconds;
}

double vtkSurfaceIntegralBase::GetIntegrateSeconds() const
{
  return this->Engine->GetReport().IntegrateSeconds;
}

double vtkSurfaceIntegralBase::GetAnalyseSeconds() const
{
  return this->Engine->GetReport().AnalyseSeconds;
}

void vtkSurfaceIntegralBase::ResetResults()
{
  this->Engine->GetReport() = sm::RunReport();
}

bool vtkSurfaceIntegralBase::IntegrateBodies(
  const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies)
{
  return this->Engine->Integrate(request, this->MakeLimits(), bodies);
}

sm::IntegralLimits vtkSurfaceIntegralBase::MakeLimits(double begin, double end)
{
  sm::IntegralLimits limits;
  limits.Backend = static_cast<sm::BackendChoice>(this->Backend);
  limits.MaximumEvaluations = this->MaximumEvaluations;
  limits.MaximumSeconds = this->MaximumSeconds;
  limits.CacheFaceResults = this->CacheFaceResults;
  limits.Perturbation = sm::GetSampleFactor();
  limits.Progress = [this, begin, end](double fraction)
  {
    this->ReportProgress(begin + (end - begin) * fraction);
    return !this->GetAbortExecute();
  };
  return limits;
}

std::string vtkSurfaceIntegralBase::FindReason(const std::vector<sm::BodyIntegrals>& bodies) const
{
  const sm::RunReport& report = this->Engine->GetReport();
  return report.Status == sm::Status::Ok ? std::string() : report.FindReason(bodies);
}

std::string vtkSurfaceIntegralBase::FormatStatus(const std::vector<sm::BodyIntegrals>& bodies) const
{
  return sm::FormatStatus(this->GetStatus(), this->FindReason(bodies)) +
    (this->Engine->GetReport().Estimated ? "Some bounds are estimates.\n" : "");
}

sm::IntegralEngine& vtkSurfaceIntegralBase::GetEngine()
{
  return *this->Engine;
}

const sm::IntegralEngine& vtkSurfaceIntegralBase::GetEngine() const
{
  return *this->Engine;
}
