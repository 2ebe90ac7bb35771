/**
 * @file smFacePlans.h
 * @brief The plans of a run's faces: made in parallel, kept for the next run, loosened to a budget
 */
#ifndef smFacePlans_h
#define smFacePlans_h

#include "smFaceCache.h"
#include "smFacePanelsCache.h"
#include "smIntegrand.h"
#include "smProgressCallback.h"
#include "smQuadraturePlan.h"

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

namespace sm
{
struct FaceTask;

class FacePlans
{
public:
  /// False when an integrand has no theory, so that nothing can be planned. Forgets all plans.
  bool SetIntegrands(const std::vector<Integrand>& integrands, int stripPoints);
  /// Forgets all plans.
  void Clear();
  /// The class that bounds an integrand, an index into a plan's bounds.
  std::size_t GetClass(std::size_t integrand) const { return this->ClassOf[integrand]; }
  const BoundClass& GetBoundClass(std::size_t integrand) const
  {
    return this->Classes[this->ClassOf[integrand]];
  }

  /// Plans every task by its face; `chosen` says which of a task's tolerances belong to the integrands. Faces that could not be
  /// cut get an empty plan. A plan of the last run is found again. `addUp` adds the evaluations of what else is planned for the
  /// same budget; it is called once for every loosening, stopped or not, and returns false to stop. False when `progress` or
  /// `addUp` stopped it.
  bool Plan(const std::vector<FaceTask>& tasks, const std::vector<CutFacePointer>& faces,
    const std::vector<std::size_t>& chosen, bool usePlacements, std::int64_t maximumEvaluations,
    const ProgressCallback& progress, const std::function<bool(std::int64_t&)>& addUp);

  /// Throws the exception that ended the last Plan(), which called `addUp` all the same; true when there was none.
  bool CheckSuccess() const;

  const FacePlan& Get(std::size_t task) const { return *this->Plans[task]; }
  /// What was planned for, tolerances loosened.
  const PlanRequest& GetRequest(std::size_t task) const { return this->Requests[task]; }
  /// Tolerances were loosened to meet the budget.
  bool WasLoosened() const { return this->Loosenings > 0; }
  int GetLoosenings() const { return this->Loosenings; }

private:
  bool PlanAll(const std::vector<PlanRequest>& requests, const std::vector<CutFacePointer>& faces,
    const ProgressCallback& progress);

  std::vector<BoundClass> Classes;
  std::vector<std::size_t> ClassOf;
  int StripPoints = 3;
  std::vector<std::shared_ptr<const FacePlan>> Plans;
  std::vector<PlanRequest> Requests;
  FaceCache<PlanRequest, std::shared_ptr<const FacePlan>> Kept{ CacheBudget::GetProcessBudget(), 1 };
  int Loosenings = 0;
  std::exception_ptr Failure;
};
}

#endif
