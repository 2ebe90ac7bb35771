/**
 * @class   vtkSchemeMassPropertiesGPU
 * @brief   mass properties by the schemes of "Accurate Moment Computation Using the GPU" (SPM 2010), for
 * comparison
 *
 * Every knot interval of a face is divided into k x k sub-patches with 1, 2x2 or 3x3 Gauss points each
 * (MIDPOINT, GAUSS2, GAUSS3). The integrands are the fluxes along z of the paper's Eq. 16-28, over the faces
 * alone. A trimmed sub-patch is weighted by the fraction of its trim texture that lies in the face; planes
 * are triangulated. The outputs include the paper's estimate of the volume's error (Eq. 36), which is not a
 * bound. vtkMassPropertiesGPU computes bounds.
 *
 * There is no tolerance: Status is at least tolerance-not-met; every `<name>Bound`, ClosureCorrection,
 * ClosureResidual and the gaps are NaN. A trim curve that leaves a curved surface makes the status suspect;
 * on a plane, which is unbounded, it does not. A loop that covers part of a surface more than once, or with
 * the wrong orientation, does not either, as a texel counts wherever the winding number is not 0. A run that
 * needs more than MaximumEvaluations, is stopped, or exceeds its time limit computes nothing. In a parallel
 * run only the rank that has the bodies computes.
 *
 * Outputs are those of vtkMassPropertiesBase and, in field data and table (smSchemeNames.h):
 * | name | comp. | unit | meaning |
 * |---|---|---|---|
 * | Scheme | 1 | | "MIDPOINT", "GAUSS2" or "GAUSS3" |
 * | PaperErrorEstimate | 1 | L^3 | the paper's estimate of the volume's error, Eq. 36 |
 * | PaperErrorEstimateWithBoundary | 1 | L^3 | the same, sub-patches on a trim boundary in full |
 * | SubPatches | 1 | | number of sub-patches of all faces that are not planar |
 */
#ifndef vtkSchemeMassPropertiesGPU_h
#define vtkSchemeMassPropertiesGPU_h

#include "smFiltersMomentSchemesModule.h"
#include "vtkMassPropertiesBase.h"

class vtkImageData;

class SMFILTERSMOMENTSCHEMES_EXPORT vtkSchemeMassPropertiesGPU : public vtkMassPropertiesBase
{
public:
  static vtkSchemeMassPropertiesGPU* New();
  vtkTypeMacro(vtkSchemeMassPropertiesGPU, vtkMassPropertiesBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Number of Gauss points of a sub-patch in each direction. */
  enum SchemeType
  {
    MIDPOINT = 1,
    GAUSS2 = 2,
    GAUSS3 = 3
  };

  ///@{
  /** The scheme, by its number of Gauss points. Range [MIDPOINT, GAUSS3], clamped. Default GAUSS2. */
  vtkSetClampMacro(Scheme, int, MIDPOINT, GAUSS3);
  vtkGetMacro(Scheme, int);
  ///@}

  ///@{
  /** Sub-patch factor k: every knot interval is divided into k x k sub-patches. Range [1, 1024], clamped.
   * Default 2. */
  vtkSetClampMacro(SubPatchFactor, int, 1, 1024);
  vtkGetMacro(SubPatchFactor, int);
  ///@}

  ///@{
  /** Number of texels of the trim texture per sub-patch in u and in v. Range [1, 16], clamped. Default 4. */
  vtkSetClampMacro(TrimTextureFactor, int, 1, 16);
  vtkGetMacro(TrimTextureFactor, int);
  ///@}

  ///@{
  /** Largest distance between the trim curves of a planar face and the chords of its trim polygon, relative
   * to the diagonal of the solid's box. Range (0, 1); any other value is reported as an error and changes
   * nothing. Default 1e-8, so that the errors of the schemes are those of curved faces. */
  void SetChordTolerance(double tolerance);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  /** Method by which the paper's deviation K of a sub-patch (Eq. 4) is computed from its second derivatives.
   */
  enum DeviationType
  {
    BOUNDED = 0,
    SAMPLED = 1
  };

  ///@{
  /** Method for the deviation K: BOUNDED uses bounds by control points and never underestimates K; SAMPLED
   * uses the largest of a few points. It changes only the paper's estimates. Range [BOUNDED, SAMPLED],
   * clamped. Default BOUNDED. */
  vtkSetClampMacro(Deviation, int, BOUNDED, SAMPLED);
  vtkGetMacro(Deviation, int);
  ///@}

  ///@{
  /** If on, keeps the trim textures: an image per trimmed face that is not planar. Default off. */
  vtkSetMacro(KeepTrimTextures, bool);
  vtkGetMacro(KeepTrimTextures, bool);
  vtkBooleanMacro(KeepTrimTextures, bool);
  ///@}

  ///@{
  /** Trim textures of the last run: unsigned char, 255 in the face and 0 outside. Origin and spacing are
   * those of the texels' centres in (u,v), averaged to an even grid if knot intervals differ. The name is
   * that of the solid and the face's entity number, "Body #12". An index out of range gives null and an empty
   * name. All instances of a model share its textures. */
  int GetNumberOfTrimTextures() const;
  vtkImageData* GetTrimTexture(int index) const;
  std::string GetTrimTextureName(int index) const;
  ///@}

  ///@{
  /** Totals of the last run: the paper's estimate of the error of the volume (L^3, not a bound) over the
   * sub-patches entirely in their faces, the same including those on a trim boundary, and the number of
   * sub-patches. NaN, NaN and 0 if nothing was computed. */
  double GetPaperErrorEstimate() const;
  double GetPaperErrorEstimateWithBoundary() const;
  vtkTypeInt64 GetSubPatches() const;
  ///@}

protected:
  vtkSchemeMassPropertiesGPU();
  ~vtkSchemeMassPropertiesGPU() override;

#ifndef __VTK_WRAP__
  void ResetResults() override;
  bool CanShareFaces() const override
  {
    return false;
  }
  sm::IntegralRequest MakeRequest() const override;
  bool IntegrateBodies(const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies) override;
  sm::MassAnalysisOptions MakeAnalysisOptions() const override;
  void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void WriteMoreOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs,
    std::string& summary) const override;
  void ReleaseKept() override;
#endif

  int Scheme = GAUSS2;
  int SubPatchFactor = 2;
  int TrimTextureFactor = 4;
  double ChordTolerance = 1e-8;
  int Deviation = BOUNDED;
  bool KeepTrimTextures = false;

private:
  vtkSchemeMassPropertiesGPU(const vtkSchemeMassPropertiesGPU&) = delete;
  void operator=(const vtkSchemeMassPropertiesGPU&) = delete;

#ifndef __VTK_WRAP__
  struct Internals;
  std::unique_ptr<Internals> Implementation;
#endif
};

#endif
