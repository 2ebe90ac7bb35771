#include "smIsolatedJob.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace
{
volatile std::sig_atomic_t Interrupted = 0; ///< the signal

void OnInterrupt(int number)
{
  Interrupted = number;
}

/// Writes one line of JSON. Names in files may be in any encoding; bytes that are not UTF-8 are replaced.
void WriteLine(int descriptor, const sm::Json& message)
{
  const std::string line = sm::Dump(message) + "\n";
  size_t done = 0;
  while (done < line.size())
  {
    const ssize_t count = write(descriptor, line.data() + done, line.size() - done);
    if (count < 0 && errno != EINTR)
    {
      _exit(1); // the parent has closed the pipe
    }
    done += count > 0 ? static_cast<size_t>(count) : 0;
  }
}

[[noreturn]] void RunChild(const sm::JobOptions& options, int descriptor)
{
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  // The standard output is for the results only, so the output of libraries goes to /dev/null.
  const int null = open("/dev/null", O_WRONLY);
  if (null >= 0)
  {
    dup2(null, STDOUT_FILENO);
    close(null);
  }
  sm::RunFileJob(options, [descriptor](const sm::Json& message) { WriteLine(descriptor, message); });
  // Without the destructors of static objects in third-party libraries, which could only fail.
  _exit(0);
}

/// Collects the messages of the child.
struct Listener
{
  const sm::ProgressListener& Progress;
  sm::Json Result;
  sm::Json Textures;
  sm::Json Picture;
  std::string Stage = "start";
  std::string Pending;

  void Take(const sm::Json& message)
  {
    if (message.contains("progress"))
    {
      this->Stage = message["progress"][0].get<std::string>();
      this->Progress(this->Stage, message["progress"][1].get<double>());
    }
    else if (message.contains("result"))
    {
      this->Result = message["result"];
    }
    else if (message.contains("textures"))
    {
      this->Textures = message["textures"];
    }
    else if (message.contains("picture"))
    {
      this->Picture = message["picture"];
    }
  }

  void Append(const char* bytes, size_t count)
  {
    this->Pending.append(bytes, count);
    size_t begin = 0;
    for (size_t end = this->Pending.find('\n'); end != std::string::npos;
         end = this->Pending.find('\n', begin))
    {
      const sm::Json message = sm::Json::parse(this->Pending.begin() + static_cast<long>(begin),
        this->Pending.begin() + static_cast<long>(end), nullptr, false);
      if (message.is_object())
      {
        this->Take(message);
      }
      begin = end + 1;
    }
    this->Pending.erase(0, begin);
  }
};

void Listen(int descriptor, pid_t child, Listener& listener)
{
  char buffer[65536];
  for (;;)
  {
    const ssize_t count = read(descriptor, buffer, sizeof(buffer));
    if (count > 0)
    {
      listener.Append(buffer, static_cast<size_t>(count));
    }
    else if (count == 0 || errno != EINTR)
    {
      return;
    }
    if (Interrupted)
    {
      kill(child, SIGKILL);
      return;
    }
  }
}

/// Returns a description of the child's exit; empty if it ended normally.
std::string DescribeEnd(int status)
{
  if (WIFSIGNALED(status))
  {
    const int number = WTERMSIG(status);
    return "ended by signal " + std::to_string(number) + " (" + strsignal(number) + ")";
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) != 0)
  {
    return "ended with exit status " + std::to_string(WEXITSTATUS(status));
  }
  return {};
}

/// A child process and the pipe that its messages come through.
struct Child
{
  pid_t Process = -1;
  int Pipe = -1;
  std::string Error; ///< why there is no child; empty: there is one
};

Child StartChild(const sm::JobOptions& options)
{
  struct stat info = {};
  if (stat(options.FileName.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
  {
    // Reading a pipe or a device may never end.
    return { -1, -1, "Cannot read " + options.FileName + ": not a regular file." };
  }
  int ends[2];
  if (pipe(ends) != 0)
  {
    return { -1, -1, std::string("no pipe to a child process: ") + std::strerror(errno) };
  }
  const pid_t process = fork();
  if (process == 0)
  {
    close(ends[0]);
    RunChild(options, ends[1]);
  }
  const int error = errno;
  close(ends[1]);
  if (process < 0)
  {
    close(ends[0]);
    return { -1, -1, std::string("no child process: ") + std::strerror(error) };
  }
  return { process, ends[0], {} };
}

/// Adds the reasons why pictures are missing that were asked for. `end` is that of DescribeEnd().
void FindPictureErrors(
  const sm::JobOptions& options, const Listener& listener, const std::string& end, sm::JobOutcome& outcome)
{
  // The status already tells why an unreadable or empty file has no pictures.
  const sm::Json& status = outcome.File["status"];
  if (!options.TexturePrefix.empty() && status != "unreadable")
  {
    outcome.TextureError = listener.Textures.is_string() ? listener.Textures.get<std::string>()
                                                         : "the process ended before they were written";
  }
  if (!options.PictureName.empty() && status != "unreadable" && status != "empty")
  {
    outcome.PictureError = listener.Picture.is_string() ? listener.Picture.get<std::string>()
      : end.empty()                                     ? "the process that drew it ended without one"
                                                        : "the process that drew it " + end;
  }
}
}

namespace sm
{
JobOutcome RunIsolatedJob(const JobOptions& options, const ProgressListener& progress)
{
  const Child child = StartChild(options);
  if (!child.Error.empty())
  {
    return { UnreadableFile(options.FileName, child.Error), {}, {} };
  }
  Listener listener{ progress, nullptr, nullptr, nullptr, "start", {} };
  Listen(child.Pipe, child.Process, listener);
  close(child.Pipe);
  int status = 0;
  while (waitpid(child.Process, &status, 0) < 0 && errno == EINTR)
  {
  }

  JobOutcome outcome;
  outcome.File = listener.Result;
  if (outcome.File.is_object())
  {
    // The pipe carries UTF-8 only; the table and the CSV show the name with its own bytes.
    outcome.File["file"] = options.FileName;
  }
  if (Interrupted)
  {
    return outcome;
  }
  const std::string end = DescribeEnd(status);
  if (outcome.File.is_null())
  {
    outcome.File = UnreadableFile(options.FileName,
      "the process that worked on this file " + (end.empty() ? "ended without a result" : end) +
        " in stage \"" + listener.Stage + "\"; the file is malformed or the CAD kernel cannot read it");
  }
  else if (!end.empty())
  {
    outcome.File["messages"].push_back(
      "the process that worked on this file " + end + " after it had sent the result");
  }
  FindPictureErrors(options, listener, end, outcome);
  return outcome;
}

void CatchInterrupt()
{
  struct sigaction action = {};
  action.sa_handler = OnInterrupt; // without SA_RESTART: a blocked read must return
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool IsInterrupted()
{
  return Interrupted != 0;
}

void EndByInterrupt()
{
  const int number = Interrupted;
  std::signal(number, SIG_DFL);
  raise(number);
  _exit(128 + number);
}
}
