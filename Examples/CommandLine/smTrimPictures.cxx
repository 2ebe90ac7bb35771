#include "smTrimPictures.h"

#include "smBodyScene.h"
#include "smOutputFiles.h"

#include "vtkImageData.h"
#include "vtkMassPropertiesGPU.h"

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
    return fileName + " would be overwritten, and it is a STEP file";
  }
  return sm::WriteImage(image, fileName);
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
