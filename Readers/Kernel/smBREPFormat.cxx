#include "smBREPFormat.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace sm
{
namespace
{
/// Largest number of an orientation in a binary file.
constexpr std::int64_t LastOrientation = 3;

constexpr std::string_view TextMagic = "CASCADE Topology V";
constexpr std::string_view BinaryMagic = "Open CASCADE Topology V";
/// First word of files that OpenCASCADE's test harness (DRAW) wrote.
constexpr std::string_view HarnessMagic = "DBRep_DrawableShape";

std::string_view SkipBlanks(std::string_view text)
{
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
  {
    text.remove_prefix(1);
  }
  return text;
}

bool StartsWith(std::string_view text, std::string_view start)
{
  return text.compare(0, start.size(), start) == 0;
}

/// Returns a number of four bytes, least significant first, `fromEnd` bytes before the end; -1 if there is
/// none.
std::int64_t GetInteger(std::string_view bytes, std::size_t fromEnd)
{
  if (bytes.size() < fromEnd)
  {
    return -1;
  }
  std::int64_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    value += static_cast<std::int64_t>(static_cast<unsigned char>(bytes[bytes.size() - fromEnd + k]))
      << (8 * k);
  }
  return value;
}
}

bool IsTextBREP(std::string_view bytes)
{
  std::string_view text = SkipBlanks(bytes);
  if (StartsWith(text, HarnessMagic))
  {
    text = SkipBlanks(text.substr(HarnessMagic.size()));
  }
  return StartsWith(text, TextMagic);
}

bool IsWholeBREP(std::string_view text)
{
  const bool isHarness = StartsWith(SkipBlanks(text), HarnessMagic);
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  const std::size_t asterisk = text.find_last_of('*', end);
  if (end == std::string_view::npos || asterisk == std::string_view::npos || asterisk == end)
  {
    return false;
  }
  std::string_view reference = SkipBlanks(text.substr(asterisk + 1, end - asterisk));
  const auto isNumber = [](std::string_view word)
  { return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos; };
  bool isFollowed = text.size() > end + 1;
  const std::size_t lineEnd = reference.find_first_of("\r\n");
  if (isHarness && lineEnd != std::string_view::npos && isNumber(SkipBlanks(reference.substr(lineEnd))))
  {
    reference = reference.substr(0, reference.find_last_not_of(" \t", lineEnd - 1) + 1);
    isFollowed = true;
  }
  const std::size_t blank = reference.find(' ');
  return blank != std::string_view::npos &&
    std::string_view("+-ie").find(reference.front()) != std::string_view::npos &&
    isNumber(reference.substr(1, blank - 1)) && isNumber(reference.substr(blank + 1)) &&
    (isFollowed || reference.substr(blank) == " 0");
}

bool IsBREPOfFreeCAD(std::string_view bytes)
{
  constexpr std::string_view table = "\nTShapes ";
  const std::size_t at = bytes.rfind(table);
  std::int64_t shapes = 0;
  for (std::size_t k = at + table.size();
       at != std::string_view::npos && k < bytes.size() && std::isdigit(static_cast<unsigned char>(bytes[k]));
       ++k)
  {
    shapes = std::min<std::int64_t>(10 * shapes + (bytes[k] - '0'), std::int64_t{ 1 } << 32);
  }
  return shapes > 0 && GetInteger(bytes, 12) == shapes && GetInteger(bytes, 8) >= 0 &&
    GetInteger(bytes, 8) <= shapes && GetInteger(bytes, 4) >= 0 && GetInteger(bytes, 4) <= LastOrientation;
}

bool LooksLikeBREP(std::string_view bytes)
{
  return IsTextBREP(bytes) || StartsWith(SkipBlanks(bytes), BinaryMagic);
}
}
