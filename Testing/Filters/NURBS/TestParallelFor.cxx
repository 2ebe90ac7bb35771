// Exceptions of worker threads arrive in the calling thread, and a loop without any visits every index once: also within a loop,
// beside another thread's, and in a child process. Worker threads round as the calling thread does.
#include "smParallelFor.h"
#include "smTesting.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <functional>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
using namespace smtest;

void CheckEveryIndex(std::size_t grain)
{
  std::vector<int> visits(10007, 0);
  sm::ParallelFor(visits.size(), grain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        ++visits[i];
      }
    });
  CheckTrue("every index once, grain " + std::to_string(grain),
    std::all_of(visits.begin(), visits.end(), [](int count) { return count == 1; }));
}

/// Loops within loops of two threads.
void CheckLoopsTogether()
{
  constexpr std::size_t Inner = 37;
  std::vector<int> visits[2] = { std::vector<int>(200 * Inner, 0), std::vector<int>(200 * Inner, 0) };
  const auto run = [](std::vector<int>& counts)
  {
    for (int repetition = 0; repetition < 20; ++repetition)
    {
      sm::ParallelFor(200, 1,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            sm::ParallelFor(Inner, 5,
              [&](std::size_t from, std::size_t to)
              {
                for (std::size_t j = from; j < to; ++j)
                {
                  ++counts[i * Inner + j];
                }
              });
          }
        });
    }
  };
  std::thread other([&]() { run(visits[1]); });
  run(visits[0]);
  other.join();
  for (const std::vector<int>& counts : visits)
  {
    CheckTrue("loops together: every index once",
      std::all_of(counts.begin(), counts.end(), [](int count) { return count == 20; }));
  }
}

/// Number of threads that run a loop whose parts take a while.
std::size_t CountThreads(const std::function<void()>& work)
{
  std::mutex mutex;
  std::set<std::thread::id> threads;
  sm::ParallelFor(1000, 1,
    [&](std::size_t, std::size_t)
    {
      work();
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      const std::lock_guard<std::mutex> lock(mutex);
      threads.insert(std::this_thread::get_id());
    });
  return threads.size();
}

/// The threads of the parent do not exist in its child, which starts others.
void CheckChildProcess()
{
  const pid_t child = fork();
  if (child == 0)
  {
    alarm(20);
    const std::size_t threads = CountThreads([]() {});
    std::atomic<std::size_t> visits{ 0 };
    for (int repetition = 0; repetition < 100; ++repetition)
    {
      sm::ParallelFor(100, 1, [&](std::size_t begin, std::size_t end) { visits += end - begin; });
    }
    _exit(visits != 10000 ? 1 : threads < 2 ? 2 : 0);
  }
  int status = -1;
  waitpid(child, &status, 0);
  CheckEqual("status of a child process with loops", 0, status);
}

void CheckRounding()
{
  std::fesetround(FE_UPWARD);
  std::atomic<int> others{ 0 };
  const std::size_t threads = CountThreads([&others]() { others += std::fegetround() == FE_UPWARD ? 0 : 1; });
  std::fesetround(FE_TONEAREST);
  CheckTrue("several threads rounded", threads > 1, std::to_string(threads));
  CheckEqual("parts that rounded otherwise than their caller", 0, others.load());
}

void CheckException()
{
  std::mutex mutex;
  std::set<std::thread::id> threads;
  std::string caught;
  try
  {
    sm::ParallelFor(1000, 1,
      [&](std::size_t begin, std::size_t)
      {
        {
          const std::lock_guard<std::mutex> lock(mutex);
          threads.insert(std::this_thread::get_id());
        }
        std::this_thread::sleep_for(std::chrono::microseconds(100));
        if (begin == 500)
        {
          throw std::runtime_error("part 500");
        }
      });
  }
  catch (const std::runtime_error& error)
  {
    caught = error.what();
  }
  CheckEqual("the exception of one part", "part 500", caught);
  CheckTrue("several threads ran", threads.size() > 1, std::to_string(threads.size()));

  bool isOutOfMemory = false;
  try
  {
    sm::ParallelFor(1000, 1, [](std::size_t, std::size_t) { throw std::bad_alloc(); });
  }
  catch (const std::bad_alloc&)
  {
    isOutOfMemory = true;
  }
  CheckTrue("every part throws: the first arrives, with its type", isOutOfMemory);
}
}

int TestParallelFor(int, char*[])
{
  CheckTrue("threads", vtkSMPTools::SetBackend("STDThread"));
  vtkSMPTools::Initialize(4);
  CheckEveryIndex(1);
  CheckEveryIndex(64);
  CheckEveryIndex(0);
  CheckException();
  CheckEveryIndex(16);
  CheckLoopsTogether();
  CheckRounding();
  CheckChildProcess();
  return Finish();
}
