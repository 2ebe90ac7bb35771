/**
 * @class   vtkMassPropertiesBase
 * @brief   what filters share that put out volume, area, centre of mass and inertia
 *
 * Abstract; see vtkMassPropertiesGPU, which integrates to a tolerance with bounds, and vtkSchemeMassPropertiesGPU, which integrates by
 * the schemes of the paper, without. World coordinates; L is the model's length unit; density in kg/m^3.
 *
 * Outputs, beside what vtkSurfaceIntegralBase says:
 * | port | type     | what                                                                              |
 * |------|----------|-----------------------------------------------------------------------------------|
 * | 0    | polydata | sphere at the centre of mass, and principal axes; field data as below             |
 * | 1    | table    | a row per solid instance with the same columns                                     |
 * | 2    | table    | 1x1, column Text: a summary to show in a view; its field data has Status           |
 * | 3    | table    | a row per face and instance: its area, and its part of the volume (flux about the part's origin) |
 * | 5    | partitioned dataset collection | the bodies' meshes with the cell arrays Volume (of the solid), FaceShare (of the face in it), FaceGap and FaceBound, floats |
 *
 * The glyph's active cell scalars are its colour, green, or red where the result is flagged: vtkPolyDataMapper shows it as it
 * is. Where there is none to draw, port 0 has one point without a cell, in the middle of the solids' box.
 *
 * Field data (smMassPropertyNames.h), each quantity with `<name>Bound`, one number in the quantity's unit:
 * | name                  | comp. | unit   | meaning                                                     |
 * |-----------------------|-------|--------|-------------------------------------------------------------|
 * | Volume                | 1     | L^3    |                                                             |
 * | SurfaceArea           | 1     | L^2    | of the faces                                                |
 * | CenterOfMass          | 3     | L      |                                                             |
 * | FirstMoments          | 3     | L^4    | about the world origin                                      |
 * | SecondMoments         | 6     | L^5    | XX YY ZZ XY YZ XZ about the centre                          |
 * | VolumeInertia         | 9     | L^5    | about the centre; off-diagonals are negative products       |
 * | VolumeInertiaAtOrigin | 9     | L^5    | about the world origin                                      |
 * | PrincipalMoments      | 3     | L^5    | ascending                                                   |
 * | PrincipalAxes         | 9     | 1      | rows; PrincipalAxesDegenerate is 1 when moments coincide    |
 * | RadiiOfGyration       | 3     | L      | about the principal axes                                    |
 * | Mass, MassInertia     | 1, 9  | kg, kg L^2 | only with a density                                     |
 * | ClosureCorrection, GapSquared, MaxGap, GapArea, ClosureResidual, OpenEdges | 1 | | the model's own doubt, no bound  |
 * | FlippedShells         | 1     |        | shells that were inside out and were turned                  |
 * | LengthUnit, Status, Backend, Renderer, Evaluations, Dispatches, Ranks | 1 | |                               |
 * A quantity that does not exist is NaN (the volume of a surface, anything that was not computed).
 */
#ifndef vtkMassPropertiesBase_h
#define vtkMassPropertiesBase_h

#include "smFiltersMassPropertiesModule.h"
#include "vtkSurfaceIntegralBase.h"

namespace sm
{
struct MassAnalysis;
struct MassAnalysisOptions;
}

class SMFILTERSMASSPROPERTIES_EXPORT vtkMassPropertiesBase : public vtkSurfaceIntegralBase
{
public:
  vtkTypeMacro(vtkMassPropertiesBase, vtkSurfaceIntegralBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Density of all solids in kg/m^3. 0 (default): the density each part's file states, if any; no mass
   * without one. A negative or infinite value, or not a number, is an error and changes nothing. */
  void SetDensity(double density);
  vtkGetMacro(Density, double);
  ///@}

  ///@{
  /** Radius of the sphere on port 0 as a fraction of the diagonal of the bounding box. Range [0, 1], default
   * 0.02; 0: no sphere. */
  vtkSetClampMacro(GlyphScale, double, 0.0, 1.0);
  vtkGetMacro(GlyphScale, double);
  ///@}

  ///@{
  /** Draw the principal axes at the centre of mass (not when they are degenerate), by 0.3 of the diagonal of the bounding box to either
   * side. Default on. */
  vtkSetMacro(ShowPrincipalAxes, bool);
  vtkGetMacro(ShowPrincipalAxes, bool);
  vtkBooleanMacro(ShowPrincipalAxes, bool);
  ///@}

  ///@{
  /** A glyph for every solid instance as well as for the whole. Default off. */
  vtkSetMacro(GlyphPerSolid, bool);
  vtkGetMacro(GlyphPerSolid, bool);
  vtkBooleanMacro(GlyphPerSolid, bool);
  ///@}

  ///@{
  /** The last run's totals; NaN when not computed. See the table above for units. */
  double GetVolume() const;
  double GetVolumeBound() const;
  double GetSurfaceArea() const;
  double GetSurfaceAreaBound() const;
  void GetCenterOfMass(double center[3]) const;
  double GetCenterOfMassBound() const;
  void GetVolumeInertia(double inertia[9]) const;
  double GetVolumeInertiaBound() const;
  void GetPrincipalMoments(double moments[3]) const;
  void GetPrincipalAxes(double axes[9]) const;
  double GetMass() const;
  ///@}

protected:
  vtkMassPropertiesBase();
  ~vtkMassPropertiesBase() override;

#ifndef __VTK_WRAP__
  void ResetResults() override;
  void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const override;
  std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const override;

  /** Tolerances, and whether there are bounds; the density is added. */
  virtual sm::MassAnalysisOptions MakeAnalysisOptions() const = 0;
  /** Adds outputs of a subclass's own, and lines to the summary. */
  virtual void WriteMoreOutputs(
    const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs, std::string& summary) const;

  /** Of the last run. */
  const sm::MassAnalysis& GetAnalysis() const;
#endif

  double Density = 0.0;
  double GlyphScale = 0.02;
  bool ShowPrincipalAxes = true;
  bool GlyphPerSolid = false;

private:
  vtkMassPropertiesBase(const vtkMassPropertiesBase&) = delete;
  void operator=(const vtkMassPropertiesBase&) = delete;

#ifndef __VTK_WRAP__
  std::unique_ptr<sm::MassAnalysis> Analysis;
#endif
};

#endif
