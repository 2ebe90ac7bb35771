/**
 * @class   vtkSolidStability
 * @brief   static stability of solids on the ground: contacts, stability margin, tip angles, rises of the
 * centre of mass, with bounds
 *
 * Input as of vtkMassPropertiesGPU: a vtkNURBSDataSet or a composite of them; the centre of mass comes from
 * such a filter inside (GetMassProperties()), with its bound, and the contacts from the exact trimmed faces
 * (smGroundContact.h), by branch and bound over their control nets, on the CPU. The body is rigid and does
 * not slide; the ground is a plane.
 *
 * Verdicts: `stable` and `unstable` are proved, up to the bounds; `too-close` when the margin is smaller than
 * its bound. A point or line of contact has no positive margin. In this case the curvature decides, and
 * DecidedBy is `rolling`: a hemisphere on its dome is stable; a lying cylinder and a ball are too-close,
 * because every position is in balance; a cone on its tip is unstable. A body whose projected centre of mass
 * misses the contact by no more than the contact tolerance counts as balanced there. Radii of curvature are
 * computed at the contacts, and their bound is an estimate. `no-contact`: the given plane is out of reach;
 * `below-ground`: parts of the body are below it by more than the tolerance; `unknown`: there is no centre of
 * mass (an open surface, see Status), or the run was aborted before this body was evaluated. An open solid
 * has a verdict for the centre that the mass filter states; Status says open.
 *
 * | port | type | content |
 * |---|---|---|
 * | 0 | polydata | support polygon, centre of mass, its projection, the line between; field data as below |
 * | 1 | table | a row per body, the same columns, with Name and Id |
 * | 2 | table | 1x1, column Text: a summary to show in a view |
 * | 3 | table | a row per side of the polygon: Solid (row of port 1), From, To, TipEnergy, |
 * | | | and with bounds StabilityMargin, TipAngle, CenterOfMassRise |
 *
 * Field data (smStabilityNames.h, with units), of the only body or of the worst: the first with the worst
 * verdict (unstable, too-close, stable; before them unknown, below-ground, no-contact). Numbers that do not
 * exist are NaN. Curved sides of the polygon are drawn, and listed, as chords to a thousandth of the size;
 * margin, smallest tip angle and rise are those of the curve. Angles in degrees. CenterOfMassRise is the rise
 * of the centre of mass until the body tips: times the weight it is the energy.
 *
 * Getters return values of the last run. RequestData fails for an input without exact geometry, a vertical
 * ground, or an exception such as insufficient memory; the outputs are then empty. In a parallel run an
 * exception is reported as an error, but RequestData returns 1. Not thread safe; with SetRenderWindow of the
 * filter inside the calling thread must be the one that renders there.
 */
#ifndef vtkSolidStability_h
#define vtkSolidStability_h

#include "smFiltersStabilityModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the implementation
#include <string> // for std::string
#include <vector> // for std::vector

class vtkMassPropertiesGPU;
class vtkRenderWindow;

namespace sm
{
struct GroundDirections;
struct SupportedBody;
}

class SMFILTERSSTABILITY_EXPORT vtkSolidStability : public vtkPolyDataAlgorithm
{
public:
  static vtkSolidStability* New();
  vtkTypeMacro(vtkSolidStability, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Direction of gravity, in world coordinates; of any length but 0. Zero, infinite or not a number: an
   * error, and nothing changes. Default 0 0 -1. */
  void SetGravityDirection(double x, double y, double z);
  void SetGravityDirection(const double direction[3]);
  vtkGetVector3Macro(GravityDirection, double);
  ///@}

  /** The ground that supports the body. */
  enum GroundType
  {
    RESTING = 0,
    PLANE = 1
  };

  ///@{
  /** RESTING: the plane through the lowest point of the body, or of each body alone; PLANE: through
   * GroundOrigin. Clamped to these. Default RESTING. */
  vtkSetClampMacro(Ground, int, RESTING, PLANE);
  vtkGetMacro(Ground, int);
  ///@}

  ///@{
  /**
   * Normal of the ground, of any length; 0 0 0 (default): against gravity. Any other direction makes a slope;
   * with a normal perpendicular to gravity the run fails. The sign of the normal does not matter. Not finite:
   * an error, and nothing changes.
   */
  void SetGroundNormal(double x, double y, double z);
  void SetGroundNormal(const double normal[3]);
  vtkGetVector3Macro(GroundNormal, double);
  ///@}

  ///@{
  /** With PLANE: a point of the ground, world coordinates, L. Not finite: an error, and nothing changes.
   * Default 0 0 0. */
  void SetGroundOrigin(double x, double y, double z);
  void SetGroundOrigin(const double origin[3]);
  vtkGetVector3Macro(GroundOrigin, double);
  ///@}

  ///@{
  /** Faces, edges and points whose distance from the ground is at most this value, times the diagonal of the
   * body's box, are in contact with it. Range [0, 0.1], clamped; NaN is reported as an error and changes
   * nothing. Default 1e-6, which is above the inaccuracy of files and modelling kernels (1e-7 of a part) and
   * below the size of intended features. A dome still touches in one point, see smGroundContact.h. */
  void SetContactTolerance(double tolerance);
  vtkGetMacro(ContactTolerance, double);
  ///@}

  /** The rigid bodies that are evaluated. */
  enum BodiesType
  {
    TOGETHER = 0,
    EACH = 1
  };

  ///@{
  /** TOGETHER: all solids as one rigid body, the centre weighted by mass where every solid has a density,
   * else by volume. EACH: every solid alone. Clamped to these. Default TOGETHER. */
  vtkSetClampMacro(Bodies, int, TOGETHER, EACH);
  vtkGetMacro(Bodies, int);
  ///@}

  ///@{
  /** Strength of gravity for TipEnergy, in m/s^2. Clamped to >= 0. Default 9.80665. */
  vtkSetClampMacro(GravityStrength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(GravityStrength, double);
  ///@}

  ///@{
  /** Options of the mass filter inside, see there: density in kg/m^3, from 1e-200 to 1e200, or 0 (default)
   * for that of the file; relative tolerance; backend. */
  void SetDensity(double density);
  double GetDensity();
  void SetRelativeTolerance(double tolerance);
  double GetRelativeTolerance();
  void SetBackend(int backend);
  int GetBackend();
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}
  /** The filter inside, for its other options and its results. Never null; its input is set by every run. Its
   * selectors choose the solids that are put on the ground. */
  vtkMassPropertiesGPU* GetMassProperties();

  ///@{
  /** The last run, of the only body or the worst; NaN and "unknown" before. Angles in degrees. */
  std::string GetStability() const;
  std::string GetSupport() const;
  double GetStabilityMargin() const;
  double GetStabilityMarginBound() const;
  double GetTipAngle() const;
  double GetTipAngleBound() const;
  double GetCenterOfMassRise() const;
  double GetCenterOfMassRiseBound() const;
  double GetRollingMargin() const;
  ///@}
  ///@{
  /** Status and messages of the last run: the status of the mass filter, "not-computed" after an exception,
   * or "empty" for an input without exact geometry; and the messages of the mass filter, followed by those
   * about contacts. */
  std::string GetStatus() const;
  int GetNumberOfMessages() const;
  std::string GetMessage(int index) const;
  ///@}

  vtkMTimeType GetMTime() override;

  /** Reports to the input whether its display mesh is needed, see smMeshDemand.h. */
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int port, vtkMTimeType* time) override;

protected:
  vtkSolidStability();
  ~vtkSolidStability() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSolidStability(const vtkSolidStability&) = delete;
  void operator=(const vtkSolidStability&) = delete;

  void SetVector(const char* name, double (&vector)[3], double x, double y, double z, bool mayVanish);

  struct Internals;

  // Steps of RequestData().
  int Evaluate(vtkDataObject* input, int piece, vtkInformationVector* outputVector);
  void UpdateMassProperties(vtkDataObject* input);
  void EvaluateBodies(const sm::GroundDirections& ground, std::vector<sm::SupportedBody>& supported);
  void FillOutputs(const sm::GroundDirections& ground, const std::vector<sm::SupportedBody>& supported,
    vtkInformationVector* outputVector);

  std::unique_ptr<Internals> Implementation;

  double GravityDirection[3] = { 0.0, 0.0, -1.0 };
  int Ground = RESTING;
  double GroundNormal[3] = { 0.0, 0.0, 0.0 };
  double GroundOrigin[3] = { 0.0, 0.0, 0.0 };
  double ContactTolerance = 1e-6;
  int Bodies = TOGETHER;
  double GravityStrength = 9.80665;
};

#endif
