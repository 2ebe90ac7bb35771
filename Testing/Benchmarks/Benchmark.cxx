// Benchmark speed|start|accuracy|scale|edit|instances ...: measures stages, the start, errors, growth, edits
// and instances.
// Exit status 1: wrong usage, or a subcommand's result is wrong, as its help says.
#include "smBenchmark.h"

#include <cstdio>
#include <exception>

std::vector<smtest::AddBenchmark>& smtest::GetBenchmarks()
{
  static std::vector<AddBenchmark> benchmarks;
  return benchmarks;
}

int main(int argc, char* argv[])
{
  CLI::App app("Measures SolidMoments; the developer guide says what for.", "Benchmark");
  app.require_subcommand(1);
  int status = 0;
  for (const smtest::AddBenchmark add : smtest::GetBenchmarks())
  {
    add(app, status);
  }
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return status;
}
