#include "smIsolatedJob.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
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

/// One line of JSON. Names in files may be in any encoding: what is not UTF-8 is replaced, not refused.
void WriteLine(int descriptor, const sm::Json& message)
{
  const std::string line = message.dump(-1, ' ', false, sm::Json::error_handler_t::replace) + "\n";
  size_t done = 0;
  while (done < line.size())
  {
    const ssize_t count = write(descriptor, line.data() + done, line.size() - done);
    if (count < 0 && errno != EINTR)
    {
      _exit(1); // nobody listens any more
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
  // The standard output belongs to the results; whatever a library prints goes nowhere.
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0)
  {
    dup2(nowhere, STDOUT_FILENO);
    close(nowhere);
  }
  sm::RunFileJob(options, [descriptor](const sm::Json& message) { WriteLine(descriptor, message); });
  // The destructors of static objects in third-party libraries have nothing to add.
  _exit(0);
}

/// Collects what the child says.
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

/// How the child ended, when that is worth a word.
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
}

namespace sm
{
JobOutcome RunIsolatedJob(const JobOptions& options, const ProgressListener& progress)
{
  struct stat info = {};
  if (stat(options.FileName.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
  {
    // Reading a pipe or a device may never end.
    return { UnreadableFile(options.FileName, "Cannot read " + options.FileName + ": not a regular file."),
      {}, {} };
  }
  int ends[2];
  if (pipe(ends) != 0)
  {
    return { UnreadableFile(
               options.FileName, std::string("no pipe to a child process: ") + std::strerror(errno)),
      {}, {} };
  }
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    RunChild(options, ends[1]);
  }
  close(ends[1]);
  if (child < 0)
  {
    const int error = errno;
    close(ends[0]);
    return { UnreadableFile(options.FileName, std::string("no child process: ") + std::strerror(error)), {},
      {} };
  }

  Listener listener{ progress, nullptr, nullptr, nullptr, "start", {} };
  Listen(ends[0], child, listener);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }

  JobOutcome outcome;
  outcome.File = listener.Result;
  if (outcome.File.is_object())
  {
    // What came through the pipe has lost the bytes that are not UTF-8.
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
        " in stage \"" + listener.Stage + "\"; the file is malformed or the CAD kernel cannot digest it");
  }
  else if (!end.empty())
  {
    outcome.File["messages"].push_back(
      "the process that worked on this file " + end + " after the result was there");
  }
  // A file that gave nothing to draw has said so by its status.
  if (!options.TexturePrefix.empty() && outcome.File["status"] != "unreadable")
  {
    outcome.TextureError =
      listener.Textures.is_string() ? listener.Textures.get<std::string>() : "the process ended before";
  }
  const bool isDrawable = outcome.File["status"] != "unreadable" && outcome.File["status"] != "empty";
  if (!options.PictureName.empty() && isDrawable)
  {
    outcome.PictureError = listener.Picture.is_string() ? listener.Picture.get<std::string>()
      : end.empty()                                     ? "the process that drew it ended without one"
                                                        : "the process that drew it " + end;
  }
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
