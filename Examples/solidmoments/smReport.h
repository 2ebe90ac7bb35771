/**
 * @file smReport.h
 * @brief Formats results: a table for people, JSON and CSV for programs
 *
 * All functions take entries of "files" of the JSON document. JSON and CSV carry every number in the shortest form that reads back
 * to the same bits; the table and captions show the digits that the bound leaves. Numbers have a decimal point in every locale.
 */
#ifndef smReport_h
#define smReport_h

#include "smJson.h"
#include "smTableText.h"

#include <string>
#include <vector>

namespace sm
{
/// Returns "mm^3" for the unit "mm" and the power 3.
std::string FormatUnit(const Json& file, int power);

/// Returns the number of entries of "validation" with that result.
int CountValidation(const Json& file, const std::string& result);

/// Returns a line for each of the first messages of a file.
std::string FormatMessages(const Json& file);
/// Returns the table of one file.
std::string FormatTable(const Json& file);
/// Returns the whole document, with objects over several lines and arrays of numbers on one.
std::string FormatJson(const Json& document);
/// Returns a header and, for every file, a row of its total and a row for each solid; missing values are empty.
/// `fields` are the columns to write, in their order; none: all.
std::string FormatCsv(const Json& files, const std::vector<std::string>& fields = {});
/// Returns the columns of the CSV of a file.
std::vector<std::string> ListColumns(const Json& file);
/// Returns a line with the columns `fields` of a file's total, separated by blanks; "nan" for a value that does not exist.
std::string FormatFields(const Json& file, const std::vector<std::string>& fields);
}

#endif
