/**
 * @file smIntegralEngine.h
 * @brief What all filters over surface integrals run on: context, backend, ranks, and the report of a run
 */
#ifndef smIntegralEngine_h
#define smIntegralEngine_h

#include "Sharing/smControllerExchange.h"
#include "smBodyIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegralNames.h"
#include "smProgressCallback.h"
#include "smStatus.h"
#include "smSurfaceIntegrator.h"

#include "vtkComputeContext.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkFieldData;

namespace sm
{
/// A run as its user sees it: what the getters return and what stands in the field data.
struct SMFILTERSSURFACEINTEGRALS_EXPORT RunReport
{
  sm::Status Status = sm::Status::None;
  std::vector<std::string> Messages;
  /// The message that says what stopped the run, or why there was nothing to compute; empty when neither is so.
  std::string Reason;
  /// A message about all bodies at once, which follows those about each of them.
  std::string Note;
  std::string Backend = names::BackendNone;
  std::string Renderer;
  /// Why the CPU computed where OpenGL would have been preferred.
  std::string FallbackReason;
  std::int64_t Evaluations = 0;
  std::int64_t Dispatches = 0;
  /// Some bound is an estimate and no theorem.
  bool Estimated = false;
  int Solids = 0;
  int Faces = 0;
  int Ranks = 0;
  double StartSeconds = 0.0;
  double PrepareSeconds = 0.0;
  double IntegrateSeconds = 0.0;

  /// Adds a message; the first of a run is its reason.
  void SetReason(const std::string& message);
  /// Status, Backend, Renderer, Evaluations, Dispatches, Faces, Ranks, BoundsEstimated.
  void FillFieldData(vtkFieldData* data) const;
};

/// Which backend may compute, as vtkSurfaceIntegralBase::BackendType.
enum class BackendChoice
{
  Automatic,
  OpenGL,
  CPU
};

/// What is to be integrated over the faces of the bodies.
struct IntegralRequest
{
  std::vector<Integrand> Integrands;
  /// True: in world coordinates, instance by instance. False: about each part's own origin, once for all its instances.
  bool UsePlacements = true;
  /// Absolute tolerances of the integrands over a whole body; every face gets an equal share, whatever the others' results.
  std::function<std::vector<double>(const BodyIntegrals&)> GetTolerances;
  /// Entity numbers of the faces to integrate over; empty: all.
  std::set<int> FaceIds;
};

/// What a run may use and spend.
struct IntegralLimits
{
  BackendChoice Backend = BackendChoice::Automatic;
  std::int64_t MaximumEvaluations = 2000000000;
  /// 0: no limit.
  double MaximumSeconds = 0.0;
  bool CacheFaceResults = true;
  /// Factor of every sample, for tests.
  double Perturbation = 1.0;
  ProgressCallback Progress;
};

/**
 * Keeps the context, the integrator with its runner, and what is known of faces from run to run. Not thread safe.
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
  /** The ranks that may share a run; null: this process alone. */
  void SetController(vtkMultiProcessController* controller) { this->Controller = controller; }
  vtkMultiProcessController* GetController() const { return this->Controller; }
  ///@}

  /// What a rank does in a run: all there is to do; its share of what another rank has; or nothing, with empty outputs.
  enum class Role
  {
    Owner,
    Worker,
    Idle
  };
  /**
   * Finds this rank's role together with the other ranks, if `pieces` of the update are as many as there are ranks. `root` gets
   * the rank that a worker works for. Collective.
   */
  Role ChooseRole(bool canShare, int pieces, bool hasInput, bool hasBodies, int& root);
  /// Releases the ranks that wait for a share of this run, if it ended before they got one.
  void ReleaseWorkers();

  /// Gives the integrator the runner that `backend` asks for and the machine has. False, with a reason in the report, without one.
  bool ChooseRunner(BackendChoice backend);
  /// Gives the integrator integrands and limits.
  void Configure(const IntegralRequest& request, const IntegralLimits& limits);

  /**
   * Gives every body the integrals of its faces, with the other ranks if they share the run. False when nothing was computed; the
   * report says why.
   */
  bool Integrate(
    const IntegralRequest& request, const IntegralLimits& limits, std::vector<BodyIntegrals>& bodies);
  /// Does this rank's share of the faces that the rank `root` has. Its report says what it computed with.
  void RunAsWorker(const IntegralRequest& request, const IntegralLimits& limits, int root);

  /// Adds what the integrator spent in its last run to the report. `dispatches` is their number before that run.
  void AddEffort(vtkTypeUInt64 dispatches);
  /// Why an integrand of the last run could not be evaluated; empty when it could.
  std::string GetObstacle(std::size_t integrand) const { return this->Integrator.GetObstacle(integrand); }

  /// Releases all memory: cut faces, results of faces, and what is on the GPU.
  void ReleaseMemory();

private:
  class SharingScope;

  RankDevice GetDevice() const;
  void ReportRanks();
  void ReportIntegrands(const IntegralRequest& request);
  bool RunTasks(
    const IntegralLimits& limits, const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results);
  /// Appends a task per face; returns the first task of every body.
  std::vector<std::size_t> MakeTasks(const IntegralRequest& request, const std::vector<BodyIntegrals>& bodies,
    std::vector<FaceTask>& tasks) const;
  std::vector<std::size_t> ChooseTasks(const std::set<int>& faceIds, std::vector<FaceTask>& tasks);
  void SpreadResults(const std::vector<std::size_t>& chosen, std::size_t integrands,
    std::vector<FaceIntegrals>& results) const;

  vtkNew<vtkComputeContext> Context;
  SurfaceIntegrator Integrator;
  /// Backend of the integrator's runner; empty before the first run.
  std::string Runner;
  /// Generation of the context of the last run; 0: the CPU's.
  vtkTypeUInt64 Generation = 0;
  std::vector<Integrand> Configured;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::unique_ptr<ControllerExchange> Exchange;
  RunReport Report;
};
}

#endif
