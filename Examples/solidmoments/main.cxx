// solidmoments: mass properties of STEP and BREP files, integrated on the GPU.

#include "smArguments.h"
#include "smComparisonTable.h"
#include "smInputFile.h"
#include "smJobQueue.h"
#include "smOutputFiles.h"
#include "smReportFiles.h"
#include "smStabilityAnalysis.h"
#include "smText.h"
#include "smValidationFile.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace
{

/// A line that is rewritten on a terminal; prints nothing to a file or a pipe.
class ProgressLine
{
public:
  explicit ProgressLine(bool wanted)
    : Active(wanted && isatty(STDERR_FILENO))
  {
  }

  void Show(const std::string& head, const std::string& stage, double fraction)
  {
    if (this->Active)
    {
      std::fprintf(
        stderr, "\r%s  %s %3ld %%\033[K", head.c_str(), stage.c_str(), std::lround(100.0 * fraction));
      std::fflush(stderr);
    }
  }

  void Clear()
  {
    if (this->Active)
    {
      std::fputs("\r\033[K", stderr);
      std::fflush(stderr);
    }
  }

private:
  bool Active;
};

/// Opens /dev/null, in the wrong direction, for every standard stream that the caller closed. Files and pipes
/// cannot get its descriptor then, and writing to a closed standard output fails as it should.
void OccupyStandardStreams()
{
  for (const auto& [stream, mode] : { std::pair(STDIN_FILENO, O_RDONLY), std::pair(STDOUT_FILENO, O_RDONLY),
         std::pair(STDERR_FILENO, O_WRONLY) })
  {
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", mode) < 0)
    {
      _exit(sm::UsageOrOutput);
    }
  }
}

/// Combines the exit statuses of two results.
int Combine(int a, int b)
{
  return a == sm::AllOk ? b : b == sm::AllOk ? a : std::min(a, b);
}

/// Returns the message with the reason why nothing was computed, otherwise the last message.
std::string FindReason(const sm::FileResult& file)
{
  std::string reason;
  for (const std::string& message : file.Messages)
  {
    reason = message;
    if (reason.rfind("nothing was computed: ", 0) == 0)
    {
      break;
    }
  }
  return reason;
}

/// Describes a status that is not ok by the first message, or by the one about bounds if these are what is
/// wrong.
std::string DescribeStatus(const sm::FileResult& file)
{
  std::string said = file.Messages.empty() ? std::string() : file.Messages.front();
  for (const std::string& message : file.Messages)
  {
    said = file.Status == "tolerance-not-met" && message.find("above the tolerance") != std::string::npos
      ? message
      : said;
  }
  return "is " + file.Status + (said.empty() ? "" : ": " + said) +
    (file.Messages.size() < 2 ? "" : " (one of " + std::to_string(file.Messages.size()) + " messages)");
}

/// Describes what fails of a file that can be read, by the statuses and the requirements of the user; empty
/// if nothing does.
std::string FindFailures(const sm::FileResult& file, const sm::Arguments& arguments)
{
  const auto has = [](const std::vector<std::string>& list, const std::string& word)
  { return std::find(list.begin(), list.end(), word) != list.end(); };
  std::string failures;
  const auto add = [&failures](bool fails, const std::string& text) {
    failures += !fails ? "" : failures.empty() ? text : ", and " + text;
  };
  const auto* stability = file.Total.Analyses.Find<sm::StabilityResult>();
  const bool isStable = stability && stability->Verdict == "stable";
  add(has(arguments.Require, "stable") && !isStable, "is not stable");
  add(has(arguments.Require, "mass") && !file.Total.Mass.IsKnown(), "has no mass");
  add(has(arguments.Require, "validation") && sm::CountValidation(file, "fail") > 0,
    "has other values than it states");
  add(sm::GetExitStatus(file) == sm::Flagged && has(arguments.FailOn, file.Status), DescribeStatus(file));
  return failures;
}

/// Returns the exit status of a finished file.
int Judge(const sm::FileResult& file, const std::string& failures)
{
  const int byStatus = sm::GetExitStatus(file);
  return byStatus == sm::Unreadable ? byStatus : failures.empty() ? sm::AllOk : sm::Flagged;
}

/// Colours the status in a table green, or red if it is not ok, for a terminal unless NO_COLOR is set.
std::string ColorStatus(std::string table, const sm::FileResult& file)
{
  const char* const off = std::getenv("NO_COLOR");
  const std::string& status = file.Status;
  const size_t at = table.find('\n');
  if (!isatty(STDOUT_FILENO) || (off && *off) || at == std::string::npos || at < status.size())
  {
    return table;
  }
  const char* const color = sm::GetExitStatus(file) == sm::AllOk ? "\033[32m" : "\033[31m";
  return table.replace(at - status.size(), status.size(), color + status + "\033[0m");
}

/// Prints the table of a finished file or, without tables, the reason why the file has no results, or what
/// fails.
void Print(const sm::FileResult& file, const std::string& failures, bool showTable, bool isFirst)
{
  if (showTable)
  {
    std::cout << (isFirst ? "" : "\n") << ColorStatus(sm::FormatTable(file), file) << std::flush;
  }
  else if (!file.Total.Area.IsKnown())
  {
    const std::string reason = FindReason(file);
    sm::Complain(file.File + " is " + file.Status + (reason.empty() ? "" : ": " + reason));
  }
  else if (!failures.empty())
  {
    sm::Complain(file.File + " " + failures);
  }
}

/// Adds a failed output of a job to the messages of its file and to the exit status.
void ReportFailure(const std::string& message, sm::FileResult& file, int& exitStatus)
{
  file.Messages.push_back(message);
  exitStatus = Combine(exitStatus, sm::Complain(message));
}

/// Returns the entry of a finished file, with messages about missing outputs.
sm::FileResult TakeFile(sm::JobOutcome outcome, const sm::JobOptions& job, int& exitStatus)
{
  for (const std::string& error : outcome.OutputErrors)
  {
    ReportFailure(error, *outcome.File, exitStatus);
  }
  if (!outcome.PictureError.empty())
  {
    ReportFailure("no picture " + job.PictureName + ": " + outcome.PictureError, *outcome.File, exitStatus);
  }
  return std::move(*outcome.File);
}

/// The job of each file.
std::vector<sm::JobOptions> MakeJobs(const sm::Arguments& arguments)
{
  const std::vector<std::string> meshes = sm::OutputNames(arguments.Files, arguments.Mesh);
  const std::vector<std::string> robots = sm::OutputNames(arguments.Files, arguments.RobotName);
  const std::vector<std::string> pictures =
    sm::OutputNames(arguments.Files, arguments.Compare ? "" : arguments.Picture);
  const std::vector<std::string> prefixes = sm::TexturePrefixes(arguments);
  const std::vector<std::string> taken =
    arguments.RobotName.empty() ? std::vector<std::string>() : sm::ListFiles(arguments);
  std::vector<sm::JobOptions> jobs(arguments.Files.size(), arguments.Job);
  for (size_t i = 0; i < jobs.size(); ++i)
  {
    jobs[i].FileName = arguments.Files[i];
    jobs[i].MeshName = meshes[i];
    jobs[i].PictureName = pictures[i];
    jobs[i].RobotName = robots[i];
    jobs[i].TakenNames = taken;
    jobs[i].AllRobots = robots;
    jobs[i].TexturePrefix = prefixes[i];
  }
  return jobs;
}

/// Ignores signals that would end this process, so that writing fails with an error instead: for a file above
/// the limit of the shell (ulimit -f) and, if there are other outputs than the table, for a reader of the
/// table that has ended.
void IgnoreWriteSignals(const sm::Arguments& arguments)
{
  std::signal(SIGXFSZ, SIG_IGN);
  const auto isFile = [](const std::string& name) { return !name.empty() && name != "-"; };
  if (isFile(arguments.Json) || isFile(arguments.Csv) || isFile(arguments.PartsCsv) ||
    isFile(arguments.RobotName) || isFile(arguments.Mesh) || isFile(arguments.Picture))
  {
    std::signal(SIGPIPE, SIG_IGN);
  }
}

/// Compares two finished files, which still have their shapes, and prints the table. Returns the comparison;
/// none where there is nothing to compare.
std::optional<sm::ProductDifference> Compare(
  const std::vector<sm::FileResult>& files, double limit, bool showTable, int& exitStatus)
{
  const bool areRead = files.size() == 2 &&
    std::all_of(
      files.begin(), files.end(), [](const sm::FileResult& file) { return file.Shapes.has_value(); }) &&
    !(files[0].Solids.empty() && files[1].Solids.empty());
  std::optional<sm::ProductDifference> comparison;
  if (areRead)
  {
    comparison = sm::CompareProducts(files[0].GetProduct(), *files[0].Shapes, files[1].GetProduct(),
      *files[1].Shapes, limit, sm::FormatExact, []() { return !sm::IsInterrupted(); });
  }
  if (sm::IsInterrupted())
  {
    return comparison;
  }
  if (!comparison || !comparison->IsEqual)
  {
    exitStatus = Combine(exitStatus, areRead ? sm::Different : sm::Flagged);
  }
  if (showTable && files.size() == 2)
  {
    std::cout << sm::FormatComparison(files[0], files[1], comparison) << std::flush;
  }
  return comparison;
}

/// Draws the comparison in another process, which reads both files again. Returns an exit status.
int DrawCompared(
  const sm::Arguments& arguments, const sm::ProductDifference& comparison, ProgressLine& progress)
{
  const sm::InputFile before(arguments.Files[0]);
  sm::JobOptions job = arguments.Job;
  job.FileName = arguments.Files[1];
  job.ComparedName = before.GetPath();
  job.Comparison = comparison;
  job.PictureName = arguments.Picture;
  sm::JobQueue queue({ job }, 1,
    [&progress](std::size_t, const std::string& stage, double fraction)
    { progress.Show("picture", stage, fraction); });
  const sm::JobOutcome outcome = queue.Next();
  progress.Clear();
  const std::string problem = !outcome.File ? "interrupted"
    : !before.GetError().empty()            ? before.GetError()
    : !outcome.PictureError.empty()         ? outcome.PictureError
    : outcome.File->Status == "ok"          ? std::string()
                                            : FindReason(*outcome.File);
  return problem.empty() ? sm::AllOk : sm::Complain("no picture " + job.PictureName + ": " + problem);
}

int Run(const sm::Arguments& arguments, double processStart)
{
  const bool showTable =
    !arguments.Quiet && arguments.Print.empty() && arguments.Json != "-" && arguments.Csv != "-";
  const std::vector<sm::JobOptions> jobs = MakeJobs(arguments);
  const std::string count = std::to_string(jobs.size());
  ProgressLine progress(!arguments.Quiet);
  sm::ReportFiles reports(arguments, processStart);
  std::vector<sm::FileResult> compared;
  int exitStatus = sm::AllOk;
  IgnoreWriteSignals(arguments);
  sm::CatchInterrupt();
  sm::JobQueue queue(jobs, static_cast<size_t>(arguments.JobsAtOnce),
    [&](size_t i, const std::string& stage, double fraction)
    {
      progress.Show(
        "[" + std::to_string(i + 1) + "/" + count + "] " + sm::GetStem(jobs[i].FileName), stage, fraction);
    });
  for (size_t i = 0; i < jobs.size(); ++i)
  {
    sm::JobOutcome outcome = queue.Next();
    progress.Clear();
    if (!outcome.File)
    {
      // This job was interrupted; later ones may be finished.
      continue;
    }
    sm::FileResult file = TakeFile(std::move(outcome), jobs[i], exitStatus);
    const std::string failures = FindFailures(file, arguments);
    exitStatus = Combine(exitStatus, Judge(file, failures));
    if (!arguments.Print.empty())
    {
      std::cout << sm::FormatFields(file, arguments.Print) << std::flush;
    }
    if (arguments.Compare)
    {
      compared.push_back(file);
      file.Shapes.reset();
    }
    const bool isFirst = reports.GetNumberOfFiles() == 0;
    Print(reports.Add(std::move(file)), showTable ? std::string() : failures, showTable && !arguments.Compare,
      isFirst);
  }
  if (arguments.Compare)
  {
    const std::optional<sm::ProductDifference> comparison =
      Compare(compared, arguments.CompareLimit, showTable, exitStatus);
    reports.SetComparison(comparison);
    if (!arguments.Picture.empty() && comparison && !sm::IsInterrupted())
    {
      exitStatus = Combine(exitStatus, DrawCompared(arguments, *comparison, progress));
    }
  }
  if ((showTable || !arguments.Print.empty()) && !std::cout)
  {
    exitStatus = Combine(exitStatus, sm::Complain("the results cannot be written to the standard output"));
  }
  exitStatus = Combine(exitStatus, reports.Finish());
  if (sm::IsInterrupted())
  {
    sm::Complain(
      "interrupted; " + std::to_string(reports.GetNumberOfFiles()) + " of " + count + " files were finished");
    sm::EndByInterrupt();
  }
  return exitStatus;
}
}

int main(int argc, char** argv)
{
  // Until here the process has only loaded its libraries.
  const double processStart = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  OccupyStandardStreams();
  sm::Arguments arguments;
  const std::optional<int> done = sm::ParseArguments(argc, argv, arguments);
  if (!done)
  {
    return Run(arguments, processStart);
  }
  return std::cout.flush() ? *done : sm::Complain("the standard output cannot be written");
}
