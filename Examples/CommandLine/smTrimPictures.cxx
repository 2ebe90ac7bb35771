#include "smTrimPictures.h"

#include "smOutputFiles.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkMassPropertiesGPU.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <algorithm>
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

std::string Write(vtkImageData* image, const std::string& fileName)
{
  if (sm::IsStepFile(fileName))
  {
    return fileName + " would be overwritten, which is a STEP file";
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(fileName.c_str());
  writer->Write();
  return writer->GetErrorCode() == vtkErrorCode::NoError
    ? std::string()
    : fileName + " cannot be written: " + vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode());
}
}

namespace sm
{
std::string WriteTrimPictures(const vtkMassPropertiesGPU* filter, const std::string& prefix)
{
  std::set<std::string> taken;
  for (int i = 0; i < filter->GetNumberOfTrimTextures(); ++i)
  {
    const std::string plain = prefix + "-" + MakeFileName(filter->GetTrimTextureName(i));
    std::string name = plain;
    for (int count = 2; !taken.insert(name).second; ++count)
    {
      name = plain + "-" + std::to_string(count);
    }
    const std::string error = Write(filter->GetTrimTexture(i), name + ".png");
    if (!error.empty())
    {
      return error;
    }
  }
  return {};
}
}
