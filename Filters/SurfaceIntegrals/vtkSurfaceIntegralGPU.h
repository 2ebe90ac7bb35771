/**
 * @class   vtkSurfaceIntegralGPU
 * @brief   integrals over the exact faces of trimmed NURBS solids, by compute shaders
 *
 * Integrates any list of integrands over the faces of every solid of the input, in double precision; see vtkSurfaceIntegralBase for
 * backends, limits, ranks and outputs. An integrand is a scalar GLSL expression, which must hold the area element once (`f * dA`,
 * `dot(field, normal)`), of
 *   - `position`: dvec3, world coordinates, in the model's length unit,
 *   - `normal`:   dvec3, outward normal of the length of the area element `dA`. Outward is what the file calls so: only
 *     vtkMassPropertiesGPU reverses a shell that is inside out, FlippedShells is 0 here,
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
 * Field data and columns: every integrand under its name, its bound as `<name>Bound` (ports 0, 1, 3); port 5 has the value of the face
 * (float; left out when there are more than 16 integrands). Port 0 has a point without a cell, in the middle of the solids' box.
 *
 * Moments and areas are planned: a theorem chooses the orders of the Gauss rules and the bisections
 * before a point is evaluated, and bounds their error (Bounds.md). For expressions the order is raised panel by panel until two
 * orders agree to the tolerance, and the error is estimated from their difference. The rounding of every sample is added to
 * both. A bound is infinite when faces are missing. On the CPU, integrands that are expressions are NaN, and a message names them.
 */
#ifndef vtkSurfaceIntegralGPU_h
#define vtkSurfaceIntegralGPU_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "vtkSurfaceIntegralBase.h"

namespace sm
{
struct Integrand;
}

class SMFILTERSSURFACEINTEGRALS_EXPORT vtkSurfaceIntegralGPU : public vtkSurfaceIntegralBase
{
public:
  static vtkSurfaceIntegralGPU* New();
  vtkTypeMacro(vtkSurfaceIntegralGPU, vtkSurfaceIntegralBase);
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
  /** Removes all integrands, and resets the next four settings. */
  void RemoveAllIntegrands();

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
  /** All integrands, in the order of the outputs: those that were added, those of the text, moments, bending energy, projected area.
   * One whose name an earlier one has is left out. */
  int GetNumberOfIntegrands() const;
  std::string GetIntegrandName(int index) const;

  ///@{
  /**
   * Tolerance of every integral relative to the scale of its solid (volume or area times the matching power
   * of its size). Range (0, 1], clamped to [1e-15, 1]; not a number is an error and changes nothing. Default 1e-9. Unmet: Status
   * tolerance-not-met, the value and its true bound are kept.
   */
  void SetRelativeTolerance(double tolerance) { this->ChangeRelativeTolerance(tolerance); }
  vtkGetMacro(RelativeTolerance, double);
  ///@}

  ///@{
  /**
   * Integrals of faces are kept by face, tolerances and (where they matter) placement, so that after an edit only the faces
   * that it changed are evaluated; values and bounds have the bits of a full run, and Evaluations counts what was
   * evaluated. Off: every run evaluates everything. Default: on.
   */
  vtkSetMacro(CacheFaceResults, bool);
  vtkGetMacro(CacheFaceResults, bool);
  vtkBooleanMacro(CacheFaceResults, bool);
  ///@}

  ///@{
  /** The last run: total of the integrand (NaN when absent or not computed) and its bound. */
  double GetIntegral(const std::string& name) const;
  double GetIntegralBound(const std::string& name) const;
  ///@}

protected:
  vtkSurfaceIntegralGPU();
  ~vtkSurfaceIntegralGPU() override;

#ifndef __VTK_WRAP__
  void ResetResults() override;
  sm::IntegralRequest MakeRequest() const override;
  void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const override;
  std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const override;
#endif

private:
  vtkSurfaceIntegralGPU(const vtkSurfaceIntegralGPU&) = delete;
  void operator=(const vtkSurfaceIntegralGPU&) = delete;

#ifndef __VTK_WRAP__
  struct Internals;
  /** Adds an integrand to a list of this filter, unless its name is taken: that is an error. */
  void Add(const sm::Integrand& integrand, std::vector<sm::Integrand>& integrands);
  std::unique_ptr<Internals> Implementation;
#endif
};

#endif
