// TestSafeFile FOLDER: bytes are on the disk before they replace a file, and what a process left that was
// killed is removed.
#include "smSafeFile.h"
#include "smTesting.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
using namespace smtest;

std::string Target;
/// The contents of the file and of its temporary file when the library called fsync().
std::string BeforeSync;
std::string Synced;
int Syncs = 0;

std::string ReadText(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

void CheckSync()
{
  CheckEqual("first", "", sm::SaveFile(Target, "first"));
  CheckEqual("calls", 1, Syncs);
  CheckEqual("second", "", sm::SaveFile(Target, "second"));
  CheckEqual("the first is there", "first", BeforeSync);
  CheckEqual("until the second is on the disk", "second", Synced);
  CheckEqual("and then the second", "second", ReadText(Target));
}

/// A process that writes, and is killed if `killed`; returns its number.
pid_t StartWriter()
{
  int ready[2];
  const bool piped = pipe(ready) == 0;
  const pid_t child = piped ? fork() : -1;
  if (child == 0)
  {
    sm::SafeFile file(Target);
    file.GetStream() << "half";
    file.GetStream().flush();
    const bool told = write(ready[1], "x", 1) == 1;
    pause();
    _exit(told ? 0 : 1);
  }
  char x = 0;
  CheckTrue("a writer", child > 0 && read(ready[0], &x, 1) == 1);
  close(ready[0]);
  close(ready[1]);
  return child;
}

void Age(const std::string& path)
{
  fs::last_write_time(path, fs::last_write_time(path) - std::chrono::minutes(2));
}

void CheckLeft()
{
  const std::string left = Target + ".saving0";
  const pid_t child = StartWriter();
  Age(left);
  CheckEqual("next to a writer", "", sm::SaveFile(Target, "third"));
  CheckEqual("its file stays", "half", ReadText(left));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  fs::last_write_time(left, fs::file_time_type::clock::now());
  CheckEqual("after it was killed", "", sm::SaveFile(Target, "fourth"));
  CheckTrue("its file stays for a minute", fs::exists(left));
  Age(left);
  CheckEqual("later", "", sm::SaveFile(Target, "fifth"));
  CheckTrue("and is removed", !fs::exists(left) && !fs::exists(Target + ".saving1"));
  CheckEqual("the file", "fifth", ReadText(Target));
  // Files that are not ours to remove.
  fs::create_directory(left);
  CheckEqual("a folder of that name", "", sm::SaveFile(Target, "sixth"));
  CheckTrue("stays", fs::is_directory(left));
}
}

/// In place of the C library's.
extern "C" __attribute__((visibility("default"))) int fsync(int file)
{
  ++Syncs;
  BeforeSync = ReadText(Target);
  Synced = ReadText("/proc/self/fd/" + std::to_string(file));
  return static_cast<int>(syscall(SYS_fsync, file));
}

int TestSafeFile(int argc, char* argv[])
{
  if (argc != 2)
  {
    return 1;
  }
  const std::string folder = std::string(argv[1]) + "/safe_file";
  fs::remove_all(folder);
  fs::create_directories(folder);
  Target = folder + "/result.txt";
  CheckSync();
  CheckLeft();
  return Finish();
}
