#include "vtkSTEPReader.h"

#include "smDocument.h"
#include "smFile.h"
#include "smSTEPExternalFiles.h"

#include "vtkObjectFactory.h"
#include "vtksys/SystemTools.hxx"

#include <sstream>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSTEPReader);

namespace
{
/// Words for vtkSTEPReader::RepairType.
constexpr const char* RepairWords[] = { "always", "needed", "never" };
constexpr sm::RepairMode RepairModes[] = { sm::RepairMode::Always, sm::RepairMode::OnNeed,
  sm::RepairMode::Never };

/// Words for vtkSTEPReader::HiddenType.
constexpr const char* HiddenWords[] = { "count", "skip", "only" };
constexpr sm::HiddenMode HiddenModes[] = { sm::HiddenMode::Count, sm::HiddenMode::Skip,
  sm::HiddenMode::Only };

/// Between folders.
constexpr char FolderSeparator = ':';

std::vector<std::string> ListFolders(const char* folders)
{
  std::vector<std::string> list;
  std::istringstream words(folders ? folders : "");
  for (std::string word; std::getline(words, word, FolderSeparator);)
  {
    if (!word.empty())
    {
      list.push_back(word);
    }
  }
  return list;
}
}

vtkSTEPReader::vtkSTEPReader()
{
  this->SetSearchFolders("");
}

vtkSTEPReader::~vtkSTEPReader()
{
  this->SetSearchFolders(nullptr);
}

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
  std::vector<std::string> messages;
  const bool isFile = this->GetFileName() && !this->HasContent();
  std::string joined = isFile
    ? sm::JoinSTEPFiles(content, this->GetFileName(), ListFolders(this->SearchFolders), messages)
    : std::string();
  sm::Document document = sm::ReadSTEP(joined.empty() ? std::move(content) : std::move(joined),
    RepairModes[this->Repair], HiddenModes[this->Hidden], progress);
  document.Messages.insert(document.Messages.begin(), messages.begin(), messages.end());
  return document;
}

std::string vtkSTEPReader::FindMistakeOfHead(const std::string& head) const
{
  return sm::CheckText(head).Problem;
}

void vtkSTEPReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SearchFolders: " << (this->SearchFolders ? this->SearchFolders : "(none)") << "\n";
  os << indent << "Repair: " << RepairWords[this->Repair] << "\n";
  os << indent << "Hidden: " << HiddenWords[this->Hidden] << "\n";
}
