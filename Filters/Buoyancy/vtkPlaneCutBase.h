/**
 * @class   vtkPlaneCutBase
 * @brief base of the filters that compute volumes below a plane and the section of the solids with it
 *
 * Abstract; vtkBuoyancy and vtkSolidSection are below it. It has the plane and the tolerance, and integrates
 * over the parts of the faces below the plane, which are cut there so that the bounds are proved
 * (smBuoyancy.h). In a parallel run only the rank that has the bodies computes. Shells are taken as the file
 * orients them (vtkMassPropertiesGPU reverses shells that are inside out).
 */
#ifndef vtkPlaneCutBase_h
#define vtkPlaneCutBase_h

#include "smFiltersBuoyancyModule.h"
#include "vtkSurfaceIntegralBase.h"

#include <memory> // for std::unique_ptr
#include <vector> // for std::vector

namespace sm
{
struct BodyBuoyancy;
class BuoyancyIntegrator;
}

class SMFILTERSBUOYANCY_EXPORT vtkPlaneCutBase : public vtkSurfaceIntegralBase
{
public:
  vtkTypeMacro(vtkPlaneCutBase, vtkSurfaceIntegralBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** A point of the plane, in world coordinates, unit L. A coordinate that is not finite is reported as an
   * error and leaves the point unchanged. Default 0 0 0. */
  void SetPoint(double x, double y, double z);
  void SetPoint(const double point[3]) { this->SetPoint(point[0], point[1], point[2]); }
  vtkGetVector3Macro(Point, double);
  ///@}
  ///@{
  /** The normal of the plane, to the side that is above it (of a waterline: out of the water), in world
   * coordinates, of any length but 0. A zero vector, or a component that is not finite, is reported as an
   * error and leaves the normal unchanged. Default 0 0 1. */
  void SetNormal(double x, double y, double z);
  void SetNormal(const double normal[3]) { this->SetNormal(normal[0], normal[1], normal[2]); }
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /** Tolerance of a volume relative to the scale of its solid's volume, of its first moments relative to
   * volume times distance from the origin, and of the section's moments relative to the scale of the solid's
   * area and powers of its size. Range (0, 1], at least 1e-15 is used; others are reported as an error and
   * change nothing. Default 1e-9. If it cannot be met, Status is tolerance-not-met, and the values are kept
   * with their true bounds. */
  void SetRelativeTolerance(double tolerance) { this->ChangeRelativeTolerance(tolerance); }
  vtkGetMacro(RelativeTolerance, double);
  ///@}

protected:
#ifndef __VTK_WRAP__
  /** `volume`: name of the array with the volumes on the side that Normal points away from; a literal. */
  vtkPlaneCutBase(bool withSection, const char* volume);
  bool CanShareFaces() const override
  {
    return false;
  }
  void ReleaseKept() override;
  sm::IntegralRequest MakeRequest() const override;
  std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const override;
  /** Computes one entry of `results` per body for the side that Normal points away from, or for the opposite
   * side, with progress between the fractions `begin` and `end`. Returns false if nothing was computed; the
   * report then has a reason. */
  bool IntegrateSide(const sm::IntegralRequest& request, const std::vector<sm::BodyIntegrals>& bodies,
    bool opposite, double begin, double end, std::vector<sm::BodyBuoyancy>& results);
#endif
  ~vtkPlaneCutBase() override;

  double Point[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };

private:
  vtkPlaneCutBase(const vtkPlaneCutBase&) = delete;
  void operator=(const vtkPlaneCutBase&) = delete;

#ifndef __VTK_WRAP__
  std::unique_ptr<sm::BuoyancyIntegrator> Integrator;
  const char* Volume;
#endif
};

#endif
