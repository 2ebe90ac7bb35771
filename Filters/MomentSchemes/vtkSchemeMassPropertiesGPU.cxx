#include "vtkSchemeMassPropertiesGPU.h"

#include "Detail/smSchemeRun.h"
#include "smFormat.h"
#include "smIntegralEngine.h"
#include "smMassAnalysis.h"
#include "smMassIntegrands.h"

#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkSchemeMassPropertiesGPU);

namespace
{
/// Largest closure residual of a closed surface whose trimmed faces are weighted by texels. A shell without
/// edges and a larger residual counts as a surface, not as a solid.
constexpr double MaxClosureResidual = 0.1;
}

struct vtkSchemeMassPropertiesGPU::Internals
{
  sm::SchemeRun Run;
  sm::SchemeTotals Estimates;
};

vtkSchemeMassPropertiesGPU::vtkSchemeMassPropertiesGPU()
  : Implementation(new Internals)
{
}

vtkSchemeMassPropertiesGPU::~vtkSchemeMassPropertiesGPU() = default;

void vtkSchemeMassPropertiesGPU::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << sm::GetSchemeName(this->Scheme) << "\n"
     << indent << "SubPatchFactor: " << this->SubPatchFactor << "\n"
     << indent << "TrimTextureFactor: " << this->TrimTextureFactor << "\n"
     << indent << "ChordTolerance: " << this->ChordTolerance << "\n"
     << indent << "Deviation: " << (this->Deviation == BOUNDED ? "BOUNDED" : "SAMPLED") << "\n"
     << indent << "KeepTrimTextures: " << this->KeepTrimTextures << "\n";
}

void vtkSchemeMassPropertiesGPU::SetChordTolerance(double tolerance)
{
  if (!(tolerance > 0.0 && tolerance < 1.0))
  {
    vtkErrorMacro("The chord tolerance "
      << sm::FormatDigits(tolerance, 6)
      << " is not used: give a number above 0 and below 1, for example 1e-8.");
    return;
  }
  if (this->ChordTolerance != tolerance)
  {
    this->ChordTolerance = tolerance;
    this->Modified();
  }
}

void vtkSchemeMassPropertiesGPU::ResetResults()
{
  this->Superclass::ResetResults();
  this->Implementation->Estimates = sm::SchemeTotals();
  this->Implementation->Run.Forget();
}

void vtkSchemeMassPropertiesGPU::ReleaseKept()
{
  this->Superclass::ReleaseKept();
  this->Implementation->Run.ReleaseMemory();
}

sm::IntegralRequest vtkSchemeMassPropertiesGPU::MakeRequest() const
{
  sm::IntegralRequest request;
  request.Integrands = sm::GetMassIntegrands();
  request.UsePlacements = false;
  sm::SchemeIntegrator::Setup setup;
  setup.Points = this->Scheme;
  setup.Options.Factor = this->SubPatchFactor;
  request.EstimateFace = [setup](const sm::Face& face)
  {
    return sm::RunSize{ sm::SchemeIntegrator::CountEvaluations(face.Surface, setup),
      sm::EstimateSize(face).Bytes };
  };
  return request;
}

bool vtkSchemeMassPropertiesGPU::IntegrateBodies(
  const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies)
{
  sm::IntegralEngine& engine = this->GetEngine();
  sm::RunReport& report = engine.GetReport();
  const sm::IntegralLimits limits = this->MakeLimits();
  if (!engine.ChooseRunner(request, limits.Backend))
  {
    return false;
  }
  sm::SchemeRun::Options options;
  options.Setup.Points = this->Scheme;
  options.Setup.Options.Factor = this->SubPatchFactor;
  options.Setup.Options.TextureFactor = this->TrimTextureFactor;
  options.Setup.Options.Deviation =
    this->Deviation == BOUNDED ? sm::DeviationMode::Bounded : sm::DeviationMode::Sampled;
  options.Setup.Perturbation = limits.Perturbation;
  options.Setup.KeepTextures = this->KeepTrimTextures;
  options.Setup.MaximumEvaluations = limits.MaximumEvaluations;
  options.Setup.MaximumSeconds = limits.MaximumSeconds;
  options.ChordTolerance = this->ChordTolerance;
  options.Context = report.Backend == sm::names::BackendOpenGL ? engine.GetContext() : nullptr;
  const vtkTypeUInt64 dispatches = engine.GetContext()->GetNumberOfDispatches();
  const bool done = this->Implementation->Run.Integrate(options, bodies, limits.Progress);
  const sm::SchemeIntegrator& integrator = this->Implementation->Run.GetIntegrator();
  report.Evaluations = integrator.GetEvaluations();
  report.Dispatches = static_cast<std::int64_t>(engine.GetContext()->GetNumberOfDispatches() - dispatches);
  report.StartSeconds += integrator.GetStartSeconds();
  report.PrepareSeconds = integrator.GetPrepareSeconds();
  report.IntegrateSeconds = integrator.GetIntegrateSeconds();
  if (!done)
  {
    report.SetReason(this->Implementation->Run.GetMessage());
  }
  return done;
}

sm::MassAnalysisOptions vtkSchemeMassPropertiesGPU::MakeAnalysisOptions() const
{
  sm::MassAnalysisOptions options;
  options.HasBounds = false;
  options.MaxClosureResidual = MaxClosureResidual;
  return options;
}

void vtkSchemeMassPropertiesGPU::AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies)
{
  this->Superclass::AnalyzeBodies(bodies);
  this->Implementation->Estimates = this->Implementation->Run.GetTotals(bodies);
  if (!this->GetAnalysis().HasOneUnit)
  {
    this->Implementation->Estimates.Estimate = this->Implementation->Estimates.EstimateWithBoundary =
      vtkMath::Nan();
  }
  const bool hasVolume = std::any_of(bodies.begin(), bodies.end(),
    [](const sm::BodyIntegrals& body) { return body.Faces && body.HasVolume(); });
  if (hasVolume)
  {
    // The note is set once for all bodies.
    this->GetEngine().GetReport().Note = sm::GetSchemeName(this->Scheme) +
      " has no error bound: the paper's estimate of the volume's error is not a bound; Mass Properties has "
      "bounds";
  }
}

void vtkSchemeMassPropertiesGPU::WriteMoreOutputs(
  const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs, std::string& summary) const
{
  const sm::SchemeTotals& total = this->Implementation->Estimates;
  const std::string scheme = sm::GetSchemeName(this->Scheme);
  this->Implementation->Run.AddColumns(scheme, bodies, total,
    sm::columns::Writer(outputs.Arrays, outputs.Totals->GetFieldData()),
    sm::columns::Writer(outputs.Arrays, outputs.Solids->GetRowData(), bodies.size()));
  const std::string texels = std::to_string(this->TrimTextureFactor);
  summary += "Scheme: " + scheme + ", " + std::to_string(total.SubPatches) + " sub-patches\n" +
    "k = " + std::to_string(this->SubPatchFactor) + ", " + texels + " x " + texels +
    " texels a sub-patch, chords of planes to " + sm::FormatDigits(this->ChordTolerance, 3) +
    " of the size, deviations " + (this->Deviation == BOUNDED ? "bounded" : "sampled") + "\n" +
    "The paper's error estimate of the volume, not a bound: " +
    sm::FormatNumber(total.Estimate, vtkMath::Nan()) + " " +
    (bodies.empty() ? "mm" : bodies.front().Model->GetLengthUnit()) + "^3\n";
}

double vtkSchemeMassPropertiesGPU::GetPaperErrorEstimate() const
{
  return this->Implementation->Estimates.Estimate;
}

double vtkSchemeMassPropertiesGPU::GetPaperErrorEstimateWithBoundary() const
{
  return this->Implementation->Estimates.EstimateWithBoundary;
}

vtkTypeInt64 vtkSchemeMassPropertiesGPU::GetSubPatches() const
{
  return this->Implementation->Estimates.SubPatches;
}

int vtkSchemeMassPropertiesGPU::GetNumberOfTrimTextures() const
{
  return static_cast<int>(this->Implementation->Run.GetTextures().size());
}

vtkImageData* vtkSchemeMassPropertiesGPU::GetTrimTexture(int index) const
{
  return index >= 0 && index < this->GetNumberOfTrimTextures()
    ? this->Implementation->Run.GetTextures()[index].Image.Get()
    : nullptr;
}

std::string vtkSchemeMassPropertiesGPU::GetTrimTextureName(int index) const
{
  return index >= 0 && index < this->GetNumberOfTrimTextures()
    ? this->Implementation->Run.GetTextures()[index].Name
    : "";
}
