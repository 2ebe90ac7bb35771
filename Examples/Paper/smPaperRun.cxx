#include "smPaperRun.h"

#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkImageData.h>

namespace smfigure
{
const char* GetName(Scheme scheme)
{
  switch (scheme)
  {
    case Scheme::Midpoint:
      return "MIDPOINT";
    case Scheme::Gauss2:
      return "GAUSS2";
    case Scheme::Gauss3:
      return "GAUSS3";
    default:
      return "ADAPTIVE";
  }
}

PaperFilter::PaperFilter(vtkDataObject* input)
{
  this->Mass->SetInputDataObject(input);
  this->Mass->SetRelativeTolerance(1e-12);
  this->Mass->SetChordTolerance(1e-9);
  // Every run warns that the schemes have no bound; the programs check the results themselves.
  this->Mass->AddObserver(vtkCommand::WarningEvent, this->Silence);
}

PaperRun PaperFilter::Run(Scheme scheme, int factor)
{
  this->Mass->SetScheme(static_cast<int>(scheme));
  this->Mass->Update();
  PaperRun run;
  run.Used = scheme;
  run.Factor = factor;
  run.SubPatches = this->Mass->GetSubPatches();
  run.Volume = this->Mass->GetVolume();
  run.Bound = this->Mass->GetVolumeBound();
  run.Estimate = this->Mass->GetPaperErrorEstimate();
  run.EstimateWithBoundary = this->Mass->GetPaperErrorEstimateWithBoundary();
  return run;
}

PaperRun PaperFilter::RunAdaptive()
{
  return this->Run(Scheme::Adaptive, 0);
}

PaperRun PaperFilter::RunScheme(Scheme scheme, int factor)
{
  this->Mass->SetSubPatchFactor(factor);
  return this->Run(scheme, factor);
}

TexturePoints PaperFilter::MakeTexture(int factor, int textureFactor)
{
  TexturePoints points;
  this->Mass->SetScheme(vtkMassPropertiesGPU::GAUSS2);
  this->Mass->SetSubPatchFactor(factor);
  this->Mass->SetTrimTextureFactor(textureFactor);
  this->Mass->SetKeepTrimTextures(true);
  this->Mass->Update();
  vtkImageData* texture = this->Mass->GetTrimTexture(0);
  if (!texture)
  {
    return points;
  }
  const int* size = texture->GetDimensions();
  const double* origin = texture->GetOrigin();
  const double* spacing = texture->GetSpacing();
  for (int i = 0; i < size[0]; ++i)
  {
    points.U.push_back(origin[0] + i * spacing[0]);
  }
  for (int j = 0; j < size[1]; ++j)
  {
    points.V.push_back(origin[1] + j * spacing[1]);
    for (int i = 0; i < size[0]; ++i)
    {
      points.Inside.push_back(texture->GetScalarComponentAsDouble(i, j, 0, 0) > 0.0);
    }
  }
  return points;
}

std::string PaperFilter::GetBackend()
{
  return std::string(this->Mass->GetBackendName()) + " on " + this->Mass->GetRenderer();
}
}
