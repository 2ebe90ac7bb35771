// TestKernelProcess FILE OUTPUT: what OpenCASCADE does in its process arrives here whatever becomes of the
// process: killed between requests, stopped, killed by another request, used by several threads, by a request
// within another one, and by a copy of this process. OpenCASCADE is never loaded here.
#include "smBodyCapture.h"
#include "smKernel.h"
#include "smTesting.h"

#include <vtkNew.h>
#include <vtkSTEPReader.h>
#include <vtkSTEPWriter.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace
{
using namespace smtest;

const sm::RepairWatch GoOn = [] { return true; };

/// The process that this thread has started; 0 if there is none.
pid_t GetChild()
{
  const std::string thread = std::to_string(syscall(SYS_gettid));
  std::ifstream children("/proc/self/task/" + thread + "/children");
  pid_t child = 0;
  children >> child;
  return child;
}

int CountFaces(const sm::ShapeGroup& group)
{
  std::size_t faces = 0;
  for (const sm::SolidUse& solid : group.Solids)
  {
    for (const sm::ShellUse& shell : solid.Solid->Shells)
    {
      faces += shell.Shell->Faces.size();
    }
  }
  return static_cast<int>(faces);
}

/// Repairs the body; returns why it failed.
std::string Repair(const sm::BodyShape& body, const sm::RepairWatch& watch = GoOn)
{
  sm::ShapeGroup result;
  sm::ShapeData data;
  data.FileId = 77;
  const std::string failure = sm::RepairBody(body, data, sm::RepairLimits(), watch, result);
  if (failure.empty())
  {
    const bool isWhole = result.Solids.size() == 1 && result.Solids[0].Solid->Data.FileId == 77 &&
      CountFaces(result) == static_cast<int>(body.Shells[0].Shell->Faces.size());
    return isWhole ? "" : "it lost faces";
  }
  return failure;
}

void CheckRepairs(const sm::BodyShape& body)
{
  CheckEqual("a repair", "", Repair(body));
  const pid_t child = GetChild();
  CheckTrue("it has a process", child > 0);
  CheckEqual("a second repair", "", Repair(body));
  CheckEqual("it has the same process", child, GetChild());
  std::vector<const sm::FaceShape*> repaired;
  const sm::BodyShape patched =
    sm::RepairFaces(body, { body.Shells[0].Shell->Faces[3].Face.get() }, sm::RepairLimits(), GoOn, repaired);
  CheckEqual("repaired faces", 1, static_cast<int>(repaired.size()));
  int same = 0;
  for (std::size_t i = 0; i < body.Shells[0].Shell->Faces.size(); ++i)
  {
    same += patched.Shells[0].Shell->Faces[i].Face == body.Shells[0].Shell->Faces[i].Face ? 1 : 0;
  }
  CheckEqual(
    "the other faces are the same objects", static_cast<int>(body.Shells[0].Shell->Faces.size()) - 1, same);
}

void CheckEnds(const sm::BodyShape& body)
{
  kill(GetChild(), SIGKILL);
  CheckEqual("after its process was killed", "", Repair(body));
  pid_t child = GetChild();
  kill(child, SIGSTOP);
  int calls = 0;
  CheckEqual("a process that hangs, and is killed then", "",
    Repair(body,
      [&]
      {
        ++calls;
        kill(child, SIGKILL);
        return true;
      }));
  CheckTrue("it was watched", calls > 0);
  child = GetChild();
  kill(child, SIGSTOP);
  calls = 0;
  CheckEqual(
    "a process that hangs, and is stopped", "it was stopped", Repair(body, [&] { return ++calls < 3; }));
  CheckEqual("calls", 3, calls);
  CheckTrue("no process is left", waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD);
  CheckEqual("and then", "", Repair(body));
  kill(GetChild(), SIGSTOP);
  bool isThrown = false;
  try
  {
    Repair(body, []() -> bool { throw std::runtime_error("by hand"); });
  }
  catch (const std::runtime_error&)
  {
    isThrown = true;
  }
  CheckTrue("an exception of the callback passes", isThrown);
  CheckTrue("no process is left", waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD);
}

void CheckUsers(const sm::BodyShape& body)
{
  std::string failures[4];
  std::vector<std::thread> threads;
  for (std::string& failure : failures)
  {
    threads.emplace_back(
      [&]
      {
        for (int i = 0; i < 5 && failure.empty(); ++i)
        {
          failure = Repair(body);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::string& failure : failures)
  {
    CheckEqual("a thread", "", failure);
  }
  CheckEqual("after the threads", "", Repair(body));
  const pid_t child = GetChild();
  kill(child, SIGSTOP);
  std::string inner = "none";
  CheckEqual("a request", "",
    Repair(body,
      [&]
      {
        inner = inner == "none" ? Repair(body) : inner;
        kill(child, SIGCONT);
        return true;
      }));
  CheckEqual("a request within it", "", inner);
  const pid_t copy = fork();
  if (copy == 0)
  {
    const bool isGood = Repair(body).empty() && Repair(body).empty();
    std::_Exit(isGood ? 0 : 1);
  }
  int status = -1;
  waitpid(copy, &status, 0);
  CheckEqual("a copy of this process", 0, status);
  CheckEqual("and this process", "", Repair(body));
}

/// Writes the part; returns true if that worked.
bool Write(vtkSTEPReader* reader, const std::string& path)
{
  vtkNew<vtkSTEPWriter> writer;
  writer->SetInputDataObject(reader->GetOutput());
  writer->SetFileName(path.c_str());
  return writer->Write() == 1;
}

/// After a write, too, a request does not depend on the thread and the process of the one before.
void CheckWrites(const sm::BodyShape& body, const std::string& file, const std::string& output)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  const std::string path = output + "/kernel_process.step";
  for (int i = 0; i < 4; ++i)
  {
    bool isWritten = false;
    std::thread([&] { isWritten = Write(reader, path); }).join();
    CheckTrue("a write in a thread of its own", isWritten);
  }
  kill(GetChild(), SIGINT);
  CheckTrue("a write after an interrupt", Write(reader, path));
  kill(GetChild(), SIGKILL);
  CheckEqual("a repair after a write whose process was killed", "", Repair(body));
  CheckTrue("a write", Write(reader, path));
  kill(GetChild(), SIGKILL);
  CheckTrue("a write after one whose process was killed", Write(reader, path));
}

void CheckBREP()
{
  const sm::BREPContent content =
    sm::ReadBREPShapes("CASCADE Topology V1, (c) Matra-Datavision\n", [](double) { return true; });
  CheckTrue(
    "a part of a file", content.Problem.find("it ends in the middle") != std::string::npos, content.Problem);
}

void CheckNotLoaded()
{
  std::ifstream maps("/proc/self/maps");
  int libraries = 0;
  bool hasReader = false;
  for (std::string line; std::getline(maps, line);)
  {
    libraries += line.find("libTK") != std::string::npos ? 1 : 0;
    hasReader = hasReader || line.find("libsmReadersSTEP") != std::string::npos;
  }
  CheckTrue("the reader is loaded", hasReader);
  CheckEqual("parts of OpenCASCADE's libraries in this process", 0, libraries);
}
}

int TestKernelProcess(int argc, char* argv[])
{
  if (argc < 3)
  {
    return 1;
  }
  const sm::BodyShape body = CaptureBodies(argv[1]).at(0);
  CheckRepairs(body);
  CheckEnds(body);
  CheckUsers(body);
  CheckWrites(body, argv[1], argv[2]);
  CheckBREP();
  CheckNotLoaded();
  return Finish();
}
