/**
 * @class   vtkMassPropertiesGPU
 * @brief   volume, area, centre of mass and inertia of exact CAD solids, with error bounds, on the GPU
 *
 * The ten moments of order 0 to 2 are fluxes of f = r g(r) / (3 + deg g), g = 1, x, y, z, xx, .., zz, over
 * the closed chain of faces, ribbons and caps (see vtkSurfaceIntegralGPU); the area is that of the faces.
 * They are integrated about a fixed local origin of each part, once per part, and carried exactly to every
 * instance and to the total. World coordinates; L is the model's length unit; density in kg/m^3.
 *
 * Outputs:
 * | port | type     | what                                                                              |
 * |------|----------|-----------------------------------------------------------------------------------|
 * | 0    | polydata | sphere at the centre of mass, and principal axes on request; field data as below   |
 * | 1    | table    | a row per solid instance with Name, Id and the same columns                        |
 * | 2    | table    | 1x1, column Text: a summary to show in a view                                      |
 * | 3    | table    | a row per face and instance: its area, and its part of the volume (flux about the part's origin) |
 * | 4    | table    | a row per edge and instance, see vtkSurfaceIntegralGPU                            |
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
 * | MovedByClosing, GapSquared, MaxGap, GapArea, Leak, OpenEdges | 1 | | the model's own doubt, no bound  |
 * | FlippedShells         | 1     |        | shells that were inside out and were turned                  |
 * | LengthUnit, Status, Backend, Renderer, Evaluations, Dispatches | 1 | |                               |
 * A quantity that does not exist is NaN (the volume of a surface, anything that was not computed).
 *
 * Status: ok; open (edges that are used once; a surface without a solid); tolerance-not-met; suspect (a
 * face could not be carried over, a trim runs far outside its surface, shells cross); empty; unreadable.
 */
#ifndef vtkMassPropertiesGPU_h
#define vtkMassPropertiesGPU_h

#include "vtkSurfaceIntegralGPU.h"

namespace sm
{
struct MassRow;
struct MassTolerance;
struct Moments;
}

class SMFILTERSMASSPROPERTIES_EXPORT vtkMassPropertiesGPU : public vtkSurfaceIntegralGPU
{
public:
  static vtkMassPropertiesGPU* New();
  vtkTypeMacro(vtkMassPropertiesGPU, vtkSurfaceIntegralGPU);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Tolerances of single quantities: relative to the quantity's scale (the volume, the area, the cube root of the
   * volume for the centre, the trace of the inertia), in [0, 1], 0: RelativeTolerance; and absolute, in the unit of
   * the quantity, 0: none. The larger of the two counts. Anything else is an error and changes nothing. Default 0 0.
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
  /** Draw the principal axes at the centre of mass (not when they are degenerate). Default off. */
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

  /** The mass filter's integrands are fixed: this keeps them. */
  void RemoveAllIntegrands() override;

protected:
  vtkMassPropertiesGPU();
  ~vtkMassPropertiesGPU() override;

  void ForgetLastRun() override;
#ifndef __VTK_WRAP__
  void ProduceOutputs(std::vector<sm::BodyIntegrals>& bodies, vtkPolyData* totals, vtkTable* solids,
    vtkTable* text, vtkTable* faces) override;

private:
  sm::MassTolerance GetTolerance() const;
  void SetTolerance(const char* name, double (&tolerance)[2], double relative, double absolute);
  /// The row of a body; `moments` gets its moments in the world when it has a volume. May flag the body.
  sm::MassRow MakeRow(sm::BodyIntegrals& body, sm::Moments& moments);
  void MakeGlyphs(
    const std::vector<sm::BodyIntegrals>& bodies, const std::vector<sm::MassRow>& rows, vtkPolyData* output);

  struct Totals;
  std::unique_ptr<Totals> Last;

protected:
#endif

  double VolumeTolerance[2] = { 0.0, 0.0 };
  double SurfaceAreaTolerance[2] = { 0.0, 0.0 };
  double CenterOfMassTolerance[2] = { 0.0, 0.0 };
  double InertiaTolerance[2] = { 0.0, 0.0 };
  double Density = 0.0;
  double GlyphScale = 0.02;
  bool ShowPrincipalAxes = false;
  bool GlyphPerSolid = false;

private:
  vtkMassPropertiesGPU(const vtkMassPropertiesGPU&) = delete;
  void operator=(const vtkMassPropertiesGPU&) = delete;
};

#endif
