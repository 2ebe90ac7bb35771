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
/// The number that the text consists of, with a decimal point in every locale and an optional sign; NaN when the text is no number.
double ParseNumber(const std::string& text);
/// The numbers of a list such as "1,2.5,-3"; empty when one of them is no number.
std::vector<double> ParseNumbers(const std::string& text);

/// The text in lower case; letters beyond ASCII stay as they are.
std::string LowerCase(std::string text);
/// The text without the blanks and line ends behind it.
std::string TrimEnd(std::string text);

/// "bracket.step" from "parts/bracket.step".
std::string GetFileName(const std::string& path);
/// "bracket" from "parts/bracket.step".
std::string GetStem(const std::string& path);

/// The text with U+FFFD in the place of every byte that is not UTF-8.
std::string MakeUtf8(const std::string& text);
/// Letters, digits and -._~/ as they are, every other byte as %XX: URL unquoting gives the bytes back.
std::string PercentEncode(const std::string& text);
}

#endif
