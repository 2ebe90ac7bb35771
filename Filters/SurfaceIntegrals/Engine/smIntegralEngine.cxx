#include "smIntegralEngine.h"

#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace sm
{
namespace
{
/// Returns the faces that are integrated for a body: those of the first model that equals it, unless faces
/// are chosen by their numbers.
const std::vector<FacePointer>& GetSources(const IntegralRequest& request, const BodyIntegrals& body)
{
  return request.FaceIds.empty() ? body.Model->GetEqualFaces() : body.Model->GetFaces();
}

/// The first tasks of models, by their faces and tolerances, on which alone the results of a body depend that
/// is not placed.
class KnownTasks
{
public:
  /// Returns the first task of a body that has the same tasks, or `next`, which becomes that of this body.
  std::size_t Find(const IntegralRequest& request, const BodyIntegrals& body, std::size_t next)
  {
    const auto [model, isNew] = this->OfModels.emplace(body.Model, next);
    const std::vector<FacePointer>& faces = GetSources(request, body);
    if (!isNew || faces.empty())
    {
      return model->second;
    }
    std::vector<double> tolerances = request.GetTolerances(body);
    std::vector<Entry>& entries = this->OfFaces[faces.front().get()];
    for (const Entry& entry : entries)
    {
      if (*entry.Faces == faces && entry.Tolerances == tolerances)
      {
        return model->second = entry.Task;
      }
    }
    entries.push_back({ &faces, std::move(tolerances), next });
    return next;
  }

private:
  struct Entry
  {
    const std::vector<FacePointer>* Faces;
    std::vector<double> Tolerances;
    std::size_t Task;
  };
  std::map<vtkTrimmedNURBSModel*, std::size_t> OfModels;
  std::map<const Face*, std::vector<Entry>> OfFaces;
};

/// Names the faces of a body in the errors of its results, which are those of faces that equal them.
void NameFaces(const std::vector<FacePointer>& sources, const std::vector<FacePointer>& faces,
  std::vector<FaceIntegrals>& results)
{
  const auto getName = [](const Face& face) { return "face #" + std::to_string(face.FileId) + ":"; };
  for (std::size_t f = 0; f < results.size(); ++f)
  {
    const std::string name = getName(*sources[f]);
    if (results[f].Error.compare(0, name.size(), name) == 0)
    {
      results[f].Error.replace(0, name.size(), getName(*faces[f]));
    }
  }
}

/// Adds a task per face of a body, each with the body's placement and an equal share of its tolerances.
void AddTasks(const IntegralRequest& request, const BodyIntegrals& body, std::vector<FaceTask>& tasks)
{
  const std::vector<FacePointer>& faces = GetSources(request, body);
  FaceTask task;
  if (request.UsePlacements)
  {
    const double* origin = body.Model->GetOrigin();
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
    task.PlacementBound = PlacementError::Make(body);
  }
  task.Tolerances = request.GetTolerances(body);
  for (double& t : task.Tolerances)
  {
    t /= static_cast<double>(std::max<std::size_t>(faces.size(), 1));
  }
  for (const FacePointer& face : faces)
  {
    task.Source = face;
    tasks.push_back(task);
  }
}
}

IntegralEngine::IntegralEngine()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

IntegralEngine::~IntegralEngine() = default;

void IntegralEngine::Configure(const IntegralRequest& request, const IntegralLimits& limits)
{
  if (this->Configured != request.Integrands)
  {
    this->Integrator.SetIntegrands(request.Integrands);
    this->Configured = request.Integrands;
  }
  this->Integrator.SetUsePlacements(request.UsePlacements);
  this->Integrator.SetPerturbation(limits.Perturbation);
  this->Integrator.SetMaximumEvaluations(limits.MaximumEvaluations);
  this->Integrator.SetMaximumSeconds(limits.MaximumSeconds);
  this->Integrator.SetCacheFaceResults(limits.CacheFaceResults);
}

void IntegralEngine::AddEffort(vtkTypeUInt64 dispatches)
{
  this->Report.Dispatches += static_cast<std::int64_t>(this->Context->GetNumberOfDispatches() - dispatches);
  this->Report.Evaluations += this->Integrator.GetEvaluations();
  this->Report.StartSeconds += this->Integrator.GetStartSeconds();
  this->Report.PrepareSeconds += this->Integrator.GetPrepareSeconds();
  this->Report.CutSeconds += this->Integrator.GetCutSeconds();
  this->Report.PlanSeconds += this->Integrator.GetPlanSeconds();
  this->Report.IntegrateSeconds += this->Integrator.GetIntegrateSeconds();
}

bool IntegralEngine::RunTasks(
  const IntegralLimits& limits, const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results)
{
  const vtkTypeUInt64 dispatches = this->Context->GetNumberOfDispatches();
  this->Integrator.SetDevice(this->GetDevice());
  const bool done = this->Integrator.Integrate(tasks, results, limits.Progress);
  this->AddEffort(dispatches);
  this->ReportRanks();
  const bool timedOut = this->Integrator.WasTimedOut();
  if (!done && !this->MustLeaveOpenGL(limits))
  {
    this->Report.SetReason(timedOut     ? "nothing was computed: the maximum seconds were over"
        : this->Integrator.WasAborted() ? "the run was aborted"
                                        : "nothing was computed: " + this->Integrator.GetError());
  }
  if (!done)
  {
    return false;
  }
  if (this->Integrator.WasAborted())
  {
    this->Report.SetReason(timedOut ? "the maximum seconds were over before all faces were integrated"
                                    : "the run was aborted before all faces were integrated");
  }
  if (this->Integrator.WasLoosened())
  {
    this->Report.Messages.push_back(
      "the maximum evaluations are too few for the tolerance, which was loosened; "
      "the bounds show the accuracy reached");
  }
  return true;
}

void IntegralEngine::ReportIntegrands(const IntegralRequest& request)
{
  std::string reason;
  for (std::size_t k = 0; k < request.Integrands.size(); ++k)
  {
    const Integrand& integrand = request.Integrands[k];
    const std::string obstacle = this->GetObstacle(k);
    if (!obstacle.empty())
    {
      const std::string message = integrand.Name + " was not computed: " + obstacle +
        (integrand.Source ? ", in \"" + integrand.Expression + "\"" : std::string());
      this->Report.Messages.push_back(message);
      reason += (reason.empty() ? "" : "\n") + message;
    }
    else if (integrand.Source && integrand.Source->MayHaveKinks())
    {
      this->Report.Messages.push_back(integrand.Name +
        " may have kinks or steps: its bound is estimated as if it were smooth on every face");
    }
  }
  this->Report.Reason = this->Report.Reason.empty() ? reason : this->Report.Reason;
}

std::vector<std::size_t> IntegralEngine::ChooseTasks(
  const std::set<std::int64_t>& faceIds, std::vector<FaceTask>& tasks)
{
  std::vector<std::size_t> chosen;
  if (faceIds.empty())
  {
    return chosen;
  }
  std::set<std::int64_t> missing = faceIds;
  std::vector<FaceTask> kept;
  for (FaceTask& task : tasks)
  {
    const std::int64_t id = task.Source->FileId;
    missing.erase(id);
    chosen.push_back(faceIds.count(id) > 0 ? kept.size() : tasks.size());
    if (chosen.back() < tasks.size())
    {
      kept.push_back(std::move(task));
    }
  }
  tasks = std::move(kept);
  for (const int id : missing)
  {
    this->Report.Messages.push_back("there is no face #" + std::to_string(id) + " to integrate over");
  }
  return chosen;
}

void IntegralEngine::SpreadResults(
  const std::vector<std::size_t>& chosen, std::size_t integrands, std::vector<FaceIntegrals>& results) const
{
  if (chosen.empty())
  {
    return;
  }
  FaceIntegrals zero;
  for (std::size_t k = 0; k < integrands; ++k)
  {
    zero.Append(this->GetObstacle(k).empty() ? 0.0 : std::numeric_limits<double>::quiet_NaN());
  }
  std::vector<FaceIntegrals> all;
  for (const std::size_t result : chosen)
  {
    all.push_back(result < results.size() ? results[result] : zero);
  }
  results = std::move(all);
}

std::vector<std::size_t> IntegralEngine::MakeTasks(const IntegralRequest& request,
  const std::vector<BodyIntegrals>& bodies, std::vector<FaceTask>& tasks) const
{
  std::vector<std::size_t> firstTask;
  KnownTasks known;
  for (const BodyIntegrals& body : bodies)
  {
    const std::size_t next = tasks.size();
    firstTask.push_back(request.UsePlacements ? next : known.Find(request, body, next));
    if (firstTask.back() == next)
    {
      AddTasks(request, body, tasks);
    }
  }
  return firstTask;
}

bool IntegralEngine::CheckPlacements(const std::vector<BodyIntegrals>& bodies)
{
  const auto isPlaced = [](const BodyIntegrals& body)
  {
    return std::all_of(
      body.Placement.begin(), body.Placement.end(), [](double entry) { return std::isfinite(entry); });
  };
  if (std::all_of(bodies.begin(), bodies.end(), isPlaced))
  {
    return true;
  }
  this->Report.SetReason("nothing was computed: the placement of a body is not finite");
  return false;
}

void IntegralEngine::TakeResults(const IntegralRequest& request, const std::vector<std::size_t>& firstTask,
  std::vector<FaceIntegrals>& results, std::vector<BodyIntegrals>& bodies)
{
  using Shared = std::shared_ptr<const std::vector<FaceIntegrals>>;
  // A body without faces has the same first task as the next body.
  std::map<std::pair<std::size_t, bool>, Shared> shared;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    const std::vector<FacePointer>& sources = GetSources(request, bodies[i]);
    Shared& faces = shared[{ firstTask[i], sources.empty() }];
    if (!faces)
    {
      const auto first = std::make_move_iterator(results.begin() + static_cast<std::ptrdiff_t>(firstTask[i]));
      faces = std::make_shared<const std::vector<FaceIntegrals>>(
        first, first + static_cast<std::ptrdiff_t>(sources.size()));
    }
    bodies[i].Faces = faces;
    const bool isDamaged = std::any_of(
      faces->begin(), faces->end(), [](const FaceIntegrals& face) { return !face.Error.empty(); });
    if (isDamaged && sources != bodies[i].Model->GetFaces())
    {
      auto named = std::make_shared<std::vector<FaceIntegrals>>(*faces);
      NameFaces(sources, bodies[i].Model->GetFaces(), *named);
      bodies[i].Faces = named;
    }
  }
}

bool IntegralEngine::Integrate(
  const IntegralRequest& request, const IntegralLimits& limits, std::vector<BodyIntegrals>& bodies)
{
  if ((request.UsePlacements && !this->CheckPlacements(bodies)) ||
    !this->ChooseRunner(request, limits.Backend))
  {
    return false;
  }
  this->Configure(request, limits);
  std::vector<FaceTask> tasks;
  const std::vector<std::size_t> firstTask = this->MakeTasks(request, bodies, tasks);
  const std::vector<std::size_t> chosen = this->ChooseTasks(request.FaceIds, tasks);
  std::vector<FaceIntegrals> results;
  bool done = this->RunTasks(limits, tasks, results);
  if (!done && this->MustLeaveOpenGL(limits))
  {
    this->LeaveOpenGL(this->Integrator.GetDistrust());
    this->Configure(request, limits);
    done = this->RunTasks(limits, tasks, results);
  }
  if (!done)
  {
    return false;
  }
  this->ReportIntegrands(request);
  this->SpreadResults(chosen, request.Integrands.size(), results);
  TakeResults(request, firstTask, results, bodies);
  return true;
}

void IntegralEngine::Sum(
  const IntegralRequest& request, bool computed, double gapLimit, std::vector<BodyIntegrals>& bodies)
{
  this->Report.Ranks = computed ? std::max(this->Report.Ranks, 1) : 0;
  for (BodyIntegrals& body : bodies)
  {
    if (computed)
    {
      SumFaces(body, request.Integrands);
    }
    else
    {
      // A value that was not computed has no bound and meets no tolerance.
      SetUnknown(body, request.Integrands.size());
    }
  }
  if (computed)
  {
    MeasureEdges(bodies, gapLimit, request.ReportSmallGaps);
    if (request.MeasureSpread)
    {
      MeasureSpreads(this->Spreads, bodies);
    }
  }
  this->Report.Status = this->Report.FileStatus;
}

void IntegralEngine::ReleaseMemory()
{
  // The next run chooses a new runner, which cuts and uploads the faces again.
  this->Integrator.ReleaseMemory();
  this->Spreads.Clear();
  this->Runner.clear();
}
}
