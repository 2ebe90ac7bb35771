/**
 * @class   vtkSurfaceIntegralBase
 * @brief   what all filters share that integrate over the exact faces of trimmed NURBS solids
 *
 * Abstract. Subclasses are siblings: vtkSurfaceIntegralGPU integrates what its user asks for, vtkMassPropertiesGPU volume, area,
 * centre of mass and inertia, vtkBuoyancy what lies below a plane, vtkSchemeMassPropertiesGPU mass properties by the schemes of the
 * paper. This class finds the solids of the input (a vtkNURBSDataSet, or the leaves of a composite dataset that are), chooses among
 * them, integrates on the GPU inside an OpenGL context of VTK, or on the CPU by the same mathematics compiled as C++, shares the work
 * with other processes, and reports what a run did. A run is in two steps: all values and statuses are computed, then the outputs
 * are written.
 *
 * Outputs of every subclass:
 * | port | type     | what                                                                           |
 * |------|----------|--------------------------------------------------------------------------------|
 * | 0    | polydata | field data: totals, each with its Bound, Status, Backend, Renderer, Evaluations, Dispatches, Faces, Ranks, BoundsEstimated |
 * | 1    | table    | a row per solid instance: Name, Id, Status, the same values                     |
 * | 2    | table    | 1x1, column Text: a readable summary                                           |
 * | 3    | table    | a row per face and instance: Solid, FaceId, values and bounds                   |
 * | 4    | table    | a row per edge and instance, the widest gap first: Solid, EdgeId, Name, Uses, Open, MaxGap, GapArea, GapSquared |
 * | 5    | partitioned dataset collection | the bodies' meshes in the order of port 1, points and cells shared with the input, with cell arrays to colour them by |
 * The names are in smIntegralNames.h. What could not be computed is NaN with a Status, never 0.
 *
 * Status, the worst of all solids: ok; tolerance-not-met (a bound is above the tolerance); suspect (the file or the result
 * contradicts itself); open (edges that are used once; a surface without a solid); not-computed (memory was short, or an error was
 * caught); empty; unreadable.
 *
 * Getters return the values of the last run and never run the pipeline: call Update() first. RequestData fails only for a wrong input
 * (no exact geometry in it).
 *
 * Not thread safe. With SetRenderWindow the calling thread must be the one that renders in that window.
 */
#ifndef vtkSurfaceIntegralBase_h
#define vtkSurfaceIntegralBase_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class vtkComputeContext;
class vtkMultiProcessController;
class vtkRenderWindow;
class vtkTable;

namespace sm
{
struct BodyIntegrals;
struct IntegralLimits;
struct IntegralRequest;
struct MeshArray;
class IntegralEngine;
}

class SMFILTERSSURFACEINTEGRALS_EXPORT vtkSurfaceIntegralBase : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkSurfaceIntegralBase, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Which bodies: those below the nodes of an assembly that any of these selectors names, as vtkDataAssembly::SelectNodes takes
   * them: "/Root/Pump/Impeller", "//Bolt". None: all. The assembly is "Assembly", the product structure that the input brings, or
   * "Hierarchy", its blocks by name. A selector that names no body is named in a message; when none does Status is empty. Default:
   * none, of "Assembly".
   */
  void AddSelector(const std::string& selector);
  void ClearSelectors();
  int GetNumberOfSelectors() const;
  void SetAssemblyName(const std::string& name);
  std::string GetAssemblyName() const;
  ///@}

  ///@{
  /** The window whose OpenGL context is used and shared with its renderers. Default: none; a context of the
   * filter's own is made (X, or EGL without a display). */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}
  /** The context, for its source, limits and counters. Never null. */
  vtkComputeContext* GetComputeContext();

  /** What computes. */
  enum BackendType
  {
    AUTOMATIC = 0,
    OPENGL = 1,
    CPU = 2
  };

  ///@{
  /**
   * What computes: OPENGL, compute shaders (OpenGL 4.3 with doubles; without, nothing is computed and Status is
   * tolerance-not-met); CPU, all threads that vtkSMPTools has (the application chooses its backend; VTK's default may be a
   * single thread); AUTOMATIC, OPENGL where it can be had, else CPU, with a message that says why. The two agree to rounding, not
   * bit for bit. Clamped to these. Default AUTOMATIC.
   */
  vtkSetClampMacro(Backend, int, AUTOMATIC, CPU);
  vtkGetMacro(Backend, int);
  ///@}

  ///@{
  /** Most surface evaluations that a run may spend. Where the tolerances would take more they are loosened, for all
   * faces alike, as far as need be; the values are kept with their true bounds. Default 2e9. At least 1. */
  vtkSetClampMacro(MaximumEvaluations, vtkTypeInt64, 1, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaximumEvaluations, vtkTypeInt64);
  ///@}

  ///@{
  /** Most seconds that a run may take, about. Faces that were not reached by then (or when the run is aborted) count as 0,
   * and the bounds hold the most that they can be; before the orders are planned nothing is known, and nothing computed.
   * Default 0: no limit. At least 0. */
  vtkSetClampMacro(MaximumSeconds, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumSeconds, double);
  ///@}

  ///@{
  /**
   * The processes (ranks) that share the faces of a run. They do when all of them update together, each its own piece of as many as
   * there are ranks (UpdatePiece(rank, ranks, 0), as ParaView's servers do), and one of them, of a reader the first, has bodies.
   * Faces are divided by estimated cost and sent to the others, which need not have read anything; they are cut, planned and
   * integrated there, and the rank that has the bodies sums them in the order of the faces: the bits are those of one
   * process, if all ranks compute with equal devices and no budget ends the run. Later runs send new faces only.
   *
   * Outputs and getters of the other ranks are empty, so that nothing is there twice. Properties must be the same on all
   * ranks; one whose integrands are not takes no part, and a message says so. A rank without OpenGL computes on the CPU; one that
   * fails has its share done by the rank with the bodies, with a message; abort on any rank stops all, at the end of a batch of some
   * 2e7 evaluations; of MaximumEvaluations every rank may spend the part that its faces are of the plan. Evaluations and
   * Dispatches count all ranks. vtkBuoyancy and vtkSchemeMassPropertiesGPU run on the rank that has the bodies. When several ranks
   * have bodies, each integrates its own. A plain Update() is for the calling process alone.
   *
   * Default: vtkMultiProcessController::GetGlobalController() when the filter was made. Null: no other process.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /** Gives back the memory that is kept for later runs: cut faces, results of faces, and all buffers on the GPU. The next run fills
   * it again, with the same bits. Every run ends with it when ReleaseDataFlag is on. The outputs and the getters stay. */
  void ReleaseMemory();

  ///@{
  /** The last run: worst status of all solids ("ok", "open", …; empty before the first run), what to tell the user, and how it was
   * done: backend "opengl", "cpu" or "none", and the name of the renderer ("CPU, N threads"). */
  std::string GetStatus() const;
  int GetNumberOfMessages() const;
  std::string GetMessage(int index) const;
  std::string GetBackendName() const;
  std::string GetRenderer() const;
  vtkTypeInt64 GetEvaluations() const;
  vtkTypeInt64 GetDispatches() const;
  int GetNumberOfSolids() const;
  int GetNumberOfFaces() const;
  /** Processes that integrated faces; 0 when nothing was computed. */
  int GetNumberOfRanks() const;
  /** Seconds of the last run: context and shaders; cutting into panels and upload; integration. */
  double GetStartSeconds() const;
  double GetPrepareSeconds() const;
  double GetIntegrateSeconds() const;
  ///@}

  /** For tests: makes every shader (the CPU's kernels too) multiply its samples by this factor, to show that the numbers come
   * from there. Default 1. */
  vtkSetMacro(ShaderPerturbation, double);
  vtkGetMacro(ShaderPerturbation, double);

protected:
  vtkSurfaceIntegralBase();
  ~vtkSurfaceIntegralBase() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

#ifndef __VTK_WRAP__
  /** The first four outputs. */
  struct Outputs
  {
    vtkPolyData* Totals;
    vtkTable* Solids;
    vtkTable* Text;
    vtkTable* Faces;
  };

  /** Makes the getters return what they do before the first run. Called at the start of every run. */
  virtual void ResetResults();

  /** Other ranks can take a share of IntegrateBodies(). */
  virtual bool CanShareFaces() const
  {
    return true;
  }

  /** What is to be integrated. */
  virtual sm::IntegralRequest MakeRequest() const = 0;

  /** Gives every body the integrals of its faces. False when nothing was computed; the report then has a reason. */
  virtual bool IntegrateBodies(const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies);

  /** Computes all that follows from the sums over the faces, and the statuses of the bodies; keeps it for the next two. */
  virtual void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) = 0;

  /** Fills the outputs. */
  virtual void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const = 0;

  /** The arrays of the meshes on port 5. The bodies outlive them. */
  virtual std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const = 0;

  /** What a run may use and spend, with progress and abort of this algorithm between the fractions `begin` and `end`. */
  sm::IntegralLimits MakeLimits(double begin = 0.0, double end = 1.0);

  /** What made a result of these bodies flagged, in a sentence; empty where nothing is known. */
  std::string FindReason(const std::vector<sm::BodyIntegrals>& bodies) const;

  /** Releases what a subclass keeps for later runs beside what the engine does. */
  virtual void ReleaseKept() {}

  /** Context, integrator and report of the last run. */
  sm::IntegralEngine& GetEngine();
  const sm::IntegralEngine& GetEngine() const;
#endif

  ///@{
  /** For subclasses that have a tolerance: relative, clamped to [1e-15, 1]; not a number is an error and changes nothing. */
  void ChangeRelativeTolerance(double tolerance);
  double RelativeTolerance = 1e-9;
  ///@}
  /** For subclasses that can keep results of faces. */
  bool CacheFaceResults = true;
  int Backend = AUTOMATIC;
  vtkTypeInt64 MaximumEvaluations = 2000000000;
  double MaximumSeconds = 0.0;
  double ShaderPerturbation = 1.0;

private:
  vtkSurfaceIntegralBase(const vtkSurfaceIntegralBase&) = delete;
  void operator=(const vtkSurfaceIntegralBase&) = delete;

#ifndef __VTK_WRAP__
  int Run(vtkInformation* request, vtkDataObject* input, vtkInformationVector* outputVector);
  /** Values, statuses and the report of the run, from what was integrated. */
  void Analyze(const sm::IntegralRequest& request, bool computed, std::vector<sm::BodyIntegrals>& bodies);
  void Write(
    const std::vector<sm::BodyIntegrals>& bodies, vtkDataObject* input, vtkInformationVector* outputVector);
  /** No exact geometry in the input: says so, and returns 0. */
  int RejectInput(bool isWithheld);
  /** The bodies that the selectors choose. */
  void ChooseBodies(vtkDataObject* input, std::vector<sm::BodyIntegrals>& bodies);
  /** VTK 9.2 leaves the flag of an abort set, so that the next run would stop at once. */
  void ClearAbort();
  /** What is said of a result: messages and one warning. */
  void AddMessages(const std::vector<sm::BodyIntegrals>& bodies);
  /** The run was ended by an exception: outputs without values, and a status that says so. */
  void Fail(const std::string& what, vtkInformationVector* outputVector);

  std::unique_ptr<sm::IntegralEngine> Engine;
  std::vector<std::string> Selectors;
  std::string AssemblyName = "Assembly";
#endif
};

#endif
