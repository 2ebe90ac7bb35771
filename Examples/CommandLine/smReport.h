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

#include <string>

namespace sm
{
/// A number rounded to the first digit that the bound reaches, with at most `digits` digits; "-" for null.
std::string FormatValue(const Json& value, const Json& bound, int digits = 12);
/// Three numbers of at most 10 digits, separated by two blanks; "-" for null.
std::string FormatVector(const Json& values, const Json& bound);
/// "mm^3" from "mm" and 3.
std::string FormatUnit(const Json& file, int power);

/// The table of one file.
std::string FormatTable(const Json& file);
/// The whole document; objects over several lines, arrays of numbers on one.
std::string FormatJson(const Json& document);
/// A header and, for every file, a row of its total and a row for each solid; missing values are empty.
std::string FormatCsv(const Json& files);
}

#endif
