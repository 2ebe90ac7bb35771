/**
 * @file smBenchmark.h
 * @brief The subcommands of the program Benchmark, each of which a file adds
 */
#ifndef smBenchmark_h
#define smBenchmark_h

#include <CLI/CLI.hpp>

#include <vector>

namespace smtest
{
/// Adds a subcommand, whose callback sets the exit status of the program.
using AddBenchmark = void (*)(CLI::App& app, int& status);

std::vector<AddBenchmark>& GetBenchmarks();

/// A static object of this type adds a subcommand to the program that its file is linked to.
struct BenchmarkEntry
{
  explicit BenchmarkEntry(AddBenchmark add) { GetBenchmarks().push_back(add); }
};
}

#endif
