/**
 * @file smFilterTesting.h
 * @brief Composite inputs for the filters that change solids, and what must hold of their outputs
 */
#ifndef smFilterTesting_h
#define smFilterTesting_h

#include "smLatticeBody.h"
#include "smTesting.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkMatrix4x4.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolygon.h>

#include <string>

namespace smtest
{
/// Two instances of one solid, the second rotated by a quarter about z and moved, and a plain mesh; names and
/// an assembly.
inline vtkSmartPointer<vtkPartitionedDataSetCollection> MakeProduct(LatticeBody& body)
{
  const auto first = body.Make();
  auto second = vtkSmartPointer<vtkNURBSDataSet>::New();
  second->ShallowCopy(first);
  vtkNew<vtkMatrix4x4> placement;
  const double rows[16] = { 0, -1, 0, 10, 1, 0, 0, -20, 0, 0, 1, 30, 0, 0, 0, 1 };
  placement->DeepCopy(rows);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    const double* p = first->GetPoint(i);
    points->InsertNextPoint(10 - p[1], p[0] - 20, p[2] + 30);
    const double* n = first->GetPointData()->GetNormals()->GetTuple(i);
    normals->InsertNextTuple3(-n[1], n[0], n[2]);
  }
  second->GetPointData()->SetNormals(normals);
  second->SetPoints(points);
  second->SetPlacement(placement);
  second->SetModel(first->GetModel());
  vtkNew<vtkPolyData> plain;
  vtkNew<vtkPoints> plainPoints;
  plainPoints->InsertNextPoint(1.0, 2.0, 3.0);
  plain->SetPoints(plainPoints);
  auto product = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  product->SetPartition(0, 0, first);
  product->SetPartition(1, 0, second);
  product->SetPartition(2, 0, plain);
  for (unsigned int i = 0; i < 3; ++i)
  {
    product->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), ("part " + std::to_string(i)).c_str());
  }
  vtkNew<vtkDataAssembly> assembly;
  assembly->SetRootNodeName("product");
  for (unsigned int i = 0; i < 3; ++i)
  {
    assembly->AddDataSetIndex(assembly->AddNode(("node" + std::to_string(i)).c_str()), i);
  }
  product->SetDataAssembly(assembly);
  return product;
}

inline vtkNURBSDataSet* GetLeaf(vtkDataObject* product, unsigned int i)
{
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(product);
  return collection && i < collection->GetNumberOfPartitionedDataSets()
    ? vtkNURBSDataSet::SafeDownCast(collection->GetPartition(i, 0))
    : nullptr;
}

inline void CheckStructure(vtkDataObject* data)
{
  auto* product = vtkPartitionedDataSetCollection::SafeDownCast(data);
  if (!CheckTrue("three parts", product && product->GetNumberOfPartitionedDataSets() == 3))
  {
    return;
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    const char* name = product->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
    CheckEqual("name", "part " + std::to_string(i), name ? name : "(none)");
  }
  vtkDataAssembly* assembly = product->GetDataAssembly();
  CheckTrue("the assembly",
    assembly && assembly->GetNumberOfChildren(0) == 3 &&
      assembly->GetDataSetIndices(assembly->GetChild(0, 1)) == std::vector<unsigned int>{ 1 });
}

/// Stops a filter from an observer of its progress, also of the executive's report after the run. The output
/// is then empty; that of the next run is not.
inline void CheckAbort(vtkAlgorithm* filter)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  const unsigned long silenceTag = filter->AddObserver(vtkCommand::WarningEvent, silence);
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Modified();
  filter->Update();
  auto* product = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
  CheckTrue("a run that is stopped: empty", product && product->GetNumberOfPartitionedDataSets() == 0);
  filter->RemoveObserver(tag);
  filter->RemoveObserver(silenceTag);
  filter->Modified();
  filter->Update();
  CheckStructure(filter->GetOutputDataObject(0));
}

/// Largest distance of the display points from their faces.
inline double GetDistanceFromFaces(vtkNURBSDataSet* leaf)
{
  double distance = 0.0;
  vtkDataArray* faces = leaf->GetPointData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  vtkDataArray* parameters = leaf->GetPointData()->GetArray(vtkNURBSDataSet::ParametersArrayName());
  const double* m = leaf->GetPlacementData();
  const double* origin = leaf->GetModel()->GetOrigin();
  for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
  {
    double p[3];
    leaf->GetModel()->GetFaces()[static_cast<std::size_t>(faces->GetComponent(i, 0))]->Surface.Evaluate(
      parameters->GetComponent(i, 0), parameters->GetComponent(i, 1), p);
    for (int r = 0; r < 3; ++r)
    {
      double x = m[4 * r + 3];
      for (int c = 0; c < 3; ++c)
      {
        x += m[4 * r + c] * (p[c] + origin[c]);
      }
      distance = std::fmax(distance, std::fabs(x - leaf->GetPoint(i)[r]));
    }
  }
  return distance;
}

/// Smallest cosine between the normal of a cell and those of its points: near 1 on a fine mesh.
inline double GetMinimumCosine(vtkNURBSDataSet* leaf)
{
  double minimum = 1.0;
  vtkDataArray* normals = leaf->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < leaf->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> ids;
    leaf->GetCellPoints(i, ids);
    double cell[3];
    vtkPolygon::ComputeNormal(
      leaf->GetPoints(), static_cast<int>(ids->GetNumberOfIds()), ids->GetPointer(0), cell);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const double* n = normals->GetTuple(ids->GetId(k));
      minimum = std::fmin(minimum, n[0] * cell[0] + n[1] * cell[1] + n[2] * cell[2]);
    }
  }
  return minimum;
}

/// Runs the filter, which must fail with an error that holds `words`, and leave nothing.
inline void CheckFails(vtkAlgorithm* filter, const std::string& words)
{
  std::string errors;
  vtkNew<vtkCallbackCommand> trap;
  trap->SetClientData(&errors);
  trap->SetCallback([](vtkObject*, unsigned long, void* text, void* data)
    { *static_cast<std::string*>(text) += data ? static_cast<const char*>(data) : "?"; });
  const unsigned long tag = filter->AddObserver(vtkCommand::ErrorEvent, trap);
  const unsigned long other = filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, trap);
  filter->Update();
  filter->RemoveObserver(tag);
  filter->GetExecutive()->RemoveObserver(other);
  CheckTrue("error: " + words, errors.find(words) != std::string::npos, errors);
  vtkNURBSDataSet* leaf = GetLeaf(filter->GetOutputDataObject(0), 0);
  CheckTrue("no output", !leaf || !leaf->GetModel());
}
}

#endif
