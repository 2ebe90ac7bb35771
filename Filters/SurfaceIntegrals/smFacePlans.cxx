#include "smFacePlans.h"

#include "smParallelFor.h"
#include "smSurfaceIntegrator.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace sm
{
namespace
{
std::size_t CountBytes(const FacePlan& plan)
{
  return sizeof(FacePlan) + plan.Items.capacity() * sizeof(PlannedItem) +
    (plan.QuadratureBound.capacity() + plan.ConversionBound.capacity() + plan.ResidualBound.capacity() +
      plan.Magnitude.capacity()) *
    sizeof(double);
}

// Number of faces that are planned between two reports of progress.
constexpr std::size_t PlansPerReport = 256;
// Number of portions per task of a thread.
constexpr std::size_t PortionsPerTask = 1;
// Factor by which tolerances are multiplied until a plan meets its budget, and the largest number of times.
constexpr double LooseningFactor = 1e3;
constexpr int MaxLoosenings = 5;

bool FindClass(const Integrand& integrand, BoundClass& found)
{
  switch (integrand.Form)
  {
    case Integrand::Kind::VolumeMoment:
      found = { BoundClass::VolumeMoment, integrand.Degree };
      return true;
    case Integrand::Kind::AreaMoment:
      found = { BoundClass::AreaMoment, integrand.Degree };
      return true;
    case Integrand::Kind::HeightMoment:
      found = { BoundClass::HeightMoment, integrand.Degree };
      return true;
    case Integrand::Kind::VectorArea:
      found = { BoundClass::VectorArea, 0 };
      return true;
    default:
      return false;
  }
}

/// Returns the translation of a placement in the rotated coordinates before the placement, R^T t.
std::array<double, 3> GetShift(const std::array<double, 12>& placement)
{
  std::array<double, 3> shift{};
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      shift[j] += placement[4 * i + j] * placement[4 * i + 3];
    }
  }
  return shift;
}
}

bool FacePlans::SetIntegrands(const std::vector<Integrand>& integrands, int stripPoints)
{
  this->Classes.clear();
  this->ClassOf.clear();
  this->Clear();
  this->StripPoints = stripPoints;
  for (const Integrand& integrand : integrands)
  {
    BoundClass wanted{};
    if (!FindClass(integrand, wanted))
    {
      return false;
    }
    auto found = std::find(this->Classes.begin(), this->Classes.end(), wanted);
    if (found == this->Classes.end())
    {
      found = this->Classes.insert(found, wanted);
    }
    this->ClassOf.push_back(static_cast<std::size_t>(found - this->Classes.begin()));
  }
  return true;
}

void FacePlans::Clear()
{
  this->Kept.Clear();
  this->Plans.clear();
  this->Requests.clear();
}

bool FacePlans::PlanAll(const std::vector<PlanRequest>& requests, const std::vector<CutFacePointer>& faces,
  const ProgressCallback& progress)
{
  for (std::size_t begin = 0; begin < faces.size(); begin += PlansPerReport)
  {
    if (progress && !progress(static_cast<double>(begin) / faces.size()))
    {
      return false;
    }
    const std::size_t end = std::min(begin + PlansPerReport, faces.size());
    // All threads share the portions of all faces, so that a single changed face is planned by all threads
    // too.
    std::vector<std::size_t> missing;
    std::vector<std::unique_ptr<FacePlanner>> planners;
    std::vector<std::pair<std::size_t, std::size_t>> work;
    for (std::size_t i = begin; i < end; ++i)
    {
      if (const auto* known = this->Kept.Find(faces[i]->Source->Id, requests[i]))
      {
        this->Plans[i] = *known;
        continue;
      }
      planners.push_back(std::make_unique<FacePlanner>(*faces[i]->Source, faces[i]->Panels, requests[i]));
      for (std::size_t k = 0; k < planners.back()->GetNumberOfPortions(); ++k)
      {
        work.emplace_back(missing.size(), k);
      }
      missing.push_back(i);
    }
    ParallelFor(work.size(), PortionsPerTask,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t w = from; w < to; ++w)
        {
          planners[work[w].first]->PlanPortion(work[w].second);
        }
      });
    for (std::size_t m = 0; m < missing.size(); ++m)
    {
      this->Plans[missing[m]] = std::make_shared<const FacePlan>(planners[m]->Join());
    }
  }
  return true;
}

bool FacePlans::Plan(const std::vector<FaceTask>& tasks, const std::vector<CutFacePointer>& faces,
  const std::vector<std::size_t>& chosen, bool usePlacements, std::int64_t maximumEvaluations,
  const ProgressCallback& progress, const std::function<bool(std::int64_t&)>& addUp)
{
  std::vector<PlanRequest> requests(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    PlanRequest& request = requests[i];
    request.Classes = this->Classes;
    request.Tolerances.assign(this->Classes.size(), std::numeric_limits<double>::max());
    for (std::size_t k = 0; k < chosen.size(); ++k)
    {
      double& tolerance = request.Tolerances[this->ClassOf[k]];
      tolerance = std::min(tolerance, tasks[i].Tolerances[chosen[k]]);
    }
    request.Shift = usePlacements ? GetShift(tasks[i].Placement) : std::array<double, 3>{};
    request.StripPoints = this->StripPoints;
  }
  this->Plans.assign(tasks.size(), nullptr);
  for (this->Loosenings = 0;; ++this->Loosenings)
  {
    const bool planned = this->PlanAll(requests, faces, progress);
    std::int64_t evaluations = 0;
    for (const auto& plan : this->Plans)
    {
      evaluations += plan ? plan->Evaluations : 0;
    }
    if (!addUp(evaluations) || !planned)
    {
      return false;
    }
    if (evaluations <= maximumEvaluations || this->Loosenings == MaxLoosenings)
    {
      break;
    }
    for (PlanRequest& request : requests)
    {
      for (double& tolerance : request.Tolerances)
      {
        tolerance *= LooseningFactor;
      }
    }
  }
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    this->Kept.Store(faces[i]->Source->Id, requests[i], this->Plans[i], CountBytes(*this->Plans[i]));
  }
  this->Kept.EndRun();
  this->Requests = std::move(requests);
  return true;
}
}
