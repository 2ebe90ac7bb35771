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

/// Returns true if `#<digits> =` begins at this place, that is, a new instance, even if the previous one is
/// not complete.
bool IsInstanceStart(const char* at, const char* end);

/// A position in the text. Each Skip… method moves it from the first character of a token to behind the last
/// one. If the token is malformed, it returns false, and the position is where that was detected.
struct SMREADERSPART21_EXPORT Part21Cursor
{
  const char* At;
  const char* End;

  bool IsAtEnd() const { return this->At == this->End; }
  char Peek() const { return this->At == this->End ? '\0' : *this->At; }

  /// Skips blanks, control characters and comments. Returns false at a comment without an end, which is not
  /// skipped.
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

  /// Skips a string between apostrophes, which may contain ''. If a line within it begins like an instance,
  /// the closing apostrophe is missing, and it returns false.
  bool SkipString();
  bool SkipBinary();
  bool SkipEnumeration();
  bool SkipResource();
  /// Skips a number. `real` is set to true if it has a point or an exponent.
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
  /// Skips a reference, # and digits. `fits` is set to false if the number exceeds 64 bits.
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

  /// Skips a keyword of letters, digits and _; that of a user-defined entity begins with !.
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
  /// Skips from an opening bracket behind the closing one. Returns false at a semicolon between them.
  bool SkipBrackets();
};
}

#endif
