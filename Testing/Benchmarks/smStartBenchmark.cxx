// Benchmark start FILE.step...: what a process takes to start, and small files with it.
#include "smBenchmark.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{
using Command = std::vector<std::string>;

/// What the runs of a command took.
struct Cost
{
  double Seconds = HUGE_VAL; ///< the minimum, of the processor, with the processes that it started
  double Megabytes = 0.0;    ///< the largest process
  bool IsDone = true;
};

/// Starts the command without output. Returns its exit status, and adds what it took; -1 if it did not exit.
int Run(const Command& command, Cost& cost)
{
  const pid_t child = fork();
  if (child == 0)
  {
    const int null = open("/dev/null", O_WRONLY);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    std::vector<char*> words;
    for (const std::string& word : command)
    {
      words.push_back(const_cast<char*>(word.c_str()));
    }
    words.push_back(nullptr);
    execvp(words[0], words.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || !WIFEXITED(status))
  {
    return -1;
  }
  const auto toSeconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  cost.Seconds = std::min(cost.Seconds, toSeconds(usage.ru_utime) + toSeconds(usage.ru_stime));
  cost.Megabytes = std::max(cost.Megabytes, static_cast<double>(usage.ru_maxrss) / 1024.0);
  return WEXITSTATUS(status);
}

/// Returns the number of libraries that the loader maps before the program begins.
int CountLibraries(const std::string& program)
{
  int lines = 0;
  if (std::FILE* pipe = popen(("LD_TRACE_LOADED_OBJECTS=1 '" + program + "'").c_str(), "r"))
  {
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
    {
      lines += c == '\n' ? 1 : 0;
    }
    pclose(pipe);
  }
  return lines;
}

struct Options
{
  int Runs = 20;
  std::string Python;
  std::vector<std::string> Files;
};

/// Prints a row; returns false if a run failed. Status 3: computed, and flagged.
bool Measure(const std::string& name, const Command& command, const Options& options, std::size_t files)
{
  Cost cost;
  for (int i = 0; i < options.Runs; ++i)
  {
    const int status = Run(command, cost);
    cost.IsDone = cost.IsDone && (status == 0 || (files > 1 && status == 3));
  }
  std::printf("| %s | %.4f | %.0f | %d | %s |\n", name.c_str(), cost.Seconds, cost.Megabytes,
    CountLibraries(command[0]),
    !cost.IsDone   ? "failed"
      : files == 0 ? ""
                   : std::to_string(static_cast<int>(static_cast<double>(files) / cost.Seconds)).c_str());
  std::fflush(stdout);
  return cost.IsDone;
}

int PrintTable(const Options& options)
{
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string program = folder / "solidmoments";
  const std::string& file = options.Files.front();
  Command all = { program, "--quiet", "--backend", "cpu" };
  const Command one = { program, "--quiet", "--backend", "cpu", file };
  all.insert(all.end(), options.Files.begin(), options.Files.end());
  std::printf("| command, minimum of %d runs | processor seconds | MB | libraries at the start | files a "
              "second of a processor |\n"
              "|---|---|---|---|---|\n",
    options.Runs);
  bool isDone = Measure("solidmoments --version", { program, "--version" }, options, 0);
  isDone = Measure("solidmoments, one file", one, options, 1) && isDone;
  isDone = Measure("solidmoments, " + std::to_string(options.Files.size()) + " files", all, options,
             options.Files.size()) &&
    isDone;
  isDone = Measure("OpenCASCADE, one file", { folder / "occt_mass_properties", file }, options, 1) && isDone;
  if (!options.Python.empty())
  {
    isDone = Measure("python3", { options.Python, "-c", "pass" }, options, 0) && isDone;
    isDone =
      Measure("import solidmoments", { options.Python, "-c", "import solidmoments" }, options, 0) && isDone;
    isDone = Measure("mass_properties()",
               { options.Python, "-c",
                 "import sys, solidmoments; solidmoments.mass_properties(sys.argv[1], backend='cpu')", file },
               options, 1) &&
      isDone;
  }
  return isDone ? 0 : 1;
}

void Add(CLI::App& app, int& status)
{
  static Options options;
  CLI::App* command = app.add_subcommand("start",
    "What processes take to start and to work on small files: the minimum of the processor seconds of "
    "several runs. "
    "The programs are those next to this one. Exit status 1: one failed");
  command->add_option("--runs", options.Runs, "runs of each command")->check(CLI::PositiveNumber);
  command->add_option("--python", options.Python, "Python, whose PYTHONPATH has the package solidmoments");
  command->add_option("FILE", options.Files, "small STEP files")->required();
  command->callback([&status]() { status = PrintTable(options); });
}
const smtest::BenchmarkEntry Entry(Add);
}
