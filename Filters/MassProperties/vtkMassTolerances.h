/**
 * @class   vtkMassTolerances
 * @brief   what tolerances of faces leave open in volume, mass, centre and inertia
 *
 * Every face of a solid has a range of offsets along its outward normals: that of a rule, else FaceTolerance.
 * Two models of what manufacturing makes of it:
 *
 * - **Worst case.** The solid contains the one with all faces at their lower limits, and lies in the one with
 *   all faces at their upper limits; neighbours are continued or cut to meet. Volume and mass of every such
 *   solid are between `<Quantity>Lower` and `<Quantity>Upper`; no coordinate of the centre, no entry of the
 *   inertia and no principal moment is farther from the nominal one than `<Quantity>Reach`. Curvature, edges
 *   and corners are included; what is of higher order is bounded (Filters/Quadrature/Bounds.md, "Tolerances
 *   of faces"). The integrals of curvatures and angles are evaluated by Gauss rules, with an estimate of
 *   their error. Where a curvature radius is not above the tolerance, or a face is about as narrow, a message
 *   names the face, and the interval is wider: strips at faces are then counted without their overlaps.
 * - **Independent offsets.** Every face moves rigidly, independently of all others, and distributed evenly
 *   between its limits, or normally with limits at three deviations. `<Quantity>Deviation` is the standard
 *   deviation, to first order. A surface that the file divides into several faces counts as several.
 *
 * Neither includes `<Quantity>Spread`, which is about the file, nor the density's tolerance. Of bodies with
 * different densities, centre and inertia are those of the volume.
 *
 * Outputs are those of vtkMassSensitivity. Field data of port 0 and the table of solids (port 1) have in
 * addition, NaN where not known: no volume; an edge that is not shared by two faces; a crease or border of a
 * face that is not an edge; neighbours, one of them curved, that have different tolerances and meet at less
 * than 6 degrees, except for tangent ones (0.06 degrees), between which there is a step:
 *
 * | name | components | unit |
 * |---|---|---|
 * | VolumeLower, VolumeUpper, VolumeDeviation | 1 | L^3 |
 * | MassLower, MassUpper, MassDeviation | 1 | kg, only with a density |
 * | CenterOfMassReach, CenterOfMassDeviation | 1, 3 | L |
 * | VolumeInertiaReach, VolumeInertiaDeviation | 1, 9 | L^5, about the centre |
 * | PrincipalMomentsReach, PrincipalMomentsDeviation | 1, 3 | L^5; deviations NaN where moments coincide |
 *
 * and the table of faces (port 3) and the meshes (port 5, as float):
 *
 * | name | components | unit |
 * |---|---|---|
 * | ToleranceLower, ToleranceUpper | 1 | L |
 * | VolumeByTolerance | 1 | L^3: the area times the larger limit without its sign |
 * | MassByTolerance | 1 | kg, with a density |
 *
 * Limits, threads and GL contexts are as in vtkMassPropertiesGPU. Takes the time of vtkMassSensitivity.
 */
#ifndef vtkMassTolerances_h
#define vtkMassTolerances_h

#include "smFiltersMassPropertiesModule.h"
#include "vtkMassSensitivity.h"

#include <memory> // for the results
#include <vector> // for the bodies

namespace sm
{
struct FaceToleranceResults;
struct FaceToleranceRule;
}

class SMFILTERSMASSPROPERTIES_EXPORT vtkMassTolerances : public vtkMassSensitivity
{
public:
  static vtkMassTolerances* New();
  vtkTypeMacro(vtkMassTolerances, vtkMassSensitivity);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** How offsets are distributed between their limits. */
  enum DistributionType
  {
    UNIFORM = 0,
    NORMAL = 1
  };

  ///@{
  /**
   * Range of the offsets of all faces without a rule, lower and upper limit in the length unit of the input;
   * one value is half of a symmetric range. Limits that are not finite, a lower one above the upper, and a
   * range without 0 are reported as an error and change nothing. Default: 0, 0.
   */
  void SetFaceTolerance(double lower, double upper);
  void SetFaceTolerance(double tolerance);
  vtkGetVector2Macro(FaceTolerance, double);
  ///@}

  ///@{
  /**
   * Adds a rule; the first that fits a face counts. `kind` is "face" (the pattern "#123" is the number of the
   * face in the file, any other one is for its name), "part" (the name of the solid) or "colour" ("#rrggbb",
   * the colour of the face). In a pattern `*` stands for any characters and `?` for one; letters of ASCII
   * match in either case. An unknown kind, an empty pattern and wrong limits are reported as an error and
   * change nothing. A rule that fits no face of a solid gets a message. Default: none.
   */
  void AddTolerance(const char* kind, const char* pattern, double lower, double upper);
  void AddTolerance(const char* kind, const char* pattern, const char* lower, const char* upper);
  void ClearTolerances();
  int GetNumberOfTolerances() const;
  ///@}

  ///@{
  /** If on, the tolerances of the drawing that the reader found in the file (smDrawingTolerances.h) are rules
   * that follow those of AddTolerance(): of faces, then those that are for all faces. Of several for one face
   * the narrowest counts. Default: off. */
  vtkSetMacro(UseDrawing, bool);
  vtkGetMacro(UseDrawing, bool);
  vtkBooleanMacro(UseDrawing, bool);
  ///@}

  ///@{
  /** The distribution of offsets between their limits, UNIFORM (default) or NORMAL. Clamped. */
  vtkSetClampMacro(Distribution, int, UNIFORM, NORMAL);
  vtkGetMacro(Distribution, int);
  ///@}

protected:
  vtkMassTolerances();
  ~vtkMassTolerances() override;

#ifndef __VTK_WRAP__
  void ResetResults() override;
  void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const override;
  std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const override;
#endif

  double FaceTolerance[2] = { 0.0, 0.0 };
  int Distribution = UNIFORM;
  bool UseDrawing = false;

private:
  vtkMassTolerances(const vtkMassTolerances&) = delete;
  void operator=(const vtkMassTolerances&) = delete;

#ifndef __VTK_WRAP__
  bool CheckRange(double lower, double upper);

  std::vector<sm::FaceToleranceRule> Rules;
  std::unique_ptr<sm::FaceToleranceResults> Results;
#endif
};

#endif
