#include "smReadProgram.h"

#include "smHelperProcess.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <dlfcn.h>
#include <unistd.h>
#include <utility>

namespace sm
{
namespace
{
/// Time in seconds after which the progress callback is called again if there is no news.
constexpr double Patience = 0.1;
/// Number of folders above that of the library that are searched; the library may be in lib/TRIPLET/ParaView.
constexpr int Levels = 4;

std::string DescribeEnd(const ProcessEnd& end)
{
  const int number = end.GetSignal();
  const bool isCrash =
    number == SIGSEGV || number == SIGBUS || number == SIGABRT || number == SIGFPE || number == SIGILL;
  return number != 0
    ? end.Describe() + (isCrash ? "; the file is malformed or OpenCASCADE cannot read it" : "")
    : end.Status == 0 ? "ended without a result"
                      : end.Describe() + " and without a result";
}
}

std::string FindReadProgram()
{
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&FindReadProgram), &info) == 0 || !info.dli_fname)
  {
    return {};
  }
  std::string folder = vtksys::SystemTools::GetFilenamePath(vtksys::SystemTools::GetRealPath(info.dli_fname));
  for (int i = 0; i < Levels && !folder.empty(); ++i)
  {
    const std::string program = folder + "/bin/solidmoments-read";
    if (access(program.c_str(), X_OK) == 0)
    {
      return program;
    }
    folder = vtksys::SystemTools::GetFilenamePath(folder);
  }
  return {};
}

ReadProgramOutcome RunReadProgram(const std::string& program, const std::vector<std::string>& arguments,
  const std::string* input, const ProgressCallback& progress)
{
  ReadProgramOutcome outcome;
  bool isComplete = false;
  double fraction = 0.0;
  HelperProcess helper(
    [&](char kind, Bytes content)
    {
      outcome.IsStarted = true;
      if (kind == ReadProgress && content.size() == sizeof(fraction))
      {
        std::memcpy(&fraction, content.data(), sizeof(fraction));
      }
      else if (kind == RepairBegins || kind == RepairEnds)
      {
        outcome.IsRepairing = kind == RepairBegins;
      }
      else if (kind == ReadResult)
      {
        outcome.Result = std::move(content);
        isComplete = true;
      }
    });
  outcome.Problem = helper.Start(program, arguments, input);
  double shown = -1.0;
  auto last = std::chrono::steady_clock::now();
  while (helper.IsRunning())
  {
    HelperProcess::Wait({ &helper }, Patience);
    const auto now = std::chrono::steady_clock::now();
    if (fraction == shown && std::chrono::duration<double>(now - last).count() < Patience)
    {
      continue;
    }
    shown = fraction;
    last = now;
    if (!progress(fraction))
    {
      outcome.IsStopped = true;
      return outcome;
    }
  }
  if (outcome.Problem.empty() && !isComplete)
  {
    outcome.Problem = DescribeEnd(helper.GetEnd());
  }
  return outcome;
}
}
