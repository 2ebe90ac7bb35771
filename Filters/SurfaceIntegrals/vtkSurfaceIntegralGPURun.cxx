// A run of vtkSurfaceIntegralGPU: what it asks the integrator for, and what it does with the answers.
#include "vtkSurfaceIntegralGPU.h"

#include "Items/smCPUItemRunner.h"
#include "Items/smGPUItemRunner.h"
#include "smIntegralNames.h"
#include "vtkSurfaceIntegralGPUInternals.h"

#include "vtkComputeContext.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

double vtkSurfaceIntegralGPU::Internals::GetScale(
  const sm::Integrand& integrand, vtkTrimmedNURBSModel& model, double reach)
{
  if (integrand.ScalePower != 0)
  {
    return sm::GetAreaScale(model) * std::pow(sm::GetRadius(model), integrand.ScalePower);
  }
  // The integral of a monomial over a body of volume V (area A) within a distance `reach` of the origin.
  const double size = std::pow(reach, std::max(integrand.Degree, 0));
  return size *
    (integrand.ClosedChain && integrand.Degree >= 0 ? sm::GetVolumeScale(model) : sm::GetAreaScale(model));
}

double vtkSurfaceIntegralGPU::Internals::GetReach(const sm::BodyIntegrals& body)
{
  const double* origin = body.Model->GetOrigin();
  double squared = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    double x = body.Placement[4 * i + 3];
    for (int j = 0; j < 3; ++j)
    {
      x += body.Placement[4 * i + j] * origin[j];
    }
    squared += x * x;
  }
  return std::sqrt(squared) + sm::GetRadius(*body.Model);
}

void vtkSurfaceIntegralGPU::Internals::AddTasks(
  const sm::BodyIntegrals& body, bool placed, double tolerance, std::vector<sm::FaceTask>& tasks) const
{
  vtkTrimmedNURBSModel& model = *body.Model;
  const std::vector<sm::FacePointer>& faces = model.GetFaces();
  sm::FaceTask task;
  if (placed)
  {
    const double* origin = model.GetOrigin();
    for (int i = 0; i < 3; ++i)
    {
      double translation = body.Placement[4 * i + 3];
      for (int j = 0; j < 3; ++j)
      {
        task.Placement[4 * i + j] = body.Placement[4 * i + j];
        translation += body.Placement[4 * i + j] * origin[j];
      }
      task.Placement[4 * i + 3] = translation;
    }
    const double reach = GetReach(body);
    for (const sm::Integrand& integrand : this->Configured)
    {
      task.Tolerances.push_back(tolerance * GetScale(integrand, model, reach));
    }
  }
  else
  {
    task.Tolerances = this->LocalTolerances(model);
  }
  for (double& t : task.Tolerances)
  {
    // An equal share for every face, whatever the others' results.
    t /= std::max<std::size_t>(faces.size(), 1);
  }
  for (const sm::FacePointer& face : faces)
  {
    task.Source = face;
    tasks.push_back(task);
  }
}

void vtkSurfaceIntegralGPU::Internals::SetReason(const std::string& message)
{
  this->Last.Messages.push_back(message);
  this->Last.Reason = this->Last.Reason.empty() ? message : this->Last.Reason;
}

bool vtkSurfaceIntegralGPU::Internals::ChooseRunner(vtkSurfaceIntegralGPU* self)
{
  Run& last = this->Last;
  const double start = vtkTimerLog::GetUniversalTime();
  const bool hasOpenGL = self->Backend != CPU && this->Context->Start() == vtkComputeContext::READY;
  last.StartSeconds = vtkTimerLog::GetUniversalTime() - start;
  if (!hasOpenGL && self->Backend == OPENGL)
  {
    this->SetReason("nothing was computed: " + this->Context->GetReason());
    return false;
  }
  if (!hasOpenGL && self->Backend == AUTOMATIC)
  {
    last.FallbackReason = this->Context->GetReason();
  }
  // Another context may be another device, which may round otherwise.
  const vtkTypeUInt64 generation = hasOpenGL ? this->Context->GetGeneration() : 0;
  if (this->Generation != generation)
  {
    this->Integrator.ForgetFaces();
    this->Buoyancy.GetIntegrator().ForgetFaces();
    this->Generation = generation;
  }
  last.Backend = hasOpenGL ? sm::names::BackendOpenGL : sm::names::BackendCPU;
  last.Renderer = hasOpenGL ? this->Context->GetRenderer() : sm::CPUItemRunner::GetDescription();
  if (this->Runner != last.Backend)
  {
    std::unique_ptr<sm::ItemRunner> runner;
    if (hasOpenGL)
    {
      runner = std::make_unique<sm::GPUItemRunner>(this->Context);
    }
    else
    {
      runner = std::make_unique<sm::CPUItemRunner>();
    }
    this->Integrator.SetRunner(std::move(runner));
    this->Buoyancy.SetRunner(hasOpenGL
        ? std::unique_ptr<sm::ItemRunner>(std::make_unique<sm::GPUItemRunner>(this->Context))
        : std::make_unique<sm::CPUItemRunner>());
    this->Runner = last.Backend;
  }
  return true;
}

void vtkSurfaceIntegralGPU::Internals::Configure(vtkSurfaceIntegralGPU* self)
{
  const std::vector<sm::Integrand> plain = this->GetPlainIntegrands();
  if (this->Configured != plain)
  {
    this->Integrator.SetIntegrands(plain);
    this->Configured = plain;
  }
  // Moments about each part's own origin are carried to the instances exactly; anything else is integrated
  // in world coordinates, instance by instance.
  this->Integrator.SetUsePlacements(!this->LocalTolerances);
  for (sm::SurfaceIntegrator* integrator : { &this->Integrator, &this->Buoyancy.GetIntegrator() })
  {
    integrator->SetPerturbation(self->ShaderPerturbation);
    integrator->SetMaximumEvaluations(self->MaximumEvaluations);
    integrator->SetMaximumSeconds(self->MaximumSeconds);
    integrator->SetKeepFaces(self->KeepFaces);
  }
}

bool vtkSurfaceIntegralGPU::Internals::RunPlain(vtkSurfaceIntegralGPU* self,
  const std::vector<sm::FaceTask>& tasks, std::vector<sm::FaceIntegrals>& results)
{
  Run& last = this->Last;
  if (this->Configured.empty() && !this->Waterlines.empty())
  {
    // Nothing to run here, but bodies want results of their faces.
    this->Integrator.ReleaseWorkers();
    results.resize(tasks.size());
    return true;
  }
  const double share = this->Waterlines.empty() ? 1.0 : 0.5;
  const vtkTypeUInt64 dispatches = this->Context->GetNumberOfDispatches();
  const bool done = this->Integrator.Integrate(tasks, results,
    [self, share](double fraction)
    {
      self->UpdateProgress(share * fraction);
      return !self->GetAbortExecute();
    });
  last.Dispatches = static_cast<vtkTypeInt64>(this->Context->GetNumberOfDispatches() - dispatches);
  last.Evaluations = this->Integrator.GetEvaluations();
  last.StartSeconds += this->Integrator.GetStartSeconds();
  last.PrepareSeconds = this->Integrator.GetPrepareSeconds();
  last.IntegrateSeconds = this->Integrator.GetIntegrateSeconds();
  this->ReportRanks();
  const bool timedOut = this->Integrator.WasTimedOut();
  if (!done)
  {
    this->SetReason(timedOut            ? "nothing was computed: MaximumSeconds were over"
        : this->Integrator.WasAborted() ? "the run was aborted"
                                        : "nothing was computed: " + this->Integrator.GetError());
    return false;
  }
  if (this->Integrator.WasAborted())
  {
    this->SetReason(timedOut ? "MaximumSeconds were over before all faces were integrated"
                             : "the run was aborted before all faces were integrated");
  }
  if (this->Integrator.WasLoosened())
  {
    last.Messages.push_back(
      "MaximumEvaluations are too few for the tolerance: it was loosened, and the bounds say by how much");
  }
  return true;
}

void vtkSurfaceIntegralGPU::Internals::ReportIntegrands()
{
  for (std::size_t k = 0; k < this->Integrands.size(); ++k)
  {
    const sm::Integrand& integrand = this->Integrands[k];
    const std::string obstacle = this->GetObstacle(k);
    if (!obstacle.empty())
    {
      this->Last.Messages.push_back(integrand.Name + " was not computed: " + obstacle +
        (integrand.Source ? ", in \"" + integrand.Expression + "\"" : std::string()));
    }
    else if (integrand.Source && integrand.Source->MayHaveKinks())
    {
      this->Last.Messages.push_back(integrand.Name +
        " may have kinks or steps: its bound is estimated as if it were smooth on every face");
    }
  }
}

bool vtkSurfaceIntegralGPU::Internals::Integrate(
  vtkSurfaceIntegralGPU* self, std::vector<sm::BodyIntegrals>& bodies)
{
  const bool hasRunner = this->ChooseRunner(self);
  this->Integrator.SetExchange(this->Exchange.get(), this->GetDevice());
  if (!hasRunner)
  {
    this->Integrator.ReleaseWorkers();
    this->Integrator.SetExchange(nullptr, {});
    return false;
  }
  this->Configure(self);
  const bool placed = !this->LocalTolerances;
  std::vector<sm::FaceTask> tasks;
  std::vector<std::size_t> firstTask;
  std::map<vtkTrimmedNURBSModel*, std::size_t> known;
  for (const sm::BodyIntegrals& body : bodies)
  {
    const auto shared = known.find(body.Model);
    if (!placed && shared != known.end())
    {
      firstTask.push_back(shared->second);
      continue;
    }
    known[body.Model] = tasks.size();
    firstTask.push_back(tasks.size());
    this->AddTasks(body, placed, self->RelativeTolerance, tasks);
  }
  const std::vector<std::size_t> chosen = this->ChooseTasks(tasks);
  std::vector<sm::FaceIntegrals> results;
  const bool done = this->RunPlain(self, tasks, results);
  this->Integrator.SetExchange(nullptr, {});
  if (!done)
  {
    return false;
  }
  this->ReportIntegrands();
  this->SpreadResults(chosen, results);
  std::map<std::size_t, std::shared_ptr<const std::vector<sm::FaceIntegrals>>> sharedFaces;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    auto& faces = sharedFaces[firstTask[i]];
    if (!faces)
    {
      const auto first = results.begin() + static_cast<std::ptrdiff_t>(firstTask[i]);
      faces = std::make_shared<const std::vector<sm::FaceIntegrals>>(
        first, first + bodies[i].Model->GetNumberOfFaces());
    }
    bodies[i].Faces = faces;
  }
  return this->Waterlines.empty() || this->IntegrateBuoyancy(self, bodies);
}
