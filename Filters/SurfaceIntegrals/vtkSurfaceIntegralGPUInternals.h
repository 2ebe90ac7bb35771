/**
 * @file vtkSurfaceIntegralGPUInternals.h
 * @brief What vtkSurfaceIntegralGPU and its subclasses share; not installed
 */
#ifndef vtkSurfaceIntegralGPUInternals_h
#define vtkSurfaceIntegralGPUInternals_h

#include "Sharing/smControllerExchange.h"
#include "smBodyIntegrals.h"
#include "smBuoyancy.h"
#include "smColumns.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegralNames.h"
#include "smSurfaceIntegrator.h"
#include "vtkSurfaceIntegralGPU.h"

#include "vtkComputeContext.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <memory>
#include <set>

class vtkFieldData;
class vtkPolyData;
class vtkTable;

struct SMFILTERSSURFACEINTEGRALS_EXPORT vtkSurfaceIntegralGPU::Internals
{
  /// What the getters return.
  struct Run
  {
    std::string Status;
    std::vector<std::string> Messages;
    /// The message that says what stopped the run, or why there was nothing to compute; empty when neither is so.
    std::string Reason;
    /// What is said of all bodies at once, behind what each of them says.
    std::string Note;
    std::string Backend = sm::names::BackendNone;
    std::string Renderer;
    /// Why the CPU computed where OpenGL would have been preferred.
    std::string FallbackReason;
    vtkTypeInt64 Evaluations = 0;
    vtkTypeInt64 Dispatches = 0;
    bool Estimated = false;
    int Solids = 0;
    int Faces = 0;
    int Ranks = 0;
    double StartSeconds = 0.0;
    double PrepareSeconds = 0.0;
    double IntegrateSeconds = 0.0;
    std::map<std::string, std::pair<double, double>> Integrals;
    /// Centres of buoyancy and their bounds, by name.
    std::map<std::string, std::pair<std::array<double, 3>, double>> Centers;
  };

  /// Tolerances of the integrands for a body about the part's own origin. Set: integrate every model once about
  /// its origin, without placements.
  using ToleranceRule = std::function<std::vector<double>(vtkTrimmedNURBSModel&)>;

  vtkNew<vtkComputeContext> Context;
  sm::SurfaceIntegrator Integrator;
  /// What the integrator's runner is: "", "opengl" or "cpu".
  std::string Runner;
  /// Of the context that the last run was in; 0: none.
  vtkTypeUInt64 Generation = 0;
  std::vector<sm::Integrand> Integrands;
  std::vector<sm::Integrand> Configured;
  ToleranceRule LocalTolerances;
  sm::BuoyancyIntegrator Buoyancy;
  std::vector<sm::Waterline> Waterlines;
  /// Their names: what the centres are called after.
  std::vector<std::string> WaterlineNames;
  /// Of the last run: waterline by waterline, bodies fastest.
  std::vector<sm::BodyBuoyancy> Displaced;
  sm::UserExpression::Constants Constants;
  /// What the switches for user interfaces are set to, and the names of the integrands that each of them added.
  std::string IntegrandText;
  int MomentDegree = -1;
  bool BendingEnergy = false;
  double ProjectedAreaDirection[3] = { 0.0, 0.0, 0.0 };
  bool HasWaterline = false;
  double WaterlinePoint[3] = { 0.0, 0.0, 0.0 };
  double WaterlineNormal[3] = { 0.0, 0.0, 1.0 };
  std::map<std::string, std::set<std::string>> Switched;
  /// Entity numbers of the faces to integrate over; empty: all.
  std::set<int> FaceIds;
  /// Which bodies: selectors of nodes, none for all, and the assembly they are of.
  std::vector<std::string> Selectors;
  std::string AssemblyName = "Assembly";
  Run Last;

  /// What a rank does in a run: all there is to do; its part of what another has; or nothing, and puts nothing out.
  enum class Role
  {
    Owner,
    Worker,
    Idle
  };
  vtkSmartPointer<vtkMultiProcessController> Controller;
  /// While the faces are shared with other ranks.
  std::unique_ptr<sm::ControllerExchange> Exchange;

  void Add(vtkSurfaceIntegralGPU* self, const sm::Integrand& integrand);
  /// Adds a message; the first of a run is its reason.
  void SetReason(const std::string& message);
  /// Replaces the integrands that the switch added before by what `add` adds.
  void Switch(vtkSurfaceIntegralGPU* self, const std::string& name, const std::function<void()>& add);
  void SwitchWaterline(vtkSurfaceIntegralGPU* self);
  /// Gives the integrator the runner that the backend asks for and the machine has, and says so in Last.
  bool ChooseRunner(vtkSurfaceIntegralGPU* self);
  bool Integrate(vtkSurfaceIntegralGPU* self, std::vector<sm::BodyIntegrals>& bodies);
  /// All but what is below waterlines, with the other ranks if they are met.
  bool RunPlain(vtkSurfaceIntegralGPU* self, const std::vector<sm::FaceTask>& tasks,
    std::vector<sm::FaceIntegrals>& results);
  /// Says in Last which integrands were not computed, and whose bounds are estimated.
  void ReportIntegrands();
  /// The integrands that the integrator is given: all but those below waterlines.
  std::vector<sm::Integrand> GetPlainIntegrands() const;
  /// Why an integrand could not be evaluated; empty when it could.
  std::string GetObstacle(std::size_t integrand) const;
  /// Integrates what is below the waterlines, and puts it between the other results of the bodies' faces.
  bool IntegrateBuoyancy(vtkSurfaceIntegralGPU* self, std::vector<sm::BodyIntegrals>& bodies);
  /// Centres of buoyancy of the bodies and of all together.
  void AddCenters(const std::vector<sm::BodyIntegrals>& bodies, vtkPolyData* totals, vtkTable* solids,
    std::string& summary);
  void AddTasks(
    const sm::BodyIntegrals& body, bool placed, double tolerance, std::vector<sm::FaceTask>& tasks) const;
  /// Leaves the tasks of chosen faces; returns for every task where its result will be (beyond the end: nowhere), nothing
  /// where all faces are chosen.
  std::vector<std::size_t> ChooseTasks(std::vector<sm::FaceTask>& tasks);
  /// Puts the results where they would be if all faces had been integrated, zeros in between.
  void SpreadResults(const std::vector<std::size_t>& chosen, std::vector<sm::FaceIntegrals>& results) const;
  /// Leaves the bodies that the selectors choose, and says which selectors choose nothing.
  void ChooseBodies(vtkDataObject* input, std::vector<sm::BodyIntegrals>& bodies);
  /// Meets the other ranks, if they are to. `root` gets the rank that a helper helps.
  Role ChooseRole(bool canShare, int pieces, bool hasInput, bool hasBodies, int& root);
  void RunAsWorker(vtkSurfaceIntegralGPU* self, int root);
  /// Gives the integrator what is asked of it.
  void Configure(vtkSurfaceIntegralGPU* self);
  sm::RankDevice GetDevice() const;
  /// Says in Last what the ranks did.
  void ReportRanks();
  void FillRunData(vtkFieldData* data) const;
  /// How far the body reaches from the world origin.
  static double GetReach(const sm::BodyIntegrals& body);
  static double GetScale(const sm::Integrand& integrand, vtkTrimmedNURBSModel& model, double reach);
};

#endif
