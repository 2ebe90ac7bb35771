// TestSTEPReaderRanks FILE LEAVES, under mpirun: all ranks have the tree of the reader's output and its
// status, whichever rank reads the file, when it cannot be read, and when one rank has not enough memory for
// the tree; a collective filter downstream works.
#include "smFailingMemory.h"
#include "smTestRanks.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkMultiProcessStream.h>
#include <vtkPartitionBalancer.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSTEPReader.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace
{
using namespace smtest;

/// Leaves that the file has.
int expectedLeaves = 0;

/// A reader whose errors are counted, and which may be stopped or fail while it reads.
struct Reader
{
  vtkNew<vtkSTEPReader> Filter;
  int Errors = 0;
  bool Stops = false;
  bool Throws = false;

  explicit Reader(const std::string& path)
  {
    vtkNew<vtkCallbackCommand> callback;
    callback->SetClientData(this);
    callback->SetCallback(
      [](vtkObject* caller, unsigned long event, void* client, void*)
      {
        auto* self = static_cast<Reader*>(client);
        if (event == vtkCommand::ErrorEvent)
        {
          ++self->Errors;
        }
        // Not at the 0 and the 1 that the executive itself reports.
        else if (self->Throws && self->Filter->GetProgress() > 0.0 && self->Filter->GetProgress() < 1.0)
        {
          throw std::runtime_error("thrown by an observer");
        }
        else if (self->Stops)
        {
          static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
        }
      });
    this->Filter->AddObserver(vtkCommand::ErrorEvent, callback);
    this->Filter->AddObserver(vtkCommand::ProgressEvent, callback);
    this->Filter->SetFileName(path.c_str());
  }
};

/// Everything that must be the same on all ranks, as text.
std::string Describe(vtkSTEPReader* reader)
{
  vtkPartitionedDataSetCollection* output = reader->GetOutput();
  std::string text = std::string("status ") + reader->GetStatusAsString() + ", bodies " +
    std::to_string(reader->GetNumberOfBodies()) + ", instances " +
    std::to_string(reader->GetNumberOfInstances()) + ", free faces " +
    std::to_string(reader->GetNumberOfFreeFaces()) + ", units " + reader->GetFileUnit() + " " +
    reader->GetLengthUnit() + "\n";
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    text += reader->GetMessage(i) + "\n";
  }
  for (unsigned int i = 0; i < output->GetNumberOfPartitionedDataSets(); ++i)
  {
    text += std::string(output->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())) + " with " +
      std::to_string(output->GetPartitionedDataSet(i)->GetNumberOfPartitions()) + " partition\n";
  }
  return text +
    (output->GetDataAssembly() ? output->GetDataAssembly()->SerializeToXML(vtkIndent()) : "no assembly");
}

/// The same text on all ranks.
void CheckSame(const std::string& what, const std::string& own)
{
  vtkMultiProcessStream stream;
  if (rank == 0)
  {
    stream << own;
  }
  controller->Broadcast(stream, 0);
  std::string first = own;
  if (rank != 0)
  {
    stream >> first;
  }
  CheckEqual(what + ": the same on rank " + std::to_string(rank), first, own);
}

int CountLeaves(vtkPartitionedDataSetCollection* output)
{
  int leaves = 0;
  for (unsigned int i = 0; i < output->GetNumberOfPartitionedDataSets(); ++i)
  {
    leaves += output->GetPartitionAsDataObject(i, 0) ? 1 : 0;
  }
  return leaves;
}

void CheckTree(const std::string& what, const std::string& path, int piece)
{
  Reader reader(path);
  reader.Filter->UpdatePiece(piece, ranks, 0);
  CheckSame(what, Describe(reader.Filter));
  CheckEqual(what + ": errors", 0, reader.Errors);
  CheckEqual(what + ": instances", expectedLeaves, reader.Filter->GetNumberOfInstances());
  CheckEqual(what + ": leaves on rank " + std::to_string(rank), piece == 0 ? expectedLeaves : 0,
    CountLeaves(reader.Filter->GetOutput()));

  // A filter that talks to the other ranks once for each partitioned dataset.
  vtkNew<vtkPartitionBalancer> balancer;
  balancer->SetController(controller);
  balancer->SetInputConnection(reader.Filter->GetOutputPort());
  balancer->UpdatePiece(piece, ranks, 0);
  auto* balanced = vtkPartitionedDataSetCollection::SafeDownCast(balancer->GetOutputDataObject(0));
  CheckEqual(
    what + ": balanced datasets", expectedLeaves, balanced ? balanced->GetNumberOfPartitionedDataSets() : 0);
  for (unsigned int i = 0; balanced && i < balanced->GetNumberOfPartitionedDataSets(); ++i)
  {
    CheckEqual(
      what + ": balanced partitions", 1, balanced->GetPartitionedDataSet(i)->GetNumberOfPartitions());
  }
  CheckEqual(
    what + ": balanced leaves", piece == 0 ? expectedLeaves : 0, balanced ? CountLeaves(balanced) : -1);
}

/// The rank that has read the file adds the mesh of what it keeps; all ranks have the same tree again.
void CheckLaterMesh(const std::string& path)
{
  Reader reader(path);
  reader.Filter->SetDisplayMeshToNever();
  reader.Filter->UpdatePiece(rank, ranks, 0);
  CheckEqual("points without a mesh", 0, reader.Filter->GetOutput()->GetNumberOfPoints());
  const std::string before = Describe(reader.Filter);
  const double seconds = reader.Filter->GetReadSeconds();
  reader.Filter->SetDisplayMeshToByNeed();
  reader.Filter->UpdatePiece(rank, ranks, 0);
  CheckTrue("points on the rank that has the leaves",
    (reader.Filter->GetOutput()->GetNumberOfPoints() > 0) == (rank == 0));
  CheckSame("with a mesh", Describe(reader.Filter));
  CheckEqual("with a mesh: as without", before, Describe(reader.Filter));
  CheckEqual("seconds of the reading", seconds, reader.Filter->GetReadSeconds());
  CheckEqual("with a mesh: errors", 0, reader.Errors);
}

void CheckFailure(const std::string& what, Reader& reader, const char* status, int errors)
{
  reader.Filter->UpdatePiece(rank, ranks, 0);
  CheckSame(what, Describe(reader.Filter));
  CheckEqual(what + ": status", status, reader.Filter->GetStatusAsString());
  CheckEqual(what + ": errors on rank " + std::to_string(rank), rank == 0 ? errors : 0, reader.Errors);
  CheckEqual(what + ": datasets", 0, reader.Filter->GetOutput()->GetNumberOfPartitionedDataSets());
}

/// Updates of one rank for itself do not wait for the others.
void CheckAlone(const std::string& path)
{
  if (rank == 0)
  {
    Reader reader(path);
    reader.Filter->Update();
    CheckEqual("one rank alone: leaves", expectedLeaves, CountLeaves(reader.Filter->GetOutput()));
    reader.Filter->UpdatePiece(1, ranks + 1, 0);
    CheckEqual(
      "another number of pieces: datasets", 0, reader.Filter->GetOutput()->GetNumberOfPartitionedDataSets());
  }
  controller->Barrier();
}

/// A reader that is short of memory between reading its file and filling its output.
class ShortReader : public vtkSTEPReader
{
public:
  static ShortReader* New()
  {
    auto* reader = new ShortReader;
    reader->InitializeObjectBase();
    return reader;
  }
  /// Number of the allocation that fails; 0: none; negative: memory is not watched.
  long Failing = -1;
  long Allocations = 0;
  bool HasEscaped = false;

protected:
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override
  {
    this->HasEscaped = false;
    this->Begin(rank != 0);
    try
    {
      this->vtkSTEPReader::RequestData(request, input, output);
    }
    catch (...)
    {
      this->HasEscaped = true;
    }
    this->Allocations = failingMemory.End();
    return 1;
  }
  void InspectDocument(const sm::Document&) override { this->Begin(true); }

private:
  void Begin(bool isHere) const
  {
    if (isHere && this->Failing >= 0)
    {
      failingMemory.Begin(this->Failing);
    }
  }
};

/// One allocation fails, each time another one, on the first or the last rank, while the tree is shared.
void CheckShortage(const std::string& path)
{
  failingMemory.LastSize = std::size_t{ 1 } << 20;
  vtkNew<ShortReader> reader;
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  reader->AddObserver(vtkCommand::ErrorEvent, silence);
  reader->SetFileName(path.c_str());
  const auto run = [&](const std::string& what, long failing)
  {
    const Watchdog watchdog(what);
    reader->Failing = failing;
    reader->Modified();
    reader->UpdatePiece(rank, ranks, 0);
    CheckTrue(what + ": no exception leaves it", !reader->HasEscaped);
    CheckSame(what, Describe(reader));
  };
  run("undisturbed", 0);
  const std::string whole = Describe(reader);
  for (const int who : { 0, ranks - 1 })
  {
    long count = reader->Allocations;
    controller->Broadcast(&count, 1, who);
    const std::set<long> chosen = ChooseAllocations(count, 6, 8);
    int failed = 0;
    for (const long allocation : chosen)
    {
      const std::string what = "rank " + std::to_string(who) + ": allocation " + std::to_string(allocation) +
        " of " + std::to_string(count) + " fails";
      run(what, rank == who ? allocation : 0);
      const bool isWhole = Describe(reader) == whole;
      failed += isWhole ? 0 : 1;
      CheckTrue(what + ": whole, or failed and empty",
        isWhole ||
          (reader->GetStatus() == vtkSTEPReader::FAILED && CountLeaves(reader->GetOutput()) == 0 &&
            reader->GetMessage(0).find("memory") != std::string::npos),
        Describe(reader).substr(0, 200));
    }
    CheckRange("runs that failed", chosen.size() / 2.0, failed, static_cast<double>(chosen.size()));
    run("and again", 0);
    CheckEqual("then whole", whole, Describe(reader));
  }
}
}

int main(int argc, char* argv[])
{
  const auto checks = [&]()
  {
    const std::string path = argc > 2 ? argv[1] : "";
    expectedLeaves = argc > 2 ? std::atoi(argv[2]) : 0;
    CheckTree("first rank", path, rank);
    CheckTree("last rank", path, ranks - 1 - rank);
    CheckAlone(path);
    CheckLaterMesh(path);
    Reader missing(path + ".missing");
    CheckFailure("no file", missing, "unreadable", 1);
    Reader stopped(path);
    stopped.Stops = rank == 0;
    CheckFailure("stopped", stopped, "aborted", 0);
    Reader thrown(path);
    thrown.Throws = rank == 0;
    CheckFailure("an exception", thrown, "unreadable", 1);
    CheckShortage(path);
    CheckTree("after failures", path, rank);
  };
  return RunOnRanks(argc, argv, checks);
}
