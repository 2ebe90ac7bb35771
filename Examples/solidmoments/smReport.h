/**
 * @file smReport.h
 * @brief Formats results: a table for people, JSON and CSV for programs
 *
 * JSON and CSV carry every number in the shortest form that reads back to the same bits; the table and
 * captions show the digits that the bound leaves. Numbers have a decimal point in every locale.
 */
#ifndef smReport_h
#define smReport_h

#include "smComparison.h"
#include "smReportRows.h"
#include "smResults.h"

#include <optional>
#include <string>
#include <vector>

namespace sm
{
/// Returns a line for each of the first messages of a file.
std::string FormatMessages(const FileResult& file);
/// Returns the table of one file.
std::string FormatTable(const FileResult& file);
/// Returns a table of the parts list of a file; empty without one.
std::string FormatPartsList(const FileResult& file);

/// What a document in JSON holds in addition to the files.
struct DocumentHead
{
  /// The processor's seconds before main().
  double ProcessStart = 0.0;
  /// Two files are compared, if they could be.
  bool HasComparison = false;
  std::optional<ProductDifference> Comparison;
};
/// Returns the whole document, with objects over several lines and arrays of numbers on one.
std::string FormatJson(const DocumentHead& head, const std::vector<FileResult>& files);

/// Returns a header and, for every file, a row of its total and a row for each solid; missing values are
/// empty. `fields` are the columns to write, in their order; none: all.
std::string FormatCsv(const std::vector<FileResult>& files, const std::vector<std::string>& fields = {});
/// Returns the columns of the CSV of a file.
std::vector<std::string> ListColumns(const FileResult& file);
/// Returns a table in Markdown of the columns of a file, with their meanings.
std::string FormatColumnReference(const FileResult& file);
/// Returns a line with the columns `fields` of a file's total, separated by blanks; "nan" for a value that
/// does not exist.
std::string FormatFields(const FileResult& file, const std::vector<std::string>& fields);
/// Returns the parts lists of all files as CSV, a row per entry with its level.
std::string FormatPartsCsv(const std::vector<FileResult>& files);
}

#endif
