// Exceptions of worker threads arrive in the calling thread, and a loop without any visits every index once.
#include "smParallelFor.h"
#include "smTesting.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace smtest;

void CheckEveryIndex(std::size_t grain)
{
  std::vector<int> visits(10007, 0);
  std::atomic<bool> areMultiples{ true };
  sm::ParallelFor(visits.size(), grain,
    [&](std::size_t begin, std::size_t end)
    {
      areMultiples = areMultiples && (grain == 0 || begin % grain == 0);
      for (std::size_t i = begin; i < end; ++i)
      {
        ++visits[i];
      }
    });
  CheckTrue("every index once, grain " + std::to_string(grain),
    std::all_of(visits.begin(), visits.end(), [](int count) { return count == 1; }));
  CheckTrue("parts begin at multiples of the grain", areMultiples);
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
  // TBB cuts a loop in halves.
  for (const char* backend : { "Sequential", "OpenMP", "TBB" })
  {
    if (vtkSMPTools::SetBackend(backend))
    {
      std::printf("--- %s\n", backend);
      CheckEveryIndex(64);
      CheckEveryIndex(0);
    }
  }
  return Finish();
}
