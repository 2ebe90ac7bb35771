/**
 * @file smFacePlans.h
 * @brief Quadrature plans of a run's faces, computed in parallel, kept for the next run, and loosened to meet
 * a budget
 */
#ifndef smFacePlans_h
#define smFacePlans_h

#include "smFaceCache.h"
#include "smFacePanelsCache.h"
#include "smIntegrand.h"
#include "smProgressCallback.h"
#include "smQuadraturePlan.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace sm
{
struct FaceTask;

/// Plans the orders of all faces of a run.
class FacePlans
{
public:
  /// Sets the integrands and removes all plans. Returns false if an integrand has no a-priori bound (an
  /// expression), so that nothing can be planned.
  bool SetIntegrands(const std::vector<Integrand>& integrands, int stripPoints);
  /// Removes all plans.
  void Clear();
  /// Returns the class that bounds an integrand, an index into a plan's bounds.
  std::size_t GetClass(std::size_t integrand) const { return this->ClassOf[integrand]; }
  const BoundClass& GetBoundClass(std::size_t integrand) const
  {
    return this->Classes[this->ClassOf[integrand]];
  }

  /// Plans every task by its face; `chosen` has the indices of the task's tolerances that belong to the
  /// integrands. Faces that could not be cut have an empty plan. Plans of the last run are reused. `addUp`
  /// adds the evaluations of other plans with the same budget; it is called once for every loosening, whether
  /// stopped or not, and returns false to stop. Returns false if `progress` or `addUp` stopped it.
  bool Plan(const std::vector<FaceTask>& tasks, const std::vector<CutFacePointer>& faces,
    const std::vector<std::size_t>& chosen, bool usePlacements, std::int64_t maximumEvaluations,
    const ProgressCallback& progress, const std::function<bool(std::int64_t&)>& addUp);

  const FacePlan& Get(std::size_t task) const { return *this->Plans[task]; }
  /// Returns the request of a task's plan, with loosened tolerances.
  const PlanRequest& GetRequest(std::size_t task) const { return this->Requests[task]; }
  /// Returns true if tolerances were loosened to meet the budget.
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
};
}

#endif
