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

namespace
{
/// Appends a character of Unicode as UTF-8; one that is not valid becomes U+FFFD.
void AppendUTF8(unsigned long code, std::string& text)
{
  code = code > 0x10ffff || (code >= 0xd800 && code < 0xe000) ? 0xfffd : code;
  if (code < 0x80)
  {
    text += static_cast<char>(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  static constexpr unsigned long Leads[] = { 0, 0xc0, 0xe0, 0xf0 };
  text += static_cast<char>(Leads[more] | (code >> (6 * more)));
  for (int k = more - 1; k >= 0; --k)
  {
    text += static_cast<char>(0x80 | (code >> (6 * k) & 0x3f));
  }
}

/// Reads `digits` hexadecimal digits at `at`; returns false if there are fewer.
bool ReadHex(std::string_view text, std::size_t at, std::size_t digits, unsigned long& code)
{
  code = 0;
  for (std::size_t k = at; k < at + digits; ++k)
  {
    const char c = k < text.size() ? text[k] : ' ';
    const int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    if (digit < 0)
    {
      return false;
    }
    code = 16 * code + static_cast<unsigned long>(digit);
  }
  return true;
}

/// Decodes the escape at `at`, and moves `at` behind it. Returns false if it is incomplete or unknown.
bool DecodeEscape(std::string_view text, std::size_t& at, std::string& result)
{
  const std::string_view rest = text.substr(at);
  unsigned long code = 0;
  const auto begins = [&rest](std::string_view word) { return rest.compare(0, word.size(), word) == 0; };
  if (begins("''") || begins("\\\\"))
  {
    result += rest[0];
    at += 2;
    return true;
  }
  if (begins("\\N\\") || begins("\\F\\"))
  {
    at += 3;
    return true;
  }
  if (begins("\\X\\") && ReadHex(rest, 3, 2, code))
  {
    AppendUTF8(code, result);
    at += 5;
    return true;
  }
  if (begins("\\S\\") && rest.size() > 3)
  {
    AppendUTF8(static_cast<unsigned char>(rest[3]) + 0x80u, result);
    at += 4;
    return true;
  }
  const std::size_t digits = begins("\\X2\\") ? 4 : begins("\\X4\\") ? 8 : 0;
  std::size_t k = 4;
  std::string decoded;
  while (digits > 0 && ReadHex(rest, k, digits, code))
  {
    unsigned long low = 0;
    k += digits;
    if (code >= 0xd800 && code < 0xdc00 && ReadHex(rest, k, digits, low) && low >= 0xdc00 && low < 0xe000)
    {
      code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
      k += digits;
    }
    AppendUTF8(code, decoded);
  }
  if (digits == 0 || rest.compare(k, 4, "\\X0\\") != 0)
  {
    return false;
  }
  result += decoded;
  at += k + 4;
  return true;
}
}

std::string DecodePart21Text(std::string_view given)
{
  // Writers break long strings anywhere, also in an escape.
  std::string text(given);
  text.erase(
    std::remove_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }), text.end());
  std::string result;
  for (std::size_t at = 0; at < text.size();)
  {
    if ((text[at] != '\'' && text[at] != '\\') || !DecodeEscape(text, at, result))
    {
      result += text[at++];
    }
  }
  return result;
}
}
