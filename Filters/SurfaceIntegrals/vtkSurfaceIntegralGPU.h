/**
 * @class   vtkSurfaceIntegralGPU
 * @brief   integrals over the exact faces of trimmed NURBS solids, by compute shaders
 *
 * Integrates a list of integrands over the faces of every solid of the input, in double precision; see
 * vtkSurfaceIntegralBase for backends, limits, ranks and outputs. An integrand is a scalar GLSL expression,
 * which must contain the area element once (`f * dA`, `dot(field, normal)`), of
 *   - `position`: dvec3, world coordinates, in the model's length unit,
 *   - `normal`:   dvec3, outward normal whose length is that of the area element `dA`. The file defines which
 *     side is outward. Where all integrands are moments and AddVolumeMoment(name, 0, 0, 0) is one of them,
 *     shells of closed bodies that are inside out are reversed in the sums of moments, as
 *     vtkMassPropertiesGPU does; otherwise FlippedShells is 0,
 *   - `unitNormal`: dvec3; `dA`: double, length(normal),
 *   - on FACES also `u`, `v`: double, the face's own parameters; `du`, `dv`, `duu`, `duv`, `dvv`: dvec3,
 *     first and second derivatives of the position with respect to them, in world coordinates;
 *     `meanCurvature`, positive where the body is convex, 1/R on a sphere; `gaussianCurvature`,
 *   - constants of AddConstant(), and the functions of GLSL; sin, cos, tan, exp, log and pow have double
 *     precision here (angles up to 2^20). Where a division by 0 or a function outside of its domain (sqrt of
 *     a negative number, log of 0, an angle above 2^20) is evaluated at a point, or the value is not finite,
 *     the integral and its bound are NaN and the status is suspect, whatever the rest of the expression makes
 *     of it; the branch of ?: that is not taken is not evaluated. A pole between the points prevents
 *     convergence: the status is tolerance-not-met, and the bound means nothing. Bounds of expressions are
 *     estimates that assume that the expressions are smooth on every face: at kinks and steps (abs, min, max,
 *     step, ?: and similar functions) an error may exceed its bound; a message names the expressions that may
 *     have some. Peaks that are too narrow for all points of the first two orders (3 and 6 per direction of a
 *     patch) are not detected. Numbers are doubles, so that 1/3 is a third. Statements, assignments,
 *     comments, commas outside of arguments, single precision and expressions with neither `dA` nor `normal`
 *     (nor both `du` and `dv`) are errors. An integrand on FACES (such as an area) is integrated over the
 *     faces alone. An integrand on the CLOSED_CHAIN is also integrated over the ribbons (strips that close
 *     the gaps between faces and their common edges) and caps (triangles that close the gaps at the ends of
 *     edges), so that fluxes are those of a closed surface.
 *
 * Field data and columns: every integrand under its name, its bound as `<name>Bound` (ports 0, 1, 3). The
 * meshes on port 5 have the value of each face (float; omitted for more than 16 integrands). Port 0 has a
 * point without a cell, in the middle of the solids' box.
 *
 * The orders for moments and areas are planned: a theorem gives the orders of the Gauss rules and the
 * bisections before a point is evaluated, and bounds their error (Bounds.md). For expressions the order is
 * raised for each panel until two orders agree to the tolerance, and the error is estimated from their
 * difference. The rounding of every sample is added to both. A bound is infinite if faces are missing. On the
 * CPU, integrands that are expressions are NaN, and a message names them.
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

  /** The domain of an integrand. */
  enum SupportType
  {
    CLOSED_CHAIN = 0,
    FACES = 1
  };

  /**
   * Adds the integrand `expression` (GLSL, double precision, see above) under `name`, on the domain
   * `support`. The following are reported as errors and add nothing: an empty name or expression; a name for
   * which the column, or the column of its bound, exists or has another meaning in the outputs
   * (ReservedColumnNames in smIntegralNames.h). The result of an expression with a mistake is NaN, with a
   * message that has the mistake and its column; the other integrands are computed.
   */
  void AddIntegrand(const std::string& name, const std::string& expression, int support = FACES);
  /** Adds the volume integral of x^i y^j z^k, computed by the divergence theorem as the flux of
   * r x^i y^j z^k / (3 + i + j + k). Powers must not be negative, and i + j + k must be at most 60; other
   * values are reported as an error and add nothing. */
  void AddVolumeMoment(const std::string& name, int i, int j, int k);
  /** Adds the surface integral of x^i y^j z^k, with the same limits of the powers. */
  void AddAreaMoment(const std::string& name, int i, int j, int k);
  /** Adds the flux of the vector (x, y, z), each an expression, out of the body. */
  void AddFlux(const std::string& name, const std::string& x, const std::string& y, const std::string& z);
  /** Adds the bending energy as of a thin plate: the integral of k1^2 + k2^2 = 4 H^2 - 2 K, where k1 and k2
   * are the principal curvatures. It is 8 pi for a sphere of any size. Relative tolerances are relative to
   * area / size^2. */
  void AddBendingEnergy(const std::string& name);
  /** Adds half the integral of |n.d|, where d is the normalised direction. For a convex body this is the area
   * of its shadow; otherwise hidden parts of the surface are counted too. A direction of length 0 or that is
   * not finite is reported as an error and adds nothing. */
  void AddProjectedArea(const std::string& name, double x, double y, double z);
  /** Defines `name` as a number in all expressions, including those added before; a second call changes the
   * number. A value that is not finite, or a name that is not an identifier or already has a meaning, is
   * reported as an error and changes nothing. */
  void AddConstant(const std::string& name, double value);
  ///@{
  /** Restricts the integration to the faces with these entity numbers (FaceId of port 3), in all bodies;
   * without any, all faces are used. Other faces count as 0, and so do the strips that join them to their
   * edges. */
  void AddFaceId(vtkTypeInt64 id);
  void RemoveAllFaceIds();
  int GetNumberOfFaceIds() const;
  ///@}
  /** Removes all integrands, and resets the next four settings to their defaults. */
  void RemoveAllIntegrands();

  ///@{
  /** Integrands as a text, for user interfaces, with one integrand per line: `NAME = EXPRESSION` over the
   * faces, or `NAME = X ; Y ; Z` for the flux of a vector out of the closed chain; empty lines are ignored.
   * They replace the integrands of an earlier text and leave all others. A line without a name, without '='
   * or without one or three expressions is reported as an error and ignored. Default: empty. */
  void SetIntegrandText(const std::string& text);
  std::string GetIntegrandText() const;
  ///@}
  ///@{
  /** Largest degree i + j + k of the volume moments x^i y^j z^k that are added as `moment_i_j_k`; -1: none.
   * Range [-1, 8], clamped, since one shader computes them all; AddVolumeMoment() permits higher degrees. If
   * there is also an expression, the bounds of the moments are estimated. Default -1. */
  void SetMomentDegree(int degree);
  int GetMomentDegree() const;
  ///@}
  ///@{
  /** If on, adds AddBendingEnergy() under the name `BendingEnergy`. Default off. */
  void SetBendingEnergy(bool on);
  bool GetBendingEnergy() const;
  void BendingEnergyOn() { this->SetBendingEnergy(true); }
  void BendingEnergyOff() { this->SetBendingEnergy(false); }
  ///@}
  ///@{
  /** Direction of AddProjectedArea() under the name `ProjectedArea`; 0 0 0: none. A component that is not
   * finite is reported as an error and changes nothing. Default 0 0 0. */
  void SetProjectedAreaDirection(double x, double y, double z);
  void SetProjectedAreaDirection(const double direction[3])
  {
    this->SetProjectedAreaDirection(direction[0], direction[1], direction[2]);
  }
  double* GetProjectedAreaDirection() VTK_SIZEHINT(3);
  ///@}
  /** All integrands, in the order of the outputs: added integrands, those of the text, moments, bending
   * energy, projected area. An integrand whose name is already used by an earlier one is left out. The name
   * for an index out of range is empty. */
  int GetNumberOfIntegrands() const;
  std::string GetIntegrandName(int index) const;

  ///@{
  /**
   * Tolerance of every integral relative to the scale of its solid (volume or area times the matching power
   * of its size). Range (0, 1], at least 1e-15 is used; others are reported as an error and change nothing.
   * Default 1e-9. If it cannot be met, Status is tolerance-not-met, and the value is kept with its true
   * bound.
   */
  void SetRelativeTolerance(double tolerance) { this->ChangeRelativeTolerance(tolerance); }
  vtkGetMacro(RelativeTolerance, double);
  ///@}

  ///@{
  /**
   * If on, integrals of faces are kept by face, tolerances and (if results depend on it) placement, so that
   * after an edit only the changed faces are evaluated. Values and bounds are bitwise equal to those of a
   * full run, and Evaluations counts only what was evaluated. If off, every run evaluates all faces. Default
   * on.
   */
  vtkSetMacro(CacheFaceResults, bool);
  vtkGetMacro(CacheFaceResults, bool);
  vtkBooleanMacro(CacheFaceResults, bool);
  ///@}

  ///@{
  /** Total of an integrand in the last run and its bound; NaN if there is no such integrand or it was not
   * computed. */
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
  /** Adds an integrand to a list of this filter. A name that is already used is reported as an error. */
  void Add(const sm::Integrand& integrand, std::vector<sm::Integrand>& integrands);
  std::unique_ptr<Internals> Implementation;
#endif
};

#endif
