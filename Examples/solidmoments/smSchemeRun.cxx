#include "smScheme.h"

#include "smExtras.h"
#include "smOutputFiles.h"
#include "smResults.h"
#include "smSchemeNames.h"

#include "vtkImageData.h"
#include "vtkSchemeMassPropertiesGPU.h"

#include <set>

namespace
{
std::string MakeFileName(const std::string& name)
{
  std::string plain;
  for (const char c : name)
  {
    const bool isKept =
      (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
    if (isKept || (!plain.empty() && plain.back() != '-'))
    {
      plain += isKept ? c : '-';
    }
  }
  return plain;
}

std::string WriteTexture(vtkImageData* image, const std::string& fileName)
{
  if (sm::IsModelFile(fileName))
  {
    return fileName + " would be overwritten, and it is a CAD file";
  }
  return sm::CallExtra(&sm::ExtraFunctions::WriteImage, image, fileName);
}
}

namespace sm
{
const char* Scheme::GetMissingModule()
{
  return nullptr;
}

vtkSmartPointer<vtkMassPropertiesBase> Scheme::MakeFilter() const
{
  auto filter = vtkSmartPointer<vtkSchemeMassPropertiesGPU>::New();
  filter->SetScheme(this->Name == "midpoint" ? vtkSchemeMassPropertiesGPU::MIDPOINT
      : this->Name == "gauss2"               ? vtkSchemeMassPropertiesGPU::GAUSS2
                                             : vtkSchemeMassPropertiesGPU::GAUSS3);
  filter->SetSubPatchFactor(this->SubPatches);
  filter->SetTrimTextureFactor(this->TrimTexture);
  filter->SetChordTolerance(this->ChordTolerance);
  filter->SetDeviation(
    this->Deviation == "sampled" ? vtkSchemeMassPropertiesGPU::SAMPLED : vtkSchemeMassPropertiesGPU::BOUNDED);
  filter->SetKeepTrimTextures(!this->TextureFolder.empty());
  return filter;
}

void Scheme::ReadOptions(vtkMassPropertiesBase* filter, FileResult& file)
{
  if (auto* scheme = vtkSchemeMassPropertiesGPU::SafeDownCast(filter))
  {
    file.SchemeOptions = { scheme->GetSubPatchFactor(), scheme->GetTrimTextureFactor(),
      scheme->GetChordTolerance(),
      scheme->GetDeviation() == vtkSchemeMassPropertiesGPU::SAMPLED ? "sampled" : "bounded" };
  }
}

void Scheme::ReadBody(vtkFieldData* data, vtkIdType row, BodyResult& body)
{
  body.PaperErrorEstimate = GetNumber(data, row, names::PaperErrorEstimate);
  body.PaperErrorEstimateWithBoundary = GetNumber(data, row, names::PaperErrorEstimateWithBoundary);
  body.SubPatches = GetCount(data, row, names::SubPatches);
}

std::string Scheme::WriteTrimPictures(vtkMassPropertiesBase* filter, const std::string& prefix)
{
  auto* scheme = vtkSchemeMassPropertiesGPU::SafeDownCast(filter);
  std::set<std::string> taken;
  for (int i = 0; scheme && i < scheme->GetNumberOfTrimTextures(); ++i)
  {
    const std::string plain = prefix + "-" + MakeFileName(scheme->GetTrimTextureName(i));
    std::string name = plain;
    for (int count = 2; !taken.insert(name).second; ++count)
    {
      name = plain + "-" + std::to_string(count);
    }
    const std::string error = WriteTexture(scheme->GetTrimTexture(i), name + ".png");
    if (!error.empty())
    {
      return error;
    }
  }
  return {};
}
}
