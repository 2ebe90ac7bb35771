#include "smFormat.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <system_error>

namespace sm
{
namespace
{
std::string Convert(double value, std::chars_format format, int digits)
{
  // The longest number has a sign, 309 digits before the point and 17 behind it.
  char text[400];
  const auto end = std::to_chars(text, text + sizeof(text), value, format, digits);
  return std::string(text, end.ptr);
}

/// Writes a double with the fewest digits that read back as the same bits.
std::string FormatExactly(double value)
{
  char text[400];
  const auto end = std::to_chars(text, text + sizeof(text), value, std::chars_format::general);
  return std::string(text, end.ptr);
}

/// The part of a bound by which a value is rounded at most.
constexpr double RoundingShare = 0.05;
}

std::string FormatDigits(double value, int digits)
{
  return Convert(value, std::chars_format::general, digits);
}

std::string FormatFixed(double value, int digits)
{
  return Convert(value, std::chars_format::fixed, std::min(digits, 17));
}

std::string FormatTriple(double x, double y, double z)
{
  return "(" + FormatDigits(x, 6) + ", " + FormatDigits(y, 6) + ", " + FormatDigits(z, 6) + ")";
}

std::string FormatDistance(double distance)
{
  return std::isfinite(distance) ? FormatDigits(distance, 3) : std::string("an unknown distance");
}

std::string FormatBound(double bound, int digits)
{
  if (!std::isfinite(bound) || bound <= 0.0)
  {
    return std::isfinite(bound) ? FormatDigits(bound, 6) : "not known";
  }
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) + 1 - digits);
  double steps = std::ceil(bound / unit);
  std::string text = FormatDigits(steps * unit, digits);
  // The power of ten and the product are rounded.
  for (double shown = 0.0;
       std::from_chars(text.data(), text.data() + text.size(), shown).ec == std::errc() && shown < bound;)
  {
    text = FormatDigits(++steps * unit, digits);
  }
  return text;
}

std::string FormatNumber(double value, double bound)
{
  if (!std::isfinite(value))
  {
    return "not known";
  }
  if (!std::isfinite(bound))
  {
    return FormatDigits(value, 6);
  }
  if (std::abs(value) <= RoundingShare * bound)
  {
    return "0";
  }
  if (bound == 0.0)
  {
    return FormatExactly(value);
  }
  const double last = std::log10(2.0 * RoundingShare * bound);
  const double digits = std::ceil(std::floor(std::log10(std::abs(value))) + 1.0 - last);
  return FormatDigits(value, static_cast<int>(std::clamp(digits, 1.0, 17.0)));
}

std::string FormatBoundOfShown(double bound, int digits)
{
  return FormatBound((1.0 + RoundingShare) * bound, digits);
}

std::string FormatBoundNote(double bound, double doubt, const std::string& word)
{
  const bool isNotable = std::isnan(doubt) || doubt > bound;
  const std::string note = isNotable ? ", " + word + " " + FormatBound(doubt, 2) + ")" : std::string(")");
  return std::isfinite(bound) ? " (+- " + FormatBoundOfShown(bound) + note
                              : std::string(" (bound not known)");
}

std::string FormatWithBound(
  double value, double bound, const std::string& unit, double doubt, const std::string& word)
{
  return std::isfinite(value)
    ? FormatNumber(value, bound) + (unit.empty() ? "" : " ") + unit + FormatBoundNote(bound, doubt, word)
    : std::string("not known");
}

std::string FormatCount(std::size_t count, const char* one, const char* many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

bool IsLineBreak(const std::string& text, std::size_t blank)
{
  const std::size_t end = text.find_last_not_of(' ', blank);
  const std::size_t next = text.find_first_not_of(' ', blank);
  if (end == std::string::npos || next == std::string::npos)
  {
    return false;
  }
  const std::size_t before = text.find_last_of(' ', end);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::string word = text.substr(begin, end - begin + 1);
  const std::string nextWord = text.substr(next, text.find(' ', next) - next);
  double number = 0.0;
  const std::from_chars_result read = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool isNumber = read.ec == std::errc() && read.ptr == word.data() + word.size();
  const bool isUnit = std::isalpha(static_cast<unsigned char>(nextWord.front())) != 0;
  // The second factor of a unit, as in kg mm^2, has an exponent.
  return word != "(+-" && !(isNumber && isUnit) && nextWord.find('^') == std::string::npos;
}

std::string WrapText(const std::string& text, std::size_t width)
{
  // With one blank between words.
  std::string rest;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    rest += (rest.empty() ? "" : " ") + word;
  }
  std::string result;
  while (rest.size() > width)
  {
    // The last break before which the words fit; of words that are too long, the one behind them.
    std::size_t cut = std::string::npos;
    for (std::size_t blank = rest.find(' ');
         blank != std::string::npos && (blank <= width || cut == std::string::npos);
         blank = rest.find(' ', blank + 1))
    {
      cut = IsLineBreak(rest, blank) ? blank : cut;
    }
    if (cut == std::string::npos)
    {
      break;
    }
    result += rest.substr(0, cut) + "\n";
    rest.erase(0, cut + 1);
  }
  return rest.empty() ? result : result + rest + "\n";
}

std::string MakeLiteral(double value)
{
  return Convert(value, std::chars_format::scientific, 17) + "LF";
}
}
