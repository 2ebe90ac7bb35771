// A value and its bound, rounded for display, still hold: the interval that is shown contains the interval that was computed.
#include "smFormat.h"
#include "smTesting.h"

#include <algorithm>
#include <random>

namespace
{
/// Reads a number as a long double, more precisely than the nearest double.
long double Read(const std::string& text)
{
  return std::strtold(text.c_str(), nullptr);
}
}

int TestFormat(int, char*[])
{
  using namespace smtest;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-17.0, 17.0);
  std::uniform_real_distribution<double> mantissa(-10.0, 10.0);
  int exceeded = 0;
  double widest = 0.0;
  double farthest = 0.0;
  std::size_t longest = 0;
  for (int i = 0; i < 200000; ++i)
  {
    const double bound = std::pow(10.0, 0.5 * exponent(random));
    const double value = mantissa(random) * std::pow(10.0, 0.5 * exponent(random));
    // No computed value is known better.
    for (int digits = bound < 1e-15 * std::abs(value) ? 3 : 1; digits <= 2; ++digits)
    {
      const std::string text = sm::FormatNumber(value, bound);
      const long double shown = Read(sm::FormatBoundOfShown(bound, digits));
      const long double off = std::abs(Read(text) - value);
      exceeded += off + bound > shown ? 1 : 0;
      widest = std::max(widest, static_cast<double>(shown / bound));
      farthest = std::max(farthest, static_cast<double>(off / bound));
      longest = std::max(longest, text.size());
      exceeded += Read(sm::FormatBound(bound, digits)) < bound ? 1 : 0;
    }
  }
  Check("shown bounds that do not hold", 0, exceeded, 0);
  CheckRange("the widest shown bound by the bound", 1.5, widest, 2.11, "1.05 with one digit, rounded up");
  CheckRange("rounding of values by their bound", 0.02, farthest, 0.05);
  CheckRange("longest value", 17, static_cast<double>(longest), 24, "17 digits, sign, point, exponent");

  CheckEqual("128/3 and its bound", "42.666666666667", sm::FormatNumber(128.0 / 3.0, 1.4e-11));
  CheckEqual("a value far below its bound", "0", sm::FormatNumber(-1e-17, 1e-12));
  CheckEqual("a value without error", "0.1", sm::FormatNumber(0.1, 0.0));
  CheckEqual("no bound", " (bound not known)", sm::FormatBoundNote(HUGE_VAL));
  CheckEqual("no value", "not known", sm::FormatWithBound(std::nan(""), 1.0, "mm"));
  return Finish();
}
