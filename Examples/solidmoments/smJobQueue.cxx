#include "smJobQueue.h"

#include "smAnalysis.h"

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <thread>
#include <utility>

namespace sm
{
namespace
{
// The largest number of files that a process works on, and the largest sum of their bytes: what larger files
// leave in memory, and what others have to wait for, is no longer small.
constexpr std::size_t MaxTogether = 32;
constexpr std::uintmax_t MaxBytesTogether = 2 << 20;

constexpr int LimitedResources[] = { RLIMIT_CPU, RLIMIT_AS, RLIMIT_DATA };

/// Returns true for a job without outputs of its own or a limit of time, if its file and those before it, of
/// `bytes`, which it is added to, are small.
bool IsSmall(const JobOptions& job, std::uintmax_t& bytes)
{
  std::error_code error;
  const std::filesystem::path path(job.FileName);
  const bool isFile = std::filesystem::is_regular_file(path, error);
  const std::uintmax_t size = isFile ? std::filesystem::file_size(path, error) : 0;
  bytes += size;
  const bool isPlain = job.MaximumSeconds == 0.0 && job.TexturePrefix.empty() && job.MeshName.empty() &&
    job.RobotName.empty() && job.PictureName.empty() && job.ValidationTarget.empty() && !job.Comparison;
  return isFile && !error && isPlain && bytes <= MaxBytesTogether &&
    std::none_of(job.Analyses.begin(), job.Analyses.end(),
      [](const std::shared_ptr<Analysis>& analysis) { return analysis->IsWanted(); });
}

/// Returns true where processor time or memory of a process are limited: the limits are those of a file.
bool HasProcessLimits()
{
  rlimit limit{};
  return std::any_of(std::begin(LimitedResources), std::end(LimitedResources),
    [&limit](int resource) { return getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY; });
}

/// Replaces the name of a copy in the messages by the name that the user gave.
void RestoreName(const JobOptions& job, FileResult& file)
{
  for (std::string& text : file.Messages)
  {
    for (std::size_t at = text.find(job.SourceName); at != std::string::npos;
         at = text.find(job.SourceName, at + job.FileName.size()))
    {
      text.replace(at, job.SourceName.size(), job.FileName);
    }
  }
}
}

JobQueue::JobQueue(std::vector<JobOptions> jobs, std::size_t atOnce, Listener progress)
  : Jobs(std::move(jobs))
  , Progress(std::move(progress))
{
  const std::size_t processors = std::max(std::thread::hardware_concurrency(), 1U);
  this->AtOnce = atOnce > 0 ? atOnce : processors;
  if (this->AtOnce > 1)
  {
    for (JobOptions& job : this->Jobs)
    {
      job.Threads = static_cast<int>(std::max<std::size_t>(processors / this->AtOnce, 1));
    }
  }
}

bool JobQueue::IsRunning(const Entry& entry)
{
  return entry.Job && entry.Job->IsRunning();
}

std::vector<JobProcess*> JobQueue::GetRunning() const
{
  std::vector<JobProcess*> running;
  for (const Entry& entry : this->Started)
  {
    if (IsRunning(entry) &&
      std::find(running.begin(), running.end(), &entry.Job->GetProcess()) == running.end())
    {
      running.push_back(&entry.Job->GetProcess());
    }
  }
  return running;
}

std::size_t JobQueue::CountTogether(std::size_t i) const
{
  // Few enough that no process is idle while another has many left.
  const std::size_t left = this->Jobs.size() - i;
  const std::size_t largest = std::min(MaxTogether, (left + 2 * this->AtOnce - 1) / (2 * this->AtOnce));
  std::uintmax_t bytes = 0;
  std::size_t count = 0;
  for (; count < largest && IsSmall(this->Jobs[i + count], bytes); ++count)
  {
  }
  return std::max<std::size_t>(HasProcessLimits() ? 1 : count, 1);
}

void JobQueue::StartJobs()
{
  std::size_t running = this->GetRunning().size();
  for (std::size_t i = this->NextOut + this->Started.size();
       i < this->Jobs.size() && running < this->AtOnce && !IsInterrupted();)
  {
    std::vector<std::size_t> entries;
    for (std::size_t left = this->CountTogether(i); left > 0; --left, ++i)
    {
      JobOptions& job = this->Jobs[i];
      Entry entry;
      entry.Input = std::make_unique<InputFile>(job.FileName);
      if (entry.Input->GetError().empty())
      {
        job.SourceName = entry.Input->GetPath();
        entries.push_back(this->Started.size());
      }
      this->Started.push_back(std::move(entry));
    }
    if (!entries.empty())
    {
      this->StartProcess(entries);
      running += IsRunning(this->Started[entries.front()]) ? 1 : 0;
    }
  }
}

void JobQueue::StartProcess(const std::vector<std::size_t>& entries)
{
  std::vector<ListenedJob> jobs;
  for (const std::size_t entry : entries)
  {
    const std::size_t i = this->NextOut + entry;
    jobs.push_back({ this->Jobs[i],
      [this, i](const std::string& stage, double fraction) { this->Progress(i, stage, fraction); } });
  }
  const auto process = std::make_shared<JobProcess>(std::move(jobs));
  for (std::size_t k = 0; k < entries.size(); ++k)
  {
    this->Started[entries[k]].Job = std::make_unique<IsolatedJob>(process, k);
  }
}

void JobQueue::StartLeftOver()
{
  for (std::size_t i = 0; i < this->Started.size() && !IsInterrupted(); ++i)
  {
    if (this->Started[i].Job && this->Started[i].Job->IsInDoubt())
    {
      this->StartProcess({ i });
    }
  }
  for (std::size_t begin = 0; begin < this->Started.size() && !IsInterrupted();)
  {
    std::vector<std::size_t> entries;
    const JobProcess* ended = nullptr;
    for (; begin < this->Started.size(); ++begin)
    {
      const std::unique_ptr<IsolatedJob>& job = this->Started[begin].Job;
      if (job && job->IsLeftOver() && (!ended || &job->GetProcess() == ended))
      {
        ended = &job->GetProcess();
        entries.push_back(begin);
      }
      else if (ended && job)
      {
        break;
      }
    }
    if (!entries.empty())
    {
      this->StartProcess(entries);
    }
  }
}

JobOutcome JobQueue::Next()
{
  // A finished outcome is returned before another job is started, which may take long if its input comes
  // through a pipe.
  while (this->Started.empty() || IsRunning(this->Started.front()))
  {
    this->StartJobs();
    if (this->Started.empty())
    {
      return {};
    }
    const std::vector<JobProcess*> running = this->GetRunning();
    if (!running.empty())
    {
      JobProcess::Wait(running);
    }
    this->StartLeftOver();
    for (Entry& entry : this->Started)
    {
      if (entry.Job && !entry.Job->IsRunning())
      {
        entry.Input.reset(); // which may be a copy of some GB
      }
    }
  }
  const Entry entry = std::move(this->Started.front());
  this->Started.pop_front();
  const JobOptions& job = this->Jobs[this->NextOut++];
  if (!entry.Job)
  {
    JobOutcome outcome;
    outcome.File = UnreadableFile(job, job.FileName + " cannot be read: " + entry.Input->GetError());
    return outcome;
  }
  JobOutcome outcome = entry.Job->GetOutcome();
  if (outcome.File && job.SourceName != job.FileName)
  {
    RestoreName(job, *outcome.File);
  }
  return outcome;
}
}
