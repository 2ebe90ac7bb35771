/**
 * @class   vtkSolidSection
 * @brief   section of exact CAD solids with a plane: area, centroid, second moments, and the volumes on
 * either side, with error bounds
 *
 * The plane runs through Point; Normal points to the side that is above it. Coordinates are world coordinates
 * and lengths are in the model's unit L. Faces are cut at the plane and integrated (smBuoyancy.h), so that no
 * value depends on a mesh and all bounds are proved: the bound of the area takes into account by how much
 * reading, placement and rounding may have moved the faces against the plane (smSubmergedFace.h). Where the
 * plane runs along a face, or touches a surface along a curve, that leaves much of the area open: the bound
 * is as wide, and the status is tolerance-not-met. The filter runs on the GPU or on the CPU, see
 * vtkSurfaceIntegralBase. The input is not changed.
 *
 * Field data of port 0 and columns of port 1, each but the directions with `<name>Bound` (smSectionNames.h):
 * | name | comp. | unit | meaning |
 * |---|---|---|---|
 * | SectionArea | 1 | L^2 | area of the section; 0 with the bound 0 if the plane certainly misses it |
 * | SectionCentroid | 3 | L | its centroid |
 * | SectionSecondMoments | 6 | L^4 | integrals of xx, yy, zz, xy, yz, xz about the centroid, world's axes |
 * | SectionPrincipalMoments | 2 | L^4 | the smallest and the largest along a direction of the plane |
 * | SectionPrincipalDirections | 6 | | these two directions |
 * | VolumeBelow, VolumeAbove | 1 | L^3 | volume on either side |
 * | CenterBelow, CenterAbove | 3 | L | its centroid |
 * | MassBelow, MassAbove | 1 | kg | Density times volume |
 * A quantity that does not exist is NaN: the centroid of an area or volume that may be 0 by its bound,
 * directions of moments that may be equal, a mass without a density, and every value of a surface or of a
 * solid that is not closed (status open): the values are fluxes through a closed surface. A total over such a
 * solid is NaN too. The second moment that resists bending about an axis of the plane is the one across that
 * axis.
 *
 * Shells are taken as the file orients them. A solid with a shell that is inside out is `suspect` here
 * (vtkMassPropertiesGPU reverses such shells and reports them).
 *
 * Port 7 (partitioned dataset collection, a block for each solid): the display mesh below the plane, closed
 * by its section; cell arrays Solid (row of port 1), Cap (1 on the section), FaceIndex (-1 on the section)
 * and Color. It is a picture; the values above do not depend on it. Port 3 and the meshes of port 5 have the
 * contribution of every face to VolumeBelow, see vtkBuoyancy. The other outputs are those of
 * vtkSurfaceIntegralBase.
 */
#ifndef vtkSolidSection_h
#define vtkSolidSection_h

#include "smFiltersSectionModule.h"
#include "vtkPlaneCutBase.h"

class SMFILTERSSECTION_EXPORT vtkSolidSection : public vtkPlaneCutBase
{
public:
  static vtkSolidSection* New();
  vtkTypeMacro(vtkSolidSection, vtkPlaneCutBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Density of all solids in kg/m^3. 0 (default): the density that the file of each part states, if any; no
   * mass without a density. Another value that is not from 1e-200 to 1e200 is reported as an error and
   * changes nothing. */
  void SetDensity(double density);
  vtkGetMacro(Density, double);
  ///@}

  ///@{
  /** Totals of the last run over all bodies; NaN if not computed. */
  double GetSectionArea() const;
  double GetSectionAreaBound() const;
  void GetSectionCentroid(double centroid[3]) const;
  double GetSectionCentroidBound() const;
  void GetSectionSecondMoments(double moments[6]) const;
  double GetSectionSecondMomentsBound() const;
  void GetSectionPrincipalMoments(double moments[2]) const;
  double GetSectionPrincipalMomentsBound() const;
  double GetVolumeBelow() const;
  double GetVolumeBelowBound() const;
  double GetVolumeAbove() const;
  double GetVolumeAboveBound() const;
  ///@}

protected:
  vtkSolidSection();
  ~vtkSolidSection() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

#ifndef __VTK_WRAP__
  void ResetResults() override;
  bool IntegrateBodies(const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies) override;
  void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const override;
#endif

  double Density = 0.0;

private:
  vtkSolidSection(const vtkSolidSection&) = delete;
  void operator=(const vtkSolidSection&) = delete;

#ifndef __VTK_WRAP__
  /** Draws the clipped meshes of the bodies, closed by their sections. */
  void DrawSection(const std::vector<sm::BodyIntegrals>& bodies) const;
  std::string WriteSummary(const std::vector<sm::BodyIntegrals>& bodies) const;

  struct Internals;
  std::unique_ptr<Internals> Implementation;
#endif
};

#endif
