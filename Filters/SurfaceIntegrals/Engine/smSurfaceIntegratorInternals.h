/**
 * @file smSurfaceIntegratorInternals.h
 * @brief State of a SurfaceIntegrator, shared by its source files: a run, a batch of faces, and the sharing
 * among ranks
 */
#ifndef smSurfaceIntegratorInternals_h
#define smSurfaceIntegratorInternals_h

#include "Items/smItemRunner.h"
#include "Sharing/smFaceExchange.h"
#include "Sharing/smFaceShares.h"
#include "Sharing/smSharedRun.h"
#include "smFacePanelsCache.h"
#include "smFacePlans.h"
#include "smFaceResultCache.h"
#include "smProgressCallback.h"
#include "smSurfaceIntegrator.h"

namespace sm
{
struct SurfaceIntegrator::Internals
{
  std::unique_ptr<ItemRunner> Runner;
  FacePanelsCache Cuts;
  FacePlans Plans;
  FaceResultCache Results;
  bool CacheFaceResults = true;
  /// True if the orders of all integrands are planned from a-priori bounds; false if one is an expression.
  bool Planned = false;
  std::vector<Integrand> Integrands;
  bool UsePlacements = false;
  double Perturbation = 1.0;
  bool Configured = false;
  std::int64_t MaximumEvaluations = 2000000000;
  double MaximumSeconds = 0.0;

  /// Integrands that the runner evaluates, and their indices among all integrands.
  std::vector<std::size_t> Chosen;
  std::vector<Integrand> ChosenIntegrands;
  std::vector<std::string> Obstacles;

  std::string Error;
  /// What the runner computes differently from the CPU; empty if nothing is known.
  std::string Distrust;
  bool Aborted = false;
  bool TimedOut = false;
  bool Loosened = false;
  std::int64_t Evaluations = 0;
  double StartSeconds = 0.0;
  double PrepareSeconds = 0.0;
  double CutSeconds = 0.0;
  double PlanSeconds = 0.0;
  double IntegrateSeconds = 0.0;

  /// The calls of the current run on several ranks; not open for a single process.
  SharedRun Sharing;
  RankDevice Device;
  FaceShares Shares;
  ReceivedFaces Received;
  std::vector<RankReport> Ranks;

  /// Progress callback of the current Integrate() or RunAsWorker().
  ProgressCallback Progress;
  /// MaximumEvaluations of the rank that has the faces, with which all ranks compare their plans.
  std::int64_t RunMaximum = 0;
  /// Number of evaluations that this rank may spend, its part of the maximum.
  std::int64_t Allowance = 0;
  /// If not negative, the number of times that tolerances are loosened, independent of the plan.
  int ForcedLoosenings = -1;
  double Start = 0.0;
  /// Limit of the run time in seconds since Start.
  double Seconds = 0.0;
  std::vector<CutFacePointer> Faces;
  /// Items of the current batch, and whether the plan compares some of them. The memory of a small batch is
  /// kept for the next one: new pages take longer than what is written to them.
  WorkItems Items;
  bool HasCompared = false;
  std::size_t ItemsDone = 0;
  std::size_t ItemsTotal = 1;

  bool Fail(const std::string& what)
  {
    // ReportProgress() sets Aborted, whatever error the caller of the callback then reports.
    this->Error = this->Aborted ? "aborted" : what;
    return false;
  }
  bool FailByRunner() { return this->Fail(this->Runner->GetError()); }
  bool ReportProgress(double fraction);
  bool ReportItemProgress();
  /// In a shared run, ends a step of all ranks and adds up their numbers. Returns false if some rank was
  /// stopped, which stops all.
  bool Agree(double& number, bool isBatch = false);
  bool AddUpPlans(std::int64_t& evaluations);
  void Configure();
  bool Prepare(const std::vector<FaceTask>& tasks);
  std::size_t GetNumberOfItems(std::size_t face) const;
  FaceResultKey GetResultKey(const FaceTask& task, std::size_t index) const;
  void Skip(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& faces,
    std::vector<FaceIntegrals>& results) const;
  bool RunAll(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results);
  /// Takes known results, and divides the other faces into batches whose rows fit into memory and whose
  /// results may be lost when the run is stopped.
  void MakeBatches(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results,
    std::vector<std::vector<std::size_t>>& batches);
  bool RunBatches(const std::vector<FaceTask>& tasks, const std::vector<std::vector<std::size_t>>& batches,
    std::vector<FaceIntegrals>& results);
  void Begin(const ProgressCallback& progress);
  FaceIntegrals MakeZeroResult() const;
  /// Cuts the faces, plans the orders and evaluates the items.
  bool Run(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results);

  // smSurfaceIntegratorBatch.cxx
  bool RunBatch(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& batch,
    std::vector<FaceIntegrals>& results);
  /// Compares the first item of each program that has not been used before with what the CPU makes of it.
  bool CheckRunner(const std::vector<ItemRunner::BatchFace>& faces, const WorkItems& items);
  /// Makes the items of the plans of a batch, face by face.
  void MakeItems(const std::vector<std::size_t>& batch);
  bool RunPortions(
    WorkItems& items, const std::vector<std::size_t>& batch, int depth, std::vector<FaceIntegrals>& results);
  bool RunItems(
    WorkItems& items, const std::vector<std::size_t>& batch, int depth, std::vector<FaceIntegrals>& results);
  /// Evaluates all items once, and those that are compared again at twice their orders; `candidates` gets
  /// those of them that are to be bisected if they do not converge.
  bool RunPlanned(WorkItems& items, int depth, std::vector<std::size_t>& candidates);
  bool RunLevels(WorkItems& items, int depth, std::vector<std::size_t>& bisected);
  /// Adds the rows of the items to the results. Those of a face are contiguous: its panels, the ribbons of
  /// each coedge, its caps.
  bool Accumulate(
    const WorkItems& items, const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results);
  /// Copies the sums of a result to or from the totals of a face.
  void SetTotals(const FaceIntegrals& result, FaceTotals& totals, std::size_t face) const;
  void TakeTotals(const FaceTotals& totals, std::size_t face, FaceIntegrals& result) const;
  /// Sets integrals to 0 whose largest possible magnitude is less than their bounds.
  void LimitByMagnitude(const FaceTask& task, const FacePlan& plan, FaceIntegrals& result) const;
  void AddBounds(const FaceTask& task, std::size_t face, FaceIntegrals& result) const;
  void Store(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& batch,
    const std::vector<FaceIntegrals>& results);

  // smSurfaceIntegratorShared.cxx
  Bytes MakeCapabilities();
  bool OnConnectionLost();
  bool IntegrateShared(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results);
  bool RunShare(const Bytes& message);
  /// Returns for each rank whether it takes part.
  std::vector<bool> ReadCapabilities(const std::vector<Bytes>& capabilities);
  std::vector<Bytes> PackShares(
    const std::vector<FaceTask>& tasks, const std::vector<std::vector<std::size_t>>& shares);
  bool GatherResults(const std::vector<FaceTask>& tasks, const std::vector<std::vector<std::size_t>>& shares,
    std::vector<FaceIntegrals>& results, std::vector<std::size_t>& left);
  bool ReadResults(const Bytes& message, const std::vector<std::size_t>& share, RankReport& report,
    std::vector<FaceIntegrals>& results);
  bool RecomputeLocally(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& share,
    std::vector<FaceIntegrals>& results);
  /// Returns the message with results, or with a reason why there are none.
  Bytes MakeResults(
    const std::string& failure, const std::vector<FaceIntegrals>& results, std::int64_t dispatches) const;
  std::int64_t CountDispatches() const
  {
    return this->Device.CountDispatches ? this->Device.CountDispatches() : 0;
  }
};
}

#endif
