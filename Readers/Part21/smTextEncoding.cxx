#include "smTextEncoding.h"

#include <algorithm>
#include <cstddef>

namespace sm
{
namespace
{
unsigned char GetByte(const std::string& text, std::size_t at)
{
  return static_cast<unsigned char>(text[at]);
}

/// Returns the number of bytes of the UTF-8 sequence that begins at a byte above 127; 0 if there is no valid
/// one.
std::size_t GetLength(const std::string& text, std::size_t at)
{
  const unsigned char first = GetByte(text, at);
  const std::size_t length = first >= 0xc2 && first < 0xe0 ? 2
    : first >= 0xe0 && first < 0xf0                        ? 3
    : first >= 0xf0 && first < 0xf5                        ? 4
                                                           : 0;
  if (length == 0 || at + length > text.size())
  {
    return 0;
  }
  for (std::size_t k = 1; k < length; ++k)
  {
    if ((GetByte(text, at + k) & 0xc0) != 0x80)
    {
      return 0;
    }
  }
  // Refuses overlong forms, surrogates of UTF-16, and code points above U+10FFFF.
  const unsigned char second = GetByte(text, at + 1);
  const bool isWrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
    (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
  return isWrong ? 0 : length;
}

bool IsASCII(char c)
{
  return static_cast<unsigned char>(c) < 0x80;
}
}

std::string ToUTF8(std::string text)
{
  // Text that is UTF-8 throughout is returned without a copy.
  std::size_t at = 0;
  const auto skip = [&text, &at]()
  {
    const auto from = text.begin() + static_cast<std::ptrdiff_t>(at);
    at = static_cast<std::size_t>(std::find_if_not(from, text.end(), IsASCII) - text.begin());
    const std::size_t length = at < text.size() ? GetLength(text, at) : 0;
    at += length;
    return length > 0;
  };
  while (skip())
  {
  }
  if (at == text.size())
  {
    return text;
  }
  std::string result;
  result.reserve(text.size() + text.size() / 8);
  std::size_t copied = 0;
  do
  {
    result.append(text, copied, at - copied);
    const unsigned char byte = GetByte(text, at);
    result += { static_cast<char>(0xc0 | (byte >> 6)), static_cast<char>(0x80 | (byte & 0x3f)) };
    copied = ++at;
    while (skip())
    {
    }
  } while (at < text.size());
  return result.append(text, copied, std::string::npos);
}
}
