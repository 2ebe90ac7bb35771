// A value and its bound, rounded for display, still hold: the interval that is shown contains the interval
// that was computed.
#include "smFormat.h"
#include "smTesting.h"

#include <algorithm>
#include <limits>
#include <random>
#include <sstream>

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
  CheckEqual(
    "gaps above the bound", "42.66 mm^3 (+- 0.1, gaps 40)", sm::FormatWithBound(42.66, 0.09, "mm^3", 39.2));
  CheckEqual("gaps below the bound", "42.66 mm^3 (+- 0.1)", sm::FormatWithBound(42.66, 0.09, "mm^3", 0.05));
  CheckEqual("a spread, rounded up", "1 mm^3 (+- 0.1, spread 1.3)",
    sm::FormatWithBound(1.0, 0.09, "mm^3", 1.21, "spread"));
  CheckEqual("an unknown spread", "1 mm^3 (+- 0.1, spread not known)",
    sm::FormatWithBound(1.0, 0.09, "mm^3", std::nan(""), "spread"));
  CheckEqual("no value", "not known", sm::FormatWithBound(std::nan(""), 1.0, "mm"));

  CheckEqual("counts", "0 faces, 1 face, 2 faces",
    sm::FormatCount(0, "face", "faces") + ", " + sm::FormatCount(1, "face", "faces") + ", " +
      sm::FormatCount(2, "face", "faces"));
  CheckEqual("the largest count", "18446744073709551615 faces",
    sm::FormatCount(std::numeric_limits<std::size_t>::max(), "face", "faces"));

  // The view of a picked part broke this text after "(+-".
  const std::string part =
    "rail (solid 3): mass 0.972 kg (+- 6e-15), volume 360000 mm^3 (+- 2e-09), area 39600 mm^2 (+- 2e-09)";
  CheckEqual("a bound is not divided",
    "rail (solid 3): mass 0.972 kg (+- 6e-15), volume 360000 mm^3\n"
    "(+- 2e-09), area 39600 mm^2 (+- 2e-09)\n",
    sm::WrapText(part, 64));
  CheckEqual("number and unit stay together", "inertia\n-5.5e-05 kg mm^2\n(+- 4e-10)\n",
    sm::WrapText("inertia -5.5e-05 kg mm^2 (+- 4e-10)", 16));
  CheckEqual("blanks and line ends are one blank, words are not divided",
    "incommensurable\n3 faces\nin\nall\n", sm::WrapText("incommensurable \n 3 faces  in all", 4));
  CheckEqual("nothing", "", sm::WrapText(" \n", 10));
  int divided = 0;
  int tooLong = 0;
  for (std::size_t width = 1; width <= part.size(); ++width)
  {
    std::istringstream lines(sm::WrapText(part, width));
    std::string joined;
    for (std::string line; std::getline(lines, line);)
    {
      joined += (joined.empty() ? "" : " ") + line;
      const std::string last = line.substr(line.find_last_of(' ') + 1);
      divided += last == "(+-" || last.find_first_not_of("0123456789.e-+") == std::string::npos ? 1 : 0;
      // The longest value is "360000 mm^3".
      tooLong += line.size() > std::max<std::size_t>(width, 11) ? 1 : 0;
    }
    divided += joined == part ? 0 : 1;
  }
  Check("values that are divided in lines of any length", 0, divided, 0);
  Check("lines that are too long", 0, tooLong, 0);
  return Finish();
}
