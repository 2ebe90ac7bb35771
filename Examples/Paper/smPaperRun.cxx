#include "smPaperRun.h"

#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkImageData.h>

#include <limits>

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
  this->Adaptive->SetInputDataObject(input);
  this->Adaptive->SetRelativeTolerance(1e-12);
  this->Schemes->SetInputDataObject(input);
  this->Schemes->SetChordTolerance(1e-9);
  // That the schemes have no bound is a warning of every run; the results are judged here.
  this->Adaptive->AddObserver(vtkCommand::WarningEvent, this->Silence);
  this->Schemes->AddObserver(vtkCommand::WarningEvent, this->Silence);
}

PaperRun PaperFilter::RunAdaptive()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Adaptive->Update();
  return { Scheme::Adaptive, 0, 0, this->Adaptive->GetVolume(), this->Adaptive->GetVolumeBound(), nan, nan };
}

PaperRun PaperFilter::RunScheme(Scheme scheme, int factor)
{
  this->Schemes->SetScheme(static_cast<int>(scheme));
  this->Schemes->SetSubPatchFactor(factor);
  this->Schemes->Update();
  return { scheme, factor, this->Schemes->GetSubPatches(), this->Schemes->GetVolume(),
    this->Schemes->GetVolumeBound(), this->Schemes->GetPaperErrorEstimate(),
    this->Schemes->GetPaperErrorEstimateWithBoundary() };
}

TexturePoints PaperFilter::MakeTexture(int factor, int textureFactor)
{
  TexturePoints points;
  this->Schemes->SetScheme(vtkSchemeMassPropertiesGPU::GAUSS2);
  this->Schemes->SetSubPatchFactor(factor);
  this->Schemes->SetTrimTextureFactor(textureFactor);
  this->Schemes->SetKeepTrimTextures(true);
  this->Schemes->Update();
  vtkImageData* texture = this->Schemes->GetTrimTexture(0);
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
}
