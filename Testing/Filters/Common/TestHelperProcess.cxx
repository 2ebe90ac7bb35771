// TestHelperProcess: messages of child processes, and how these end.
#include "smHelperProcess.h"
#include "smTesting.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace
{
using namespace smtest;

constexpr char Kind = 'k';

struct Outcome
{
  std::vector<sm::Bytes> Messages;
  sm::ProcessEnd End;
};

Outcome Run(const std::function<void(int)>& work, double seconds = 60.0)
{
  Outcome outcome;
  sm::HelperProcess helper(
    [&outcome](char kind, sm::Bytes content)
    {
      CheckTrue("kind", kind == Kind);
      outcome.Messages.push_back(std::move(content));
    });
  helper.SetSecondsLeft(seconds);
  CheckEqual("fork", "", helper.Fork(work));
  while (helper.IsRunning())
  {
    sm::HelperProcess::Wait({ &helper }, 1.0);
  }
  outcome.End = helper.GetEnd();
  return outcome;
}

sm::Bytes MakeBytes(std::size_t size)
{
  sm::Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    bytes[i] = static_cast<char>(i * i + size);
  }
  return bytes;
}

/// Messages that are empty, fit into the pipe together, or are longer than it, arrive whole and in their
/// order.
void CheckMessages()
{
  const std::vector<std::size_t> sizes = { 0, 1, 7, 65536, 3, 5000000, 0, 65527, 100 };
  const Outcome outcome = Run(
    [&sizes](int descriptor)
    {
      for (const std::size_t size : sizes)
      {
        const sm::Bytes bytes = MakeBytes(size);
        sm::SendMessage(descriptor, Kind, bytes.data(), bytes.size());
      }
    });
  CheckEqual("messages", static_cast<int>(sizes.size()), static_cast<int>(outcome.Messages.size()));
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    CheckTrue("message " + std::to_string(i), outcome.Messages[i] == MakeBytes(sizes[i]));
  }
  CheckEqual("a good end", "", outcome.End.Describe());
  CheckTrue("is not forced", !outcome.End.IsForced());
}

void CheckEnd(const std::string& what, const sm::ProcessEnd& end, const std::string& expected, bool isForced)
{
  CheckTrue(what, end.Describe().rfind(expected, 0) == 0, end.Describe());
  CheckTrue(what + ": forced", end.IsForced() == isForced);
}

void CheckEnds()
{
  CheckEnd("exit status", Run([](int) { _exit(7); }).End, "ended with exit status 7", false);
  CheckEnd("crash", Run([](int) { raise(SIGSEGV); }).End, "ended by signal 11", false);
  CheckEnd("killed", Run([](int) { raise(SIGKILL); }).End, "ended by signal 9", true);
  const auto start = std::chrono::steady_clock::now();
  const sm::ProcessEnd late = Run([](int) { sleep(600); }, 0.2).End;
  CheckTrue("its time is over", late.IsTimeOver && late.IsForced());
  CheckTrue("and nobody waits", std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
  const auto useMemory = [](int)
  {
    const rlimit limit{ 1 << 30, 1 << 30 };
    setrlimit(RLIMIT_AS, &limit);
    for (;;)
    {
      // A compiler may leave out memory that is not used.
      volatile char* const kept = new char[1 << 24];
      *kept = 1;
    }
  };
  CheckEnd("no memory", Run(useMemory).End, "ran out of memory and ended by signal", true);
  const auto useProcessor = [](int)
  {
    const rlimit limit{ 1, 5 };
    setrlimit(RLIMIT_CPU, &limit);
    for (volatile int i = 0;;)
    {
      i = i + 1;
    }
  };
  CheckEnd("processor time", Run(useProcessor).End, "used all the processor time", true);
}

/// A message that the child did not send whole is none.
void CheckPart()
{
  const Outcome outcome = Run(
    [](int descriptor)
    {
      const sm::Bytes whole = MakeBytes(10);
      sm::SendMessage(descriptor, Kind, whole.data(), whole.size());
      const std::string part = std::string(1, Kind) + std::string(8, '\1') + "abc";
      CheckTrue("written", write(descriptor, part.data(), part.size()) == static_cast<ssize_t>(part.size()));
    });
  CheckEqual("whole messages", 1, static_cast<int>(outcome.Messages.size()));
}

/// A program gets requests, whose bytes cat sends back; one that has ended takes none.
void CheckProgram()
{
  const auto goOn = []() { return true; };
  sm::Bytes received;
  sm::HelperProcess helper([&received](char, sm::Bytes content) { received = std::move(content); });
  CheckEqual("start", "", helper.Start("/bin/cat", {}));
  const sm::Bytes request = MakeBytes(300);
  CheckTrue("send", helper.Send(Kind, request, goOn));
  while (received.empty() && helper.IsRunning())
  {
    sm::HelperProcess::Wait({ &helper }, 1.0);
  }
  CheckTrue("cat sends it back", received == request);
  helper.Kill();
  while (helper.IsRunning())
  {
    sm::HelperProcess::Wait({ &helper }, 1.0);
  }
  CheckTrue("a program that has ended takes nothing", !helper.Send(Kind, request, goOn));
  sm::HelperProcess deaf([](char, const sm::Bytes&) {});
  CheckEqual("start", "", deaf.Start("/bin/sleep", { "600" }));
  int calls = 0;
  CheckTrue("one that does not read is stopped",
    !deaf.Send(Kind, MakeBytes(5000000), [&calls]() { return ++calls < 3; }));
  CheckEqual("calls", 3, calls);
  sm::HelperProcess none([](char, const sm::Bytes&) {});
  const std::string problem = none.Start("/bin/there is none", {});
  CheckTrue("no program", problem.rfind("could not be started: ", 0) == 0, problem);
  CheckTrue("does not run", !none.IsRunning());
}
}

int TestHelperProcess(int, char*[])
{
  CheckMessages();
  CheckEnds();
  CheckPart();
  CheckProgram();
  return Finish();
}
