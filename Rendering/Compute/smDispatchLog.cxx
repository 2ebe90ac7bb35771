#include "Detail/smDispatchLog.h"

#include "vtkComputeContext.h"

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>

namespace sm
{
void LogDispatch(vtkComputeContext* context, const std::string& program)
{
  static const char* const path = std::getenv("SOLIDMOMENTS_DISPATCH_LOG");
  if (!path || !*path)
  {
    return;
  }
  // The renderer is set when the context is ready: programs of the start-up probe run before that.
  const std::string renderer = context->GetRenderer();
  if (renderer.empty())
  {
    return;
  }
  static std::mutex mutex;
  static std::set<std::string> written;
  const std::string line = program + "\t" + renderer + "\t" + context->GetVersionString() + "\n";
  const std::lock_guard<std::mutex> lock(mutex);
  if (!written.insert(line).second)
  {
    return;
  }
  if (std::FILE* file = std::fopen(path, "a"))
  {
    // Unbuffered, so that the line is one write() at the end of the file.
    std::setvbuf(file, nullptr, _IONBF, 0);
    std::fwrite(line.data(), 1, line.size(), file);
    std::fclose(file);
  }
}
}
