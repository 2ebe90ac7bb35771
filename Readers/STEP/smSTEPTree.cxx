#include "smSTEPTree.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

namespace sm
{
namespace
{
/// Adds a node below `parent`. Its name is made valid for XML; its attribute "label" is the name as it is given, or `fallback`.
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

void AddAssembly(
  const ProductNode& root, const std::string& fileName, vtkPartitionedDataSetCollection* output)
{
  vtkNew<vtkDataAssembly> assembly;
  const std::string stem = GetStem(fileName);
  assembly->SetRootNodeName("STEP");
  assembly->SetAttribute(vtkDataAssembly::GetRootNode(), "label", stem.c_str());
  for (const ProductNode& product : root.Children)
  {
    AddProduct(assembly, vtkDataAssembly::GetRootNode(), product);
  }
  output->SetDataAssembly(assembly);
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
    assembly->InitializeFromXML(xml.c_str());
    output->SetDataAssembly(assembly);
  }
}
}
