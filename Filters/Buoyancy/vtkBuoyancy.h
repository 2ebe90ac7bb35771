/**
 * @class   vtkBuoyancy
 * @brief   displaced volume and centre of buoyancy of exact CAD solids below a plane, with error bounds
 *
 * The waterline is the plane through Point with the normal Normal, which points out of the water. Coordinates are world
 * coordinates and lengths are in the model's unit L. Faces are cut at the waterline, so that the bounds are proved although the
 * submerged part has an edge there (smBuoyancy.h). A body above the waterline displaces 0, one below it displaces its volume. The
 * integrals are those of a flux that vanishes on the plane, so that the waterplane contributes nothing. The filter runs on the
 * GPU or on the CPU, see vtkSurfaceIntegralBase, and needs no GLSL code of the user. In a parallel run only the rank that has the
 * bodies computes.
 *
 * Field data of port 0 and columns of port 1, each with `<name>Bound` (smBuoyancyNames.h):
 * | name                  | comp. | unit | meaning                                                             |
 * |-----------------------|-------|------|---------------------------------------------------------------------|
 * | DisplacedVolume       | 1     | L^3  | volume below the waterline                                          |
 * | DisplacedFirstMoments | 3     | L^4  | first moments of that volume about the world's origin               |
 * | CenterOfBuoyancy      | 3     | L    | centroid of that volume; NaN where the volume may be 0 by its bound |
 * Shells are taken as the file orients them: a negative displaced volume is `suspect`, but a void that the file orients as an outer
 * shell counts as material here (vtkMassPropertiesGPU reverses such shells and reports them).
 *
 * Values that were not computed are NaN, and Status gives the reason. Port 3 and the meshes of port 5 have the contribution of
 * every face to DisplacedVolume: its flux of a field that vanishes on the plane (for a body that is entirely below the waterline:
 * on a parallel plane through the body). The other outputs are those of vtkSurfaceIntegralBase.
 */
#ifndef vtkBuoyancy_h
#define vtkBuoyancy_h

#include "smFiltersBuoyancyModule.h"
#include "vtkSurfaceIntegralBase.h"

class SMFILTERSBUOYANCY_EXPORT vtkBuoyancy : public vtkSurfaceIntegralBase
{
public:
  static vtkBuoyancy* New();
  vtkTypeMacro(vtkBuoyancy, vtkSurfaceIntegralBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** A point of the waterline, in world coordinates, unit L. A coordinate that is not finite is reported as an error and leaves
   * the point unchanged. Default 0 0 0. */
  void SetPoint(double x, double y, double z);
  void SetPoint(const double point[3]) { this->SetPoint(point[0], point[1], point[2]); }
  vtkGetVector3Macro(Point, double);
  ///@}
  ///@{
  /** The direction out of the water, in world coordinates, of any length but 0. A zero vector, or a component that is not
   * finite, is reported as an error and leaves the normal unchanged. Default 0 0 1. */
  void SetNormal(double x, double y, double z);
  void SetNormal(const double normal[3]) { this->SetNormal(normal[0], normal[1], normal[2]); }
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /** Tolerance of the displaced volume relative to the scale of its solid's volume, and of its first moments relative to volume
   * times distance from the origin. Range (0, 1], clamped to [1e-15, 1]; NaN is reported as an error and changes nothing.
   * Default 1e-9. If it cannot be met, Status is tolerance-not-met, and the values are kept with their true bounds. */
  void SetRelativeTolerance(double tolerance) { this->ChangeRelativeTolerance(tolerance); }
  vtkGetMacro(RelativeTolerance, double);
  ///@}

  ///@{
  /** Totals of the last run over all bodies; NaN if not computed. */
  double GetDisplacedVolume() const;
  double GetDisplacedVolumeBound() const;
  void GetDisplacedFirstMoments(double moments[3]) const;
  double GetDisplacedFirstMomentsBound() const;
  void GetCenterOfBuoyancy(double center[3]) const;
  double GetCenterOfBuoyancyBound() const;
  ///@}

protected:
  vtkBuoyancy();
  ~vtkBuoyancy() override;

#ifndef __VTK_WRAP__
  void ResetResults() override;
  bool CanShareFaces() const override
  {
    return false;
  }
  sm::IntegralRequest MakeRequest() const override;
  bool IntegrateBodies(const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies) override;
  void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const override;
  std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const override;
  void ReleaseKept() override;
#endif

  double Point[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };

private:
  vtkBuoyancy(const vtkBuoyancy&) = delete;
  void operator=(const vtkBuoyancy&) = delete;

#ifndef __VTK_WRAP__
  struct Internals;
  std::unique_ptr<Internals> Implementation;
#endif
};

#endif
