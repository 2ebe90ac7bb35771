/**
 * @file smHelperProcess.h
 * @brief Child processes, a program or a function of this one, that send messages through a pipe; not
 * installed
 *
 * A message is its kind, one byte, the number of bytes that follow, and these bytes. A function of this
 * process ends with the thread that started it, a program with this process. Other output of a child to the
 * standard output is discarded.
 */
#ifndef smHelperProcess_h
#define smHelperProcess_h

#include "smBytes.h"
#include "smFiltersCommonModule.h"

#include <csignal>
#include <functional>
#include <limits>
#include <string>
#include <sys/types.h>
#include <vector>

namespace sm
{
/// How a child ended.
struct SMFILTERSCOMMON_EXPORT ProcessEnd
{
  int Status = 0;          ///< of waitpid(); SIGXCPU at a limit of processor time, soft or hard
  bool IsTimeOver = false; ///< killed after the time of SetSecondsLeft()
  bool IsOutOfMemory = false;
  double PeakMegabytes = 0.0;

  /// Returns true if the cause is not in the child's work: a limit of time, memory or stack, or
  /// SIGKILL.
  bool IsForced() const;
  /// Returns the number of the signal that ended the child; 0 if none did.
  int GetSignal() const;
  /// Returns the predicate of a sentence about the child, "ended by signal 11 (Segmentation fault)"; empty if
  /// it ended with exit status 0.
  std::string Describe() const;
};

class SMFILTERSCOMMON_EXPORT HelperProcess
{
public:
  using Listener = std::function<void(char kind, Bytes content)>;

  /// `take` gets every message in Wait().
  explicit HelperProcess(Listener take);
  /// Kills the child if it still runs.
  ~HelperProcess();
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;

  /// Starts a program whose standard input gets the messages of Send(), and ends with this process; its
  /// standard error is discarded. Returns the predicate of a sentence about the program, "could not be
  /// started: ..."; empty if it runs.
  std::string Start(const std::string& program, const std::vector<std::string>& arguments);
  /// Sends a message to the program of Start(). `watch` is called about ten times a second as long as
  /// the program does not take the bytes, and returns false to stop. Returns false if that or the time of
  /// SetSecondsLeft() stopped it, or if the program has ended.
  bool Send(char kind, const Bytes& content, const std::function<bool()>& watch);
  /// Starts a copy of this process, which calls `work` with the descriptor for its messages and ends with
  /// exit status 0. Call from a process with one thread. Signal handlers that report a lack of memory are
  /// installed only if the memory is limited (ulimit -v). Returns why there is no child; empty if there is
  /// one.
  std::string Fork(const std::function<void(int descriptor)>& work);

  /// Limits the time in Wait(); other time does not count, because a full pipe stops the child.
  void SetSecondsLeft(double seconds) { this->SecondsLeft = seconds; }
  bool IsRunning() const { return this->Pipe >= 0; }
  /// Ends the child, which runs until Wait() sees its end.
  void Kill();
  /// Waits at most `seconds` until one of the children, all of which must be running, sends bytes or ends.
  /// Kills those whose time has elapsed.
  static void Wait(const std::vector<HelperProcess*>& helpers, double seconds);
  /// Returns how the child ended. Call when it no longer runs.
  const ProcessEnd& GetEnd() const { return this->End; }

private:
  void Receive();
  void TakeMessages();
  void TakeEnd();

  Listener Take;
  Bytes Pending;
  ProcessEnd End;
  pid_t Id = -1;
  pid_t Parent = -1; ///< the process that started the child; a copy of it leaves the child alone
  int Pipe = -1;     ///< -1: there is no child, or it has ended
  int Requests = -1; ///< a socket that is the child's standard input; -1: none
  double SecondsLeft = std::numeric_limits<double>::infinity();
  bool IsKilled = false;
  volatile std::sig_atomic_t* OutOfMemory = nullptr; ///< shared with the child of Fork(), which sets it
  long MemoryKills = 0;                              ///< of the system, before the child
};

/// Returns the path of a program in the folder bin next to that of this library, or next to a folder above
/// it; empty if it is not there.
SMFILTERSCOMMON_EXPORT std::string FindProgram(const std::string& name);

/// For a process that a HelperProcess started: returns the descriptor for its messages, -1 if there is none.
/// The standard output is /dev/null afterwards.
SMFILTERSCOMMON_EXPORT int OpenMessages();
/// For a program that HelperProcess::Start() started: ends it as soon as its standard input is closed, also
/// while it works.
SMFILTERSCOMMON_EXPORT void EndWithInput();
/// Sends a message to the other process; returns false if it has ended.
SMFILTERSCOMMON_EXPORT bool SendMessage(int descriptor, char kind, const void* bytes, std::size_t size);
/// Waits for the next message of Send(); returns false if the other process has ended.
SMFILTERSCOMMON_EXPORT bool ReceiveMessage(int descriptor, char& kind, Bytes& content);
}

#endif
