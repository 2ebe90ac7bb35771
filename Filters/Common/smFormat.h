/**
 * @file smFormat.h
 * @brief Numbers as text for messages, summaries and shaders; with a decimal point in every locale
 */
#ifndef smFormat_h
#define smFormat_h

#include "smFiltersCommonModule.h"

#include <cstddef>
#include <string>

namespace sm
{
/// At most `digits` significant digits, without trailing zeros: 1.5, 1.23e-05, nan, inf.
SMFILTERSCOMMON_EXPORT std::string FormatDigits(double value, int digits);
/// Exactly `digits` digits behind the point.
SMFILTERSCOMMON_EXPORT std::string FormatFixed(double value, int digits);

/// Three numbers for a message, with at most six digits each: "(1.5, 0, -2)".
SMFILTERSCOMMON_EXPORT std::string FormatTriple(double x, double y, double z);
/// A distance for a message, with three digits; "an unknown distance" if it is not finite.
SMFILTERSCOMMON_EXPORT std::string FormatDistance(double distance);

/// A bound with `digits` digits, rounded up; "not known" if it is not finite, here and below.
SMFILTERSCOMMON_EXPORT std::string FormatBound(double bound, int digits = 1);
/// A value with as many digits as its bound leaves: rounded by at most a twentieth of it, all digits where it
/// is 0.
SMFILTERSCOMMON_EXPORT std::string FormatNumber(double value, double bound);
/// The bound of the number that FormatNumber() prints: includes the rounding of the printed digits.
SMFILTERSCOMMON_EXPORT std::string FormatBoundOfShown(double bound, int digits = 1);
/// " (+- bound)", to follow the number of FormatNumber() and its unit. `doubt` is what gaps of the model
/// change or leave in doubt, which no bound includes: where it is larger than the bound, the note names it by
/// `word` and rounds it up, " (+- bound, gaps 40)"; where it is NaN, the note ends in "gaps not known".
SMFILTERSCOMMON_EXPORT std::string FormatBoundNote(
  double bound, double doubt = 0.0, const std::string& word = "gaps");
/// Value, unit and FormatBoundNote().
SMFILTERSCOMMON_EXPORT std::string FormatWithBound(
  double value, double bound, const std::string& unit, double doubt = 0.0, const std::string& word = "gaps");

/// A count with the noun in the right number: "1 face", "3 faces".
SMFILTERSCOMMON_EXPORT std::string FormatCount(std::size_t count, const char* one, const char* many);

/// Returns true if a line of the text may end at this blank: not within a value, where sign, number and unit
/// stay together, as in "(+- 2e-09)", "5 kg mm^2" or "3 faces".
SMFILTERSCOMMON_EXPORT bool IsLineBreak(const std::string& text, std::size_t blank);
/// Breaks text at IsLineBreak() into lines of at most `width` characters (more for a longer word or value),
/// each with a newline.
SMFILTERSCOMMON_EXPORT std::string WrapText(const std::string& text, std::size_t width);

/// A double literal of GLSL that reads back to the bit: "-1.50000000000000000e+00LF".
SMFILTERSCOMMON_EXPORT std::string MakeLiteral(double value);
}

#endif
