#include "smSTEPTree.h"

#include "smFailureReason.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>
#include <array>
#include <new>

namespace sm
{
namespace
{
/// Adds a node below `parent`. Its node name is made valid for XML; its attribute "label" is the given name,
/// or `fallback`.
int AddChild(vtkDataAssembly* assembly, int parent, const std::string& name, const std::string& fallback)
{
  std::string valid = name.empty() ? fallback : vtkDataAssembly::MakeValidNodeName(name.c_str());
  if (vtkDataAssembly::IsNodeNameReserved(valid.c_str()))
  {
    valid += "_";
  }
  const int node = assembly->AddNode(valid.c_str(), parent);
  assembly->SetAttribute(node, "label", name.empty() ? fallback.c_str() : name.c_str());
  return node;
}

void AddProduct(vtkDataAssembly* assembly, int parent, const ProductNode& product)
{
  const int node = AddChild(assembly, parent, product.Name, "Part");
  if (product.Name.empty())
  {
    // The file has no name: the label is the fallback.
    assembly->SetAttribute(node, "unnamed", 1);
  }
  if (!product.Layer.empty())
  {
    assembly->SetAttribute(node, "layer", product.Layer.c_str());
  }
  for (const int instance : product.Instances)
  {
    assembly->AddDataSetIndex(node, static_cast<unsigned int>(instance));
  }
  for (const ProductNode& child : product.Children)
  {
    AddProduct(assembly, node, child);
  }
}

std::string GetStem(const std::string& path)
{
  const std::size_t slash = path.find_last_of("/\\");
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}
}

vtkSmartPointer<vtkDataAssembly> MakeAssembly(
  const ProductNode& root, const char* format, const std::string& fileName)
{
  auto assembly = vtkSmartPointer<vtkDataAssembly>::New();
  const std::string stem = GetStem(fileName);
  assembly->SetRootNodeName(format);
  assembly->SetAttribute(vtkDataAssembly::GetRootNode(), "label", stem.c_str());
  for (const ProductNode& product : root.Children)
  {
    AddProduct(assembly, vtkDataAssembly::GetRootNode(), product);
  }
  return assembly;
}

void CheckMemory(std::size_t bytes)
{
  ::operator delete(::operator new(bytes));
}

bool BroadcastBytes(
  vtkMultiProcessController* controller, int root, std::vector<unsigned char>& bytes, bool& hasMemory)
{
  // The message is sent in pieces. A rank without memory for the whole receives them into a buffer on the
  // stack.
  constexpr long long PieceSize = 32768;
  const bool isRoot = controller->GetLocalProcessId() == root;
  auto size = static_cast<long long>(bytes.size());
  bool ok = controller->Broadcast(&size, 1, root) != 0;
  const bool hasRoom = isRoot || !ok || HasMemoryFor([&]() { bytes.resize(static_cast<std::size_t>(size)); });
  hasMemory = hasMemory && hasRoom;
  std::array<unsigned char, PieceSize> dropped;
  for (long long at = 0; at < size && ok; at += PieceSize)
  {
    const auto count = static_cast<vtkIdType>(std::min(PieceSize, size - at));
    ok = controller->Broadcast(hasRoom ? bytes.data() + at : dropped.data(), count, root) != 0;
  }
  return ok;
}

void PackTree(vtkPartitionedDataSetCollection* output, vtkMultiProcessStream& stream)
{
  stream << output->GetNumberOfPartitionedDataSets();
  for (unsigned int i = 0; i < output->GetNumberOfPartitionedDataSets(); ++i)
  {
    stream << std::string(output->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()));
  }
  vtkDataAssembly* assembly = output->GetDataAssembly();
  stream << (assembly ? assembly->SerializeToXML(vtkIndent()) : std::string());
}

void UnpackTree(vtkMultiProcessStream& stream, vtkPartitionedDataSetCollection* output)
{
  unsigned int count = 0;
  stream >> count;
  constexpr std::size_t BytesOfDataSet = 4096;
  CheckMemory(SpareMemory + BytesOfDataSet * count);
  output->SetNumberOfPartitionedDataSets(count);
  for (unsigned int i = 0; i < count; ++i)
  {
    std::string name;
    stream >> name;
    output->SetPartition(i, 0, nullptr);
    output->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
  std::string xml;
  stream >> xml;
  if (!xml.empty())
  {
    vtkNew<vtkDataAssembly> assembly;
    if (!assembly->InitializeFromXML(xml.c_str()))
    {
      // VTK's stream does not report a lack of memory, but the text is then incomplete.
      throw std::bad_alloc();
    }
    output->SetDataAssembly(assembly);
  }
}
}
