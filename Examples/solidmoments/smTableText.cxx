#include "smTableText.h"

#include "smFormat.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Returns true for a byte that begins a UTF-8 character.
bool StartsCharacter(char byte)
{
  return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

/// Returns the position of a character by its number; the size of the text behind the last one.
size_t FindCharacter(const std::string& text, size_t number)
{
  size_t at = 0;
  for (size_t count = 0; at < text.size(); ++at)
  {
    count += StartsCharacter(text[at]) ? 1 : 0;
    if (count > number)
    {
      break;
    }
  }
  return at;
}
}

size_t GetWidth(const std::string& text)
{
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), StartsCharacter));
}

std::string Shorten(const std::string& text, size_t width)
{
  const size_t length = GetWidth(text);
  if (length <= width)
  {
    return text;
  }
  const size_t tail = (width - 2) / 2;
  return text.substr(0, FindCharacter(text, width - 2 - tail)) + ".." +
    text.substr(FindCharacter(text, length - tail));
}

std::string Pad(const std::string& text, size_t width, bool right)
{
  const size_t length = GetWidth(text);
  const std::string blanks(length < width ? width - length : 0, ' ');
  return right ? blanks + text : text + blanks;
}

std::string FormatValue(double value, double bound, int digits)
{
  return !std::isfinite(value) ? "-"
    : std::isfinite(bound)     ? FormatNumber(value, bound)
                               : FormatDigits(value, digits);
}

std::string FormatVector(const double* values, double bound)
{
  const int digits = 10;
  return std::isnan(values[0]) ? "-"
                               : FormatValue(values[0], bound, digits) + "  " +
      FormatValue(values[1], bound, digits) + "  " + FormatValue(values[2], bound, digits);
}

std::string FormatBrief(double value, double bound)
{
  const bool hasBound = std::isfinite(bound);
  return !std::isfinite(value)
    ? "-"
    : (hasBound ? "" : "~") + FormatValue(value, std::max(hasBound ? bound : 0.0, 1e-8 * std::abs(value)));
}

std::string FormatBrief(const VectorQuantity& quantity)
{
  if (!quantity.IsKnown())
  {
    return "-";
  }
  const bool hasBound = std::isfinite(quantity.Bound);
  double limit = hasBound ? quantity.Bound : 0.0;
  for (const double number : quantity.Value)
  {
    limit = std::max(limit, 1e-8 * std::abs(number));
  }
  return (hasBound ? "" : "~") + FormatVector(quantity.Value, limit);
}

std::string FormatCell(const std::optional<std::string>& value)
{
  std::string text = value.value_or("");
  if (text.find_first_of(",\"\n\r") == std::string::npos)
  {
    return text;
  }
  for (size_t i = text.find('"'); i != std::string::npos; i = text.find('"', i + 2))
  {
    text.insert(i, 1, '"');
  }
  return "\"" + text + "\"";
}
}
