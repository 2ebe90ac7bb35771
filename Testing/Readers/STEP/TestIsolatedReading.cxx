// TestIsolatedReading SOLIDS OUTPUT: a reader that reads in a process of its own puts out the same bits, and
// outlives that process whatever becomes of it.
#include "smMessageTrap.h"
#include "smReaderTesting.h"
#include "smTestManifest.h"

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkTimerLog.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{
using namespace smtest;

void CheckNoProcessIsLeft(const std::string& what)
{
  CheckTrue(what + ": no process is left", waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD);
}

/// Everything that the reader puts out, except for the times.
std::vector<char> GetOutput(vtkSTEPReader* reader)
{
  std::vector<char> bytes = reader->PackOutput();
  std::uint64_t head = 0;
  std::memcpy(&head, bytes.data(), sizeof(head));
  const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(sizeof(head) + head);
  bytes.erase(first, first + 5 * sizeof(double));
  return bytes;
}

void CheckSame(const std::string& path, const std::string& unit, double deflection)
{
  const std::string what = path.substr(path.find_last_of('/') + 1);
  std::vector<char> outputs[2];
  for (const bool isolated : { false, true })
  {
    vtkNew<vtkSTEPReader> reader;
    const MessageTrap trap(reader);
    reader->SetFileName(path.c_str());
    reader->SetIsolated(isolated);
    reader->SetOutputUnit(unit);
    reader->SetLinearDeflection(deflection);
    reader->Update();
    outputs[isolated ? 1 : 0] = GetOutput(reader);
    const bool isRead = reader->GetStatus() == vtkSTEPReader::OK;
    CheckEqual(what + ": errors", isRead ? 0 : 1, trap.NumberOfErrors);
    CheckEqual(what + ": error code", isRead ? 0 : 1, reader->GetErrorCode() != 0 ? 1 : 0);
    CheckTrue(what + ": time", !isRead || reader->GetReadSeconds() > 0.0);
  }
  CheckTrue(what + ": the same bits", outputs[0] == outputs[1] && outputs[0].size() > 100,
    std::to_string(outputs[0].size()) + " and " + std::to_string(outputs[1].size()) + " bytes");
  CheckNoProcessIsLeft(what);
}

/// The process that this thread has started; 0 if there is none.
pid_t GetChild()
{
  const std::string thread = std::to_string(syscall(SYS_gettid));
  std::ifstream children("/proc/self/task/" + thread + "/children");
  pid_t child = 0;
  children >> child;
  return child;
}

/// Acts once, on the process that reads, as soon as there is progress.
struct Actor
{
  vtkSTEPReader* Reader;
  std::function<void(pid_t)> Act;
  bool IsDone = false;

  void OnProgress()
  {
    // Before, it may not have started.
    const pid_t child = this->IsDone || this->Reader->GetProgress() == 0.0 ? 0 : GetChild();
    if (child > 0)
    {
      this->IsDone = true;
      this->Act(child);
    }
  }
};

void ReadAndAct(vtkSTEPReader* reader, const std::string& path, const std::function<void(pid_t)>& act)
{
  Actor actor{ reader, act };
  const unsigned long id = reader->AddObserver(vtkCommand::ProgressEvent, &actor, &Actor::OnProgress);
  reader->SetFileName(path.c_str());
  reader->Modified();
  reader->Update();
  reader->RemoveObserver(id);
  CheckTrue("there was a process", actor.IsDone);
}

void CheckEnds(const std::string& path)
{
  vtkNew<vtkSTEPReader> reader;
  const MessageTrap trap(reader);
  reader->IsolatedOn();
  // A fine mesh takes the process long enough to be killed before it is done.
  reader->SetLinearDeflection(1e-6);
  // On a busy machine the process may be done before this one gets to kill it.
  for (int attempt = 0; attempt < 20 && std::string(reader->GetStatusAsString()) != "unreadable"; ++attempt)
  {
    ReadAndAct(reader, path, [](pid_t child) { kill(child, SIGSEGV); });
  }
  CheckEqual("crash: status", "unreadable", reader->GetStatusAsString());
  CheckTrue("crash: error", trap.Errors.find("ended by signal 11") != std::string::npos, trap.Errors);
  CheckEqual("crash: datasets", 0, reader->GetOutput()->GetNumberOfPartitionedDataSets());
  CheckNoProcessIsLeft("crash");

  ReadAndAct(reader, path, [&](pid_t) { reader->AbortExecuteOn(); });
  CheckEqual("abort: status", "aborted", reader->GetStatusAsString());
  CheckNoProcessIsLeft("abort");

  reader->SetMaximumSeconds(1.0);
  const double start = vtkTimerLog::GetUniversalTime();
  ReadAndAct(reader, path, [](pid_t child) { kill(child, SIGSTOP); });
  CheckEqual("hang: status", "aborted", reader->GetStatusAsString());
  CheckTrue("hang: it was not waited for", vtkTimerLog::GetUniversalTime() - start < 60.0);
  CheckNoProcessIsLeft("hang");

  reader->SetMaximumSeconds(0.0);
  reader->SetLinearDeflection(0.001);
  reader->Modified();
  reader->Update();
  CheckEqual("and then the file is read", "ok", reader->GetStatusAsString());
  CheckEqual("instances", 1, reader->GetNumberOfInstances());
}

/// Without the program next to its library the reader reads here, and says so.
int CheckLonely(const std::string& path)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->IsolatedOn();
  reader->Update();
  CheckEqual("without the program: status", "ok", reader->GetStatusAsString());
  CheckTrue("and a message",
    reader->GetNumberOfMessages() > 0 && reader->GetMessage(0).find("was not found") != std::string::npos,
    reader->GetMessage(0));
  return Finish();
}

/// Runs this test with a copy of the reader's library that lies alone.
void RunLonely(const std::string& solids)
{
  std::string library;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; library.empty() && std::getline(maps, line);)
  {
    library = line.find("libsmReadersSTEP") != std::string::npos ? line.substr(line.find('/')) : "";
  }
  const std::filesystem::path folder = Folder + "lonely/a/b/c/d";
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(library, folder / std::filesystem::path(library).filename(),
    std::filesystem::copy_options::overwrite_existing);
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "LD_LIBRARY_PATH='" + folder.string() + ":" +
    std::filesystem::path(library).parent_path().string() + "':\"$LD_LIBRARY_PATH\" '" + program +
    "' TestIsolatedReading '" + solids + "' '" + Folder + "' lonely";
  CheckEqual("the same alone", 0, std::system(command.c_str()));
}
}

int TestIsolatedReading(int argc, char* argv[])
{
  if (argc < 3)
  {
    return 1;
  }
  if (argc > 3)
  {
    return CheckLonely(Manifest(argv[1]).GetSolid("box", "plain")[0].Path);
  }
  const Manifest manifest(argv[1]);
  for (const char* solid : { "slanted_hole", "spline_ring", "hollow_sphere" })
  {
    for (const Expected& expected : manifest.GetSolid(solid))
    {
      CheckSame(expected.Path, "mm", 0.001);
    }
  }
  CheckSame(manifest.GetSolid("box", "inch")[0].Path, "file", 1.0 / 3.0);
  Folder = std::string(argv[2]) + "/";
  WriteAssembly(Folder + "isolated_assembly.step");
  CheckSame(Folder + "isolated_assembly.step", "mm", 0.001);
  for (const char* special : { "assembly", "open_shell", "no_geometry" })
  {
    CheckSame(manifest.GetSpecial(special).Path, "m", 0.01);
  }
  CheckSame(Folder + "there is none.step", "mm", 0.001);
  CheckSame(manifest.GetSolid("box", "plain")[0].Path, "parsec", 0.001);
  RunLonely(argv[1]);
  CheckEnds(manifest.GetSolid("slanted_hole", "moved")[0].Path);
  return Finish();
}
