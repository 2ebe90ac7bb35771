#include "smSTEPTree.h"

#include "smFailureReason.h"
#include "smFormat.h"
#include "smInstanceNames.h"

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
/// Returns the name of a product, or what stands for it.
std::string GetLabel(const ProductNode& product)
{
  return product.Name.empty() ? "Part" : product.Name;
}

/// Adds the node names that the file's names make to `names`.
void CollectNodeNames(const ProductNode& product, std::unordered_set<std::string>& names)
{
  for (const ProductNode& child : product.Children)
  {
    names.insert(MakeNodeName(GetLabel(child)));
    CollectNodeNames(child, names);
  }
}

/// Returns the numbers of PlacementAttribute.
std::string WritePlacement(const Placement& placement, double unit)
{
  std::string text;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      const double value = j < 3 ? placement.Linear[i][j] : unit * placement.Translation[i];
      text += (text.empty() ? "" : " ") + FormatDigits(value, 17);
    }
  }
  return text;
}

void AddProducts(vtkDataAssembly* assembly, int parent, const std::vector<ProductNode>& products,
  const std::unordered_set<std::string>& taken, double unit);

/// Adds a node below `parent`. Its attribute "label" is the given one, and its node name is made of it.
void AddProduct(vtkDataAssembly* assembly, int parent, const ProductNode& product, const std::string& label,
  const std::unordered_set<std::string>& taken, double unit)
{
  const int node = assembly->AddNode(MakeNodeName(label).c_str(), parent);
  assembly->SetAttribute(node, "label", label.c_str());
  if (label != GetLabel(product))
  {
    assembly->SetAttribute(node, FileNameAttribute, GetLabel(product).c_str());
  }
  if (product.Name.empty())
  {
    // The file has no name: the label is the fallback.
    assembly->SetAttribute(node, "unnamed", 1);
  }
  if (!product.Layer.empty())
  {
    assembly->SetAttribute(node, "layer", product.Layer.c_str());
  }
  if (product.Place)
  {
    assembly->SetAttribute(node, PlacementAttribute, WritePlacement(*product.Place, unit).c_str());
  }
  // All at once: every call reads the indices that the node has.
  assembly->AddDataSetIndices(
    node, std::vector<unsigned int>(product.Instances.begin(), product.Instances.end()));
  AddProducts(assembly, node, product.Children, taken, unit);
}

/// Adds nodes for the products, with numbers where names repeat.
void AddProducts(vtkDataAssembly* assembly, int parent, const std::vector<ProductNode>& products,
  const std::unordered_set<std::string>& taken, double unit)
{
  std::vector<std::string> names;
  names.reserve(products.size());
  for (const ProductNode& product : products)
  {
    names.push_back(GetLabel(product));
  }
  const std::vector<std::string> labels = NumberNames(names, taken);
  for (std::size_t i = 0; i < products.size(); ++i)
  {
    AddProduct(assembly, parent, products[i], labels[i], taken, unit);
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
  const ProductNode& root, const char* format, const std::string& fileName, double unit)
{
  auto assembly = vtkSmartPointer<vtkDataAssembly>::New();
  const std::string stem = GetStem(fileName);
  assembly->SetRootNodeName(format);
  assembly->SetAttribute(vtkDataAssembly::GetRootNode(), "label", stem.c_str());
  std::unordered_set<std::string> names;
  CollectNodeNames(root, names);
  AddProducts(assembly, vtkDataAssembly::GetRootNode(), root.Children, names, unit);
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
