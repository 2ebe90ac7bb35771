#include "smBodyMeshes.h"

#include "smInstanceNames.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkNURBSDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <cstring>
#include <limits>
#include <map>
#include <string>

namespace sm
{
namespace
{
/// Cell arrays, shared by meshes with the same array of face indices and bitwise equal values of the faces.
class ArrayPool
{
public:
  vtkFloatArray* Get(vtkDataArray* faces, const std::string& name, const std::vector<float>& values)
  {
    std::vector<Entry>& entries = this->Entries[{ faces, name }];
    for (const Entry& entry : entries)
    {
      // The comparison is bitwise, so that NaN equals itself.
      if (entry.Values.size() == values.size() &&
        std::memcmp(entry.Values.data(), values.data(), values.size() * sizeof(float)) == 0)
      {
        return entry.Array;
      }
    }
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name.c_str());
    const vtkIdType cells = faces->GetNumberOfTuples();
    array->SetNumberOfValues(cells);
    for (vtkIdType cell = 0; cell < cells; ++cell)
    {
      const double face = faces->GetComponent(cell, 0);
      array->SetValue(cell,
        face >= 0.0 && face < static_cast<double>(values.size()) ? values[static_cast<std::size_t>(face)]
                                                                 : std::numeric_limits<float>::quiet_NaN());
    }
    entries.push_back({ values, array });
    return array;
  }

private:
  struct Entry
  {
    std::vector<float> Values;
    vtkSmartPointer<vtkFloatArray> Array;
  };
  std::map<std::pair<vtkDataArray*, std::string>, std::vector<Entry>> Entries;
};

/// Copies the assembly of a collection, with the indices of the bodies as indices of datasets.
void KeepAssembly(
  const std::vector<BodyIntegrals>& bodies, vtkDataObject* input, vtkPartitionedDataSetCollection* output)
{
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(input);
  if (!collection || !collection->GetDataAssembly())
  {
    return;
  }
  // A leaf may occur at several places, of which some may be chosen: the ids count the places.
  std::map<std::string, unsigned int> numbers;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    numbers[bodies[i].Id] = static_cast<unsigned int>(i);
  }
  int places = 0;
  std::map<unsigned int, std::vector<unsigned int>> renumbered;
  for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkPartitionedDataSet* partitions = collection->GetPartitionedDataSet(i);
    for (unsigned int j = 0; partitions && j < partitions->GetNumberOfPartitions(); ++j)
    {
      auto* leaf = vtkNURBSDataSet::SafeDownCast(partitions->GetPartitionAsDataObject(j));
      if (leaf && leaf->GetModel())
      {
        const auto found = numbers.find(std::to_string(++places));
        if (found != numbers.end())
        {
          renumbered[i].push_back(found->second);
        }
      }
    }
  }
  vtkNew<vtkDataAssembly> assembly;
  assembly->DeepCopy(collection->GetDataAssembly());
  std::vector<int> nodes = assembly->GetChildNodes(vtkDataAssembly::GetRootNode(), true);
  nodes.push_back(vtkDataAssembly::GetRootNode());
  for (const int node : nodes)
  {
    const std::vector<unsigned int> before = assembly->GetDataSetIndices(node, false);
    assembly->RemoveAllDataSetIndices(node, false);
    // All at once: every call reads the indices that the node has.
    std::vector<unsigned int> after;
    for (const unsigned int index : before)
    {
      after.insert(after.end(), renumbered[index].begin(), renumbered[index].end());
    }
    assembly->AddDataSetIndices(node, after);
  }
  output->SetDataAssembly(assembly);
}
}

std::vector<std::string> NameBlocks(const std::vector<BodyIntegrals>& bodies)
{
  std::vector<std::string> blocks;
  blocks.reserve(bodies.size());
  for (const BodyIntegrals& body : bodies)
  {
    blocks.push_back(body.Block);
  }
  return NumberNames(blocks, {});
}

void MakeBodyMeshes(const std::vector<BodyIntegrals>& bodies, const std::vector<MeshArray>& arrays,
  vtkDataObject* input, vtkPartitionedDataSetCollection* output)
{
  ArrayPool pool;
  const std::vector<std::string> blocks = NameBlocks(bodies);
  output->SetNumberOfPartitionedDataSets(static_cast<unsigned int>(bodies.size()));
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    vtkNew<vtkNURBSDataSet> mesh;
    mesh->ShallowCopy(bodies[i].Mesh);
    vtkDataArray* faces = mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
    std::vector<float> values(static_cast<std::size_t>(bodies[i].Model->GetNumberOfFaces()));
    for (const MeshArray& array : arrays)
    {
      for (std::size_t face = 0; face < values.size(); ++face)
      {
        values[face] = static_cast<float>(array.GetValue(i, face));
      }
      if (faces)
      {
        mesh->GetCellData()->AddArray(pool.Get(faces, array.Name, values));
      }
    }
    output->SetPartition(static_cast<unsigned int>(i), 0, mesh);
    output->GetMetaData(static_cast<unsigned int>(i))->Set(vtkCompositeDataSet::NAME(), blocks[i].c_str());
  }
  KeepAssembly(bodies, input, output);
}
}
