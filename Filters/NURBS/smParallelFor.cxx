#include "smParallelFor.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include <unistd.h>

namespace sm
{
namespace
{
/// A loop of one caller.
class ParallelLoop
{
public:
  ParallelLoop(
    std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work)
    : Work(work)
    , Count(count)
    , Grain(grain)
  {
    std::fegetenv(&this->Environment);
  }

  /// Makes a helper round as the caller does.
  void ShareEnvironment() const { std::fesetenv(&this->Environment); }

  /// Runs a part, or skips it after an exception.
  void RunPart(std::size_t begin, std::size_t end)
  {
    if (this->HasFailed)
    {
      return;
    }
    try
    {
      this->Work(begin, end);
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->HasFailed)
      {
        this->First = std::current_exception();
        this->HasFailed = true;
      }
    }
  }

  /// Runs parts until none is left.
  void RunParts()
  {
    std::size_t begin = 0;
    while ((begin = this->Next.fetch_add(this->Grain)) < this->Count)
    {
      this->RunPart(begin, std::min(begin + this->Grain, this->Count));
    }
  }

  void Rethrow() const
  {
    if (this->First)
    {
      std::rethrow_exception(this->First);
    }
  }

  /// Number of helpers that run parts now; Helpers' mutex protects it.
  int Running = 0;

private:
  const std::function<void(std::size_t, std::size_t)>& Work;
  std::size_t Count;
  std::size_t Grain;
  std::fenv_t Environment;
  std::atomic<std::size_t> Next{ 0 };
  std::atomic<bool> HasFailed{ false };
  std::mutex Mutex;
  std::exception_ptr First;
};

/// Threads that wait for the loops of the process.
class Helpers
{
public:
  /// Never destroyed, as its threads wait for ever. A child process starts its own.
  static Helpers& Get()
  {
    static std::mutex mutex;
    static Helpers* helpers = nullptr;
    static pid_t process = 0;
    const std::lock_guard<std::mutex> lock(mutex);
    if (process != getpid())
    {
      helpers = new Helpers;
      process = getpid();
    }
    return *helpers;
  }

  /// Runs the loop with up to `count` helpers; alone if they are busy.
  void Run(ParallelLoop& loop, int count)
  {
    if (!this->Begin(loop, count))
    {
      loop.RunParts();
      return;
    }
    for (int i = 0; i < count; ++i)
    {
      this->Wake.notify_one();
    }
    loop.RunParts();
    std::unique_lock<std::mutex> lock(this->Mutex);
    // Nothing is left for helpers that have not come yet.
    this->Wanted = 0;
    this->Done.wait(lock, [&loop]() { return loop.Running == 0; });
    this->Current = nullptr;
  }

private:
  bool Begin(ParallelLoop& loop, int count)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Current)
    {
      return false;
    }
    try
    {
      for (; this->Threads < count; ++this->Threads)
      {
        std::thread([this]() { this->Help(); }).detach();
      }
    }
    catch (const std::system_error&)
    {
      // As many as the system allows.
    }
    this->Current = &loop;
    this->Wanted = count;
    return true;
  }

  void Help()
  {
    // Signals are for the threads of the application.
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, nullptr);
    std::unique_lock<std::mutex> lock(this->Mutex);
    for (;;)
    {
      this->Wake.wait(lock, [this]() { return this->Wanted > 0; });
      --this->Wanted;
      ParallelLoop& loop = *this->Current;
      ++loop.Running;
      lock.unlock();
      loop.ShareEnvironment();
      loop.RunParts();
      lock.lock();
      if (--loop.Running == 0)
      {
        this->Done.notify_one();
      }
    }
  }

  std::mutex Mutex;
  std::condition_variable Wake;
  std::condition_variable Done;
  ParallelLoop* Current = nullptr;
  int Wanted = 0;
  int Threads = 0;
};
}

void ParallelFor(
  std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work)
{
  if (count <= std::max<std::size_t>(grain, 1))
  {
    if (count > 0)
    {
      work(0, count);
    }
    return;
  }
  if (std::strcmp(vtkSMPTools::GetBackend(), "STDThread") == 0)
  {
    const auto threads = static_cast<std::size_t>(std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1));
    const std::size_t size = grain > 0 ? grain : std::max<std::size_t>(count / (4 * threads), 1);
    ParallelLoop loop(count, size, work);
    Helpers::Get().Run(loop, static_cast<int>(std::min(threads, (count + size - 1) / size)) - 1);
    loop.Rethrow();
    return;
  }
  ParallelLoop loop(count, grain, work);
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), static_cast<vtkIdType>(grain),
    [&loop](vtkIdType begin, vtkIdType end)
    { loop.RunPart(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)); });
  loop.Rethrow();
}
}
