/**
 * @file smDecimalCommas.h
 * @brief A locale with decimal commas for tests of texts
 */
#ifndef smDecimalCommas_h
#define smDecimalCommas_h

#include <clocale>
#include <locale>
#include <string>

namespace smtest
{
/// Numbers in C++ streams have a decimal comma while this object lives; those of printf and std::to_string,
/// too, where LOCPATH has the locale de_DE.UTF-8.
class DecimalCommas
{
public:
  DecimalCommas()
    : StreamsBefore(std::locale::global(std::locale(std::locale(), new Punctuation)))
    , NumbersBefore(std::setlocale(LC_NUMERIC, nullptr))
  {
    std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  }
  ~DecimalCommas()
  {
    std::locale::global(this->StreamsBefore);
    std::setlocale(LC_NUMERIC, this->NumbersBefore.c_str());
  }
  DecimalCommas(const DecimalCommas&) = delete;
  DecimalCommas& operator=(const DecimalCommas&) = delete;

private:
  class Punctuation : public std::numpunct<char>
  {
  protected:
    char do_decimal_point() const override { return ','; }
  };

  std::locale StreamsBefore;
  std::string NumbersBefore;
};
}

#endif
