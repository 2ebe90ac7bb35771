/**
 * @file smRates.h
 * @brief Calls a second, by Google Benchmark where it is installed
 */
#ifndef smRates_h
#define smRates_h

#include <functional>
#include <string>

namespace smtest
{
/// Returns how often `call` runs in a second of the clock. It runs for at least `seconds`, and once.
double MeasureRate(const std::string& name, double seconds, const std::function<void()>& call);

/// How MeasureRate() measures: "Google Benchmark", or "a loop".
const char* GetRateMethod();
}

#endif
