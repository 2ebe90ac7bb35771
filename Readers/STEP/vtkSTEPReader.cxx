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
/// Words of the setting of the format, by vtkSTEPReader::RepairType.
constexpr const char* RepairWords[] = { "always", "needed", "never" };
constexpr sm::RepairMode RepairModes[] = { sm::RepairMode::Always, sm::RepairMode::OnNeed,
  sm::RepairMode::Never };

/// Words of the bodies that are read, by vtkSTEPReader::HiddenType, which follow that of the repair.
constexpr const char* HiddenWords[] = { "count", "skip", "only" };
constexpr sm::HiddenMode HiddenModes[] = { sm::HiddenMode::Count, sm::HiddenMode::Skip,
  sm::HiddenMode::Only };
constexpr char WordSeparator = ',';

/// Between folders, and before the first one in the setting of the format.
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
    RepairModes[this->IsRepairSkipped ? NEVER : this->Repair], HiddenModes[this->Hidden], progress);
  document.Messages.insert(document.Messages.begin(), messages.begin(), messages.end());
  return document;
}

std::string vtkSTEPReader::FindMistakeOfHead(const std::string& head) const
{
  return sm::CheckText(head).Problem;
}

std::string vtkSTEPReader::GetSettingOfFormat() const
{
  return std::string(RepairWords[this->IsRepairSkipped ? NEVER : this->Repair]) + WordSeparator +
    HiddenWords[this->Hidden] + FolderSeparator + (this->SearchFolders ? this->SearchFolders : "");
}

void vtkSTEPReader::SetSettingOfFormat(const std::string& word)
{
  const std::size_t end = word.find(FolderSeparator);
  const std::string first = word.substr(0, end);
  for (int repair = ALWAYS; repair <= NEVER; ++repair)
  {
    for (int hidden = COUNT_HIDDEN; hidden <= ONLY_HIDDEN; ++hidden)
    {
      if (first == std::string(RepairWords[repair]) + WordSeparator + HiddenWords[hidden])
      {
        this->SetRepair(repair);
        this->SetHidden(hidden);
      }
    }
  }
  this->SetSearchFolders(end == std::string::npos ? "" : word.substr(end + 1).c_str());
}

bool vtkSTEPReader::SkipRepair(bool isSkipped)
{
  this->IsRepairSkipped = isSkipped;
  return this->Repair != NEVER;
}

void vtkSTEPReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SearchFolders: " << (this->SearchFolders ? this->SearchFolders : "(none)") << "\n";
  os << indent << "Repair: " << RepairWords[this->Repair] << "\n";
  os << indent << "Hidden: " << HiddenWords[this->Hidden] << "\n";
}
