/**
 * @file smTableText.h
 * @brief Formats cells of tables and of CSV
 */
#ifndef smTableText_h
#define smTableText_h

#include "smFields.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace sm
{
/// Returns the number of UTF-8 characters.
size_t GetWidth(const std::string& text);
/// Pads a text with blanks to a width; the blanks come first if it is right-aligned.
std::string Pad(const std::string& text, size_t width, bool right = false);
/// Removes the middle of a text that is too long, because names of parts often differ at their ends.
std::string Shorten(const std::string& text, size_t width);

/// Formats a number, rounded to the first digit that the bound affects, with at most `digits` digits; "-" for
/// NaN.
std::string FormatValue(double value, double bound, int digits = 12);
/// Formats three numbers of at most 10 digits, separated by two blanks; "-" for NaN.
std::string FormatVector(const double* values, double bound);
inline std::string FormatVector(const std::array<double, 3>& values, double bound)
{
  return FormatVector(values.data(), bound);
}
/// Formats a number, or three numbers, with at most 9 digits of the largest, and with a ~ if it has no bound.
std::string FormatBrief(double value, double bound);
std::string FormatBrief(const VectorQuantity& quantity);

/// Formats a value for CSV, in quotes if necessary; empty if it is not known.
std::string FormatCell(const std::optional<std::string>& value);
}

#endif
