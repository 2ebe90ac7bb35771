#include "smRates.h"

#ifdef SM_HAS_GOOGLE_BENCHMARK

#include <benchmark/benchmark.h>

namespace smtest
{
namespace
{
class RateReporter : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs)
    {
      this->Rate = static_cast<double>(run.iterations) / run.real_accumulated_time;
    }
  }

  double Rate = 0.0;
};
}

double MeasureRate(const std::string& name, double seconds, const std::function<void()>& call)
{
  benchmark::ClearRegisteredBenchmarks();
  benchmark::RegisterBenchmark(name.c_str(),
    [&call](benchmark::State& state)
    {
      for (auto _ : state)
      {
        call();
      }
    })
    ->UseRealTime()
    ->MinTime(seconds);
  RateReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return reporter.Rate;
}

const char* GetRateMethod()
{
  return "Google Benchmark";
}
}

#else

#include <chrono>

namespace smtest
{
double MeasureRate(const std::string&, double seconds, const std::function<void()>& call)
{
  const auto start = std::chrono::steady_clock::now();
  double elapsed = 0.0;
  int calls = 0;
  do
  {
    call();
    ++calls;
    elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  } while (elapsed < seconds);
  return calls / elapsed;
}

const char* GetRateMethod()
{
  return "a loop, as Google Benchmark was not found by CMake";
}
}

#endif
