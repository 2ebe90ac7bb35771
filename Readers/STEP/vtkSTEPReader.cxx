#include "vtkSTEPReader.h"

#include "smOCCTDocument.h"
#include "smOCCTFile.h"

#include "vtkObjectFactory.h"
#include "vtksys/SystemTools.hxx"

#include <utility>

vtkStandardNewMacro(vtkSTEPReader);

vtkSTEPReader::vtkSTEPReader() = default;

vtkSTEPReader::~vtkSTEPReader() = default;

int vtkSTEPReader::CanReadFile(const char* fileName)
{
  if (!fileName || sm::LooksLikeSTEP(fileName))
  {
    return fileName ? 1 : 0;
  }
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
  const bool isNamed = extension == ".step" || extension == ".stp" || extension == ".p21";
  return isNamed && vtksys::SystemTools::FileExists(fileName, true) ? 1 : 0;
}

int vtkSTEPReader::CanReadContent(const std::string& content)
{
  return sm::CheckText(content).Readable ? 1 : 0;
}

sm::Document vtkSTEPReader::ReadDocument(std::string content, const sm::ProgressCallback& progress)
{
  return sm::ReadSTEP(
    std::move(content), this->Repair == ON_NEED ? sm::RepairMode::OnNeed : sm::RepairMode::Always, progress);
}

std::string vtkSTEPReader::FindMistakeOfHead(const std::string& head) const
{
  return sm::CheckText(head).Problem;
}

std::string vtkSTEPReader::GetSettingOfFormat() const
{
  return this->Repair == ON_NEED ? "needed" : "always";
}

void vtkSTEPReader::SetSettingOfFormat(const std::string& word)
{
  this->SetRepair(word == "needed" ? ON_NEED : ALWAYS);
}

void vtkSTEPReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Repair: " << (this->Repair == ON_NEED ? "on need\n" : "always\n");
}
