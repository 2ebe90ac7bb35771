#include "smPart21Values.h"

#include "smPart21Cursor.h"

#include <array>
#include <charconv>
#include <cmath>

namespace sm
{
#define SM_B Part21Blank
#define SM_D Part21Digit
#define SM_L Part21Letter
// Kinds of all bytes. Control characters are blanks, because the standard requires a reader to ignore them.
// Bytes above 127 have no kind.
const unsigned char Part21Characters[256] = { SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B,
  SM_B, SM_B, SM_B, SM_B, SM_B, SM_B,                                                             //
  SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, SM_B, //
  SM_B, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,                                              //
  SM_D, SM_D, SM_D, SM_D, SM_D, SM_D, SM_D, SM_D, SM_D, SM_D, 0, 0, 0, 0, 0, 0,                   //
  0, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L,    //
  SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, 0, 0, 0, 0, SM_L,             //
  0, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L,    //
  SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, SM_L, 0, 0, 0, 0, 0 };
#undef SM_B
#undef SM_D
#undef SM_L

bool IsInstanceStart(const char* at, const char* end)
{
  if (at == end || *at != '#')
  {
    return false;
  }
  const char* digits = ++at;
  while (at != end && IsPart21(*at, Part21Digit))
  {
    ++at;
  }
  const bool numbered = at != digits;
  while (at != end && IsPart21(*at, Part21Blank))
  {
    ++at;
  }
  return numbered && at != end && *at == '=';
}

bool Part21Cursor::SkipComment()
{
  const std::string_view rest(this->At, static_cast<std::size_t>(this->End - this->At));
  const std::size_t end = rest.find("*/", 2);
  if (end == std::string_view::npos)
  {
    return false;
  }
  this->At += end + 2;
  return true;
}

bool Part21Cursor::SkipString()
{
  const char* at = this->At + 1;
  for (;;)
  {
    const void* found = std::memchr(at, '\'', static_cast<std::size_t>(this->End - at));
    const char* quote = found ? static_cast<const char*>(found) : this->End;
    for (const char* line = at;;)
    {
      line = static_cast<const char*>(std::memchr(line, '\n', static_cast<std::size_t>(quote - line)));
      if (!line)
      {
        break;
      }
      if (IsInstanceStart(++line, this->End))
      {
        return false;
      }
    }
    if (!found)
    {
      return false;
    }
    at = quote + 1;
    if (at == this->End || *at != '\'')
    {
      this->At = at;
      return true;
    }
    ++at;
  }
}

bool Part21Cursor::SkipBinary()
{
  ++this->At;
  while (this->At != this->End && IsPart21(*this->At, Part21Digit | Part21Letter))
  {
    ++this->At;
  }
  if (this->Peek() != '"')
  {
    return false;
  }
  ++this->At;
  return true;
}

bool Part21Cursor::SkipEnumeration()
{
  ++this->At;
  const char* start = this->At;
  while (this->At != this->End && IsPart21(*this->At, Part21Digit | Part21Letter))
  {
    ++this->At;
  }
  if (this->At == start || this->Peek() != '.' || IsPart21(*start, Part21Digit))
  {
    return false;
  }
  ++this->At;
  return true;
}

bool Part21Cursor::SkipResource()
{
  while (this->At != this->End && *this->At != '>' && *this->At != '\n')
  {
    ++this->At;
  }
  if (this->Peek() != '>')
  {
    return false;
  }
  ++this->At;
  return true;
}

bool Part21Cursor::IsWithin64Bits(std::string_view digits)
{
  std::uint64_t number = 0;
  return std::from_chars(digits.data(), digits.data() + digits.size(), number).ec == std::errc();
}

bool Part21Cursor::SkipBrackets()
{
  std::size_t depth = 0;
  while (this->At != this->End)
  {
    switch (*this->At)
    {
      case '\'':
        if (!this->SkipString())
        {
          return false;
        }
        continue;
      case '/':
        if (this->End - this->At > 1 && this->At[1] == '*')
        {
          if (!this->SkipComment())
          {
            return false;
          }
          continue;
        }
        break;
      case '(':
        ++depth;
        break;
      case ')':
        if (--depth == 0)
        {
          ++this->At;
          return true;
        }
        break;
      case ';':
        // The brackets of the record do not balance.
        return false;
      default:
        break;
    }
    ++this->At;
  }
  return false;
}

bool Part21Value::GetNumber(double& number) const
{
  if (!this->IsNumber())
  {
    return false;
  }
  const char* start = this->Text.data() + (this->Text[0] == '+' ? 1 : 0);
  const char* end = this->Text.data() + this->Text.size();
  const std::from_chars_result result = std::from_chars(start, end, number);
  // A number that is too small for a double becomes 0; one that is too large is refused.
  if (result.ec == std::errc::result_out_of_range && this->Text.find('-', 1) != std::string_view::npos)
  {
    number = 0.0;
    return true;
  }
  return result.ec == std::errc() && result.ptr == end && std::isfinite(number);
}

bool Part21Value::GetInteger(std::int64_t& number) const
{
  if (this->Kind != Part21Kind::Integer)
  {
    return false;
  }
  const char* start = this->Text.data() + (this->Text[0] == '+' ? 1 : 0);
  const char* end = this->Text.data() + this->Text.size();
  const std::from_chars_result result = std::from_chars(start, end, number);
  return result.ec == std::errc() && result.ptr == end;
}

namespace
{
std::string_view Between(const char* start, const char* end, std::size_t margin)
{
  return { start + margin, static_cast<std::size_t>(end - start) - 2 * margin };
}

bool ReadTyped(Part21Cursor& cursor, Part21Value& value)
{
  value.TypeName = cursor.SkipKeyword();
  if (!cursor.SkipBlanks() || cursor.Peek() != '(')
  {
    return false;
  }
  const char* start = cursor.At;
  if (!cursor.SkipBrackets())
  {
    return false;
  }
  value.Kind = Part21Kind::Typed;
  value.Text = Between(start, cursor.At, 1);
  return true;
}

bool ReadNumber(Part21Cursor& cursor, Part21Value& value)
{
  const char* start = cursor.At;
  bool real = false;
  if (!cursor.SkipNumber(real))
  {
    return false;
  }
  value.Kind = real ? Part21Kind::Real : Part21Kind::Integer;
  value.Text = Between(start, cursor.At, 0);
  return true;
}

/// Reads a token that is enclosed by one character on each side, which are removed.
bool ReadEnclosed(Part21Cursor& cursor, Part21Value& value, Part21Kind kind, bool (Part21Cursor::*skip)())
{
  const char* start = cursor.At;
  if (!(cursor.*skip)())
  {
    return false;
  }
  value.Kind = kind;
  value.Text = Between(start, cursor.At, 1);
  return true;
}

bool ReadValue(Part21Cursor& cursor, Part21Value& value)
{
  value = Part21Value();
  const char c = cursor.Peek();
  bool fits = true;
  switch (c)
  {
    case '$':
    case '*':
      value.Kind = c == '$' ? Part21Kind::Omitted : Part21Kind::Derived;
      value.Text = { cursor.At++, 1 };
      return true;
    case '#':
    {
      const char* start = cursor.At;
      const bool valid = cursor.SkipReference(value.Id, fits) && fits;
      value.Kind = valid ? Part21Kind::Reference : Part21Kind::Malformed;
      value.Text = Between(start, cursor.At, 0);
      return valid;
    }
    case '\'':
      return ReadEnclosed(cursor, value, Part21Kind::String, &Part21Cursor::SkipString);
    case '"':
      return ReadEnclosed(cursor, value, Part21Kind::Binary, &Part21Cursor::SkipBinary);
    case '(':
      return ReadEnclosed(cursor, value, Part21Kind::List, &Part21Cursor::SkipBrackets);
    case '<':
      return ReadEnclosed(cursor, value, Part21Kind::Resource, &Part21Cursor::SkipResource);
    case '.':
      return cursor.End - cursor.At > 1 && IsPart21(cursor.At[1], Part21Digit)
        ? ReadNumber(cursor, value)
        : ReadEnclosed(cursor, value, Part21Kind::Enumeration, &Part21Cursor::SkipEnumeration);
    default:
      return IsPart21(c, Part21Letter) || c == '!' ? ReadTyped(cursor, value) : ReadNumber(cursor, value);
  }
}
}

bool Part21Values::Next(Part21Value& value)
{
  Part21Cursor cursor{ this->At, this->End };
  bool valid = !this->Malformed && cursor.SkipBlanks();
  if (valid && cursor.IsAtEnd())
  {
    this->At = this->End;
    return false;
  }
  if (valid && !this->First)
  {
    valid = cursor.Peek() == ',';
    cursor.At += valid ? 1 : 0;
    valid = valid && cursor.SkipBlanks();
  }
  this->First = false;
  valid = valid && ReadValue(cursor, value);
  this->Malformed = !valid;
  this->At = cursor.At;
  if (!valid)
  {
    value.Kind = Part21Kind::Malformed;
  }
  return valid;
}

Part21Value GetPart21Value(std::string_view text, std::size_t index)
{
  Part21Values values(text);
  Part21Value value;
  for (std::size_t i = 0; values.Next(value); ++i)
  {
    if (i == index)
    {
      return value;
    }
  }
  return {};
}

std::string FormatPart21Real(double value)
{
  std::array<char, 40> digits;
  const auto end =
    std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::scientific).ptr;
  std::string text(digits.data(), end);
  const std::size_t exponent = text.find('e');
  if (text.find('.') == std::string::npos)
  {
    text.insert(exponent, ".");
  }
  text[text.find('e')] = 'E';
  return text;
}
}
