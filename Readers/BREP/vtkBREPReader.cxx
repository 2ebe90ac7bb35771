#include "vtkBREPReader.h"

#include "smBREPFormat.h"
#include "smFile.h"
#include "smKernel.h"
#include "smLengthUnits.h"

#include "vtkObjectFactory.h"
#include "vtkSTEPReader.h"
#include "vtksys/SystemTools.hxx"

vtkStandardNewMacro(vtkBREPReader);

vtkBREPReader::vtkBREPReader() = default;

vtkBREPReader::~vtkBREPReader() = default;

int vtkBREPReader::CanReadFile(const char* fileName)
{
  const std::string head = fileName ? sm::LoadHead(fileName) : std::string();
  if (!fileName || sm::LooksLikeBREP(head) || vtkSTEPReader::CanReadContent(head) != 0)
  {
    return sm::LooksLikeBREP(head) ? 1 : 0;
  }
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
  return (extension == ".brep" || extension == ".brp") && vtksys::SystemTools::FileExists(fileName, true) ? 1
                                                                                                          : 0;
}

int vtkBREPReader::CanReadContent(const std::string& content)
{
  return sm::LooksLikeBREP(content) ? 1 : 0;
}

sm::Document vtkBREPReader::ReadDocument(std::string content, const sm::ProgressCallback& progress)
{
  sm::Document document;
  if (const sm::Kernel* kernel = sm::GetKernel())
  {
    document = kernel->ReadBREP(content, progress);
  }
  else
  {
    document.Problem = "OpenCASCADE, which reads BREP files, is not installed, or its library "
                       "(smReadersKernel) cannot be loaded";
  }
  document.FileUnit = this->InputUnit;
  document.FileUnitInMillimetres = document.UnitInMillimetres = sm::GetUnitInMillimetres(this->InputUnit);
  return document;
}

std::string vtkBREPReader::FindMistakeOfHead(const std::string& head) const
{
  return sm::LooksLikeBREP(head) ? std::string() : sm::NotBREP;
}

std::string vtkBREPReader::FindMistakeOfFormat() const
{
  return sm::GetShortUnit(sm::GetUnitInMillimetres(this->InputUnit)).empty()
    ? "InputUnit \"" + this->InputUnit + "\" is not known; use mm, cm, m, um, inch or ft"
    : std::string();
}

void vtkBREPReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InputUnit: " << this->InputUnit << "\n";
}
