#include "smReportFiles.h"

#include "smSafeFile.h"

#include <iostream>
#include <utility>

namespace sm
{
namespace
{
constexpr size_t FreeBytes = size_t(256) << 20;
}

const FileResult& ReportFiles::Add(FileResult file)
{
  this->Files.push_back(std::move(file));
  if (this->Written <= FreeBytes || this->Files.size() > this->Due + this->Due / 20)
  {
    this->SaveAll(false);
    this->Due = this->Files.size();
  }
  return this->Files.back();
}

int ReportFiles::Finish()
{
  return this->SaveAll(true);
}

int ReportFiles::SaveAll(bool isLast)
{
  const auto isDue = [isLast](const std::string& name)
  { return !name.empty() && (isLast || (name != "-" && !IsStream(name))); };
  int exitStatus = AllOk;
  if (isDue(this->JsonName) &&
    this->Save(this->JsonName, FormatJson(this->Head, this->Files), this->InJson, isLast) != AllOk)
  {
    exitStatus = UsageOrOutput;
  }
  if (isDue(this->CsvName) &&
    this->Save(this->CsvName, FormatCsv(this->Files, this->Fields), this->InCsv, isLast) != AllOk)
  {
    exitStatus = UsageOrOutput;
  }
  if (isDue(this->PartsName) &&
    this->Save(this->PartsName, FormatPartsCsv(this->Files), this->InParts, isLast) != AllOk)
  {
    exitStatus = UsageOrOutput;
  }
  return exitStatus;
}

int ReportFiles::Save(const std::string& name, const std::string& text, size_t& saved, bool isLast)
{
  if (name == "-")
  {
    std::cout << text << std::flush;
    return std::cout ? AllOk : Complain("the standard output cannot be written");
  }
  this->Written += text.size();
  const std::string problem = SaveFile(name, text);
  if (problem.empty())
  {
    saved = this->Files.size();
    return AllOk;
  }
  // If this is not the last version, the error is ignored: there may be room on the disk when the next file
  // is finished.
  return !isLast ? AllOk
                 : Complain(name + " cannot be written: " + problem +
                     (saved > 0 ? "; it holds the first " + std::to_string(saved) + " files" : ""));
}
}
