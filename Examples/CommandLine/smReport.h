/**
 * @file smReport.h
 * @brief Results as text: a table for people, JSON and CSV for programs
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
/// "mm^3" from "mm" and 3.
std::string FormatUnit(const Json& file, int power);

/// Number of entries of "validation" with that result.
int CountValidation(const Json& file, const std::string& result);

/// A line for each of the first messages of a file.
std::string FormatMessages(const Json& file);
/// The table of one file.
std::string FormatTable(const Json& file);
/// The whole document; objects over several lines, arrays of numbers on one.
std::string FormatJson(const Json& document);
/// A header and, for every file, a row of its total and a row for each solid; missing values are empty.
/// `fields` are the columns to write, in their order; none: all.
std::string FormatCsv(const Json& files, const std::vector<std::string>& fields = {});
/// The columns of the CSV of a file.
std::vector<std::string> ListColumns(const Json& file);
/// A line with the columns `fields` of a file's total, separated by blanks; "nan" for a value that does not exist.
std::string FormatFields(const Json& file, const std::vector<std::string>& fields);
}

#endif
