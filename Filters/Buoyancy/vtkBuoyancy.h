/**
 * @class   vtkBuoyancy
 * @brief   displaced volume and centre of buoyancy of exact CAD solids below a plane, with error bounds
 *
 * The waterline is the plane through Point with the normal Normal, which points out of the water. Coordinates
 * are world coordinates and lengths are in the model's unit L. Faces are cut at the waterline, so that the
 * bounds are proved although the submerged part has an edge there (smBuoyancy.h). A body above the waterline
 * displaces 0, one below it displaces its volume. The integrals are those of a flux that vanishes on the
 * plane, so that the waterplane contributes nothing. The filter runs on the GPU or on the CPU, see
 * vtkSurfaceIntegralBase. In a parallel run only the rank that has the bodies computes.
 *
 * Field data of port 0 and columns of port 1, each with `<name>Bound` (smBuoyancyNames.h):
 * | name | comp. | unit | meaning |
 * |---|---|---|---|
 * | DisplacedVolume | 1 | L^3 | volume below the waterline |
 * | DisplacedFirstMoments | 3 | L^4 | first moments of that volume about the world's origin |
 * | CenterOfBuoyancy | 3 | L | centroid of that volume; NaN where the volume may be 0 by its bound |
 * Shells are taken as the file orients them: a negative displaced volume is `suspect`, but a void that the
 * file orients as an outer shell counts as material here (vtkMassPropertiesGPU reverses such shells and
 * reports them).
 *
 * Values that were not computed are NaN, and Status gives the reason. Port 3 and the meshes of port 5 have
 * the contribution of every face to DisplacedVolume: its flux of a field that vanishes on the plane (for a
 * body that is entirely below the waterline: on a parallel plane through the body). The other outputs are
 * those of vtkSurfaceIntegralBase.
 */
#ifndef vtkBuoyancy_h
#define vtkBuoyancy_h

#include "smFiltersBuoyancyModule.h"
#include "vtkPlaneCutBase.h"

class SMFILTERSBUOYANCY_EXPORT vtkBuoyancy : public vtkPlaneCutBase
{
public:
  static vtkBuoyancy* New();
  vtkTypeMacro(vtkBuoyancy, vtkPlaneCutBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
  bool IntegrateBodies(const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies) override;
  void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const override;
#endif

private:
  vtkBuoyancy(const vtkBuoyancy&) = delete;
  void operator=(const vtkBuoyancy&) = delete;

#ifndef __VTK_WRAP__
  struct Internals;
  std::unique_ptr<Internals> Implementation;
#endif
};

#endif
