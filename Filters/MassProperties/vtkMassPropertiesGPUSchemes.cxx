// The paper's schemes in vtkMassPropertiesGPU.
#include "smFormat.h"
#include "smMassPropertyNames.h"
#include "smMassTable.h"
#include "smMassTolerance.h"
#include "vtkMassPropertiesGPUInternals.h"
#include "vtkSurfaceIntegralGPUInternals.h"

#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cstdio>
#include <limits>

namespace
{
// The closed chain of a sound solid leaks rounding only: at most 2e-13 on 87 real files.
constexpr double LargestClosureResidual = 1e-9;
}

void vtkMassPropertiesGPU::SetChordTolerance(double tolerance)
{
  if (!(tolerance > 0.0 && tolerance < 1.0))
  {
    vtkErrorMacro("SetChordTolerance: " << tolerance << " is not in (0, 1); give for example 1e-8.");
    return;
  }
  if (this->ChordTolerance != tolerance)
  {
    this->ChordTolerance = tolerance;
    this->Modified();
  }
}

void vtkMassPropertiesGPU::PrintSchemeOptions(ostream& os, vtkIndent indent) const
{
  os << indent << "Scheme: " << sm::GetSchemeName(this->Scheme) << "\n"
     << indent << "SubPatchFactor: " << this->SubPatchFactor << "\n"
     << indent << "TrimTextureFactor: " << this->TrimTextureFactor << "\n"
     << indent << "ChordTolerance: " << this->ChordTolerance << "\n"
     << indent << "Deviation: " << (this->Deviation == BOUNDED ? "BOUNDED" : "SAMPLED") << "\n"
     << indent << "KeepTrimTextures: " << this->KeepTrimTextures << "\n";
}

bool vtkMassPropertiesGPU::IntegrateBodies(std::vector<sm::BodyIntegrals>& bodies)
{
  this->Last->Run.Forget();
  if (!this->HasScheme())
  {
    return this->Superclass::IntegrateBodies(bodies);
  }
  Internals& shared = *this->Implementation;
  if (!shared.ChooseRunner(this))
  {
    return false;
  }
  sm::SchemeRun::Options options;
  // MIDPOINT, GAUSS2 and GAUSS3 are the numbers of their points in each direction.
  options.Setup.Points = this->Scheme;
  options.Setup.Options.Factor = this->SubPatchFactor;
  options.Setup.Options.TextureFactor = this->TrimTextureFactor;
  options.Setup.Options.Deviation =
    this->Deviation == BOUNDED ? sm::DeviationMode::Bounded : sm::DeviationMode::Sampled;
  options.Setup.Perturbation = this->ShaderPerturbation;
  options.Setup.KeepTextures = this->KeepTrimTextures;
  options.Setup.MaximumEvaluations = this->MaximumEvaluations;
  options.Setup.MaximumSeconds = this->MaximumSeconds;
  options.ChordTolerance = this->ChordTolerance;
  options.Context = shared.Last.Backend == sm::names::BackendOpenGL ? shared.Context.Get() : nullptr;
  const vtkTypeUInt64 dispatches = shared.Context->GetNumberOfDispatches();
  const bool done = this->Last->Run.Integrate(options, bodies,
    [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return !this->GetAbortExecute();
    });
  const sm::SchemeIntegrator& integrator = this->Last->Run.GetIntegrator();
  shared.Last.Evaluations = integrator.GetEvaluations();
  shared.Last.Dispatches = static_cast<vtkTypeInt64>(shared.Context->GetNumberOfDispatches() - dispatches);
  shared.Last.StartSeconds += integrator.GetStartSeconds();
  shared.Last.PrepareSeconds = integrator.GetPrepareSeconds();
  shared.Last.IntegrateSeconds = integrator.GetIntegrateSeconds();
  if (!done)
  {
    shared.SetReason(this->Last->Run.GetMessage());
  }
  return done;
}

std::string vtkMassPropertiesGPU::GetSchemeMessage() const
{
  return sm::GetSchemeName(this->Scheme) +
    " has no error bound: the paper's estimate of the volume's error is none; ADAPTIVE has one";
}

std::string vtkMassPropertiesGPU::GetSchemeOptions() const
{
  char text[160];
  std::snprintf(text, sizeof(text),
    "k = %d, %d x %d texels a sub-patch, chords of planes to %.3g of the size, deviations %s",
    this->SubPatchFactor, this->TrimTextureFactor, this->TrimTextureFactor, this->ChordTolerance,
    this->Deviation == BOUNDED ? "bounded" : "sampled");
  return text;
}

double vtkMassPropertiesGPU::GetLargestClosureResidual(const sm::BodyIntegrals& body, double perArea) const
{
  if (!this->HasScheme())
  {
    // What quadrature leaves of the vector area, at a loose tolerance or without convergence, is no hole.
    return LargestClosureResidual + perArea * vtkMath::Norm(body.Bound.data() + sm::MassVectorArea);
  }
  // Texels leave the faces of a sound solid open: only what has no edges is told by its leak.
  return body.IsSolid() ? std::numeric_limits<double>::infinity() : sm::LargestSchemeClosureResidual;
}

void vtkMassPropertiesGPU::AddSchemeOutputs(const std::vector<sm::BodyIntegrals>& bodies, bool oneUnit,
  vtkPolyData* totals, vtkTable* solids, std::string& summary)
{
  if (!this->HasScheme())
  {
    return;
  }
  sm::SchemeTotals& total = this->Last->Estimates;
  total = this->Last->Run.GetTotals(bodies);
  if (!oneUnit)
  {
    total.Estimate = total.EstimateWithBoundary = vtkMath::Nan();
  }
  const std::string scheme = sm::GetSchemeName(this->Scheme);
  this->Last->Run.AddColumns(scheme, bodies, total, totals->GetFieldData(), solids);
  summary += "Scheme: " + scheme + ", " + std::to_string(total.SubPatches) + " sub-patches\n" +
    this->GetSchemeOptions() + "\n" +
    "The paper's error estimate: " + sm::FormatNumber(total.Estimate, vtkMath::Nan()) + "\n";
}

double vtkMassPropertiesGPU::GetPaperErrorEstimate() const
{
  return this->Last->Estimates.Estimate;
}

double vtkMassPropertiesGPU::GetPaperErrorEstimateWithBoundary() const
{
  return this->Last->Estimates.EstimateWithBoundary;
}

vtkTypeInt64 vtkMassPropertiesGPU::GetSubPatches() const
{
  return this->Last->Estimates.SubPatches;
}

int vtkMassPropertiesGPU::GetNumberOfTrimTextures() const
{
  return static_cast<int>(this->Last->Run.GetTextures().size());
}

vtkImageData* vtkMassPropertiesGPU::GetTrimTexture(int index) const
{
  return index >= 0 && index < this->GetNumberOfTrimTextures()
    ? this->Last->Run.GetTextures()[index].Image.Get()
    : nullptr;
}

std::string vtkMassPropertiesGPU::GetTrimTextureName(int index) const
{
  return index >= 0 && index < this->GetNumberOfTrimTextures() ? this->Last->Run.GetTextures()[index].Name
                                                               : "";
}
