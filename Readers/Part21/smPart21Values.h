/**
 * @file smPart21Values.h
 * @brief The parameters of a record of a STEP file (ISO 10303-21, clear text encoding), read from the text
 * when they are asked for
 */
#ifndef smPart21Values_h
#define smPart21Values_h

#include "smReadersPart21Module.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sm
{
enum class Part21Kind : unsigned char
{
  Omitted,     ///< $
  Derived,     ///< *
  Integer,     ///< 12
  Real,        ///< 1.5E-7
  String,      ///< 'text'; Text is without the apostrophes, '' and \X2\ are as in the file
  Binary,      ///< "0FF"
  Enumeration, ///< .MILLI. or .T.; Text has no dots
  Reference,   ///< #12; Id is the number
  List,        ///< (…); Text is without the brackets
  Typed,       ///< LENGTH_MEASURE(25.4); Text is "25.4", TypeName is "LENGTH_MEASURE"
  Resource,    ///< <…> of the third edition
  Malformed    ///< any other text
};

/// One parameter. The views point into the text of the file.
struct SMREADERSPART21_EXPORT Part21Value
{
  Part21Kind Kind = Part21Kind::Malformed;
  std::string_view Text;
  std::string_view TypeName;
  std::uint64_t Id = 0;

  bool IsReference() const { return this->Kind == Part21Kind::Reference; }
  bool IsList() const { return this->Kind == Part21Kind::List; }
  bool IsNumber() const { return this->Kind == Part21Kind::Integer || this->Kind == Part21Kind::Real; }
  /// Gets the number of an Integer or a Real, independent of the locale. Returns false for other kinds and
  /// for numbers that exceed the range of double.
  bool GetNumber(double& number) const;
  /// Gets the number of an Integer. Returns false for other kinds and for numbers beyond 64 bits.
  bool GetInteger(std::int64_t& number) const;
};

/**
 * The comma-separated values of a list or of a record's parameters, one after the other:
 *
 *     Part21Values values(text);
 *     for (Part21Value value; values.Next(value);) …
 *
 * A nested list is one value; its own values are those of Part21Values(value.Text). Reading all values takes
 * time in proportion to the text, however deep lists are nested, since an inner list is skipped and not
 * entered. Nothing is allocated.
 */
class SMREADERSPART21_EXPORT Part21Values
{
public:
  explicit Part21Values(std::string_view text)
    : At(text.data())
    , End(text.data() + text.size())
  {
  }

  /// Reads the next value. Returns false at the end, and at text that is not a value, where IsMalformed()
  /// becomes true.
  bool Next(Part21Value& value);
  bool IsMalformed() const { return this->Malformed; }

private:
  const char* At;
  const char* End;
  bool First = true;
  bool Malformed = false;
};

/// Returns value number `index` (from 0); one of kind Malformed if there are fewer values.
SMREADERSPART21_EXPORT Part21Value GetPart21Value(std::string_view text, std::size_t index);

/// Formats a real number, which must have a point, with all its digits.
SMREADERSPART21_EXPORT std::string FormatPart21Real(double value);
}

#endif
