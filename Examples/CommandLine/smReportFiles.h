/**
 * @file smReportFiles.h
 * @brief The JSON and CSV of a run, which hold the finished files at any moment
 */
#ifndef smReportFiles_h
#define smReportFiles_h

#include "smArguments.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
/**
 * The documents are written again after every file, whole each time (SaveFile), so that a process that is killed leaves what it had
 * computed. After 256 MB they are written whenever they have a twentieth more files: all versions together are then not much longer than
 * twenty times the last. Standard output, devices and pipes get their document once, by Finish().
 */
class ReportFiles
{
public:
  /// `processStart`: the processor's seconds before main().
  ReportFiles(const Arguments& arguments, double processStart)
    : ProcessStart(processStart)
    , JsonName(arguments.Json)
    , CsvName(arguments.Csv)
    , PartsName(arguments.PartsCsv)
    , UrdfName(arguments.Urdf)
    , Fields(arguments.Fields)
  {
  }

  /// Adds the entry of a finished file, and returns it.
  const Json& Add(Json file);
  /// Adds the comparison of the files to the JSON.
  void SetComparison(Json comparison) { this->Comparison = std::move(comparison); }
  size_t GetNumberOfFiles() const { return this->Files.size(); }
  /// Writes what is not yet written. Returns an exit status, after a sentence about every output that could not be written.
  int Finish();

private:
  /// Saves the text; `saved` is the number of files in the last version that was written.
  int Save(const std::string& name, const std::string& text, size_t& saved, bool isLast);
  int SaveAll(bool isLast);

  double ProcessStart;
  std::string JsonName;
  std::string CsvName;
  std::string PartsName;
  std::string UrdfName;
  std::vector<std::string> Fields; ///< columns of the CSV; none: all
  Json Files = Json::array();
  std::optional<Json> Comparison;
  size_t InJson = 0;
  size_t InCsv = 0;
  size_t InParts = 0;
  size_t InUrdf = 0;
  /// Bytes of all versions, and number of files when the last was due.
  size_t Written = 0;
  size_t Due = 0;
};
}

#endif
