/**
 * @class   vtkMassSensitivity
 * @brief   mass properties, and how they change if one face is moved along its normals
 *
 * For each face of each solid: the derivatives of volume, mass, centre of mass and principal moments of the
 * solid by a uniform offset t of that face along its outward normals, at t = 0. A face that moves outwards by
 * a small t adds t to the thickness of the solid there, and its neighbours are continued or cut to meet it:
 * what happens at edges is of second order. With x from the centre of mass, A the area of the face and V the
 * volume,
 *
 *     dV/dt = A,   dc/dt = integral of x dA / V,   d(C_ij)/dt = integral of x_i x_j dA,
 *
 * where C are the second moments about the centre; a principal moment changes by a . (tr(C') 1 - C') a, a its
 * axis. Where principal moments coincide they have no derivative. The derivative of the area is not computed.
 *
 * Outputs are those of vtkMassPropertiesGPU. The table of faces (port 3) has these columns in addition, and
 * the meshes (port 5) the same as cell arrays (float, without bounds) to colour faces by: | name | comp. |
 * unit | value on failure |
 * |---|---|---|---|
 * | VolumePerOffset | 1 | L^2 | NaN |
 * | MassPerOffset | 1 | kg / L | NaN, also without a density |
 * | CenterOfMassPerOffset | 3 | 1, in world axes | NaN |
 * | PrincipalMomentsPerOffset | 3 | L^4, ascending moments | NaN, also where moments coincide |
 * Each has a `<name>Bound` of its numerical error, one number. Values are those of the solid that the face
 * belongs to, at unit density except for the mass. All are known only for solids with a volume.
 *
 * Nine more integrals over the area of every face are evaluated. Limits, threads and GL contexts are as in
 * vtkMassPropertiesGPU.
 */
#ifndef vtkMassSensitivity_h
#define vtkMassSensitivity_h

#include "smFiltersMassPropertiesModule.h"
#include "vtkMassPropertiesGPU.h"

#include <vector> // for the bodies

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
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const override;
  std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const override;
#endif

private:
  vtkMassSensitivity(const vtkMassSensitivity&) = delete;
  void operator=(const vtkMassSensitivity&) = delete;
};

#endif
