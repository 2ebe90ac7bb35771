// Sends the output of a reader to other processes: to MPI ranks, and from solidmoments-read to an isolated
// reader.
#include "vtkCADReaderInternals.h"

#include "smFailureReason.h"
#include "smLeafBytes.h"
#include "smReadProgram.h"
#include "smSTEPTree.h"

#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>
#include <array>
#include <utility>

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

std::vector<std::string> vtkCADReader::PackSettings() const
{
  return { this->FileName ? this->FileName : "", this->OutputUnit, this->GetSettingOfFormat() };
}

void vtkCADReader::UnpackSettings(const std::vector<std::string>& words)
{
  this->SetFileName(words[0].empty() ? nullptr : words[0].c_str());
  this->SetOutputUnit(words[1]);
  this->SetSettingOfFormat(words[2]);
}

std::vector<char> vtkCADReader::PackOutput()
{
  vtkPartitionedDataSetCollection* output = this->GetOutput();
  std::vector<unsigned char> head;
  this->Pack(output, head);
  sm::ByteWriter to;
  to.PutAll(head);
  to.Put(std::array<double, 5>{ this->Last->ReadSeconds, this->Last->MeshSeconds,
    this->Last->ConversionSeconds, this->Last->ParseSeconds, this->Last->TrimSeconds });
  sm::PutLeaves(output, to);
  for (unsigned int i = 0; this->Kept && i < output->GetNumberOfPartitionedDataSets(); ++i)
  {
    to.Put(this->Kept->Sources[i].BodyColor);
    to.Put(this->Kept->Sources[i].Color);
  }
  return std::move(to.GetBytes());
}

bool vtkCADReader::UnpackReading(sm::ByteReader& from, vtkPartitionedDataSetCollection* tree)
{
  if (!sm::GetLeaves(from, tree))
  {
    return false;
  }
  auto reading = std::make_unique<Reading>();
  for (unsigned int i = 0; i < tree->GetNumberOfPartitionedDataSets(); ++i)
  {
    auto* leaf = vtkNURBSDataSet::SafeDownCast(tree->GetPartitionAsDataObject(i, 0));
    sm::LeafSource source;
    source.BodyColor = from.Get<sm::Vector3>();
    source.Color = from.Get<sm::Vector3>();
    source.Model = leaf ? leaf->GetModel() : nullptr;
    if (!from.IsGood() || !source.Model)
    {
      return false;
    }
    std::copy_n(leaf->GetPlacementData(), source.Placement.size(), source.Placement.begin());
    reading->Sources.push_back(source);
    reading->Names.push_back(leaf->GetPartName());
  }
  reading->Assembly = tree->GetDataAssembly();
  reading->NameInstances();
  reading->Last = *this->Last;
  reading->ModelTime = reading->FindModelTime();
  this->Kept = std::move(reading);
  return true;
}

bool vtkCADReader::SkipRepair(bool)
{
  return false;
}

sm::ReadProgramOutcome vtkCADReader::RunProgram()
{
  const std::string program = sm::FindReadProgram();
  std::vector<std::string> arguments{ this->GetFormatName(), this->IsContentGiven ? "content" : "file" };
  for (const std::string& word : this->PackSettings())
  {
    arguments.push_back(word);
  }
  return program.empty()
    ? sm::ReadProgramOutcome{ {}, "was not found", false, false, false }
    : sm::RunReadProgram(program, arguments, this->IsContentGiven ? &this->Content : nullptr,
        [this](double x) { return this->Report(Reading::MeshStart * x); });
}

bool vtkCADReader::ReadIsolated(vtkPartitionedDataSetCollection* output)
{
  sm::ReadProgramOutcome outcome = this->RunProgram();
  std::string crash;
  if (!outcome.Problem.empty() && outcome.IsRepairing && this->SkipRepair(true))
  {
    crash = outcome.Problem;
    const auto restore = [](vtkCADReader* reader) { reader->SkipRepair(false); };
    const std::unique_ptr<vtkCADReader, decltype(restore)> guard(this, restore);
    outcome = this->RunProgram();
  }
  if (outcome.IsStopped)
  {
    this->Stop();
    return true;
  }
  if (!outcome.Problem.empty() && !outcome.IsStarted)
  {
    this->Last->Messages.push_back(
      "The file was not read in a process of its own: the program solidmoments-read " + outcome.Problem +
      ".");
    return false;
  }
  if (!outcome.Problem.empty())
  {
    this->Fail(UNREADABLE, "the process that read it " + outcome.Problem);
    return true;
  }
  sm::ByteReader from(outcome.Result);
  vtkNew<vtkPartitionedDataSetCollection> tree;
  this->Unpack(from.GetAll<unsigned char>(), tree);
  if (!crash.empty())
  {
    this->Last->Defects.push_back("A repair by OpenCASCADE ended its process, which " + crash +
      "; the file was read again without repairs.");
  }
  const auto seconds = from.Get<std::array<double, 5>>();
  this->Last->ReadSeconds = seconds[0];
  this->Last->MeshSeconds = seconds[1];
  this->Last->ConversionSeconds = seconds[2];
  this->Last->ParseSeconds = seconds[3];
  this->Last->TrimSeconds = seconds[4];
  if (this->Status != OK)
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    vtkErrorMacro(<< this->Last->Problem);
  }
  else if (!this->UnpackReading(from, tree))
  {
    this->Fail(UNREADABLE, "the process that read it sent what is not understood here");
  }
  else
  {
    this->FillOutput(output);
  }
  return true;
}
