/**
 * @file smPart21Cursor.h
 * @brief The tokens of ISO 10303-21, one by one, without allocation
 */
#ifndef smPart21Cursor_h
#define smPart21Cursor_h

#include "smReadersPart21Module.h"

#include <cstdint>
#include <cstring>
#include <string_view>

namespace sm
{
/// Kinds of characters, as bits.
enum Part21Character : unsigned char
{
  Part21Blank = 1,
  Part21Digit = 2,
  Part21Letter = 4
};
extern SMREADERSPART21_EXPORT const unsigned char Part21Characters[256];

inline bool IsPart21(char c, unsigned char kinds)
{
  return (Part21Characters[static_cast<unsigned char>(c)] & kinds) != 0;
}

/// True when `#<digits> =` begins there: a new instance, whatever stood before.
bool IsInstanceStart(const char* at, const char* end);

/// A place in the text. Each Skip… begins at the first character of its token and ends behind the last; false when the token is
/// malformed, then the place is where that shows.
struct SMREADERSPART21_EXPORT Part21Cursor
{
  const char* At;
  const char* End;

  bool IsAtEnd() const { return this->At == this->End; }
  char Peek() const { return this->At == this->End ? '\0' : *this->At; }

  /// Blanks, control characters and comments. False at a comment without an end, which is not skipped.
  bool SkipBlanks()
  {
    for (;;)
    {
      while (this->At != this->End && IsPart21(*this->At, Part21Blank))
      {
        ++this->At;
      }
      if (this->End - this->At < 2 || this->At[0] != '/' || this->At[1] != '*')
      {
        return true;
      }
      if (!this->SkipComment())
      {
        return false;
      }
    }
  }
  bool SkipComment();

  /// An apostrophe to its partner, '' within. A line within it that begins like an instance shows that the partner is missing.
  bool SkipString();
  bool SkipBinary();
  bool SkipEnumeration();
  bool SkipResource();
  /// `real` tells whether it has a point or an exponent.
  bool SkipNumber(bool& real)
  {
    this->SkipSign();
    bool digits = this->SkipDigits();
    real = this->Peek() == '.';
    if (real)
    {
      ++this->At;
      // Some systems write .5 for 0.5.
      digits = this->SkipDigits() || digits;
    }
    if (digits && (this->Peek() == 'E' || this->Peek() == 'e'))
    {
      real = true;
      ++this->At;
      this->SkipSign();
      digits = this->SkipDigits();
    }
    return digits;
  }
  /// # and digits; `fits` is false when the number is beyond 64 bits.
  bool SkipReference(std::uint64_t& id, bool& fits)
  {
    const char* start = ++this->At;
    id = 0;
    while (this->At != this->End && IsPart21(*this->At, Part21Digit))
    {
      id = 10 * id + static_cast<std::uint64_t>(*this->At++ - '0');
    }
    fits = this->At - start < 19 || IsWithin64Bits({ start, static_cast<std::size_t>(this->At - start) });
    return this->At != start;
  }
  bool SkipDigits()
  {
    const char* start = this->At;
    while (this->At != this->End && IsPart21(*this->At, Part21Digit))
    {
      ++this->At;
    }
    return this->At != start;
  }
  void SkipSign() { this->At += this->Peek() == '+' || this->Peek() == '-' ? 1 : 0; }
  static bool IsWithin64Bits(std::string_view digits);

  /// A name of letters, digits and _, with ! before that of a user's own.
  std::string_view SkipKeyword()
  {
    const char* start = this->At;
    this->At += this->At != this->End && *this->At == '!' ? 1 : 0;
    while (this->At != this->End && IsPart21(*this->At, Part21Letter | Part21Digit))
    {
      ++this->At;
    }
    return { start, static_cast<std::size_t>(this->At - start) };
  }
  /// An opening bracket to its closing one. False at a semicolon between them.
  bool SkipBrackets();
};
}

#endif
