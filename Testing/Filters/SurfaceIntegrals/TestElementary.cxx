// The elementary functions of smElementary.glsl, compiled as C++: against the C library's in extended
// precision.
#include "smPortableCxx.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

// Not all functions of a chunk are called here.
namespace chunk
{
#include "glsl/smErrorFree.glsl"

#include "glsl/smElementary.glsl"
}

namespace
{
using namespace chunk;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr int Samples = 400000;

/// The error in units of the last place of the exact value, those of subnormal numbers being one size.
double GetUnits(long double exact, double actual)
{
  const double rounded = static_cast<double>(exact);
  if (!std::isfinite(rounded) || !std::isfinite(actual))
  {
    return rounded == actual || (std::isnan(rounded) && std::isnan(actual)) ? 0.0 : Infinity;
  }
  const int exponent = std::max(rounded == 0.0 ? -1022 : std::ilogb(rounded), -1022);
  return static_cast<double>(std::fabs(std::ldexp(static_cast<long double>(actual) - exact, 52 - exponent)));
}

using Draw = std::function<double(std::mt19937_64&)>;

Draw Uniform(double low, double high)
{
  return [=](std::mt19937_64& random) { return std::uniform_real_distribution<double>(low, high)(random); };
}

/// A number of either sign, with all exponents in the range equally likely.
Draw Logarithmic(int low, int high, bool negative)
{
  return [=](std::mt19937_64& random)
  {
    const double value = std::ldexp(std::uniform_real_distribution<double>(1.0, 2.0)(random),
      std::uniform_int_distribution<int>(low, high)(random));
    return negative && random() % 2 == 0 ? -value : value;
  };
}

void CheckFunction(const std::string& name, double (*actual)(double), long double (*exact)(long double),
  const Draw& draw, double limit)
{
  std::mt19937_64 random(5);
  double worst = 0.0;
  double where = 0.0;
  for (int i = 0; i < Samples; ++i)
  {
    const double x = draw(random);
    const double units = GetUnits(exact(x), actual(x));
    if (!(units <= worst))
    {
      worst = units;
      where = x;
    }
  }
  smtest::CheckRange(
    name, 0.0, worst, limit, ("units in the last place, at " + std::to_string(where)).c_str());
}

void CheckPower(const std::string& name, const Draw& drawX, const Draw& drawY)
{
  std::mt19937_64 random(7);
  double worst = 0.0;
  for (int i = 0; i < Samples; ++i)
  {
    const double x = drawX(random);
    const double y = drawY(random);
    worst = std::max(
      worst, GetUnits(std::pow(static_cast<long double>(x), static_cast<long double>(y)), smPow(x, y)));
  }
  smtest::CheckRange(name, 0.0, worst, 2.0, "units in the last place");
}

void CheckRanges()
{
  const auto sine = [](long double x) { return std::sin(x); };
  const auto cosine = [](long double x) { return std::cos(x); };
  const auto tangent = [](long double x) { return std::tan(x); };
  const double angle = 1048576.0;
  CheckFunction("sin, |x| <= 2^20", smSin, sine, Uniform(-angle, angle), 2.0);
  CheckFunction("cos, |x| <= 2^20", smCos, cosine, Uniform(-angle, angle), 2.0);
  CheckFunction("tan, |x| <= 2^20", smTan, tangent, Uniform(-angle, angle), 3.0);
  CheckFunction("sin, every size", smSin, sine, Logarithmic(-1022, 19, true), 2.0);
  CheckFunction("cos, every size", smCos, cosine, Logarithmic(-1022, 19, true), 2.0);
  CheckFunction("tan, every size", smTan, tangent, Logarithmic(-1022, 19, true), 3.0);
  // The doubles nearest to multiples of pi/2, where all digits cancel.
  const Draw nearZero = [](std::mt19937_64& random)
  {
    return static_cast<double>(
      std::acos(-1.0L) / 2 * std::uniform_int_distribution<int>(-660000, 660000)(random));
  };
  CheckFunction("sin near multiples of pi/2", smSin, sine, nearZero, 2.0);
  CheckFunction("cos near multiples of pi/2", smCos, cosine, nearZero, 2.0);
  CheckFunction("tan near multiples of pi/2", smTan, tangent, nearZero, 3.0);

  const auto exponential = [](long double x) { return std::exp(x); };
  const auto logarithm = [](long double x) { return std::log(x); };
  CheckFunction("exp, everywhere", smExp, exponential, Uniform(-760.0, 720.0), 2.0);
  CheckFunction("exp, near 0", smExp, exponential, Logarithmic(-1060, 3, true), 2.0);
  CheckFunction("log, everywhere", smLog, logarithm, Logarithmic(-1074, 1023, false), 2.0);
  CheckFunction("log, near 1", smLog, logarithm, Uniform(0.5, 2.0), 2.0);
  CheckFunction("log, at 1", smLog, logarithm, Uniform(1.0 - 1e-9, 1.0 + 1e-9), 2.0);
  CheckPower("pow, moderate", Uniform(0.0, 10.0), Uniform(-20.0, 20.0));
  CheckPower("pow, large results", Logarithmic(-1022, 1022, false), Logarithmic(-12, 10, true));
  CheckPower("pow, bases near 1", Uniform(0.999, 1.001), Uniform(-7e5, 7e5));
  const Draw integers = [](std::mt19937_64& random) { return std::floor(Uniform(-40.0, 40.0)(random)); };
  CheckPower("pow, negative bases", Uniform(-10.0, 0.0), integers);
}

void CheckSame(const std::string& what, double expected, double actual)
{
  const bool same = std::isnan(expected)
    ? std::isnan(actual)
    : expected == actual && std::signbit(expected) == std::signbit(actual);
  smtest::CheckTrue(what, same, std::to_string(actual));
}

void CheckSpecialValues()
{
  CheckSame("sin 0", 0.0, smSin(0.0));
  CheckSame("cos 0", 1.0, smCos(0.0));
  CheckSame("sin beyond the range", NotANumber, smSin(1048577.0));
  CheckSame("cos of infinity", NotANumber, smCos(Infinity));
  CheckSame("tan of no number", NotANumber, smTan(NotANumber));
  CheckSame("exp 0", 1.0, smExp(0.0));
  CheckSame("exp of infinity", Infinity, smExp(Infinity));
  CheckSame("exp of -infinity", 0.0, smExp(-Infinity));
  CheckSame("exp of no number", NotANumber, smExp(NotANumber));
  CheckSame("exp that overflows", Infinity, smExp(710.0));
  CheckSame("log 0", -Infinity, smLog(0.0));
  CheckSame("log 1", 0.0, smLog(1.0));
  CheckSame("log of a negative number", NotANumber, smLog(-1.0));
  CheckSame("log of infinity", Infinity, smLog(Infinity));
  CheckSame("log of no number", NotANumber, smLog(NotANumber));
  const double values[] = { 0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 2.0, -2.0, 3.0, -3.0, 1e300, -1e300, 1e-300,
    Infinity, -Infinity, NotANumber, 9007199254740993.0 };
  for (const double x : values)
  {
    for (const double y : values)
    {
      const double exact = std::pow(x, y);
      const double actual = smPow(x, y);
      smtest::CheckTrue("pow(" + std::to_string(x) + ", " + std::to_string(y) + ")",
        GetUnits(exact, actual) <= 2.0 && (std::isnan(exact) || std::signbit(exact) == std::signbit(actual)),
        std::to_string(actual));
    }
  }
}
}

int TestElementary(int, char*[])
{
  CheckRanges();
  CheckSpecialValues();
  return smtest::Finish();
}
