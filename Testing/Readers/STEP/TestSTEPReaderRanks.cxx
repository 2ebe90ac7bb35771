// TestSTEPReaderRanks FILE LEAVES, under mpirun: all ranks have the tree of the reader's output and its status, whichever rank reads the file,
// and when it cannot be read; a collective filter downstream works.
#include "smTesting.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkMPIController.h>
#include <vtkMultiProcessStream.h>
#include <vtkNew.h>
#include <vtkPartitionBalancer.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSTEPReader.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace
{
using smtest::CheckEqual;
using smtest::CheckTrue;

vtkMultiProcessController* controller = nullptr;
int rank = 0;
int ranks = 1;
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
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> mpi;
  mpi->Initialize(&argc, &argv);
  controller = mpi;
  vtkMultiProcessController::SetGlobalController(mpi);
  rank = mpi->GetLocalProcessId();
  ranks = mpi->GetNumberOfProcesses();
  const std::string path = argc > 2 ? argv[1] : "";
  expectedLeaves = argc > 2 ? std::atoi(argv[2]) : 0;
  CheckTrue("there are other ranks", ranks > 1, std::to_string(ranks));
  CheckTree("first rank", path, rank);
  CheckTree("last rank", path, ranks - 1 - rank);
  CheckAlone(path);
  Reader missing(path + ".missing");
  CheckFailure("no file", missing, "unreadable", 1);
  Reader stopped(path);
  stopped.Stops = rank == 0;
  CheckFailure("stopped", stopped, "aborted", 0);
  Reader thrown(path);
  thrown.Throws = rank == 0;
  CheckFailure("an exception", thrown, "unreadable", 1);
  CheckTree("after failures", path, rank);
  vtkMultiProcessController::SetGlobalController(nullptr);
  const int status = smtest::Finish();
  mpi->Finalize();
  return status;
}
