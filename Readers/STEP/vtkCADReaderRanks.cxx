// Sends the output of a reader to the other MPI ranks.
#include "vtkCADReaderInternals.h"

#include "smFailureReason.h"
#include "smSTEPTree.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPartitionedDataSetCollection.h"

#include <vector>

namespace
{
void PackStrings(vtkMultiProcessStream& stream, const std::vector<std::string>& strings)
{
  stream << static_cast<int>(strings.size());
  for (const std::string& text : strings)
  {
    stream << text;
  }
}

void UnpackStrings(vtkMultiProcessStream& stream, std::vector<std::string>& strings)
{
  int count = 0;
  stream >> count;
  strings.resize(count);
  for (std::string& text : strings)
  {
    stream >> text;
  }
}

void PackTolerances(vtkMultiProcessStream& stream, const std::vector<sm::DrawingTolerance>& tolerances)
{
  stream << static_cast<int>(tolerances.size());
  for (const sm::DrawingTolerance& tolerance : tolerances)
  {
    stream << static_cast<vtkTypeInt64>(tolerance.Id) << tolerance.Kind
           << static_cast<int>(tolerance.Faces.size());
    for (const std::int64_t face : tolerance.Faces)
    {
      stream << static_cast<vtkTypeInt64>(face);
    }
    stream << (tolerance.IsForAll ? 1 : 0) << tolerance.Lower << tolerance.Upper << tolerance.Problem;
  }
}

void UnpackTolerances(vtkMultiProcessStream& stream, std::vector<sm::DrawingTolerance>& tolerances)
{
  int count = 0;
  stream >> count;
  tolerances.resize(count);
  for (sm::DrawingTolerance& tolerance : tolerances)
  {
    vtkTypeInt64 id = 0;
    int faces = 0;
    int isForAll = 0;
    stream >> id >> tolerance.Kind >> faces;
    tolerance.Id = id;
    tolerance.Faces.resize(faces);
    for (std::int64_t& face : tolerance.Faces)
    {
      stream >> id;
      face = id;
    }
    stream >> isForAll >> tolerance.Lower >> tolerance.Upper >> tolerance.Problem;
    tolerance.IsForAll = isForAll != 0;
  }
}
}

void vtkCADReader::Pack(vtkPartitionedDataSetCollection* output, std::vector<unsigned char>& bytes) const
{
  const Results& last = *this->Last;
  vtkMultiProcessStream stream;
  stream << this->Status << last.Bodies << last.Instances << last.FreeFaces << last.FileUnit
         << last.LengthUnit << last.Problem;
  PackStrings(stream, last.Messages);
  PackStrings(stream, last.Defects);
  PackTolerances(stream, last.Tolerances);
  sm::PackTree(output, stream);
  stream.GetRawData(bytes);
}

void vtkCADReader::Unpack(const std::vector<unsigned char>& bytes, vtkPartitionedDataSetCollection* output)
{
  Results& last = *this->Last;
  vtkMultiProcessStream stream;
  stream.SetRawData(bytes);
  stream >> this->Status >> last.Bodies >> last.Instances >> last.FreeFaces >> last.FileUnit >>
    last.LengthUnit >> last.Problem;
  UnpackStrings(stream, last.Messages);
  UnpackStrings(stream, last.Defects);
  UnpackTolerances(stream, last.Tolerances);
  sm::UnpackTree(stream, output);
}

std::string_view vtkCADReader::ShareTree(
  vtkMultiProcessController* controller, int root, vtkPartitionedDataSetCollection* output) noexcept
{
  const bool isRoot = controller->GetLocalProcessId() == root;
  std::vector<unsigned char> bytes;
  bool hasMemory = true;
  if (isRoot && !sm::HasMemoryFor([&]() { this->Pack(output, bytes); }))
  {
    hasMemory = false;
    bytes.clear();
  }
  bool isConnected = sm::BroadcastBytes(controller, root, bytes, hasMemory);
  const auto complete = [&]()
  {
    if (!isRoot)
    {
      this->Unpack(bytes, output);
    }
    this->WriteState(output);
  };
  // An empty message means that the root had no memory for it.
  const int own = isConnected && hasMemory && !bytes.empty() && sm::HasMemoryFor(complete) ? 1 : 0;
  int all = 0;
  isConnected = isConnected && controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP) != 0;
  return !isConnected ? "the connection to the other processes was lost"
    : all == 0        ? "there is not enough memory in one of the processes"
                      : "";
}
