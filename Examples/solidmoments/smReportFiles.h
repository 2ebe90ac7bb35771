/**
 * @file smReportFiles.h
 * @brief Writes the JSON and CSV of a run, which contain all finished files at any time
 */
#ifndef smReportFiles_h
#define smReportFiles_h

#include "smArguments.h"
#include "smReport.h"

#include <string>
#include <utility>
#include <vector>

namespace sm
{
/**
 * The documents are written completely after every file (SaveFile), so that the results of a process that is
 * killed are not lost. Above 256 MB they are written only when they have a twentieth more files: all versions
 * together are then not much longer than twenty times the last one. Standard output, devices and pipes get
 * their document once, by Finish().
 */
class ReportFiles
{
public:
  /// `processStart`: the processor's seconds before main().
  ReportFiles(const Arguments& arguments, double processStart)
    : JsonName(arguments.Json)
    , CsvName(arguments.Csv)
    , PartsName(arguments.PartsCsv)
    , Fields(arguments.Fields)
  {
    this->Head.ProcessStart = processStart;
  }

  /// Adds the entry of a finished file, and returns it.
  const FileResult& Add(FileResult file);
  /// Adds the comparison of the files to the JSON.
  void SetComparison(std::optional<ProductDifference> comparison)
  {
    this->Head.HasComparison = true;
    this->Head.Comparison = std::move(comparison);
  }
  size_t GetNumberOfFiles() const { return this->Files.size(); }
  /// Writes the final documents. Returns an exit status, and prints a message about every output that could
  /// not be written.
  int Finish();

private:
  /// Saves the text; `saved` is the number of files in the last version that was written.
  int Save(const std::string& name, const std::string& text, size_t& saved, bool isLast);
  int SaveAll(bool isLast);

  std::string JsonName;
  std::string CsvName;
  std::string PartsName;
  std::vector<std::string> Fields; ///< columns of the CSV; none: all
  std::vector<FileResult> Files;
  DocumentHead Head;
  size_t InJson = 0;
  size_t InCsv = 0;
  size_t InParts = 0;
  /// Bytes of all versions so far, and number of files in the last one.
  size_t Written = 0;
  size_t Due = 0;
};
}

#endif
