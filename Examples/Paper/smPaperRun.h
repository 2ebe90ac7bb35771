/**
 * @file smPaperRun.h
 * @brief Runs of the mass filter for the paper's graphs
 */
#ifndef smPaperRun_h
#define smPaperRun_h

#include <vtkCallbackCommand.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>
#include <vtkSchemeMassPropertiesGPU.h>

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
  /// The bound of ADAPTIVE; NaN with the other schemes.
  double Bound;
  /// The paper's estimates (Eq. 36), NaN with ADAPTIVE: over the sub-patches entirely inside their faces, and
  /// over those and the ones on a trim boundary, which count with their whole area.
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

/// Both filters on one input; they keep their shaders and faces from run to run.
class PaperFilter
{
public:
  explicit PaperFilter(vtkDataObject* input);

  /// Runs ADAPTIVE at a tolerance of 1e-12.
  PaperRun RunAdaptive();
  /// Runs a scheme. The chords of planes are within 1e-9 of the box of their curves, so that the error is
  /// that of curved faces.
  PaperRun RunScheme(Scheme scheme, int factor);
  /// The trim texture of the first face that has one; empty when there is none.
  TexturePoints MakeTexture(int factor, int textureFactor);

private:
  vtkNew<vtkCallbackCommand> Silence;
  vtkNew<vtkMassPropertiesGPU> Adaptive;
  vtkNew<vtkSchemeMassPropertiesGPU> Schemes;
};
}

#endif
