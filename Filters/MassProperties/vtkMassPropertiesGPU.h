/**
 * @class   vtkMassPropertiesGPU
 * @brief   volume, area, centre of mass and inertia of exact CAD solids, with error bounds, on the GPU
 *
 * The ten moments of order 0 to 2 are fluxes of f = r g(r) / (3 + deg g), g = 1, x, y, z, xx, .., zz, over
 * the closed chain of faces, ribbons and caps (see vtkSurfaceIntegralGPU); the area is that of the faces.
 * They are integrated about a fixed local origin of each part, once per part, and carried exactly to every
 * instance and to the total. World coordinates; L is the model's length unit; density in kg/m^3.
 *
 * SetScheme() chooses, instead, one of the schemes of the paper that this filter grew from, for comparison: they have no
 * bound (every `<name>Bound` is NaN), so that Status is at best tolerance-not-met, and ClosureCorrection and the gaps are NaN.
 *
 * Outputs:
 * | port | type     | what                                                                              |
 * |------|----------|-----------------------------------------------------------------------------------|
 * | 0    | polydata | sphere at the centre of mass, and principal axes on request; field data as below   |
 * | 1    | table    | a row per solid instance with Name, Id and the same columns                        |
 * | 2    | table    | 1x1, column Text: a summary to show in a view                                      |
 * | 3    | table    | a row per face and instance: its area, and its part of the volume (flux about the part's origin) |
 * | 4    | table    | a row per edge and instance, see vtkSurfaceIntegralGPU                            |
 * | 5    | partitioned dataset collection | the bodies' meshes, see vtkSurfaceIntegralGPU, with the cell arrays Volume (of the solid), FaceShare (of the face in it), FaceGap and FaceBound, floats |
 *
 * The glyph's active cell scalars are its colour, green, or red where the result is flagged: vtkPolyDataMapper shows it as it
 * is. Where there is none to draw, port 0 has one point without a cell, in the middle of the solids' box. The text's field data has
 * Status.
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
 * | Scheme                | 1     |        | with one of the paper's schemes only, as the next three     |
 * | PaperErrorEstimate    | 1     | L^3    | the paper's estimate of the volume's error, Eq. 36: no bound |
 * | PaperErrorEstimateWithBoundary | 1 | L^3 | the same with the sub-patches on a trim boundary counted whole |
 * | SubPatches            | 1     |        | of all faces that are not planar                             |
 * A quantity that does not exist is NaN (the volume of a surface, anything that was not computed).
 *
 * Status: ok; open (edges that are used once; a surface without a solid); tolerance-not-met; suspect (a
 * face could not be carried over, a trim runs far outside its surface, shells cross); empty; unreadable.
 */
#ifndef vtkMassPropertiesGPU_h
#define vtkMassPropertiesGPU_h

#include "smFiltersMassPropertiesModule.h"
#include "vtkSurfaceIntegralGPU.h"

namespace sm
{
struct MassRow;
struct MassTolerance;
struct Moments;
}

class vtkImageData;

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

  /** How faces are integrated. */
  enum SchemeType
  {
    ADAPTIVE = 0,
    MIDPOINT = 1,
    GAUSS2 = 2,
    GAUSS3 = 3
  };

  ///@{
  /**
   * ADAPTIVE, to the tolerances, with bounds; or a scheme of "Accurate Moment Computation Using the GPU" (SPM 2010): the sub-patches
   * of every face (see below) with 1, 2x2 or 3x3 Gauss points each, the fluxes along z of its Eq. 16-28 over the faces alone, trimmed
   * sub-patches weighed by the fraction of their trim texture, planes by triangles. No tolerance applies, and no bound comes out.
   * A trim that leaves a curved surface makes the status suspect as with ADAPTIVE; a loop that covers part of a surface more than
   * once, or from outside, does not: a texel counts where the winding number is any but 0. On planes, which go on, neither does.
   * Needs more than MaximumEvaluations, stopped, or out of time: nothing is computed. Clamped to these. Default ADAPTIVE.
   */
  vtkSetClampMacro(Scheme, int, ADAPTIVE, GAUSS3);
  vtkGetMacro(Scheme, int);
  ///@}

  ///@{
  /** Of the paper's schemes: every knot interval is divided into k x k sub-patches. Clamped to [1, 1024], default 2. */
  vtkSetClampMacro(SubPatchFactor, int, 1, 1024);
  vtkGetMacro(SubPatchFactor, int);
  ///@}

  ///@{
  /** Of the paper's schemes: texels of the trim texture per sub-patch in u and in v. Clamped to [1, 16], default 4. */
  vtkSetClampMacro(TrimTextureFactor, int, 1, 16);
  vtkGetMacro(TrimTextureFactor, int);
  ///@}

  ///@{
  /** Of the paper's schemes: how far the chords of a planar face's trim polygon may be from its trim curves, relative to the
   * diagonal of the solid's box. In (0, 1), default 1e-8, so that the schemes' errors
   * are those of curved faces. Anything else is an error and changes nothing. */
  void SetChordTolerance(double tolerance);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  /** How the paper's deviation K of a sub-patch (Eq. 4) is found from its second derivatives. */
  enum DeviationType
  {
    BOUNDED = 0,
    SAMPLED = 1
  };

  ///@{
  /** BOUNDED: from control points, never too small; SAMPLED: the largest of a few points. Changes the paper's estimates only.
   * Clamped to these. Default BOUNDED. */
  vtkSetClampMacro(Deviation, int, BOUNDED, SAMPLED);
  vtkGetMacro(Deviation, int);
  ///@}

  ///@{
  /** Keep the trim textures of the paper's schemes, an image per trimmed face that is not planar. Default off. */
  vtkSetMacro(KeepTrimTextures, bool);
  vtkGetMacro(KeepTrimTextures, bool);
  vtkBooleanMacro(KeepTrimTextures, bool);
  ///@}

  ///@{
  /** Trim textures of the last run: unsigned char, 255 in the face and 0 outside; origin and spacing are the texels' centres in
   * (u,v), of an even grid where knot intervals differ. The name is that of the solid and the face's entity number, "Body #12". Null
   * and empty for an index out of range. Instances of one model have theirs once. */
  int GetNumberOfTrimTextures() const;
  vtkImageData* GetTrimTexture(int index) const;
  std::string GetTrimTextureName(int index) const;
  ///@}

  ///@{
  /** The last run's totals, with one of the paper's schemes: the paper's estimate of the error of the volume (L^3, no bound) over the
   * sub-patches wholly in their faces, and over those on a trim boundary as well; and the number of sub-patches. NaN, NaN and 0
   * otherwise. */
  double GetPaperErrorEstimate() const;
  double GetPaperErrorEstimateWithBoundary() const;
  vtkTypeInt64 GetSubPatches() const;
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
  bool CanShareFaces() const override
  {
    return !this->HasScheme();
  }
  bool IntegrateBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void ProduceOutputs(std::vector<sm::BodyIntegrals>& bodies, vtkPolyData* totals, vtkTable* solids,
    vtkTable* text, vtkTable* faces) override;
  std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) override;

private:
  sm::MassTolerance GetTolerance() const;
  void SetTolerance(const char* name, double (&tolerance)[2], double relative, double absolute);
  /// With one of the paper's schemes.
  bool HasScheme() const
  {
    return this->Scheme != ADAPTIVE;
  }
  std::string GetSchemeMessage() const;
  /// The largest leak of what counts as closed.
  double GetLargestClosureResidual(const sm::BodyIntegrals& body, double perArea) const;
  void AddSchemeOutputs(const std::vector<sm::BodyIntegrals>& bodies, bool oneUnit, vtkPolyData* totals,
    vtkTable* solids, std::string& summary);
  /// k, texels, chords and deviation in words.
  std::string GetSchemeOptions() const;
  /// The row of a body; `moments` gets its moments in the world when it has a volume. May flag the body.
  sm::MassRow MakeRow(sm::BodyIntegrals& body, sm::Moments& moments);
  void MakeGlyphs(const std::vector<sm::BodyIntegrals>& bodies, const std::vector<sm::MassRow>& rows,
    const std::string& status, vtkPolyData* output);

  void PrintSchemeOptions(ostream& os, vtkIndent indent) const;

  struct Totals;
  std::unique_ptr<Totals> Last;

protected:
#endif

  double VolumeTolerance[2] = { 0.0, 0.0 };
  double SurfaceAreaTolerance[2] = { 0.0, 0.0 };
  double CenterOfMassTolerance[2] = { 0.0, 0.0 };
  double InertiaTolerance[2] = { 0.0, 0.0 };
  int Scheme = ADAPTIVE;
  int SubPatchFactor = 2;
  int TrimTextureFactor = 4;
  double ChordTolerance = 1e-8;
  int Deviation = BOUNDED;
  bool KeepTrimTextures = false;
  double Density = 0.0;
  double GlyphScale = 0.02;
  bool ShowPrincipalAxes = true;
  bool GlyphPerSolid = false;

private:
  vtkMassPropertiesGPU(const vtkMassPropertiesGPU&) = delete;
  void operator=(const vtkMassPropertiesGPU&) = delete;
};

#endif
