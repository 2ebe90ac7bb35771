#include "smSchemeJob.h"

#include "smBodyScene.h"
#include "smOutputFiles.h"
#include "smQuantities.h"
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
  return sm::WriteImage(image, fileName);
}
}

namespace sm
{
vtkSmartPointer<vtkMassPropertiesBase> MakeSchemeFilter(const JobOptions& options)
{
  auto filter = vtkSmartPointer<vtkSchemeMassPropertiesGPU>::New();
  filter->SetScheme(options.Scheme == "midpoint" ? vtkSchemeMassPropertiesGPU::MIDPOINT
      : options.Scheme == "gauss2"               ? vtkSchemeMassPropertiesGPU::GAUSS2
                                                 : vtkSchemeMassPropertiesGPU::GAUSS3);
  filter->SetSubPatchFactor(options.SubPatches);
  filter->SetTrimTextureFactor(options.TrimTexture);
  filter->SetChordTolerance(options.ChordTolerance);
  filter->SetDeviation(options.Deviation == "sampled" ? vtkSchemeMassPropertiesGPU::SAMPLED
                                                      : vtkSchemeMassPropertiesGPU::BOUNDED);
  filter->SetKeepTrimTextures(!options.TexturePrefix.empty());
  return filter;
}

Json GetSchemeOptions(vtkMassPropertiesBase* filter)
{
  auto* scheme = vtkSchemeMassPropertiesGPU::SafeDownCast(filter);
  if (!scheme)
  {
    return nullptr;
  }
  Json options;
  options["sub_patch_factor"] = scheme->GetSubPatchFactor();
  options["texture_factor"] = scheme->GetTrimTextureFactor();
  options["chord_tolerance"] = scheme->GetChordTolerance();
  options["deviation"] =
    scheme->GetDeviation() == vtkSchemeMassPropertiesGPU::SAMPLED ? "sampled" : "bounded";
  return options;
}

Json GetSchemeQuantities(vtkFieldData* data, vtkIdType row)
{
  Json quantities;
  quantities["paper_error_estimate"] = GetNumber(data, row, names::PaperErrorEstimate);
  quantities["paper_error_estimate_with_boundary"] =
    GetNumber(data, row, names::PaperErrorEstimateWithBoundary);
  quantities["sub_patches"] = GetCount(data, row, names::SubPatches);
  return quantities;
}

std::string WriteTrimPictures(vtkMassPropertiesBase* filter, const std::string& prefix)
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
