/**
 * @class   vtkSurfaceIntegralGPU
 * @brief   integrals over the exact faces of trimmed NURBS solids, by compute shaders
 *
 * Integrates any list of integrands over the faces of every vtkNURBSDataSet in the input (one, or the
 * leaves of a composite dataset), in double precision on the GPU, inside an OpenGL context of VTK; or, where there is
 * no OpenGL 4.3 with doubles, on the CPU by the same mathematics compiled as C++, see SetBackend().
 * An integrand is a scalar GLSL expression, which must hold the area element once (`f * dA`, `dot(field, normal)`), of
 *   - `position`: dvec3, world coordinates, in the model's length unit,
 *   - `normal`:   dvec3, outward normal of the length of the area element `dA`. Outward is what the file calls so: a
 *     shell that is inside out is turned by vtkMassPropertiesGPU only, FlippedShells is 0 here,
 *   - `unitNormal`: dvec3; `dA`: double, length(normal),
 *   - on FACES also `u`, `v`: double, the face's own parameters; `du`, `dv`, `duu`, `duv`, `dvv`: dvec3, first and
 *     second derivatives of the point in them, in world coordinates; `meanCurvature`, positive where the body is
 *     convex, 1/R on a sphere; `gaussianCurvature`,
 *   - constants of AddConstant(), and the functions of GLSL; sin, cos, tan, exp, log and pow are of doubles here (angles up
 *     to 2^20, beyond they are not a number).
 * Bounds of expressions are estimated, and suppose that they are smooth on every face: at kinks and steps (abs, min, max,
 * step, ?: and their like) an error may exceed its bound; a message says which expressions may have
 * some. Peaks too narrow for any point of the first two orders (3 and 6 a direction of a patch) are not seen at all.
 * Numbers are doubles, 1/3 is a third; statements, assignments, comments, commas outside of arguments and single precision are
 * errors.
 * An integrand on the CLOSED_CHAIN is also integrated over the ribbons and caps that join the faces along
 * their common edges, so that fluxes are those of a closed surface; one on FACES (areas) is not.
 *
 * Outputs:
 * | port | type     | what                                                                           |
 * |------|----------|--------------------------------------------------------------------------------|
 * | 0    | polydata | a point without a cell, in the middle of the solids' box; field data: one array per integrand (total), its Bound, Status …; centres of buoyancy |
 * | 1    | table    | a row per solid instance: Name, Id, every integrand, its Bound, Status; centres of buoyancy |
 * | 2    | table    | 1x1, column Text: a readable summary                                           |
 * | 3    | table    | a row per face and instance: Solid, FaceId, every integrand, its Bound         |
 * | 4    | table    | a row per edge and instance, the widest gap first: Solid, EdgeId, Name, Uses, Open, MaxGap, GapArea, GapSquared |
 * | 5    | partitioned dataset collection | the bodies' meshes in the order of port 1, points and cells shared with the input, with cell arrays to colour by: every integrand, the value of the face (float; left out when there are more than 16) |
 * The names are in smIntegralNames.h. What could not be computed is NaN with a Status, never 0.
 *
 * Moments and areas are planned: a theorem chooses the orders of the Gauss rules and the bisections
 * before a point is evaluated, and bounds their error (Bounds.md). For expressions the order is raised panel by panel until two
 * orders agree to the tolerance, and the error is estimated from their difference. The rounding of every sample is added to
 * both. A bound is infinite when faces are missing.
 *
 * Getters return the values of the last run and never run the pipeline: call Update() first.
 * RequestData fails only for a wrong input (no exact geometry in it). What cannot be computed has its rows, with NaN and
 * a status: everything, when OPENGL is asked for and there is none; on the CPU, integrands that are expressions.
 *
 * Several processes share the work where they update together, see SetController().
 *
 * Not thread safe. With SetRenderWindow the calling thread must be the one that renders in that window.
 */
#ifndef vtkSurfaceIntegralGPU_h
#define vtkSurfaceIntegralGPU_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the implementation
#include <string> // for std::string
#include <vector> // for std::vector

class vtkComputeContext;
class vtkMultiProcessController;
class vtkNURBSDataSet;
class vtkRenderWindow;
class vtkTable;

namespace sm
{
struct BodyIntegrals;
struct Integrand;
struct MeshArray;
}

class SMFILTERSSURFACEINTEGRALS_EXPORT vtkSurfaceIntegralGPU : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceIntegralGPU* New();
  vtkTypeMacro(vtkSurfaceIntegralGPU, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Where an integrand is integrated. */
  enum SupportType
  {
    CLOSED_CHAIN = 0,
    FACES = 1
  };

  /**
   * Adds the integrand `expression` (GLSL, double precision, see above) under `name`. An empty name or
   * expression, or a name whose column, or whose bound's, exists or has another meaning in the outputs (ReservedColumnNames in
   * smIntegralNames.h), is an error and adds nothing. An expression that does not compile is
   * NaN, with a message that has the compiler's words and the column; the other integrands are computed.
   */
  void AddIntegrand(const std::string& name, const std::string& expression, int support = FACES);
  /** Volume integral of x^i y^j z^k, by the divergence theorem: flux of r x^i y^j z^k / (3 + i + j + k).
   * Powers are not negative, and i + j + k is 60 at most; others are an error and add nothing. */
  void AddVolumeMoment(const std::string& name, int i, int j, int k);
  /** Surface integral of x^i y^j z^k, powers as above. */
  void AddAreaMoment(const std::string& name, int i, int j, int k);
  /** Flux of the vector (x, y, z), each an expression, out of the body. */
  void AddFlux(const std::string& name, const std::string& x, const std::string& y, const std::string& z);
  /** Energy of bending as of a thin plate: the integral of k1^2 + k2^2 = 4 H^2 - 2 K, k1 and k2 the principal curvatures. Of
   * any size of a sphere 8 pi. Relative tolerances are relative to area / size^2. */
  void AddBendingEnergy(const std::string& name);
  /** Half the integral of |n.d|, d the direction made a unit vector: the area of the shadow, if the body is convex; else what
   * lies behind something counts too. */
  void AddProjectedArea(const std::string& name, double x, double y, double z);
  /**
   * What lies below a waterline, the plane through the point (x, y, z) with the normal (upX, upY, upZ) out of the water, of any
   * length but 0; in world coordinates, lengths in the model's unit. Four integrands: `name`, the displaced volume;
   * `name`MomentX, MomentY and MomentZ, its first moments about the world's origin; with them `name`Center, the centre of
   * buoyancy, and its bound (ports 0 and 1; NaN where the volume is not surely above 0). Faces are cut at the waterline, so that
   * bounds are theorems as those of moments, kinks notwithstanding; a body above the waterline displaces 0, one below it
   * its volume. Per face (port 3): its flux of a field that vanishes on the plane (for a
   * body that is below as a whole: on a parallel plane through it), so that the sum over a closed solid is the volume with
   * nothing added for the waterplane. A direction of no length, or a number that is not finite, is an error and adds
   * nothing, as a name that exists. Needs no GLSL of the user's: the CPU backend has it.
   */
  void AddBuoyancy(const std::string& name, double x, double y, double z, double upX, double upY, double upZ);
  /** Makes `name` a number in expressions, those added before too; again: another number. An error, and nothing, when it is not
   * finite, or no identifier, or has a meaning. */
  void AddConstant(const std::string& name, double value);
  ///@{
  /** Integrates over faces of these entity numbers (FaceId of port 3) alone, in all bodies; none: over all. Others count as 0,
   * and with them the strips that join them to their edges. */
  void AddFaceId(int id);
  void RemoveAllFaceIds();
  int GetNumberOfFaceIds() const;
  ///@}
  /** Forgets all integrands, those of the next five too. */
  virtual void RemoveAllIntegrands();

  ///@{
  /** Integrands as a text, for user interfaces: a line each, `NAME = EXPRESSION` over the faces or `NAME = X ; Y ; Z`, the flux
   * of a vector out of the closed chain; empty lines are passed over. They replace those of an earlier text and leave all
   * others. A line without a name, a '=' or one or three expressions is an error and is left out. Default: empty. */
  void SetIntegrandText(const std::string& text);
  std::string GetIntegrandText() const;
  ///@}
  ///@{
  /** All volume moments x^i y^j z^k, i + j + k up to this degree, as `moment_i_j_k`; -1: none. Clamped to -1 .. 8, since one
   * shader has them all; AddVolumeMoment() takes more. Beside an
   * expression their bounds are estimated. Default: -1. */
  void SetMomentDegree(int degree);
  int GetMomentDegree() const;
  ///@}
  ///@{
  /** AddBendingEnergy() under the name `BendingEnergy`. Default: off. */
  void SetBendingEnergy(bool on);
  bool GetBendingEnergy() const;
  void BendingEnergyOn() { this->SetBendingEnergy(true); }
  void BendingEnergyOff() { this->SetBendingEnergy(false); }
  ///@}
  ///@{
  /** AddProjectedArea() of this direction under the name `ProjectedArea`; 0 0 0: none. What is not finite is an error and changes
   * nothing. Default: 0 0 0. */
  void SetProjectedAreaDirection(double x, double y, double z);
  void SetProjectedAreaDirection(const double direction[3])
  {
    this->SetProjectedAreaDirection(direction[0], direction[1], direction[2]);
  }
  double* GetProjectedAreaDirection() VTK_SIZEHINT(3);
  ///@}
  ///@{
  /** AddBuoyancy() under the name `Displaced`, of the waterline through a point, with a normal out of the water. A normal of no length
   * or numbers that are not finite are an error, and there is no such integral. Defaults: off, 0 0 0, 0 0 1. */
  void SetWaterline(bool on);
  bool GetWaterline() const;
  void WaterlineOn() { this->SetWaterline(true); }
  void WaterlineOff() { this->SetWaterline(false); }
  void SetWaterlinePoint(double x, double y, double z);
  void SetWaterlinePoint(const double point[3]) { this->SetWaterlinePoint(point[0], point[1], point[2]); }
  double* GetWaterlinePoint() VTK_SIZEHINT(3);
  void SetWaterlineNormal(double x, double y, double z);
  void SetWaterlineNormal(const double normal[3])
  {
    this->SetWaterlineNormal(normal[0], normal[1], normal[2]);
  }
  double* GetWaterlineNormal() VTK_SIZEHINT(3);
  ///@}
  int GetNumberOfIntegrands() const;
  std::string GetIntegrandName(int index) const;

  ///@{
  /**
   * Which bodies: those below the nodes of an assembly that any of these selectors names, as vtkDataAssembly::SelectNodes takes
   * them: "/Root/Pump/Impeller", "//Bolt". None: all. The assembly is "Assembly", the product structure that the input brings, or
   * "Hierarchy", its blocks by name. A selector that names no body is told in a message; when none does Status is empty. Default:
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

  ///@{
  /**
   * Tolerance of every integral relative to the scale of its solid (volume or area times the matching power
   * of its size). Range (0, 1], clamped to [1e-15, 1]; not a number is an error and changes nothing. Default 1e-9. Unmet: Status tolerance-not-met, the
   * value and its true bound are kept.
   */
  void SetRelativeTolerance(double tolerance);
  vtkGetMacro(RelativeTolerance, double);
  ///@}

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
   * single thread), where moments run and expressions (AddIntegrand) do not: they are NaN, and a message names them;
   * AUTOMATIC, OPENGL where it can be had, else CPU, with a message that says why. The two agree to rounding, not bit
   * for bit. Clamped to these. Default AUTOMATIC.
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
   * Integrals of faces are kept by face, tolerances and (where they matter) placement, so that after an edit only the faces
   * that it changed are evaluated; values and bounds have the bits of a full run, and Evaluations counts what was
   * evaluated. Off: every run evaluates everything. The paper's schemes always do. Default: on.
   */
  vtkSetMacro(KeepFaces, bool);
  vtkGetMacro(KeepFaces, bool);
  vtkBooleanMacro(KeepFaces, bool);
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
   * Dispatches count all ranks. The paper's schemes run on one rank. When several ranks have bodies, each
   * integrates its own. A plain Update() is for the calling process alone.
   *
   * Default: vtkMultiProcessController::GetGlobalController() when the filter was made. Null: no other process.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  ///@{
  /** The last run: total of the integrand (NaN when absent or not computed) and its bound. */
  double GetIntegral(const std::string& name) const;
  double GetIntegralBound(const std::string& name) const;
  ///@}

  ///@{
  /** The last run: the centre of buoyancy of all bodies together (NaN when absent or nothing is below the waterline) and its
   * bound, a length. `name` is AddBuoyancy()'s. */
  void GetCenterOfBuoyancy(const std::string& name, double center[3]) const;
  double GetCenterOfBuoyancyBound(const std::string& name) const;
  ///@}

  ///@{
  /** The last run: worst status of all solids ("ok", "open", …), what to tell the user, and how it was done: backend
   * "opengl", "cpu" or "none", and the name of the renderer ("CPU, N threads"). */
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
  vtkSurfaceIntegralGPU();
  ~vtkSurfaceIntegralGPU() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

#ifndef __VTK_WRAP__
  /** Makes the getters return what they do before the first run. Called at the start of every run. */
  virtual void ForgetLastRun();

  /** Other ranks can help IntegrateBodies(). */
  virtual bool CanShareFaces() const
  {
    return true;
  }

  /** What made a result of these bodies have this status, in a sentence; empty where nothing is known. */
  std::string FindReason(const std::vector<sm::BodyIntegrals>& bodies, const std::string& status) const;

  /** VTK 9.2 leaves the flag of an abort set. Whoever clears it on one rank alone would have that rank run, and wait, alone. */
  void ForgetAbort();

  /** Gives every body the integrals of its faces. False when nothing was computed; Last then has a reason. */
  virtual bool IntegrateBodies(std::vector<sm::BodyIntegrals>& bodies);

  /** The arrays of the meshes on port 5, once the other outputs are there. The bodies outlive them. */
  virtual std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies);

  /** Fills the first four outputs from the results of all bodies. */
  virtual void ProduceOutputs(std::vector<sm::BodyIntegrals>& bodies, vtkPolyData* totals, vtkTable* solids,
    vtkTable* text, vtkTable* faces);

  struct Internals;
  std::unique_ptr<Internals> Implementation;
#endif

  double RelativeTolerance = 1e-9;
  int Backend = AUTOMATIC;
  vtkTypeInt64 MaximumEvaluations = 2000000000;
  double MaximumSeconds = 0.0;
  double ShaderPerturbation = 1.0;
  bool KeepFaces = true;

private:
  vtkSurfaceIntegralGPU(const vtkSurfaceIntegralGPU&) = delete;
  void operator=(const vtkSurfaceIntegralGPU&) = delete;
};

#endif
