/**
 * @file smPaperRun.h
 * @brief Runs of the mass filter, as the paper's graphs need them
 */
#ifndef smPaperRun_h
#define smPaperRun_h

#include <vtkCallbackCommand.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>
#include <vtkSchemeMassPropertiesGPU.h>

#include <string>
#include <vector>

class vtkDataObject;

namespace smfigure
{
enum class Scheme
{
  Adaptive = 0,
  Midpoint = vtkSchemeMassPropertiesGPU::MIDPOINT,
  Gauss2 = vtkSchemeMassPropertiesGPU::GAUSS2,
  Gauss3 = vtkSchemeMassPropertiesGPU::GAUSS3
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

/// Both filters on one input, their shaders and faces kept from run to run.
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
  vtkNew<vtkCallbackCommand> Silence;
  vtkNew<vtkMassPropertiesGPU> Adaptive;
  vtkNew<vtkSchemeMassPropertiesGPU> Schemes;
};
}

#endif
