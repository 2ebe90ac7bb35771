#include "Sharing/smSharedStructure.h"

#include "smFailureReason.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

#include <new>
#include <string>

namespace sm
{
namespace
{
/// The blocks of a rank, or of all.
struct Structure
{
  std::vector<std::string> Names;
  std::string Assembly;
};

Structure Describe(vtkPartitionedDataSetCollection& meshes)
{
  Structure structure;
  for (unsigned int i = 0; i < meshes.GetNumberOfPartitionedDataSets(); ++i)
  {
    const char* name =
      meshes.HasMetaData(i) ? meshes.GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : nullptr;
    structure.Names.emplace_back(name ? name : "");
  }
  if (meshes.GetDataAssembly() && !structure.Names.empty())
  {
    structure.Assembly = meshes.GetDataAssembly()->SerializeToXML(vtkIndent());
  }
  return structure;
}

Bytes Pack(std::uint64_t first, const Structure& structure)
{
  ByteWriter to;
  to.Put(first);
  to.PutTexts(structure.Names);
  to.PutText(structure.Assembly);
  return std::move(to.GetBytes());
}

/// Returns false for an empty message.
bool Unpack(const Bytes& bytes, std::uint64_t& first, Structure& structure)
{
  ByteReader from(bytes);
  first = from.Get<std::uint64_t>();
  structure.Names = from.GetTexts();
  structure.Assembly = from.GetText();
  return from.IsGood();
}

/// Returns for each rank the blocks of all ranks, and the number of those before its own; nothing if a
/// message is missing.
std::vector<Bytes> Merge(const std::vector<Bytes>& messages)
{
  Structure all;
  std::vector<std::uint64_t> firsts;
  for (const Bytes& message : messages)
  {
    std::uint64_t first = 0;
    Structure own;
    if (!Unpack(message, first, own))
    {
      return {};
    }
    firsts.push_back(all.Names.size());
    all.Assembly = all.Names.empty() ? own.Assembly : all.Assembly;
    all.Names.insert(all.Names.end(), own.Names.begin(), own.Names.end());
  }
  std::vector<Bytes> merged;
  for (const std::uint64_t first : firsts)
  {
    merged.push_back(Pack(first, all));
  }
  return merged;
}

/// Returns the message about all ranks; empty where there is none.
Bytes Exchange(FaceExchange& exchange, vtkPartitionedDataSetCollection& meshes, bool& isConnected)
{
  // Every rank takes part in every call, whatever happens to its memory.
  Bytes mine;
  std::vector<Bytes> all;
  HasMemoryFor([&]() { mine = Pack(0, Describe(meshes)); });
  isConnected = true;
  const bool isGathered = HasMemoryFor([&]() { isConnected = exchange.Gather(0, mine, all); });
  if (!isGathered || !HasMemoryFor([&]() { all = Merge(all); }))
  {
    all.clear();
  }
  mine.clear();
  if (isConnected && !HasMemoryFor([&]() { isConnected = exchange.Scatter(0, all, mine); }))
  {
    mine.clear();
  }
  return mine;
}

/// Gives the collection the blocks of all ranks, its own from number `first` on.
void Extend(const Structure& all, unsigned int first, vtkPartitionedDataSetCollection& meshes)
{
  vtkNew<vtkPartitionedDataSetCollection> own;
  own->ShallowCopy(&meshes);
  const unsigned int count = own->GetNumberOfPartitionedDataSets();
  meshes.Initialize();
  meshes.SetNumberOfPartitionedDataSets(static_cast<unsigned int>(all.Names.size()));
  for (unsigned int i = 0; i < all.Names.size(); ++i)
  {
    const bool isOwn = i >= first && i - first < count;
    meshes.SetPartition(i, 0, isOwn ? own->GetPartitionAsDataObject(i - first, 0) : nullptr);
    meshes.GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), all.Names[i].c_str());
  }
  if (!all.Assembly.empty())
  {
    vtkNew<vtkDataAssembly> assembly;
    assembly->InitializeFromXML(all.Assembly.c_str());
    meshes.SetDataAssembly(assembly);
  }
}
}

bool ShareStructure(FaceExchange& exchange, vtkPartitionedDataSetCollection& meshes)
{
  bool isConnected = true;
  const Bytes message = Exchange(exchange, meshes, isConnected);
  const auto extend = [&]()
  {
    std::uint64_t first = 0;
    Structure all;
    if (!Unpack(message, first, all))
    {
      throw std::bad_alloc();
    }
    if (all.Names.size() != meshes.GetNumberOfPartitionedDataSets())
    {
      Extend(all, static_cast<unsigned int>(first), meshes);
    }
  };
  const bool isDone = isConnected && HasMemoryFor(extend);
  RankNumbers failures{};
  failures[0] = isDone ? 0.0 : 1.0;
  if (!isConnected || !exchange.Sum(failures) || failures[0] != 0.0)
  {
    meshes.Initialize();
    return false;
  }
  return true;
}
}
