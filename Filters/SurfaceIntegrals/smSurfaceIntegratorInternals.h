/**
 * @file smSurfaceIntegratorInternals.h
 * @brief The state of a SurfaceIntegrator, for its sources: a run, a batch of faces, and how ranks share the faces
 */
#ifndef smSurfaceIntegratorInternals_h
#define smSurfaceIntegratorInternals_h

#include "Items/smItemRunner.h"
#include "Sharing/smFaceExchange.h"
#include "Sharing/smFaceShares.h"
#include "smFacePanelsCache.h"
#include "smFacePlans.h"
#include "smFaceResultCache.h"
#include "smProgressCallback.h"
#include "smSurfaceIntegrator.h"

#include <exception>
#include <new>

namespace sm
{
struct SurfaceIntegrator::Internals
{
  std::unique_ptr<ItemRunner> Runner;
  FacePanelsCache Cuts;
  FacePlans Plans;
  FaceResultCache Results;
  bool CacheFaceResults = true;
  /// All integrands have a theory.
  bool Planned = false;
  std::vector<Integrand> Integrands;
  bool UsePlacements = false;
  double Perturbation = 1.0;
  bool Configured = false;
  std::int64_t MaximumEvaluations = 2000000000;
  double MaximumSeconds = 0.0;

  /// The integrands that the runner evaluates: which of all they are.
  std::vector<std::size_t> Chosen;
  std::vector<Integrand> ChosenIntegrands;
  std::vector<std::string> Obstacles;

  std::string Error;
  bool Aborted = false;
  bool TimedOut = false;
  bool Loosened = false;
  std::int64_t Evaluations = 0;
  double StartSeconds = 0.0;
  double PrepareSeconds = 0.0;
  double IntegrateSeconds = 0.0;

  /// Null: alone.
  FaceExchange* Exchange = nullptr;
  RankDevice Device;
  FaceShares Shares;
  ReceivedFaces Received;
  std::vector<RankReport> Ranks;

  /// Of the running Integrate() or RunAsWorker().
  ProgressCallback Progress;
  /// Its steps are agreed on with the other ranks.
  bool IsShared = false;
  /// Not empty: this rank has failed, and takes no more part than to agree.
  std::string Failure;
  /// MaximumEvaluations of the rank that has the faces: all ranks compare their plans with it.
  std::int64_t RunMaximum = 0;
  /// Evaluations that this rank may spend, its part of the maximum.
  std::int64_t Allowance = 0;
  /// Not negative: the tolerances are loosened as often, whatever the plan says.
  int ForcedLoosenings = -1;
  double Start = 0.0;
  /// What it may take since then.
  double Seconds = 0.0;
  std::vector<CutFacePointer> Faces;
  std::size_t ItemsDone = 0;
  std::size_t ItemsTotal = 1;

  bool Fail(const std::string& what)
  {
    // An abort is told by ReportProgress(), whoever passes it on.
    this->Error = this->Aborted ? "aborted" : what;
    return false;
  }
  /// Where a rank cannot go on: in a shared run it goes on without work, and true.
  bool FailAlone(const std::string& what);
  /// Runs a step of this rank that may throw, for want of memory. In a shared run an exception is a failure of this rank, which goes on
  /// to agree with the others; alone it is thrown on.
  template <typename Step>
  bool Guard(Step&& step)
  {
    try
    {
      return step();
    }
    catch (const std::bad_alloc&)
    {
      if (!this->IsShared)
      {
        throw;
      }
      return this->Fail("there is not enough memory");
    }
    catch (const std::exception& error)
    {
      if (!this->IsShared)
      {
        throw;
      }
      return this->Fail(error.what());
    }
  }
  bool FailByRunner() { return this->Fail(this->Runner->GetError()); }
  bool ReportProgress(double fraction);
  bool ReportItemProgress();
  /// Adds the numbers of all ranks up. False when some rank was stopped, and with it all.
  bool Agree(double& number);
  bool AddUpPlans(std::int64_t& evaluations);
  void Configure();
  bool Prepare(const std::vector<FaceTask>& tasks);
  std::size_t GetNumberOfItems(std::size_t face) const;
  FaceResultKey GetResultKey(const FaceTask& task, std::size_t index) const;
  void Skip(const std::vector<std::size_t>& faces, std::vector<FaceIntegrals>& results) const;
  bool RunAll(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results);
  /// Takes known results, and parts the other faces into batches that have room for their rows and are not too much to lose.
  bool MakeBatches(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results,
    std::vector<std::vector<std::size_t>>& batches);
  bool RunBatches(const std::vector<FaceTask>& tasks, const std::vector<std::vector<std::size_t>>& batches,
    std::vector<FaceIntegrals>& results);
  void Begin(const ProgressCallback& progress);
  FaceIntegrals MakeZeroResult() const;
  /// Cuts, plans and evaluates.
  bool Run(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results);

  // smSurfaceIntegratorBatch.cxx
  bool RunBatch(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& batch,
    std::vector<FaceIntegrals>& results);
  bool RunPortions(std::vector<WorkItem>& items, const std::vector<std::size_t>& batch, int depth,
    std::vector<FaceIntegrals>& results);
  bool RunItems(std::vector<WorkItem>& items, const std::vector<std::size_t>& batch, int depth,
    std::vector<FaceIntegrals>& results);
  bool RunPlanned(std::vector<WorkItem>& items, int depth, std::vector<std::size_t>& bisected);
  bool RunLevels(std::vector<WorkItem>& items, int depth, std::vector<std::size_t>& bisected);
  bool Accumulate(const std::vector<WorkItem>& items, const std::vector<std::size_t>& batch,
    std::vector<FaceIntegrals>& results);
  void AddBounds(const std::vector<std::size_t>& batch, std::vector<FaceIntegrals>& results) const;
  void Store(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& batch,
    const std::vector<FaceIntegrals>& results);

  // smSurfaceIntegratorShared.cxx
  Bytes MakeCapabilities() const;
  bool OnConnectionLost();
  bool IntegrateShared(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results);
  bool ReleaseWorkers();
  /// The ranks that take part.
  std::vector<bool> ReadCapabilities(const std::vector<Bytes>& capabilities);
  bool SendShares(const std::vector<FaceTask>& tasks, const std::vector<std::vector<std::size_t>>& shares);
  bool ReadResults(const Bytes& outcome, const std::vector<std::size_t>& share, RankReport& report,
    std::vector<FaceIntegrals>& results);
  bool RecomputeLocally(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& share,
    std::vector<FaceIntegrals>& results);
  Bytes MakeResults(const std::vector<FaceIntegrals>& results, std::int64_t dispatches) const;
};
}

#endif
