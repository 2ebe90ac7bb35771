// TestWriterErrors SOLIDS OUTPUT: what the writers do where they cannot write, and that nothing is lost or
// left behind.
#include "smRoundTrip.h"
#include "smTestManifest.h"
#include "smWriterFiles.h"

#include <vtkErrorCode.h>
#include <vtkMatrix4x4.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <tuple>

namespace
{
using namespace smtest;
namespace fs = std::filesystem;

/// A writer whose errors are counted.
struct Watched
{
  explicit Watched(vtkNURBSModelWriter* writer)
    : Writer(writer)
    , Trap(writer)
  {
  }

  vtkNURBSModelWriter* Writer;
  MessageTrap Trap;
};

void CheckFails(
  const std::string& what, Watched& watched, const char* path, unsigned long code, const char* word)
{
  MessageTrap& trap = watched.Trap;
  vtkNURBSModelWriter* writer = watched.Writer;
  trap.Errors.clear();
  const int before = trap.NumberOfErrors;
  writer->SetFileName(path);
  CheckEqual(what + ": fails", 0, writer->Write());
  CheckEqual(what + ": one error", before + 1, trap.NumberOfErrors);
  CheckTrue(what + ": says " + word, trap.Errors.find(word) != std::string::npos, trap.Errors);
  CheckTrue(what + ": names the file", !path || !*path || trap.Errors.find(path) != std::string::npos);
  CheckEqual(what + ": code", static_cast<long long>(code), static_cast<long long>(writer->GetErrorCode()));
  CheckTrue(what + ": the error is the last message",
    trap.Errors.find(writer->GetMessage(writer->GetNumberOfMessages() - 1)) != std::string::npos);
}

/// Without its input there is no file to write, whether or not the writer itself is called.
void CheckUnreadableInput(const std::string& path)
{
  vtkNew<vtkSTEPReader> reader;
  const MessageTrap readerTrap(reader);
  const MessageTrap executiveTrap(reader->GetExecutive());
  vtkNew<vtkSTEPWriter> writer;
  const MessageTrap writerExecutiveTrap(writer->GetExecutive());
  Watched watched(writer);
  writer->SetInputConnection(reader->GetOutputPort());
  CheckFails("an input that fails", watched, path.c_str(), vtkErrorCode::UserError, "could not be computed");
  CheckTrue("which says why", readerTrap.Errors.find("no file name") != std::string::npos, readerTrap.Errors);
}

long long CountFiles(const std::string& folder)
{
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

void CheckErrors(const std::string& folder, const std::string& own)
{
  const std::string path = own + "/box.step";
  const auto box = ReadFile(Manifest(folder).GetSolid("gear", "plain")[0].Path);
  vtkNew<vtkSTEPWriter> step;
  Watched watched(step);
  CheckFails("no input", watched, path.c_str(), vtkErrorCode::UserError, "no input");
  step->SetInputDataObject(box);
  CheckFails("no name", watched, nullptr, vtkErrorCode::NoFileNameError, "SetFileName");
  CheckFails("empty name", watched, "", vtkErrorCode::NoFileNameError, "SetFileName");
  // Also on a rank that would write nothing: all ranks fail, or none.
  step->SetNumberOfPieces(2);
  step->SetPiece(1);
  CheckFails("no name, second piece", watched, nullptr, vtkErrorCode::NoFileNameError, "SetFileName");
  step->SetPiece(0);
  step->SetNumberOfPieces(1);
  CheckUnreadableInput(path);
  CheckFails(
    "no folder", watched, (own + "/none/box.step").c_str(), vtkErrorCode::CannotOpenFileError, "folder");
  CheckFails("a folder", watched, own.c_str(), vtkErrorCode::CannotOpenFileError, "it is a folder");
  step->SetOutputUnit("parsec");
  CheckFails("unit", watched, path.c_str(), vtkErrorCode::UserError, "parsec");
  step->SetOutputUnit("yard");
  CheckFails("a unit that OpenCASCADE has not", watched, path.c_str(), vtkErrorCode::UserError, "yard");
  step->SetOutputUnit("file");
  vtkNew<vtkBREPWriter> mesh;
  Watched watchedMesh(mesh);
  vtkNew<vtkSphereSource> sphere;
  mesh->SetInputConnection(sphere->GetOutputPort());
  CheckFails(
    "a mesh", watchedMesh, (own + "/mesh.brep").c_str(), vtkErrorCode::UserError, "no exact geometry");
  // The placement alone of a copy is of no use: a NaN is not a number of a STEP file.
  vtkNew<vtkNURBSDataSet> nowhere;
  nowhere->ShallowCopy(vtkPartitionedDataSetCollection::SafeDownCast(box)->GetPartition(0, 0));
  for (const auto& [row, column, value] :
    { std::tuple(0, 3, std::nan("")), std::tuple(1, 1, HUGE_VAL), std::tuple(3, 0, 0.5) })
  {
    vtkNew<vtkMatrix4x4> placement;
    placement->SetElement(row, column, value);
    nowhere->SetPlacement(placement);
    for (Watched* writer : { &watched, &watchedMesh })
    {
      writer->Writer->SetInputDataObject(nowhere);
      CheckFails("a placement that is none", *writer, path.c_str(), vtkErrorCode::UserError, "placement");
    }
  }
  step->SetInputDataObject(box);
  CheckEqual("nothing was left behind", 0, CountFiles(own));

  step->SetFileName(path.c_str());
  CheckEqual("written", 1, step->Write());
  CheckEqual("one file", 1, CountFiles(own));
  const std::string content = ReadAll(path);
  fs::permissions(own, fs::perms::owner_read | fs::perms::owner_exec);
  // A user who may write anything may write here, too.
  if (!std::ofstream(own + "/probe"))
  {
    CheckFails("write-protected folder", watched, (own + "/other.step").c_str(),
      vtkErrorCode::CannotOpenFileError, "folder");
  }
  fs::permissions(own, fs::perms::owner_all);
  fs::remove(own + "/probe");
  // A disk that takes no more: the file that is there stays.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit;
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = 5000;
  setrlimit(RLIMIT_FSIZE, &limit);
  CheckFails("full disk", watched, path.c_str(), vtkErrorCode::OutOfDiskSpaceError, "not all of it");
  vtkNew<vtkBREPWriter> brep;
  Watched watchedBrep(brep);
  brep->SetInputDataObject(box);
  CheckFails("full disk, BREP", watchedBrep, (own + "/box.brep").c_str(), vtkErrorCode::OutOfDiskSpaceError,
    "not all of it");
  limit.rlim_cur = before;
  setrlimit(RLIMIT_FSIZE, &limit);
  CheckEqual("one file still", 1, CountFiles(own));
  CheckTrue("as it was", content.size() > 5000 && content == ReadAll(path));
  CheckEqual("and written again", 1, step->Write());
  CheckEqual("without an error", vtkErrorCode::NoError, static_cast<long long>(step->GetErrorCode()));

  // Another word for a unit is the unit.
  step->SetOutputUnit("in");
  CheckEqual("written in inches", 1, step->Write());
  CompareProperties("inches", box, ReadFile(path), 2e-14);
}

/// Where something else than a file is, or a link leads to.
void CheckTargets(const std::string& folder, const std::string& own)
{
  vtkNew<vtkSTEPWriter> step;
  Watched watched(step);
  step->SetInputDataObject(ReadFile(Manifest(folder).GetSolid("box", "plain")[0].Path));
  const std::string pipe = own + "/pipe";
  CheckEqual("a pipe is made", 0, mkfifo(pipe.c_str(), 0600));
  CheckFails("a pipe", watched, pipe.c_str(), vtkErrorCode::CannotOpenFileError, "no file but");
  CheckTrue("is a pipe still", fs::is_fifo(pipe));

  // A link to a file that is not there yet.
  fs::create_directories(own + "/elsewhere");
  fs::create_symlink("elsewhere/box.step", own + "/link.step");
  step->SetFileName((own + "/link.step").c_str());
  CheckEqual("a link is followed", 1, step->Write());
  CheckTrue("and stays a link", fs::is_symlink(own + "/link.step"));
  CheckTrue("to the file", fs::is_regular_file(own + "/elsewhere/box.step"));

  // A file that has the first temporary name already belongs to somebody else.
  const std::string path = own + "/box.step";
  fs::create_symlink("nowhere", path + ".saving0");
  step->SetFileName(path.c_str());
  CheckEqual("next to a link that leads nowhere", 1, step->Write());
  CheckTrue("which stays", fs::is_symlink(path + ".saving0") && !fs::exists(own + "/nowhere"));
  CheckEqual("nothing else was left behind", 5, CountFiles(own));
}
}

int TestWriterErrors(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::fprintf(stderr, "usage: TestWriterErrors SOLIDS OUTPUT\n");
    return 1;
  }
  const std::string folder = std::string(argv[2]) + "/writers-errors";
  fs::remove_all(folder);
  CheckErrors(argv[1], MakeFolder(folder, "errors"));
  CheckTargets(argv[1], MakeFolder(folder, "targets"));
  return Finish();
}
