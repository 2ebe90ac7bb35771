#include "smFormat.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace sm
{
namespace
{
std::string Convert(double value, std::chars_format format, int digits)
{
  // The longest: a sign, 309 digits before the point and 17 behind it.
  char text[400];
  const auto end = std::to_chars(text, text + sizeof(text), value, format, digits);
  return std::string(text, end.ptr);
}
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

std::string FormatBound(double bound)
{
  if (!std::isfinite(bound))
  {
    return "not known";
  }
  if (bound <= 0.0)
  {
    return FormatDigits(bound, 6);
  }
  int exponent = static_cast<int>(std::floor(std::log10(bound)));
  double digit = std::ceil(bound / std::pow(10.0, exponent));
  if (digit > 9.0)
  {
    digit = 1.0;
    ++exponent;
  }
  const std::string power = std::to_string(std::abs(exponent));
  return FormatFixed(digit, 0) + (exponent < 0 ? "e-" : "e+") + (power.size() < 2 ? "0" : "") + power;
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
  if (std::abs(value) <= bound)
  {
    return "0";
  }
  const double ratio = bound > 0.0 ? std::log10(std::abs(value) / bound) : 12.0;
  return FormatDigits(value, std::clamp(static_cast<int>(std::floor(ratio)) + 1, 1, 12));
}

std::string FormatBoundNote(double bound)
{
  return std::isfinite(bound) ? " (+- " + FormatBound(bound) + ")" : std::string(" (bound not known)");
}

std::string FormatWithBound(double value, double bound, const std::string& unit)
{
  return std::isfinite(value)
    ? FormatNumber(value, bound) + (unit.empty() ? "" : " ") + unit + FormatBoundNote(bound)
    : std::string("not known");
}

std::string WrapText(const std::string& text, std::size_t width)
{
  std::string result;
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    if (!line.empty() && line.size() + 1 + word.size() > width)
    {
      result += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? result : result + line + "\n";
}

std::string MakeLiteral(double value)
{
  return Convert(value, std::chars_format::scientific, 17) + "LF";
}
}
