/**
 * @class   vtkSchemeMassPropertiesGPU
 * @brief   mass properties by the schemes of "Accurate Moment Computation Using the GPU" (SPM 2010), for comparison
 *
 * Every knot interval of a face is divided into k x k sub-patches with 1, 2x2 or 3x3 Gauss points each (MIDPOINT, GAUSS2, GAUSS3). The
 * integrands are the fluxes along z of the paper's Eq. 16-28, over the faces alone. A trimmed sub-patch is weighed by the fraction of
 * its trim texture that lies in the face; planes are triangulated. The paper's estimate of the volume's error (Eq. 36) is put out; it
 * is no bound. vtkMassPropertiesGPU has bounds.
 *
 * There is no tolerance: Status is at best tolerance-not-met; every `<name>Bound`, ClosureCorrection, ClosureResidual and the gaps are
 * NaN. A trim that leaves a curved surface makes the status suspect; a loop that covers part of a surface more than once, or from
 * outside, does not: a texel counts where the winding number is any but 0. On planes, which have no end, neither does. A run that
 * needs more than MaximumEvaluations, is stopped, or is out of time computes nothing. Of several ranks the one with the bodies
 * computes.
 *
 * Outputs are those of vtkMassPropertiesBase, and in field data and table (smSchemeNames.h):
 * | name                  | comp. | unit   | meaning                                                     |
 * |-----------------------|-------|--------|-------------------------------------------------------------|
 * | Scheme                | 1     |        | "MIDPOINT", "GAUSS2" or "GAUSS3"                             |
 * | PaperErrorEstimate    | 1     | L^3    | the paper's estimate of the volume's error, Eq. 36           |
 * | PaperErrorEstimateWithBoundary | 1 | L^3 | the same with the sub-patches on a trim boundary counted whole |
 * | SubPatches            | 1     |        | of all faces that are not planar                             |
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

  /** The numbers of Gauss points of a sub-patch in each direction. */
  enum SchemeType
  {
    MIDPOINT = 1,
    GAUSS2 = 2,
    GAUSS3 = 3
  };

  ///@{
  /** The scheme. Clamped to these. Default GAUSS2. */
  vtkSetClampMacro(Scheme, int, MIDPOINT, GAUSS3);
  vtkGetMacro(Scheme, int);
  ///@}

  ///@{
  /** Every knot interval is divided into k x k sub-patches. Clamped to [1, 1024], default 2. */
  vtkSetClampMacro(SubPatchFactor, int, 1, 1024);
  vtkGetMacro(SubPatchFactor, int);
  ///@}

  ///@{
  /** Texels of the trim texture per sub-patch in u and in v. Clamped to [1, 16], default 4. */
  vtkSetClampMacro(TrimTextureFactor, int, 1, 16);
  vtkGetMacro(TrimTextureFactor, int);
  ///@}

  ///@{
  /** How far the chords of a planar face's trim polygon may be from its trim curves, relative to the
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
  /** Keep the trim textures, an image per trimmed face that is not planar. Default off. */
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
  /** The last run's totals: the paper's estimate of the error of the volume (L^3, no bound) over the
   * sub-patches wholly in their faces, and over those on a trim boundary as well; and the number of sub-patches. NaN, NaN and 0 when nothing was
   * computed. */
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
