/**
 * @class   vtkMassSensitivity
 * @brief   mass properties, and how they change if one face is moved along its normals
 *
 * For each face of each solid: the derivatives of volume, mass, area, centre of mass and principal moments of
 * the solid by a uniform offset t of that face along its outward normals, at t = 0. A face that moves
 * outwards by a small t adds t to the thickness of the solid there, and its neighbours are continued or cut
 * to meet it: what happens at edges is of second order, except for the area. With x from the centre of mass,
 * A the area of the face and V the volume,
 *
 *     dV/dt = A,   dc/dt = integral of x dA / V,   d(C_ij)/dt = integral of x_i x_j dA,
 *
 * where C are the second moments about the centre; a principal moment changes by a . (tr(C') 1 - C') a, a its
 * axis. Where principal moments coincide they have no derivative. The area of the whole solid changes by
 *
 *     integral of 2H over the face + integral of tan(angle / 2) along its edges,
 *
 * H the mean curvature, positive on a ball, and the angle that between the outward normals of both faces,
 * negative where the edge is concave. Neighbours that are tangent are followed: a step between them is not
 * counted.
 *
 * Outputs are those of vtkMassPropertiesGPU. The table of faces (port 3) has these columns in addition:
 *
 * | name | components | unit | value on failure |
 * |---|---|---|---|
 * | VolumePerOffset | 1 | L^2 | NaN |
 * | MassPerOffset | 1 | kg / L | NaN, also without a density |
 * | SurfaceAreaPerOffset | 1 | L | NaN, also where an edge is not shared, or missing at a crease |
 * | CenterOfMassPerOffset | 3 | 1, in world axes | NaN |
 * | PrincipalMomentsPerOffset | 3 | L^4, ascending moments | NaN, also where moments coincide |
 *
 * Each has a `<name>Bound` of its numerical error, one number; that of SurfaceAreaPerOffset is an estimate,
 * ten times the difference of two Gauss rules. The meshes (port 5) have cell arrays (float, without bounds)
 * to colour faces by: VolumePerOffset, MassPerOffset, SurfaceAreaPerOffset, CenterOfMassPerOffset_X, _Y and
 * _Z, PrincipalMomentsPerOffset_1, _2 and _3. Values are those of the solid that the face belongs to, at unit
 * density except for the mass. All are known only for solids with a volume.
 *
 * Nine more integrals over the area of every face are evaluated, and curvatures on faces and angles along
 * edges, in parallel on the CPU; where the run is stopped, or its time is over, SurfaceAreaPerOffset is NaN.
 * Limits, threads and GL contexts are as in vtkMassPropertiesGPU.
 */
#ifndef vtkMassSensitivity_h
#define vtkMassSensitivity_h

#include "smFiltersMassPropertiesModule.h"
#include "vtkMassPropertiesGPU.h"

#include <memory> // for the offsets
#include <vector> // for the bodies

namespace sm
{
class BodyOffsets;
}

class SMFILTERSMASSPROPERTIES_EXPORT vtkMassSensitivity : public vtkMassPropertiesGPU
{
public:
  static vtkMassSensitivity* New();
  vtkTypeMacro(vtkMassSensitivity, vtkMassPropertiesGPU);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMassSensitivity();
  ~vtkMassSensitivity() override;

#ifndef __VTK_WRAP__
  sm::IntegralRequest MakeRequest() const override;
  void ResetResults() override;
  void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const override;
  std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const override;

  /** Returns curvatures and angles of the bodies of the last run. */
  const sm::BodyOffsets& GetOffsets() const;
#endif

private:
  vtkMassSensitivity(const vtkMassSensitivity&) = delete;
  void operator=(const vtkMassSensitivity&) = delete;

#ifndef __VTK_WRAP__
  std::unique_ptr<sm::BodyOffsets> Offsets;
#endif
};

#endif
