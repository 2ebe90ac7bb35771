#include "Detail/smWorkerThreads.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

#include <unistd.h>

namespace sm
{
namespace
{
/// True in a thread that is executing a part of a loop.
thread_local bool IsInLoop = false;

/// One loop at a time. Its threads wait until the process ends.
class WorkerThreads
{
public:
  WorkerThreads()
    : Process(getpid())
  {
  }

  /// The threads of this process. They are never destroyed: they may wait on their conditions while statics
  /// are.
  static WorkerThreads& Get()
  {
    static std::mutex mutex;
    static WorkerThreads* threads = nullptr;
    const std::lock_guard<std::mutex> lock(mutex);
    if (!threads || threads->Process != getpid())
    {
      threads = new WorkerThreads;
    }
    return *threads;
  }

  /// Runs the loop on so many threads, of which the caller is one. Returns false if another thread's loop is
  /// running.
  bool Run(std::size_t threads, std::size_t count, std::size_t grain, const LoopPart& part)
  {
    const std::unique_lock<std::mutex> running(this->Running, std::try_to_lock);
    if (!running)
    {
      return false;
    }
    const std::size_t parts = (count + grain - 1) / grain;
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Start(std::min(threads, parts) - 1);
      const std::size_t helpers = std::min(std::min(threads, parts) - 1, this->Started);
      this->Count = count;
      this->Grain = grain;
      this->Part = &part;
      this->Next = 0;
      this->Wanted = helpers;
      this->Active = helpers;
      ++this->Loop;
    }
    this->Begin.notify_all();
    this->TakeParts();
    std::unique_lock<std::mutex> lock(this->Mutex);
    // All parts are taken; threads that have not woken up are not waited for.
    this->Active -= this->Wanted;
    this->Wanted = 0;
    this->End.wait(lock, [this] { return this->Active == 0; });
    return true;
  }

private:
  /// Starts threads until there are so many, or as many as the system gives.
  void Start(std::size_t threads)
  {
    try
    {
      for (; this->Started < threads; ++this->Started)
      {
        std::thread([this, loop = this->Loop] { this->Wait(loop); }).detach();
      }
    }
    catch (const std::exception&)
    {
      // The loop has fewer threads.
    }
  }

  void TakeParts()
  {
    IsInLoop = true;
    for (;;)
    {
      const std::size_t begin = this->Next.fetch_add(this->Grain);
      if (begin >= this->Count)
      {
        break;
      }
      (*this->Part)(begin, std::min(begin + this->Grain, this->Count));
    }
    IsInLoop = false;
  }

  /// What a thread does for ever: it takes part in each loop that wants one more.
  void Wait(unsigned long long last)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    for (;;)
    {
      this->Begin.wait(lock, [&] { return this->Loop != last && this->Wanted > 0; });
      last = this->Loop;
      --this->Wanted;
      lock.unlock();
      this->TakeParts();
      lock.lock();
      if (--this->Active == 0)
      {
        this->End.notify_one();
      }
    }
  }

  const pid_t Process;
  /// Held during a loop.
  std::mutex Running;
  std::mutex Mutex;
  std::condition_variable Begin;
  std::condition_variable End;
  std::size_t Count = 0;
  std::size_t Grain = 1;
  const LoopPart* Part = nullptr;
  std::atomic<std::size_t> Next{ 0 };
  /// Number of the loop, threads that it still wants, threads that have not finished it, threads that exist.
  unsigned long long Loop = 0;
  std::size_t Wanted = 0;
  std::size_t Active = 0;
  std::size_t Started = 0;
};
}

void RunLoop(std::size_t count, std::size_t grain, const LoopPart& part)
{
  if (count == 0)
  {
    return;
  }
  const char* backend = vtkSMPTools::GetBackend();
  const bool isSequential = !backend || std::strcmp(backend, "Sequential") == 0;
  const auto threads =
    static_cast<std::size_t>(isSequential ? 1 : std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1));
  if (grain == 0)
  {
    grain = std::max<std::size_t>(count / (4 * threads), 1);
  }
  if (threads == 1 || grain >= count || IsInLoop || !WorkerThreads::Get().Run(threads, count, grain, part))
  {
    part(0, count);
  }
}
}
