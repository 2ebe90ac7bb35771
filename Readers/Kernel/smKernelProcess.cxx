#include "smKernelProcess.h"

#include "smHelperProcess.h"
#include "smKernelMessages.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <iterator>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <unistd.h>
#include <utility>

namespace sm
{
namespace
{
/// Time in seconds after which the progress callback is called again if there is no news.
constexpr double Patience = 0.1;
/// A request may take so many seconds, and more for each of its bytes.
constexpr double MinSeconds = 60.0;
constexpr double SecondsPerByte = 20e-6;

/// Returns true for a process that ended by an error of its own, and was not ended from outside.
bool IsError(const ProcessEnd& end)
{
  constexpr int errors[] = { SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS, SIGTRAP };
  return !end.IsForced() &&
    std::find(std::begin(errors), std::end(errors), end.GetSignal()) != std::end(errors);
}

/// A running solidmoments-kernel.
class Server
{
public:
  Server()
    : Process([this](char kind, Bytes content) { this->Take(kind, std::move(content)); })
  {
  }

  /// Returns the predicate of a sentence about the program; empty if it runs.
  std::string Start()
  {
    const std::string program = FindProgram(kernel::ProgramName);
    return program.empty() ? "was not found: install it in the folder bin next to the libraries"
                           : this->Process.Start(program, {});
  }

  KernelAnswer Ask(char kind, const Bytes& request, const ProgressCallback& progress,
    const std::function<bool(const Bytes&)>& take)
  {
    const double seconds = MinSeconds + SecondsPerByte * static_cast<double>(request.size());
    this->Process.SetSecondsLeft(seconds);
    this->OnContent = &take;
    this->IsContentTaken = false;
    const auto watch = [&]
    {
      this->IsStopped = this->IsStopped || !progress(this->Fraction);
      return !this->IsStopped;
    };
    this->Process.Send(kind, request, watch);
    double shown = -1.0;
    auto last = std::chrono::steady_clock::now();
    while (this->Process.IsRunning() && !this->Result)
    {
      HelperProcess::Wait({ &this->Process }, Patience);
      const auto now = std::chrono::steady_clock::now();
      if (this->Fraction != shown || std::chrono::duration<double>(now - last).count() >= Patience)
      {
        shown = this->Fraction;
        last = now;
        watch();
      }
      if (this->IsOutOfMemory)
      {
        throw std::bad_alloc();
      }
      if (this->Process.IsRunning() && (this->IsStopped || this->IsOther))
      {
        this->Process.Kill();
      }
    }
    KernelAnswer answer;
    answer.IsStopped = this->IsStopped;
    if (this->Result)
    {
      answer.Result = std::move(*this->Result);
      this->Result.reset();
    }
    else if (!this->IsStopped)
    {
      answer.Problem = this->DescribeEnd(seconds);
      answer.IsCrash = !this->IsOther && IsError(this->Process.GetEnd());
    }
    this->Fraction = 0.0;
    return answer;
  }

  /// Returns true if the program waits for the next request of this process, and not of a copy of it.
  bool IsReady()
  {
    if (this->Process.IsRunning() && this->Owner == getpid())
    {
      this->Process.SetSecondsLeft(MinSeconds);
      HelperProcess::Wait({ &this->Process }, 0.0);
    }
    return this->Process.IsRunning() && !this->IsStopped && this->Owner == getpid();
  }
  /// Returns true if the program ended, though not because its time was over, before it sent a part of the
  /// answer.
  bool MayBeAskedAgain() const
  {
    return !this->Process.IsRunning() && !this->IsContentTaken && !this->Process.GetEnd().IsTimeOver;
  }

private:
  std::string DescribeEnd(double seconds) const
  {
    const ProcessEnd& end = this->Process.GetEnd();
    const std::string words = end.Describe();
    return this->IsOther ? "its program solidmoments-kernel is not of version " SOLIDMOMENTS_VERSION
                           ": install it together with the libraries"
      : end.IsTimeOver
      ? "its process did not answer within " + std::to_string(static_cast<long>(seconds)) + " s"
      : "its process " + (words.empty() ? "ended without a result" : words);
  }

  void Take(char kind, Bytes content)
  {
    if (kind == kernel::Version)
    {
      this->IsOther = std::string(content.begin(), content.end()) != SOLIDMOMENTS_VERSION;
    }
    else if (kind == kernel::Fraction && content.size() == sizeof(this->Fraction))
    {
      std::memcpy(&this->Fraction, content.data(), sizeof(this->Fraction));
    }
    else if (kind == kernel::Content && *this->OnContent && !this->IsStopped)
    {
      this->IsContentTaken = true;
      this->IsStopped = !(*this->OnContent)(content);
    }
    else if (kind == kernel::Result)
    {
      this->Result = std::move(content);
    }
    this->IsOutOfMemory = kind == kernel::OutOfMemory;
  }

  HelperProcess Process;
  const pid_t Owner = getpid();
  double Fraction = 0.0;
  const std::function<bool(const Bytes&)>* OnContent = nullptr;
  std::optional<Bytes> Result;
  bool IsStopped = false;
  bool IsContentTaken = false;
  bool IsOutOfMemory = false;
  /// True if the program is of another version.
  bool IsOther = false;
};

/// The process that waits for the next request; null: none.
class IdleServer
{
public:
  std::unique_ptr<Server> Exchange(std::unique_ptr<Server> other)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::swap(this->Idle, other);
    return other;
  }
  static IdleServer& Get()
  {
    static IdleServer idle;
    return idle;
  }

private:
  std::mutex Mutex;
  std::unique_ptr<Server> Idle;
};
}

KernelAnswer AskKernel(char kind, const Bytes& request, const ProgressCallback& progress,
  const std::function<bool(const Bytes&)>& take)
{
  std::unique_ptr<Server> server = IdleServer::Get().Exchange(nullptr);
  for (;;)
  {
    const bool isUsed = server && server->IsReady();
    if (!isUsed)
    {
      server = std::make_unique<Server>();
      const std::string problem = server->Start();
      if (!problem.empty())
      {
        return { {}, "its program solidmoments-kernel " + problem, false };
      }
    }
    KernelAnswer answer = server->Ask(kind, request, progress, take);
    // A process that has waited may end just before the request, for a reason that is not in it.
    const bool isLost = isUsed && !answer.Problem.empty() && server->MayBeAskedAgain();
    if (server->IsReady())
    {
      IdleServer::Get().Exchange(std::move(server));
    }
    if (!isLost)
    {
      return answer;
    }
    server.reset();
  }
}
}
