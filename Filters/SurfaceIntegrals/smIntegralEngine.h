/**
 * @file smIntegralEngine.h
 * @brief Engine of all filters over surface integrals: context, backend, ranks, and the report of a run
 */
#ifndef smIntegralEngine_h
#define smIntegralEngine_h

#include "Items/smBackendCost.h"
#include "Sharing/smControllerExchange.h"
#include "smBackendChoice.h"
#include "smBodyIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smProgressCallback.h"
#include "smRunReport.h"
#include "smSurfaceIntegrator.h"

#include "vtkComputeContext.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkPartitionedDataSetCollection;

namespace sm
{
/// The integrals to compute over the faces of the bodies.
struct IntegralRequest
{
  std::vector<Integrand> Integrands;
  /// True: in world coordinates, for each instance. False: about each part's own origin, once for all its
  /// instances.
  bool UsePlacements = true;
  /// Returns absolute tolerances of the integrands over a whole body. Every face gets an equal share,
  /// independent of other results.
  std::function<std::vector<double>(const BodyIntegrals&)> GetTolerances;
  /// Entity numbers of the faces to integrate over; empty: all.
  std::set<std::int64_t> FaceIds;
  /// True: gaps that do not make a body suspect are messages, too, where they are wider than the file's
  /// tolerances.
  bool ReportSmallGaps = true;
  /// True: measures what other closings of the gaps may change (smClosingSpread.h).
  bool MeasureSpread = false;
  /// Size of a face's part of the run; empty: that of integrals to a tolerance.
  std::function<RunSize(const Face&)> EstimateFace;

  /// Returns true if an integrand is an expression in GLSL.
  bool HasExpressions() const;
};

/// Limits and options of a run.
struct IntegralLimits
{
  BackendChoice Backend = BackendChoice::Automatic;
  std::int64_t MaximumEvaluations = 2000000000;
  /// Limit of the run time in seconds; 0: no limit.
  double MaximumSeconds = 0.0;
  bool CacheFaceResults = true;
  /// Factor applied to every sample, for tests.
  double Perturbation = 1.0;
  ProgressCallback Progress;
};

/**
 * Runs the integration for a filter. It keeps the context, the integrator with its runner, and cached data of
 * faces from run to run. Not thread safe.
 */
class SMFILTERSSURFACEINTEGRALS_EXPORT IntegralEngine
{
public:
  IntegralEngine();
  ~IntegralEngine();

  vtkComputeContext* GetContext() const { return this->Context; }
  SurfaceIntegrator& GetIntegrator() { return this->Integrator; }
  RunReport& GetReport() { return this->Report; }
  const RunReport& GetReport() const { return this->Report; }

  ///@{
  /** The ranks that may share a run; null: only this process. */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  /// Role of a rank in a run: it has the bodies; it computes a share of another rank's faces; or it has
  /// nothing to do, with empty outputs.
  enum class Role
  {
    Owner,
    Worker,
    Idle
  };
  /**
   * Determines this rank's role together with the other ranks, if `pieces` of the update equals the number of
   * ranks; otherwise the rank runs alone. Collective; every rank that took part ends the run by
   * FinishSharing().
   */
  Role ChooseRole(bool canShare, int pieces, bool hasInput, bool hasBodies);
  /// Gives the meshes the same blocks on all ranks that run together (smSharedStructure.h). Collective, under
  /// the condition of ChooseRole().
  void ShareStructure(int pieces, vtkPartitionedDataSetCollection* meshes);
  /// Ends the part of this rank in a shared run, wherever it is in it, so that no rank waits for it.
  /// `failure` is the exception that ended the run of this rank, or null.
  void FinishSharing(const std::exception_ptr& failure = nullptr) noexcept;

  /// Sets the rates by which runs are estimated from now on.
  void SetRates(const BackendRates& rates) { this->Rates = rates; }
  /// Estimates what the run takes on either backend, for ChooseRunner() and the report. It depends on the
  /// request, the faces of the bodies, threads and lanes, and not on what earlier runs have left.
  void EstimateBackends(const IntegralRequest& request, const std::vector<BodyIntegrals>& bodies);
  /**
   * Gives the integrator a runner that `backend` allows and the machine supports. Returns false, with a
   * reason in the report, if there is none. BackendChoice::Automatic takes OpenGL for expressions and where
   * the context has a window or source of the user's, and otherwise the backend with the lower estimate (on a
   * rank that shares the run, that of the rank with the bodies): OpenGL then only on a GPU, as a software
   * renderer is slower on the same processor than the CPU backend. Where the estimate is for the CPU no
   * context is made.
   */
  bool ChooseRunner(const IntegralRequest& request, BackendChoice backend);
  /// Returns true if all placements are finite. Otherwise nothing can be integrated in the world's
  /// coordinates; the report has the reason.
  bool CheckPlacements(const std::vector<BodyIntegrals>& bodies);
  /// Sets the integrands and limits of the integrator.
  void Configure(const IntegralRequest& request, const IntegralLimits& limits);

  /**
   * Sets the Faces of every body, together with the other ranks if they share the run. Returns false if
   * nothing was computed; the report then has the reason.
   */
  bool Integrate(
    const IntegralRequest& request, const IntegralLimits& limits, std::vector<BodyIntegrals>& bodies);
  /**
   * Sums the faces of every body and measures the gaps of their edges, or sets unknown values if nothing was
   * computed. The status of the run becomes that of the file; what the bodies add to it follows from the
   * analysis (RunReport::AddStatuses).
   */
  void Sum(
    const IntegralRequest& request, bool computed, double gapLimit, std::vector<BodyIntegrals>& bodies);
  /// Integrates this rank's share of another rank's faces. This rank's own report has only its device.
  void RunAsWorker(const IntegralRequest& request, const IntegralLimits& limits);

  /// Adds the effort of the integrator's last run to the report. `dispatches` is the number of dispatches
  /// before that run.
  void AddEffort(vtkTypeUInt64 dispatches);
  /// Returns the reason why an integrand of the last run could not be evaluated; empty if it could.
  std::string GetObstacle(std::size_t integrand) const { return this->Integrator.GetObstacle(integrand); }

  /// Releases all memory: cut faces, results of faces, and GPU buffers.
  void ReleaseMemory();

private:
  bool IsSharedUpdate(int pieces) const;
  RankDevice GetDevice() const;
  void ReportRanks();
  std::string DescribeEstimate(bool hasOpenGL) const;
  /// Returns why the started context is not used; empty if it is.
  std::string FindContextProblem(BackendChoice backend) const;
  void SetRunner(bool hasOpenGL);
  /// Goes on with the CPU, because OpenGL computes something wrong, in this run and in others by the same
  /// context.
  void LeaveOpenGL(const std::string& distrust);
  /// Returns true if the last run by OpenGL failed for that, and the CPU may take its place.
  bool MustLeaveOpenGL(const IntegralLimits& limits) const;
  void ReportIntegrands(const IntegralRequest& request);
  bool RunTasks(
    const IntegralLimits& limits, const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results);
  /// Appends a task per face; returns the first task of every body.
  std::vector<std::size_t> MakeTasks(const IntegralRequest& request, const std::vector<BodyIntegrals>& bodies,
    std::vector<FaceTask>& tasks) const;
  /// Gives each body the results of its tasks; bodies with the same first task share them.
  static void TakeResults(const IntegralRequest& request, const std::vector<std::size_t>& firstTask,
    std::vector<FaceIntegrals>& results, std::vector<BodyIntegrals>& bodies);
  std::vector<std::size_t> ChooseTasks(const std::set<std::int64_t>& faceIds, std::vector<FaceTask>& tasks);
  void SpreadResults(const std::vector<std::size_t>& chosen, std::size_t integrands,
    std::vector<FaceIntegrals>& results) const;

  vtkNew<vtkComputeContext> Context;
  SurfaceIntegrator Integrator;
  ClosingSpreads Spreads;
  /// Backend of the integrator's runner; empty before the first run.
  std::string Runner;
  BackendRates Rates;
  /// True if the estimate of the run is for OpenGL; in a shared run that of the rank with the bodies.
  bool PrefersOpenGL = false;
  /// Smallest weight of a control point, as of EstimateBackends().
  double MinimumWeight = 1.0;
  /// Generation of the context of the last run; 0: the CPU's.
  vtkTypeUInt64 Generation = 0;
  /// Generation of the context that computes something wrong, and what.
  vtkTypeUInt64 DistrustedGeneration = 0;
  std::string Distrust;
  std::vector<Integrand> Configured;
  /// Exchange with the ranks of the controller; null without one.
  std::unique_ptr<ControllerExchange> Exchange;
  RunReport Report;
};
}

#endif
