// Threads that ask for the X display at the same time get one connection.
#include "Detail/smCurrentContext.h"
#include "smTesting.h"

#include <array>
#include <atomic>
#include <thread>
#include <vector>

using namespace smtest;

int TestComputeContextDisplays(int, char*[])
{
  std::array<void*, 8> displays{};
  std::atomic<std::size_t> ready{ 0 };
  std::vector<std::thread> threads;
  for (void*& display : displays)
  {
    threads.emplace_back(
      [&display, &displays, &ready]
      {
        // The first call opens the connection, so all threads make theirs together.
        for (++ready; ready < displays.size();)
        {
          std::this_thread::yield();
        }
        const char* reason = "";
        display = sm::GetXDisplay(reason);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  CheckTrue("a display", displays[0] != nullptr);
  for (void* display : displays)
  {
    CheckTrue("the same display", display == displays[0]);
  }
  return Finish();
}
