#include "smIsolatedJob.h"

#include "smByteFields.h"
#include "smFormat.h"
#include "smIntegralNames.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace
{
namespace names = sm::names;

volatile std::sig_atomic_t Interrupted = 0; ///< the signal

void OnInterrupt(int number)
{
  Interrupted = number;
}

/// Visits what a message of the kind `result` holds.
void VisitResult(sm::Fields& fields, sm::FileResult& file, bool& isComplete)
{
  isComplete = fields.Has(isComplete);
  file.Visit(fields);
  if (fields.Has(file.Shapes.has_value()))
  {
    file.Shapes = file.Shapes.value_or(sm::ProductShapes());
    file.Shapes->Visit(fields);
  }
}

void WriteMessage(int descriptor, const sm::JobMessage& message)
{
  sm::ByteFieldWriter writer;
  if (message.Kind == sm::JobMessage::Result)
  {
    bool isComplete = message.IsComplete;
    // A writer changes nothing.
    VisitResult(writer, const_cast<sm::FileResult&>(*message.File), isComplete);
  }
  else
  {
    std::string text = message.Text;
    double fraction = message.Fraction;
    writer.sm::Fields::Text(nullptr, text);
    writer.Number(nullptr, fraction);
  }
  if (!sm::SendMessage(descriptor, message.Kind, writer.Get().data(), writer.Get().size()))
  {
    _exit(1); // the parent has closed the pipe
  }
}

/// Returns the seconds after which a job is killed. Computations stop at the time limit by themselves; a
/// hanging reader or compiler does not.
double GetSecondsLeft(const sm::JobOptions& options)
{
  return options.MaximumSeconds > 0.0 ? options.MaximumSeconds + std::max(2.0, 0.25 * options.MaximumSeconds)
                                      : std::numeric_limits<double>::infinity();
}

/// Returns a sentence about the process of a child and how it ended; empty if it ended normally.
std::string DescribeEnd(const sm::ProcessEnd& end, const sm::JobOptions& options)
{
  return end.IsTimeOver ? "took longer than the " + sm::FormatDigits(options.MaximumSeconds, 6) +
      " s of --max-seconds and was ended"
                        : end.Describe();
}

/// Adds the reason for missing results to those that a child sent before it failed; `isExplained` is true if
/// `end` is the whole reason.
void AddFailure(const sm::JobOptions& options, const std::string& stage, const std::string& end,
  bool isExplained, std::optional<sm::FileResult>& file)
{
  std::string reason = "the process that worked on this file " +
    (end.empty() ? "ended without a result" : end) + " in stage \"" + stage + "\"";
  if (!file)
  {
    const bool isReading = stage == sm::stages::Read;
    file = sm::UnreadableFile(options, reason + (isReading && !isExplained ? "; the file is malformed" : ""));
    file->Status = isExplained ? names::StatusNotComputed : names::StatusUnreadable;
    return;
  }
  if (!isExplained)
  {
    reason += "; this is a defect of this program or of the OpenGL driver, and none of the file";
  }
  const bool isComputed = file->Status != names::StatusNotComputed;
  sm::MarkIncomplete(*file, reason + (isComputed ? "; what was computed before is kept" : ""));
}

/// Adds the reasons why requested pictures and meshes are missing. `end`: result of DescribeEnd().
void FindOutputErrors(
  const sm::JobOptions& options, const sm::JobMessages& said, const std::string& end, sm::JobOutcome& outcome)
{
  // The status already explains why an unreadable or empty file has no pictures.
  const std::string& status = outcome.File->Status;
  const auto add = [&outcome](const std::string& what, const std::string& reason)
  {
    if (!reason.empty())
    {
      outcome.OutputErrors.push_back(what + ": " + reason);
    }
  };
  if (!options.TexturePrefix.empty() && status != "unreadable")
  {
    add("trim textures are missing", said.Textures.value_or("the process ended before they were written"));
  }
  const bool isRead = status != "unreadable" && status != "empty";
  const auto explain = [&end](const std::optional<std::string>& reason, const std::string& process)
  { return reason.value_or(process + " " + (end.empty() ? "ended without one" : end)); };
  if (!options.MeshName.empty() && isRead)
  {
    add("no mesh " + options.MeshName, explain(said.Mesh, "the process that made it"));
  }
  for (const std::shared_ptr<sm::Analysis>& analysis : options.Analyses)
  {
    const std::string name = analysis->IsWanted() ? analysis->GetOutputFile() : std::string();
    const auto reported = said.Analyses.find(analysis->GetKey());
    const auto reason = reported == said.Analyses.end() ? std::nullopt : std::optional(reported->second);
    add(std::string("no file of ") + analysis->GetOption() + " " + name,
      name.empty() || !isRead ? std::string() : explain(reason, "the process that made it"));
  }
  if (!options.ValidationTarget.empty() && isRead)
  {
    add("no file of --write-validation " + options.ValidationTarget,
      explain(said.Validation, "the process that made it"));
  }
  if (!options.RobotName.empty() && isRead)
  {
    add("robot " + options.RobotName, explain(said.Robot, "the process that made it"));
  }
  if (!options.PictureName.empty() && isRead)
  {
    outcome.PictureError = explain(said.Picture, "the process that drew it");
  }
}
}

namespace sm
{
void JobMessages::Take(
  JobMessage::Kinds kind, Bytes bytes, const JobOptions& options, const ProgressListener& progress)
{
  ByteFieldReader reader(std::move(bytes));
  if (kind == JobMessage::Result)
  {
    FileResult file(options);
    bool isComplete = false;
    VisitResult(reader, file, isComplete);
    if (reader.IsWhole())
    {
      this->Result = std::move(file);
      this->IsComplete = isComplete;
    }
    return;
  }
  std::string text;
  double fraction = 0.0;
  reader.Fields::Text(nullptr, text);
  reader.Number(nullptr, fraction);
  if (!reader.IsWhole())
  {
    return;
  }
  if (kind == JobMessage::Progress)
  {
    this->Stage = text;
    progress(text, fraction);
  }
  else if (kind == JobMessage::Analysis)
  {
    const std::size_t end = std::min(text.find('\n'), text.size());
    this->Analyses[text.substr(0, end)] = text.substr(std::min(end + 1, text.size()));
  }
  else
  {
    (kind == JobMessage::Textures        ? this->Textures
        : kind == JobMessage::Mesh       ? this->Mesh
        : kind == JobMessage::Validation ? this->Validation
        : kind == JobMessage::Robot      ? this->Robot
                                         : this->Picture) = text;
  }
}

JobProcess::JobProcess(std::vector<ListenedJob> jobs)
  : Jobs(std::move(jobs))
  , Said(this->Jobs.size())
  , Helper([this](char kind, Bytes content) { this->Take(kind, std::move(content)); })
{
  for (JobMessages& said : this->Said)
  {
    said.Stage = stages::Start;
  }
  const JobOptions& first = this->Jobs.front().Options;
  this->Helper.SetSecondsLeft(GetSecondsLeft(first));
  struct stat info = {};
  if (stat(first.FileName.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
  {
    // Reading a pipe or a device may never end.
    this->Error = "Cannot read " + first.FileName +
      (S_ISDIR(info.st_mode) && access(first.FileName.c_str(), R_OK | X_OK) != 0
          ? ": it is a folder that may not be read; change its permissions, or name files in it."
          : S_ISDIR(info.st_mode)
          ? ": it is a folder without STEP or BREP files; name a file, or a folder that has some."
          : ": it is not a regular file; write its content to a file, or to the standard input, and name - "
            "for that.");
    return;
  }
  this->Error = this->Helper.Fork([this](int descriptor) { this->Run(descriptor); });
}

void JobProcess::Run(int descriptor)
{
  const JobOptions& first = this->Jobs.front().Options;
  if (first.Threads > 0)
  {
    vtkSMPTools::Initialize(first.Threads);
    // Mesa's software rasterizer has threads of its own.
    setenv("LP_NUM_THREADS", std::to_string(first.Threads).c_str(), 0);
  }
  for (std::size_t i = 0; i < this->Jobs.size(); ++i)
  {
    bool isOk = false;
    RunFileJob(this->Jobs[i].Options,
      [descriptor, &isOk](const JobMessage& message)
      {
        isOk = message.Kind == JobMessage::Result
          ? message.IsComplete && message.File->Status == names::StatusOk && message.File->Backend == "cpu"
          : isOk;
        WriteMessage(descriptor, message);
      });
    if (!isOk || i + 1 == this->Jobs.size())
    {
      return;
    }
    WriteMessage(descriptor, JobMessage::OfOutput(JobMessage::Next, {}));
  }
}

void JobProcess::Take(char kind, Bytes content)
{
  if (kind == JobMessage::Next)
  {
    this->Current = std::min(this->Current + 1, this->Jobs.size() - 1);
    return;
  }
  const ListenedJob& job = this->Jobs[this->Current];
  this->Said[this->Current].Take(
    static_cast<JobMessage::Kinds>(kind), std::move(content), job.Options, job.Progress);
}

void JobProcess::Wait(const std::vector<JobProcess*>& processes)
{
  std::vector<HelperProcess*> helpers;
  for (JobProcess* process : processes)
  {
    helpers.push_back(&process->Helper);
    if (Interrupted)
    {
      process->Helper.Kill();
    }
  }
  // A signal that arrives just before the wait is noticed a second later.
  HelperProcess::Wait(helpers, 1.0);
}

bool IsolatedJob::IsLeftOver() const
{
  return !this->Process->IsRunning() && this->Process->Error.empty() && this->Process->Current < this->Index;
}

bool IsolatedJob::IsInDoubt() const
{
  return !this->Process->IsRunning() && this->Process->Error.empty() && this->Index > 0 &&
    this->Process->Current == this->Index && !this->Process->Said[this->Index].IsComplete;
}

ProcessEnd IsolatedJob::GetEnd() const
{
  return this->Process->Current > this->Index ? ProcessEnd() : this->Process->Helper.GetEnd();
}

JobOutcome IsolatedJob::GetOutcome()
{
  JobOutcome outcome;
  const JobOptions& options = this->Process->Jobs[this->Index].Options;
  JobMessages& said = this->Process->Said[this->Index];
  if (!this->Process->Error.empty())
  {
    outcome.File = UnreadableFile(options, this->Process->Error);
    return outcome;
  }
  outcome.File = std::move(said.Result);
  if (outcome.File)
  {
    // The pipe carries UTF-8 only; the table and the CSV show the name with its own bytes.
    outcome.File->File = options.FileName;
  }
  if (Interrupted)
  {
    // After an interrupt only complete results count as those of a finished file.
    return said.IsComplete ? outcome : JobOutcome();
  }
  const ProcessEnd how = this->GetEnd();
  const std::string end = DescribeEnd(how, options);
  if (!said.IsComplete)
  {
    AddFailure(options, said.Stage, end, how.IsForced(), outcome.File);
  }
  else if (!end.empty() && !how.IsTimeOver)
  {
    outcome.File->Messages.push_back("the process that worked on this file " + end + " in stage \"" +
      said.Stage + "\", after it had sent the result");
  }
  FindOutputErrors(options, said, end, outcome);
  return outcome;
}

void CatchInterrupt()
{
  struct sigaction action = {};
  action.sa_handler = OnInterrupt; // without SA_RESTART: a blocked read must return
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction before = {};
  // If nohup has set SIGHUP to be ignored, it stays ignored.
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
  {
    sigaction(SIGHUP, &action, nullptr);
  }
}

bool IsInterrupted()
{
  return Interrupted != 0;
}

void EndByInterrupt()
{
  const int number = Interrupted;
  std::signal(number, SIG_DFL);
  raise(number);
  _exit(128 + number);
}
}
