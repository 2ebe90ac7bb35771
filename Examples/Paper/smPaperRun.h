/**
 * @file smPaperRun.h
 * @brief Runs of the mass filter, as the paper's graphs need them
 */
#ifndef smPaperRun_h
#define smPaperRun_h

#include <vtkCallbackCommand.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>

#include <string>
#include <vector>

class vtkDataObject;

namespace smfigure
{
enum class Scheme
{
  Adaptive = vtkMassPropertiesGPU::ADAPTIVE,
  Midpoint = vtkMassPropertiesGPU::MIDPOINT,
  Gauss2 = vtkMassPropertiesGPU::GAUSS2,
  Gauss3 = vtkMassPropertiesGPU::GAUSS3
};

const char* GetName(Scheme scheme);

struct PaperRun
{
  Scheme Used = Scheme::Adaptive;
  /// The sub-patch factor k; 0 with ADAPTIVE.
  int Factor = 0;
  long long SubPatches = 0;
  double Volume;
  /// Of ADAPTIVE; NaN with the others.
  double Bound;
  /// The paper's estimates (Eq. 36), NaN with ADAPTIVE: over the sub-patches wholly in their faces, and with those on a trim's
  /// boundary counted whole.
  double Estimate;
  double EstimateWithBoundary;
};

/// A face's trim texture: centres of its columns and rows, and the texels, u fastest.
struct TexturePoints
{
  std::vector<double> U;
  std::vector<double> V;
  std::vector<bool> Inside;
};

/// The filter on one input, its shaders and faces kept from run to run.
class PaperFilter
{
public:
  explicit PaperFilter(vtkDataObject* input);

  /// At a tolerance of 1e-12.
  PaperRun RunAdaptive();
  /// Planes with chords as near to their curves as 1e-9 of the box, so that curved faces alone make the error.
  PaperRun RunScheme(Scheme scheme, int factor);
  /// Of the first face that has one; empty when there is none.
  TexturePoints MakeTexture(int factor, int textureFactor);
  /// What computed, for example "opengl on llvmpipe".
  std::string GetBackend();

private:
  PaperRun Run(Scheme scheme, int factor);

  vtkNew<vtkCallbackCommand> Silence;
  vtkNew<vtkMassPropertiesGPU> Mass;
};
}

#endif
