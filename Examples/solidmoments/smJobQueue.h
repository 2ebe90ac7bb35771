/**
 * @file smJobQueue.h
 * @brief Runs the jobs of several files at the same time and returns their outcomes in the order of the files
 */
#ifndef smJobQueue_h
#define smJobQueue_h

#include "smInputFile.h"
#include "smIsolatedJob.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace sm
{
class JobQueue
{
public:
  using Listener = std::function<void(std::size_t job, const std::string& stage, double fraction)>;

  /// `atOnce` is the number of jobs that run at a time, which share the processors; 0: as many as there are
  /// processors.
  JobQueue(std::vector<JobOptions> jobs, std::size_t atOnce, Listener progress);

  /// Waits for the outcome of the next job. It has no File if it was interrupted before there was one. Later
  /// jobs continue to run.
  JobOutcome Next();

private:
  struct Entry
  {
    std::unique_ptr<InputFile> Input;
    std::unique_ptr<IsolatedJob> Job; ///< null when the input cannot be read
  };

  static bool IsRunning(const Entry& entry);
  void StartJobs();
  /// Starts a process for entries of Started that have an input.
  void StartProcess(const std::vector<std::size_t>& entries);
  /// Starts processes for the jobs that one which has ended did not begin with, and one for a job in which it
  /// ended after it had worked on others.
  void StartLeftOver();
  /// Returns the processes that run.
  std::vector<JobProcess*> GetRunning() const;
  /// Returns the number of jobs, from i on, that one process is to work on.
  std::size_t CountTogether(std::size_t i) const;

  std::vector<JobOptions> Jobs;
  std::size_t AtOnce = 1;
  Listener Progress;
  std::deque<Entry> Started; ///< jobs whose outcomes have not been returned
  std::size_t NextOut = 0;
};
}

#endif
