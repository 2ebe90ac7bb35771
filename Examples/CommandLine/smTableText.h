/**
 * @file smTableText.h
 * @brief Cells of tables and of CSV as text
 */
#ifndef smTableText_h
#define smTableText_h

#include "smJson.h"

#include <cstddef>
#include <string>

namespace sm
{
/// Number of characters of UTF-8.
size_t GetWidth(const std::string& text);
/// The text with blanks up to a width, before it if it stands on the right.
std::string Pad(const std::string& text, size_t width, bool right = false);
/// A text that is too long loses its middle: names of parts often differ at their ends.
std::string Shorten(const std::string& text, size_t width);

/// A number rounded to the first digit that the bound reaches, with at most `digits` digits; "-" for null.
std::string FormatValue(const Json& value, const Json& bound, int digits = 12);
/// Three numbers of at most 10 digits, separated by two blanks; "-" for null.
std::string FormatVector(const Json& values, const Json& bound);
/// At most 9 digits of a number, or of the largest of three numbers; with a ~ when they have no bound.
std::string FormatBrief(const Json& value, const Json& bound);

/// A value in CSV, in quotes where it needs them; empty for null.
std::string FormatCell(const Json& value);
}

#endif
