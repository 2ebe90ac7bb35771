/**
 * @file smText.h
 * @brief Text of the example programs: numbers, file names and UTF-8. Needs neither VTK nor a locale.
 */
#ifndef smText_h
#define smText_h

#include <string>
#include <vector>

namespace sm
{
class Fields;

/// Returns the number of a text, with a decimal point in every locale and an optional sign; NaN if the text
/// is not a number.
double ParseNumber(const std::string& text);
/// Returns the numbers of a list such as "1,2.5,-3"; empty if one of them is not a number.
std::vector<double> ParseNumbers(const std::string& text);

/// Returns the number in the shortest form that reads back to the same bits, with a decimal point: "22160.0",
/// "1e-09".
std::string FormatExact(double number);

/// Returns the text in lower case; letters beyond ASCII are not changed.
std::string LowerCase(std::string text);
/// Returns the text without blanks and line ends at its end.
std::string TrimEnd(std::string text);

/// Returns "bracket.step" for "parts/bracket.step".
std::string GetFileName(const std::string& path);
/// Returns "bracket" for "parts/bracket.step".
std::string GetStem(const std::string& path);

/// Replaces every byte that is not UTF-8 by U+FFFD.
std::string MakeUtf8(const std::string& text);
/// Writes every byte other than letters, digits and -._~/ as %XX; URL decoding restores the bytes.
std::string PercentEncode(const std::string& text);

/// Sets the keys "file" and "file_bytes". "file" is the name; Dump() replaces its bytes that are not UTF-8.
/// When there are such bytes, "file_bytes" is the percent-encoded name, which gives them back; otherwise it
/// is null.
void VisitFileName(Fields& fields, std::string& name);
}

#endif
