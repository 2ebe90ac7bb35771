/**
 * @file smTesting.h
 * @brief Checks of all test programs, which print expected, actual, difference and limit
 *
 * A program calls the checks and returns smtest::Finish(). A program that ran no check fails, so that a
 * loop over nothing cannot pass.
 */
#ifndef smTesting_h
#define smTesting_h

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace smtest
{
/// CTest's SKIP_RETURN_CODE: the machine cannot run the test. The reference platform (Xvfb + llvmpipe) never
/// returns it.
constexpr int Skipped = 77;

struct Counts
{
  int Checks = 0;
  int Failures = 0;
};

inline Counts& GetCounts()
{
  static Counts counts;
  return counts;
}

/// Ends the program with an error and its usage unless its arguments are right.
inline void RequireUsage(bool isRight, const char* usage)
{
  if (!isRight)
  {
    std::fprintf(stderr, "usage: %s\n", usage);
    std::exit(EXIT_FAILURE);
  }
}

inline bool Record(bool passed)
{
  ++GetCounts().Checks;
  GetCounts().Failures += passed ? 0 : 1;
  return passed;
}

/// Checks |actual - expected| <= limit, and prints the result. A NaN fails. `reason` says where the limit
/// comes from.
inline bool Check(
  const std::string& what, double expected, double actual, double limit, const char* reason = "")
{
  const double difference = actual - expected;
  const bool passed = std::fabs(difference) <= limit;
  std::printf("%s %-44s expected % .17g actual % .17g difference % .2e limit %.2e %s\n",
    passed ? "ok  " : "FAIL", what.c_str(), expected, actual, difference, limit, reason);
  return Record(passed);
}

/// Checks low <= actual <= high, and prints the result. A NaN fails.
inline bool CheckRange(
  const std::string& what, double low, double actual, double high, const char* reason = "")
{
  const bool passed = actual >= low && actual <= high;
  std::printf("%s %-44s actual % .17g range [%g, %g] %s\n", passed ? "ok  " : "FAIL", what.c_str(), actual,
    low, high, reason);
  return Record(passed);
}

inline bool CheckTrue(const std::string& what, bool passed, const std::string& detail = "")
{
  std::printf("%s %-44s %s\n", passed ? "ok  " : "FAIL", what.c_str(), detail.c_str());
  return Record(passed);
}

inline bool CheckEqual(const std::string& what, const std::string& expected, const std::string& actual)
{
  const bool passed = expected == actual;
  std::printf("%s %-44s expected \"%s\" actual \"%s\"\n", passed ? "ok  " : "FAIL", what.c_str(),
    expected.c_str(), actual.c_str());
  return Record(passed);
}

inline bool CheckEqual(const std::string& what, long long expected, long long actual)
{
  const bool passed = expected == actual;
  std::printf(
    "%s %-44s expected %lld actual %lld\n", passed ? "ok  " : "FAIL", what.c_str(), expected, actual);
  return Record(passed);
}

/// The program's exit status.
inline int Finish()
{
  const Counts& counts = GetCounts();
  std::printf("%d checks, %d failed\n", counts.Checks, counts.Failures);
  std::fflush(stdout);
  return counts.Checks > 0 && counts.Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

#endif
