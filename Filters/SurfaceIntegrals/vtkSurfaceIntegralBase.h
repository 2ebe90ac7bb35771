/**
 * @class   vtkSurfaceIntegralBase
 * @brief   base of the filters that integrate over the exact faces of trimmed NURBS solids
 *
 * Abstract. The subclasses are siblings: vtkSurfaceIntegralGPU computes integrals that its user chooses,
 * vtkMassPropertiesGPU volume, area, centre of mass and inertia, vtkBuoyancy displaced volume and centre of
 * buoyancy below a plane, vtkSolidSection the section with a plane and what lies on either side,
 * vtkSchemeMassPropertiesGPU mass properties by the schemes of the paper. This class finds the solids of the
 * input (a vtkNURBSDataSet, or those leaves of a composite dataset that are one), applies the selectors,
 * integrates on the GPU inside an OpenGL context of VTK, or on the CPU by the same mathematics compiled as
 * C++, shares the work with other processes, and reports on the run. A run has two steps: all values and
 * statuses are computed, then the outputs are written.
 *
 * Outputs of every subclass:
 * | port | type | contents |
 * |---|---|---|
 * | 0 | polydata | field data: totals, each with its Bound, Status, Backend, Renderer, BackendReason, |
 * | | | Evaluations, Dispatches, Faces, Ranks, BoundsEstimated |
 * | 1 | table | a row per solid instance: Name, Id, Status, LengthUnit, OpenEdges, FlippedShells, |
 * | | | BoundsEstimated, Faces, and its values with their Bounds |
 * | 2 | table | 1x1, column Text: a readable summary |
 * | 3 | table | a row per face and instance: Solid, FaceIndex (in it), FaceId, values, bounds, MaxGap |
 * | 4 | table | a row per edge and instance, widest gap first: Solid, EdgeIndex (in it), EdgeId, Name, |
 * | | | Uses, Open, MaxGap, GapArea, GapSquared, ClosureSpread (with mass properties) |
 * | 5 | partitioned dataset collection | meshes of the bodies as in port 1, points and cells shared with |
 * | | | the input, with cell arrays for colouring |
 * | 6 | polydata | flagged places of suspect and open bodies: edges (open or wide gaps) as lines, faces as |
 * | | | triangles; cell arrays Flag (number of the place, the worst first), Solid, Name, FaceId, EdgeId, |
 * | | | MaxGap, AreaInDoubt, VolumeInDoubt, Text. The figures are estimates for the place as a whole |
 * | | | (smFlaggedPlaces.h), repeated on each of its cells |
 * Ports 5 and 6 show the display mesh of the input. A reader makes it only where one is needed: by a view or
 * filter that is connected to port 5 or to the reader, or by Update(5). Otherwise the meshes of port 5 are
 * empty; values are the same. A run fills the arrays of the outputs of the run before again, except those to
 * which something else refers: hold an array to keep its values. The names are in smIntegralNames.h. A value
 * that could not be computed is NaN, never 0, and Status gives the reason.
 *
 * Status is the worst status of all solids and of the file. In ascending order: ok; tolerance-not-met (a
 * bound is above the tolerance); suspect (the file or the result contradicts itself, or the file declares
 * more than was read); open (some edges are used once, or the body is a surface, not a solid); not-computed
 * (a value could not be computed, for example without OpenGL or memory); empty (no body was found or
 * selected); unreadable (the reader of the input could not read its file).
 *
 * Getters return the values of the last run and never run the pipeline: call Update() first. RequestData
 * fails only for an input without exact geometry; where several ranks update together it does not, so that
 * what is downstream runs on all of them.
 *
 * Not thread safe. After SetRenderWindow() the calling thread must be the one that renders in that window.
 */
#ifndef vtkSurfaceIntegralBase_h
#define vtkSurfaceIntegralBase_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <cstddef>    // for std::size_t
#include <exception>  // for std::exception_ptr
#include <functional> // for std::function
#include <memory>     // for std::unique_ptr
#include <string>     // for std::string
#include <vector>     // for std::vector

class vtkComputeContext;
class vtkMultiProcessController;
class vtkRenderWindow;
class vtkTable;

namespace sm
{
struct BodyIntegrals;
struct RejectedInput;
struct IntegralLimits;
struct IntegralRequest;
struct MeshArray;
class IntegralEngine;
namespace columns
{
class KeptArrays;
}
}

class SMFILTERSSURFACEINTEGRALS_EXPORT vtkSurfaceIntegralBase : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkSurfaceIntegralBase, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  ///@{
  /**
   * Selectors of the bodies: only bodies below the nodes of the assembly that one of these selectors names
   * are used. The syntax is that of vtkDataAssembly::SelectNodes: "/Root/Pump/Impeller", "//Bolt". Without
   * selectors all bodies are used. The assembly is "Assembly", the product structure of the input, or
   * "Hierarchy", its blocks by name. A message names each selector that matches no body, or an assembly that
   * does not exist; if no body is selected, Status is empty. Default: no selectors, assembly "Assembly".
   */
  void AddSelector(const std::string& selector);
  void ClearSelectors();
  int GetNumberOfSelectors() const;
#ifndef __VTK_WRAP__
  /** Function that removes bodies of the input, of those that the selectors choose, and returns messages that
   * name them. */
  using BodyFilter = std::function<std::vector<std::string>(vtkDataObject*, std::vector<sm::BodyIntegrals>&)>;
  /** Leaves out the bodies that `leaveOut` removes. Null, the default: none. */
  void SetLeftOut(BodyFilter leaveOut);
#endif
  void SetAssemblyName(const std::string& name);
  std::string GetAssemblyName() const;
  ///@}

  ///@{
  /** Ends the table of port 1 with a row of the totals of port 0, where it has several rows and they were
   * computed: its Name is "Total", with selectors for example "Total of 3 of 7 solids", and its Id is empty.
   * Sums downstream count it, too. Default: off. */
  vtkSetMacro(TotalRow, bool);
  vtkGetMacro(TotalRow, bool);
  vtkBooleanMacro(TotalRow, bool);
  ///@}

  ///@{
  /** The window whose OpenGL context is used and shared with its renderers. Null, the default: the filter
   * makes its own context (X, or EGL without a display). */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}
  /** The OpenGL context, for its source, limits and counters. Never null. */
  vtkComputeContext* GetComputeContext();

  /** The device that computes. */
  enum BackendType
  {
    AUTOMATIC = 0,
    OPENGL = 1,
    CPU = 2
  };

  ///@{
  /**
   * The device that computes. OPENGL: compute shaders (OpenGL 4.3 with doubles; if not available, nothing is
   * computed and Status is not-computed). CPU: all threads of vtkSMPTools (the application chooses its
   * backend; VTK's default may be a single thread). AUTOMATIC: OPENGL with expressions, with a render window,
   * or with a source set in the compute context. Otherwise the seconds of both are estimated from the faces
   * of the input and the number of threads: OPENGL where that pays for starting it, and on a GPU only (no
   * software renderer, Mesa's llvmpipe); else CPU, with a message if there is a GPU that would pay and cannot
   * be used. Edits and full runs choose alike. The results of both agree to rounding, but not bitwise. Range
   * [AUTOMATIC, CPU], clamped. Default AUTOMATIC.
   */
  vtkSetClampMacro(Backend, int, AUTOMATIC, CPU);
  vtkGetMacro(Backend, int);
  ///@}

  ///@{
  /** Largest number of surface evaluations of a run. If the tolerances require more, they are loosened for
   * all faces alike, as far as necessary; the values are kept with their true bounds. At least 1, clamped.
   * Default 2e9. */
  vtkSetClampMacro(MaximumEvaluations, vtkTypeInt64, 1, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaximumEvaluations, vtkTypeInt64);
  ///@}

  ///@{
  /** Approximate limit of the duration of a run in seconds. Faces that are not integrated by then (or when
   * the run is aborted) count as 0, and the bounds include their largest possible magnitude; if the limit
   * ends the run before the orders are planned, nothing is computed. At least 0, clamped. Default 0: no
   * limit. */
  vtkSetClampMacro(MaximumSeconds, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumSeconds, double);
  ///@}

  ///@{
  /**
   * Gaps that make a result suspect: a distance between a face and its edge above this fraction of the
   * diagonal of the body, and a volume change by closing gaps above this fraction of the volume. A file that
   * states an uncertainty excuses more: gaps up to twice the uncertainty, for either side may be off by it,
   * and a change of the volume up to the uncertainty times the area; neither may exceed ten times the limit.
   * In [0, 1], clamped; 1 accepts every gap. Default 1e-3.
   */
  vtkSetClampMacro(GapLimit, double, 0.0, 1.0);
  vtkGetMacro(GapLimit, double);
  ///@}

  ///@{
  /**
   * The controller of the processes (ranks) that share the faces of a run. They share them if all ranks
   * update together, each its own piece of as many pieces as there are ranks (UpdatePiece(rank, ranks, 0), as
   * ParaView's servers do), and one rank, with a reader the first one, has bodies. Faces are divided by
   * estimated cost and sent to the other ranks, which need not have read anything. There they are cut,
   * planned and integrated, and the rank that has the bodies sums the results in the order of the faces:
   * these are bitwise equal to those of one process if all ranks have equal devices and no limit ends the
   * run. Later runs send only new faces.
   *
   * Outputs and getters of the other ranks are empty, so that no result exists twice. Properties must be the
   * same on all ranks; a rank with other integrands takes no part, with a message. A rank without OpenGL
   * computes on the CPU. If a rank fails, by an exception or otherwise, the rank with the bodies computes its
   * share, with a message; if that one fails, nothing is computed. An abort on any rank stops all ranks, at
   * the end of a batch of some 2e7 evaluations. Every rank may spend the part of MaximumEvaluations that
   * corresponds to its faces' part of the plan. Evaluations and Dispatches count all ranks. vtkBuoyancy,
   * vtkSolidSection and vtkSchemeMassPropertiesGPU run on the rank that has the bodies. If several ranks have
   * bodies, each integrates its own. A plain Update() involves only the calling process.
   *
   * Default: vtkMultiProcessController::GetGlobalController() at construction. Null: no other process.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /** Releases the memory that is kept for later runs: cut faces, results of faces, and all buffers on the
   * GPU. The next run computes it again, with bitwise equal results. If ReleaseDataFlag is on, every run ends
   * with this call. Outputs and getters are not affected. */
  void ReleaseMemory();

  ///@{
  /** Report of the last run: worst status of all solids ("ok", "open", …; empty before the first run),
   * messages for the user, the backend "opengl", "cpu" or "none", the name of the renderer ("CPU, N
   * threads"), and the effort. */
  std::string GetStatus() const;
  int GetNumberOfMessages() const;
  std::string GetMessage(int index) const;
  std::string GetBackendName() const;
  std::string GetRenderer() const;
  /** Why AUTOMATIC took this backend, for example "estimated 0.0024 s; OpenGL 0.4 s"; empty if the backend
   * was chosen. */
  std::string GetBackendReason() const;
  vtkTypeInt64 GetEvaluations() const;
  vtkTypeInt64 GetDispatches() const;
  int GetNumberOfSolids() const;
  int GetNumberOfFaces() const;
  /** Number of processes that integrated faces; 0 if nothing was computed. */
  int GetNumberOfRanks() const;
  /** Seconds of the last run: context and shaders; cutting into panels, planning and upload; integration;
   * sums, checks of shells, plausibility and tables. */
  double GetStartSeconds() const;
  double GetPrepareSeconds() const;
  double GetIntegrateSeconds() const;
  double GetAnalyseSeconds() const;
  /** Parts of GetPrepareSeconds(): cutting into panels; choosing the orders of the Gauss rules. The rest is
   * mostly upload. */
  double GetCutSeconds() const;
  double GetPlanSeconds() const;
  ///@}

  ///@{
  /** What AUTOMATIC expected of the last run before anything was cut, from the faces of the input:
   * evaluations, without those of expressions, and the seconds of the integration by OPENGL, with the start
   * of a context, or CPU; 0 for another backend. */
  double GetEstimatedEvaluations() const;
  double GetEstimatedSeconds(int backend) const;
  ///@}

  ///@{
  /**
   * Updates a port. For a port with meshes this also requests them, as a connected view does: the reader
   * makes the display mesh if there is none yet.
   */
  using vtkPolyDataAlgorithm::Update;
  void Update(int port) override;
  vtkTypeBool Update(int port, vtkInformationVector* requests) override;
  ///@}

  /** Reports to the input whether its display mesh is needed, see smMeshDemand.h. */
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int port, vtkMTimeType* time) override;

protected:
  vtkSurfaceIntegralBase();
  ~vtkSurfaceIntegralBase() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

#ifndef __VTK_WRAP__
  /** The outputs of ports 0 to 3, and where their arrays are from. */
  struct Outputs
  {
    sm::columns::KeptArrays& Arrays;
    vtkPolyData* Totals;
    vtkTable* Solids;
    vtkTable* Text;
    vtkTable* Faces;
    /// Port 7 of classes that have one, else null.
    vtkTable* Parts;
  };

  /** Resets the results, so that the getters return the values before the first run. Called at the start of
   * every run. */
  virtual void ResetResults();

  /** Returns true if other ranks can take a share of IntegrateBodies(). */
  virtual bool CanShareFaces() const
  {
    return true;
  }

  /** Returns the integrals to compute. */
  virtual sm::IntegralRequest MakeRequest() const = 0;

  /** Sets the Faces of every body. Returns false if nothing was computed; the report then has a reason. */
  virtual bool IntegrateBodies(const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies);

  /** Computes all quantities that follow from the sums over the faces, and the statuses of the bodies, and
   * stores them for WriteOutputs() and GetMeshArrays(). */
  virtual void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) = 0;

  /** Fills the outputs from the stored results. */
  virtual void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const = 0;

  /** Returns the cell arrays of the meshes on port 5. The bodies outlive them. */
  virtual std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const = 0;

  /** Returns the limits of a run, with progress and abort of this algorithm between the fractions `begin` and
   * `end`. */
  sm::IntegralLimits MakeLimits(double begin = 0.0, double end = 1.0);

  /** Returns a sentence with the reason for the status of these bodies; empty if none is known, and for the
   * status `ok`. */
  std::string FindReason(const std::vector<sm::BodyIntegrals>& bodies) const;

  /** Returns the first lines of a summary: sm::FormatStatus(), and that bounds are estimated where they are.
   */
  std::string FormatStatus(const std::vector<sm::BodyIntegrals>& bodies) const;

  /** Releases data that a subclass keeps for later runs in addition to the engine's data. */
  virtual void ReleaseKept() {}

  /** The engine, with context, integrator and report of the last run. */
  sm::IntegralEngine& GetEngine();
  const sm::IntegralEngine& GetEngine() const;
#endif

  ///@{
  /** Sets the relative tolerance, for subclasses that have one, in (0, 1]; at least 1e-15 is used. Others are
   * reported as an error and change nothing. */
  void ChangeRelativeTolerance(double tolerance);
  double RelativeTolerance = 1e-9;
  ///@}
  /** Sets `setting`, a member of a subclass, to `value`. If the value is not valid, it is reported as an
   * error and changes nothing; the message has the name of the setting and, after "give", the advice. */
  void ChangeSetting(double& setting, double value, bool isValid, const char* name, const char* advice);
  /** Changes a setting that is a density in kg/m^3: from 1e-200 to 1e200, or 0 for none. */
  void ChangeDensity(double& setting, double density);

  /** Gives the collection on a port the same blocks on all ranks that run together; collective, called by
   * RequestData() for each such port. */
  virtual void ShareBlocks(vtkInformation* request, vtkInformationVector* outputVector, int port);

  /** Option of subclasses that can keep results of faces. */
  bool CacheFaceResults = true;
  bool TotalRow = false;
  int Backend = AUTOMATIC;
  vtkTypeInt64 MaximumEvaluations = 2000000000;
  double MaximumSeconds = 0.0;
  double GapLimit = 1e-3;

private:
  vtkSurfaceIntegralBase(const vtkSurfaceIntegralBase&) = delete;
  void operator=(const vtkSurfaceIntegralBase&) = delete;

#ifndef __VTK_WRAP__
  /** Makes the text of the next report of progress say why no other will follow for some seconds. */
  void ReportCompilation();
  void ReportProgress(double fraction);
  int Run(vtkInformation* request, vtkDataObject* input, vtkInformationVector* outputVector);
  struct Input;
  /** Finds the bodies of the input that are to be integrated, and estimates what that takes. */
  void FindBodies(vtkDataObject* input, Input& found);
  /** The run of the rank that has the bodies. */
  int RunAsOwner(Input& found, vtkDataObject* input, vtkInformationVector* outputVector);
  /** The run of a rank that integrates a share of the bodies of another one. */
  void RunAsWorker();
  /** Computes values, statuses and the report of the run from the integrals. */
  void Analyze(const sm::IntegralRequest& request, bool computed, std::vector<sm::BodyIntegrals>& bodies);
  void Write(
    const std::vector<sm::BodyIntegrals>& bodies, vtkDataObject* input, vtkInformationVector* outputVector);
  /** Reports that the input has no exact geometry, and returns 0. */
  int RejectInput(bool isWithheld);
  /** Removes the bodies that no selector matches, and adds messages about unmatched selectors. */
  void ChooseBodies(
    vtkDataObject* input, std::vector<sm::BodyIntegrals>& bodies, sm::RejectedInput& rejected);
  /** Removes the bodies of SetLeftOut(), with a message. */
  void LeaveOutBodies(vtkDataObject* input, std::vector<sm::BodyIntegrals>& bodies);
  /** Adds the row of TotalRow to the table of port 1; `all` is the number of bodies of the input. */
  void WriteTotalRow(std::size_t bodies, std::size_t all, vtkInformationVector* outputVector) const;
  /** Adds the messages of the bodies to the report, and issues at most one warning. */
  void AddMessages(const std::vector<sm::BodyIntegrals>& bodies);
  /** Handles an exception that ended the run: writes outputs without values, and a status with the reason. */
  void Fail(const std::exception_ptr& failure, vtkInformationVector* outputVector);

  std::unique_ptr<sm::IntegralEngine> Engine;
  std::unique_ptr<sm::columns::KeptArrays> Arrays;
  std::vector<std::string> Selectors;
  BodyFilter LeavesOut;
  std::string AssemblyName = "Assembly";
  bool IsCompiling = false;
#endif
};

#endif
