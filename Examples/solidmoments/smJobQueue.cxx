#include "smJobQueue.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace sm
{
namespace
{
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

void JobQueue::StartJobs()
{
  auto running =
    static_cast<std::size_t>(std::count_if(this->Started.begin(), this->Started.end(), IsRunning));
  for (std::size_t i = this->NextOut + this->Started.size();
       i < this->Jobs.size() && running < this->AtOnce && !IsInterrupted(); ++i)
  {
    JobOptions& job = this->Jobs[i];
    Entry entry;
    entry.Input = std::make_unique<InputFile>(job.FileName);
    if (entry.Input->GetError().empty())
    {
      job.SourceName = entry.Input->GetPath();
      entry.Job = this->MakeJob(i);
    }
    running += IsRunning(entry) ? 1 : 0;
    this->Started.push_back(std::move(entry));
  }
}

std::unique_ptr<IsolatedJob> JobQueue::MakeJob(std::size_t i)
{
  return std::make_unique<IsolatedJob>(this->Jobs[i],
    [this, i](const std::string& stage, double fraction) { this->Progress(i, stage, fraction); });
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
    std::vector<IsolatedJob*> running;
    for (const Entry& entry : this->Started)
    {
      if (IsRunning(entry))
      {
        running.push_back(entry.Job.get());
      }
    }
    if (!running.empty())
    {
      IsolatedJob::Wait(running);
    }
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
