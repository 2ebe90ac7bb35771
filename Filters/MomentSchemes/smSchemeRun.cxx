#include "Detail/smSchemeRun.h"

#include "Detail/smCPUSchemeRunner.h"
#include "Detail/smGPUSchemeRunner.h"
#include "smBodyScales.h"
#include "smColumns.h"
#include "smSchemeNames.h"

#include "vtkComputeContext.h"
#include "vtkLongLongArray.h"

#include <algorithm>
#include <limits>

namespace sm
{
namespace
{
vtkSmartPointer<vtkImageData> MakeImage(const TrimTexture& texture)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(texture.Width, texture.Height, 1);
  image->SetOrigin(texture.Origin[0], texture.Origin[1], 0.0);
  image->SetSpacing(texture.Spacing[0], texture.Spacing[1], 1.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::transform(texture.Texels.begin(), texture.Texels.end(), pixels,
    [](unsigned char texel) { return static_cast<unsigned char>(texel != 0 ? 255 : 0); });
  return image;
}
}

bool SchemeRun::Integrate(
  const Options& options, std::vector<BodyIntegrals>& bodies, const ProgressCallback& progress)
{
  this->Forget();
  if (!this->HasRunner || this->RunnerContext != options.Context)
  {
    std::unique_ptr<SchemeRunner> runner;
    if (options.Context)
    {
      runner = std::make_unique<GPUSchemeRunner>(options.Context);
    }
    else
    {
      runner = std::make_unique<CPUSchemeRunner>();
    }
    this->Integrator->SetRunner(std::move(runner));
    this->RunnerContext = options.Context;
    this->HasRunner = true;
  }
  std::vector<SchemeTask> tasks;
  std::map<vtkTrimmedNURBSModel*, std::size_t> firstTask;
  for (const BodyIntegrals& body : bodies)
  {
    if (firstTask.emplace(body.Model, tasks.size()).second)
    {
      const double tolerance = options.ChordTolerance * 2.0 * GetRadius(*body.Model);
      for (const FacePointer& face : body.Model->GetFaces())
      {
        // A model of zero extent still needs a positive tolerance.
        tasks.push_back({ face, tolerance > 0.0 ? tolerance : std::numeric_limits<double>::min() });
      }
    }
  }
  std::vector<SchemeResult> results;
  if (!this->Integrator->Integrate(tasks, options.Setup, results, progress))
  {
    return false;
  }
  std::map<vtkTrimmedNURBSModel*, std::shared_ptr<const std::vector<FaceIntegrals>>> shared;
  for (BodyIntegrals& body : bodies)
  {
    auto& faces = shared[body.Model];
    if (!faces)
    {
      const std::size_t first = firstTask[body.Model];
      auto own = std::make_shared<std::vector<FaceIntegrals>>();
      SchemeTotals& totals = this->Totals[body.Model];
      totals.Estimate = totals.EstimateWithBoundary = 0.0;
      for (std::size_t i = 0; i < body.Model->GetFaces().size(); ++i)
      {
        const SchemeResult& result = results[first + i];
        totals.Estimate += result.Estimate;
        totals.EstimateWithBoundary += result.EstimateWithBoundary;
        totals.SubPatches += result.SubPatches;
        own->push_back(result.Integrals);
      }
      this->KeepTextures(body, results, first);
      faces = own;
    }
    body.Faces = faces;
  }
  return true;
}

void SchemeRun::KeepTextures(const BodyIntegrals& body, std::vector<SchemeResult>& results, std::size_t first)
{
  const std::vector<FacePointer>& faces = body.Model->GetFaces();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    TrimTexture& texture = results[first + i].Texture;
    if (!texture.Texels.empty())
    {
      this->Textures.push_back(
        { body.Name + (body.Name.empty() ? "" : " ") + "#" + std::to_string(faces[i]->FileId),
          MakeImage(texture) });
      texture = TrimTexture();
    }
  }
}

std::string SchemeRun::GetMessage() const
{
  return this->Integrator->WasTimedOut() ? "nothing was computed: the maximum seconds were over"
    : this->Integrator->WasAborted()     ? "the run was aborted"
                                         : "nothing was computed: " + this->Integrator->GetError();
}

SchemeTotals SchemeRun::GetTotals(vtkTrimmedNURBSModel* model) const
{
  const auto found = this->Totals.find(model);
  return found == this->Totals.end() ? SchemeTotals() : found->second;
}

SchemeTotals SchemeRun::GetTotals(const std::vector<BodyIntegrals>& bodies) const
{
  SchemeTotals sum;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    const SchemeTotals own = this->GetTotals(bodies[i].Model);
    sum.Estimate = i == 0 ? own.Estimate : sum.Estimate + own.Estimate;
    sum.EstimateWithBoundary =
      i == 0 ? own.EstimateWithBoundary : sum.EstimateWithBoundary + own.EstimateWithBoundary;
    sum.SubPatches += own.SubPatches;
  }
  return sum;
}

void SchemeRun::AddColumns(const std::string& scheme, const std::vector<BodyIntegrals>& bodies,
  const SchemeTotals& total, columns::Writer totals, columns::Writer solids) const
{
  totals.SetString(names::Scheme, scheme);
  totals.SetDouble(names::PaperErrorEstimate, total.Estimate);
  totals.SetDouble(names::PaperErrorEstimateWithBoundary, total.EstimateWithBoundary);
  totals.SetInteger(names::SubPatches, total.SubPatches);
  vtkStdString* name = solids.AddStrings(names::Scheme);
  double* estimate = solids.AddDoubles(names::PaperErrorEstimate);
  double* withBoundary = solids.AddDoubles(names::PaperErrorEstimateWithBoundary);
  auto* subPatches = solids.Add<vtkLongLongArray>(names::SubPatches);
  for (const BodyIntegrals& body : bodies)
  {
    const SchemeTotals own = this->GetTotals(body.Model);
    *name++ = scheme;
    *estimate++ = own.Estimate;
    *withBoundary++ = own.EstimateWithBoundary;
    *subPatches++ = own.SubPatches;
  }
}

void SchemeRun::Forget()
{
  this->Totals.clear();
  this->Textures.clear();
}

void SchemeRun::ReleaseMemory()
{
  this->Integrator = std::make_unique<SchemeIntegrator>();
  this->HasRunner = false;
  this->RunnerContext = nullptr;
}

std::string GetSchemeName(int points)
{
  return points == 1 ? "MIDPOINT" : points == 2 ? "GAUSS2" : points == 3 ? "GAUSS3" : "";
}
}
