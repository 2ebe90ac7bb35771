/**
 * @file smTableText.h
 * @brief Formats cells of tables and of CSV
 */
#ifndef smTableText_h
#define smTableText_h

#include "smJson.h"

#include <cstddef>
#include <string>

namespace sm
{
/// Returns the number of UTF-8 characters.
size_t GetWidth(const std::string& text);
/// Pads a text with blanks to a width; the blanks come first if it is right-aligned.
std::string Pad(const std::string& text, size_t width, bool right = false);
/// Removes the middle of a text that is too long, because names of parts often differ at their ends.
std::string Shorten(const std::string& text, size_t width);

/// Formats a number, rounded to the first digit that the bound affects, with at most `digits` digits; "-" for null.
std::string FormatValue(const Json& value, const Json& bound, int digits = 12);
/// Formats three numbers of at most 10 digits, separated by two blanks; "-" for null.
std::string FormatVector(const Json& values, const Json& bound);
/// Formats a number, or the largest of three numbers, with at most 9 digits, and with a ~ if it has no bound.
std::string FormatBrief(const Json& value, const Json& bound);

/// Formats a value for CSV, in quotes if necessary; empty for null.
std::string FormatCell(const Json& value);
}

#endif
