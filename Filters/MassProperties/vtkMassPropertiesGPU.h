/**
 * @class   vtkMassPropertiesGPU
 * @brief   volume, area, centre of mass and inertia of exact CAD solids, with error bounds, on the GPU
 *
 * The ten moments of order 0 to 2 are fluxes of f = r g(r) / (3 + deg g), g = 1, x, y, z, xx, .., zz, over
 * the closed chain of faces, ribbons and caps (see vtkSurfaceIntegralGPU); the area is that of the faces.
 * They are integrated once per part, about a fixed local origin of the part, and transformed without
 * discretisation error to every instance and to the total. The outputs are those of vtkMassPropertiesBase;
 * backends, limits and ranks are those of vtkSurfaceIntegralBase.
 */
#ifndef vtkMassPropertiesGPU_h
#define vtkMassPropertiesGPU_h

#include "smFiltersMassPropertiesModule.h"
#include "vtkMassPropertiesBase.h"

namespace sm
{
struct MassTolerance;
}

class SMFILTERSMASSPROPERTIES_EXPORT vtkMassPropertiesGPU : public vtkMassPropertiesBase
{
public:
  static vtkMassPropertiesGPU* New();
  vtkTypeMacro(vtkMassPropertiesGPU, vtkMassPropertiesBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Tolerance of every quantity, relative to its scale as below. Range (0, 1], at least 1e-15 is used; others
   * are reported as an error and change nothing. Default 1e-9. If it cannot be met, Status is
   * tolerance-not-met, and the values are kept with their true bounds.
   */
  void SetRelativeTolerance(double tolerance) { this->ChangeRelativeTolerance(tolerance); }
  vtkGetMacro(RelativeTolerance, double);
  ///@}

  ///@{
  /**
   * Tolerances of single quantities. `relative` refers to the quantity's scale (the volume, the area, the
   * larger of half the body's diagonal and the cube root of the volume for the centre, the trace of the
   * inertia), range [0, 1]; 0 stands for RelativeTolerance. `absolute` is in the unit of the quantity, not
   * negative; 0 for none. The larger of the two applies. Any other value is reported as an error and changes
   * nothing. Default 0 0.
   */
  void SetVolumeTolerance(double relative, double absolute);
  vtkGetVector2Macro(VolumeTolerance, double);
  void SetSurfaceAreaTolerance(double relative, double absolute);
  vtkGetVector2Macro(SurfaceAreaTolerance, double);
  void SetCenterOfMassTolerance(double relative, double absolute);
  vtkGetVector2Macro(CenterOfMassTolerance, double);
  void SetInertiaTolerance(double relative, double absolute);
  vtkGetVector2Macro(InertiaTolerance, double);
  ///@}

  ///@{
  /**
   * If on, integrals of faces are kept by face and tolerances, so that after an edit only the changed faces
   * are evaluated. Values and bounds are bitwise equal to those of a full run, and Evaluations counts only
   * what was evaluated. If off, every run evaluates all faces. Default on.
   */
  vtkSetMacro(CacheFaceResults, bool);
  vtkGetMacro(CacheFaceResults, bool);
  vtkBooleanMacro(CacheFaceResults, bool);
  ///@}

protected:
  vtkMassPropertiesGPU();
  ~vtkMassPropertiesGPU() override;

#ifndef __VTK_WRAP__
  sm::IntegralRequest MakeRequest() const override;
  sm::MassAnalysisOptions MakeAnalysisOptions() const override;
#endif

  double VolumeTolerance[2] = { 0.0, 0.0 };
  double SurfaceAreaTolerance[2] = { 0.0, 0.0 };
  double CenterOfMassTolerance[2] = { 0.0, 0.0 };
  double InertiaTolerance[2] = { 0.0, 0.0 };

private:
  vtkMassPropertiesGPU(const vtkMassPropertiesGPU&) = delete;
  void operator=(const vtkMassPropertiesGPU&) = delete;

#ifndef __VTK_WRAP__
  sm::MassTolerance GetTolerance() const;
  void SetTolerance(const char* name, double (&tolerance)[2], double relative, double absolute);
#endif
};

#endif
