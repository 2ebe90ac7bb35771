/**
 * @file smSurfaceIntegrator.h
 * @brief Integrates a list of integrands over faces, face by face, with an error for each
 */
#ifndef smSurfaceIntegrator_h
#define smSurfaceIntegrator_h

#include "smFaceIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegrand.h"
#include "smProgressCallback.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace sm
{
class FaceExchange;
class ItemRunner;
struct RankDevice;
struct RankReport;

/**
 * Cuts faces (and keeps them cut), plans the orders of their items, and has an ItemRunner, the GPU's or the CPU's, evaluate
 * the items and sum their results. The orders come from a theorem (smQuadraturePlan.h), before anything is
 * evaluated; a face's tolerance is shared equally among its items, so that the result of a face depends on no other.
 *
 * Two things have no such theory: the area where normals nearly vanish, which is evaluated at two orders and compared;
 * and integrands of the user's, for which every item climbs a ladder of orders until two agree, or is bisected.
 *
 * When the plan exceeds the budget of evaluations, tolerances are loosened until it does not; when the time is
 * over or the caller stops, faces not reached yet are skipped. Bounds say what came of it. Not thread safe.
 * Several processes may share the work, see SetExchange().
 */
class SMFILTERSSURFACEINTEGRALS_EXPORT SurfaceIntegrator
{
public:
  SurfaceIntegrator();
  ~SurfaceIntegrator();

  /// What evaluates; never null once Integrate() is called. Cut faces outlive a change.
  void SetRunner(std::unique_ptr<ItemRunner> runner);

  /// Frees what the runner keeps between calls of Integrate(), memory of the GPU above all.
  void FreeMemory();

  /// A change drops the compiled shaders. An integrand that the runner cannot evaluate is left out; its results are NaN.
  void SetIntegrands(const std::vector<Integrand>& integrands);
  void SetUsePlacements(bool use);
  void SetPerturbation(double factor);
  void SetMaximumEvaluations(std::int64_t evaluations);
  /**
   * Keeps the results of faces by their ids, tolerances and placements, and does not evaluate again what is known: the bits are
   * those of a full run, and evaluations count what was evaluated. What was kept is forgotten when anything changes that
   * results depend on, when this is switched off, and for faces that were not in the last 8 runs. Default: on.
   */
  void SetCacheFaceResults(bool cache);
  /// Forgets the results of all faces.
  void ForgetFaces();
  /// Forgets everything that is kept for later runs: cut faces, results, faces of other ranks; buffers on the GPU.
  void ReleaseMemory();
  /// Of one Integrate(); 0: no limit.
  void SetMaximumSeconds(double seconds);

  /// False when a shader does not build, memory is short, or the caller stopped it before any face was evaluated;
  /// GetError() says why.
  bool Integrate(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results,
    const ProgressCallback& progress);

  ///@{
  /**
   * Shares the faces with other ranks. Integrate() on the rank that has the faces, and RunAsWorker() with its number on all others,
   * must be called together; or ReleaseWorkers() on that rank, when there is nothing to do. Shares are chosen by estimated cost, and a
   * face travels once. As the result of a face depends on no other, results are the bits of a run alone if all ranks compute
   * with equal devices, and no budget ends. Every rank may spend its part of the evaluations; the seconds are those of the rank
   * that has the faces; who is stopped stops all. A rank that fails, or whose integrands are not the same, is
   * named in GetRanks(), and its faces are integrated by the rank that has them.
   *
   * Null, the default: alone. The exchange must live until it is replaced. `device` is what this rank computes with.
   */
  void SetExchange(FaceExchange* exchange, const RankDevice& device);
  /// False when the connection to the other ranks was lost.
  bool RunAsWorker(int root, const ProgressCallback& progress);
  bool ReleaseWorkers();
  /// What the ranks did in the last shared Integrate(); empty when it was not shared.
  const std::vector<RankReport>& GetRanks() const;
  ///@}

  const std::string& GetError() const;
  /// The caller stopped it, or the time was over: faces were skipped, if it returned true.
  bool WasAborted() const;
  bool WasTimedOut() const;
  /// The budget of evaluations was too small for the tolerances.
  bool WasLoosened() const;
  /// Why the runner could not evaluate an integrand in the last Integrate(); empty when it could.
  std::string GetObstacle(std::size_t integrand) const;
  std::int64_t GetEvaluations() const;
  /// Seconds of the last Integrate(): shaders with a warm dispatch; cutting and upload; integration.
  double GetStartSeconds() const;
  double GetPrepareSeconds() const;
  double GetIntegrateSeconds() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
