/**
 * @file smSurfaceIntegrator.h
 * @brief Integrates a list of integrands over faces, with an error bound for each face
 */
#ifndef smSurfaceIntegrator_h
#define smSurfaceIntegrator_h

#include "Engine/smFaceIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegrand.h"
#include "smProgressCallback.h"

#include <cstdint>
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
 * Cuts faces into panels (and keeps them), plans the orders of their items, and lets an ItemRunner, on the
 * GPU or the CPU, evaluate the items and sum their results. A theorem gives the orders (smQuadraturePlan.h)
 * before anything is evaluated. The tolerance of a face is divided equally among its items, so that the
 * result of a face does not depend on other faces.
 *
 * The theorem does not cover two cases: the area where normals nearly vanish, which is evaluated at two
 * orders and compared; and user integrands, for which the order of every item is raised until two orders
 * agree, or the item is bisected.
 *
 * If the plan exceeds the budget of evaluations, tolerances are loosened until it does not. If the time limit
 * is exceeded or the caller stops the run, the remaining faces are skipped. The bounds include the effect.
 * Not thread safe. Several processes may share the work, see BeginSharing().
 */
class SMFILTERSSURFACEINTEGRALS_EXPORT SurfaceIntegrator
{
public:
  SurfaceIntegrator();
  ~SurfaceIntegrator();

  /// Sets the runner that evaluates the items. It must not be null when Integrate() is called. Cut faces are
  /// kept when it changes.
  void SetRunner(std::unique_ptr<ItemRunner> runner);

  /// Sets the integrands. A change releases the compiled shaders. An integrand that the runner cannot
  /// evaluate is left out; its results are NaN.
  void SetIntegrands(const std::vector<Integrand>& integrands);
  void SetUsePlacements(bool use);
  void SetPerturbation(double factor);
  void SetMaximumEvaluations(std::int64_t evaluations);
  /**
   * If on, keeps the results of faces by their ids, tolerances and placements, and does not evaluate these
   * again: results are bitwise equal to those of a full run, and the number of evaluations counts only what
   * was evaluated. Results are removed when a setting changes on which they depend, when this option is
   * switched off, and for faces that were not in the last 8 runs. Default: on.
   */
  void SetCacheFaceResults(bool cache);
  /// Removes the results of all faces.
  void ForgetFaces();
  /// Releases all memory that is kept for later runs: cut faces, results, faces of other ranks, GPU buffers.
  void ReleaseMemory();
  /// Sets the limit of the duration of one Integrate() in seconds; 0: no limit.
  void SetMaximumSeconds(double seconds);

  /// Computes one result per task. Returns false, with the reason in GetError(), if a shader cannot be built,
  /// memory is insufficient, or the caller stopped it before any face was evaluated.
  bool Integrate(const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results,
    const ProgressCallback& progress);

  ///@{
  /**
   * Shares the faces with other ranks. All ranks call BeginSharing() with the number `root` of the one that
   * has the faces. It then calls Integrate() while all others call RunAsWorker(). Every rank ends the run
   * with FinishSharing(), also after an exception and if it has nothing to do: it makes the collective calls
   * that are left, without the need for memory, so that no rank waits for this one. If this rank failed,
   * `failure` is the reason, else empty. The failure of the root stops the run of all ranks. Shares are
   * chosen by estimated cost, and a face is sent once. As the result of a face does not depend on other
   * faces, results are bitwise equal to those of a single process if all ranks have equal devices and no
   * limit ends the run. Every rank may spend its part of the evaluations; the time limit is that of the rank
   * that has the faces; a rank that is stopped stops all ranks. GetRanks() names a rank that fails, or whose
   * integrands differ, and the rank that has the faces integrates that rank's faces.
   *
   * Without BeginSharing(), a run is that of a single process. The exchange must live until FinishSharing().
   * `device` describes the device of this rank.
   */
  void SetDevice(const RankDevice& device);
  void BeginSharing(FaceExchange& exchange, int root);
  void FinishSharing(const char* failure) noexcept;
  /// Integrates the share of this rank. Returns false if the connection to the other ranks was lost.
  bool RunAsWorker(const ProgressCallback& progress);
  /// Returns the reports of the ranks in the last shared Integrate(); empty if it was not shared.
  const std::vector<RankReport>& GetRanks() const;
  ///@}

  const std::string& GetError() const;
  /// Returns what the runner computes differently from the CPU, if the last Integrate() failed for that.
  const std::string& GetDistrust() const;
  /// Returns true if the caller or the time limit stopped the run. If Integrate() returned true, faces were
  /// skipped.
  bool WasAborted() const;
  bool WasTimedOut() const;
  /// Returns true if the budget of evaluations was too small for the tolerances.
  bool WasLoosened() const;
  /// Returns the reason why the runner could not evaluate an integrand in the last Integrate(); empty if it
  /// could.
  std::string GetObstacle(std::size_t integrand) const;
  std::int64_t GetEvaluations() const;
  /// Seconds of the last Integrate() for the shaders including a first dispatch, for cutting and upload, and
  /// for the integration.
  double GetStartSeconds() const;
  double GetPrepareSeconds() const;
  /// Parts of GetPrepareSeconds(): cutting, and choosing orders.
  double GetCutSeconds() const;
  double GetPlanSeconds() const;
  double GetIntegrateSeconds() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
