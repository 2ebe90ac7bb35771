// Leaves as bytes: every property of a model and its dataset comes back, what is shared is shared again, and
// a message that ends early is refused.
#include "smLeafBytes.h"
#include "smTesting.h"
#include "vtkNURBSDataSet.h"
#include "vtkTrimmedNURBSModel.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace
{
using namespace smtest;

template <typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, int components, vtkIdType tuples, double first)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(*name ? name : nullptr);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetVariantValue(i, first + i);
  }
  return array;
}

/// A square of two triangles, its face, and no property that is the default.
vtkSmartPointer<vtkTrimmedNURBSModel> MakeModel()
{
  auto model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  const auto knots = MakeArray<vtkDoubleArray>("", 1, 4, 0.0);
  const double values[4] = { 0.0, 0.0, 1.0, 1.0 };
  std::copy(values, values + 4, knots->GetPointer(0));
  const auto corners = MakeArray<vtkDoubleArray>("", 3, 4, 0.5);
  model->AddFace(1, knots, 1, knots, corners, true);
  auto face = std::make_shared<sm::Face>(*model->GetFaces()[0]);
  face->Color = { 0.1, 0.2, 0.3 };
  face->Messages = { "a face", "" };
  face->Name = "named";
  face->FileId = 17;
  model->SetFace(0, face);
  model->SetBody(vtkTrimmedNURBSModel::SHELL);
  model->SetName("name");
  model->SetFileId(12);
  model->SetLengthUnit("cm");
  model->SetFileUnit("inch");
  model->SetMaterial("steel");
  model->SetDensity(7850.0);
  model->SetFileVolume(1.5);
  model->SetFileArea(2.5);
  model->SetFileUncertainty(0.125);
  model->SetNumberOfMissingFaces(3);
  model->SetNumberOfDefects(4);
  model->SetNumberOfOuterShells(2);
  model->SetOrigin(1.0, 2.0, 3.0);
  model->SetLocalBounds(-1.0, 1.0, -2.0, 2.0, -3.0, 3.0);
  model->SetVolumeScale(8.0);
  model->SetAreaScale(16.0);
  model->SetShells({ { 0 }, {} });
  model->SetMessages({ "one", "two" });
  return model;
}

vtkSmartPointer<vtkPartitionedDataSetCollection> MakeCollection()
{
  const auto model = MakeModel();
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 1, 3, 2 });
  const auto faces = MakeArray<vtkFloatArray>("shared", 1, 2, 7.0);
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  collection->SetNumberOfPartitionedDataSets(3);
  for (const unsigned int i : { 0u, 2u })
  {
    vtkNew<vtkNURBSDataSet> leaf;
    vtkNew<vtkPoints> points;
    points->SetData(MakeArray<vtkDoubleArray>("", 3, 4, 100.0 * i));
    leaf->SetPoints(points);
    leaf->SetPolys(triangles);
    leaf->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Parameters", 2, 4, 1.0));
    leaf->GetPointData()->SetNormals(MakeArray<vtkFloatArray>("Normals", 3, 4, 2.0));
    leaf->GetCellData()->AddArray(MakeArray<vtkUnsignedCharArray>("Color", 3, 2, 3.0));
    leaf->GetCellData()->AddArray(faces);
    leaf->GetFieldData()->AddArray(MakeArray<vtkDoubleArray>("MeshDeviation", 1, 1, 0.25));
    vtkNew<vtkMatrix4x4> placement;
    placement->SetElement(0, 3, 5.0 + i);
    leaf->SetPlacement(placement);
    leaf->SetPartName("nut");
    leaf->SetPartPath("arm/nut (" + std::to_string(i) + ")");
    leaf->SetModel(model);
    collection->SetPartition(i, 0, leaf);
  }
  collection->SetPartition(1, 0, nullptr);
  return collection;
}

sm::Bytes GetBytes(vtkPartitionedDataSetCollection* collection)
{
  sm::ByteWriter to;
  sm::PutLeaves(collection, to);
  return to.GetBytes();
}

bool Read(const sm::Bytes& bytes, vtkPartitionedDataSetCollection* collection)
{
  collection->SetNumberOfPartitionedDataSets(3);
  sm::ByteReader from(bytes);
  return sm::GetLeaves(from, collection);
}

vtkNURBSDataSet* GetLeaf(vtkPartitionedDataSetCollection* collection, unsigned int index)
{
  return vtkNURBSDataSet::SafeDownCast(collection->GetPartitionAsDataObject(index, 0));
}

void CheckModel(vtkTrimmedNURBSModel* model)
{
  CheckEqual("body", vtkTrimmedNURBSModel::SHELL, model->GetBody());
  CheckEqual("texts", "name cm inch steel",
    model->GetName() + " " + model->GetLengthUnit() + " " + model->GetFileUnit() + " " +
      model->GetMaterial());
  CheckTrue("whole numbers",
    model->GetFileId() == 12 && model->GetNumberOfMissingFaces() == 3 && model->GetNumberOfDefects() == 4 &&
      model->GetNumberOfOuterShells() == 2);
  CheckTrue("numbers",
    model->GetDensity() == 7850.0 && model->GetFileVolume() == 1.5 && model->GetFileArea() == 2.5 &&
      model->GetFileUncertainty() == 0.125 && model->GetVolumeScale() == 8.0 &&
      model->GetAreaScale() == 16.0);
  CheckTrue("places", model->GetOrigin()[2] == 3.0 && model->GetLocalBounds()[5] == 3.0);
  CheckTrue("shells", model->GetShells() == std::vector<std::vector<int>>{ { 0 }, {} });
  CheckTrue("messages", model->GetMessages() == std::vector<std::string>{ "one", "two" });
  const sm::Face& face = *model->GetFaces()[0];
  CheckTrue("face",
    face.Name == "named" && face.FileId == 17 && face.Reversed && face.Color[2] == 0.3 &&
      face.Messages.size() == 2 && face.Messages[0] == "a face" && face.Surface.ControlPoints.size() == 4);
}

void CheckLeaf(vtkNURBSDataSet* leaf, double shift)
{
  CheckEqual("points", 4, leaf->GetNumberOfPoints());
  Check("first coordinate", 100.0 * shift, leaf->GetPoint(0)[0], 0.0);
  CheckEqual("cells", 2, leaf->GetNumberOfCells());
  CheckTrue("normals are the normals", leaf->GetPointData()->GetNormals() != nullptr);
  CheckEqual("point arrays", 2, leaf->GetPointData()->GetNumberOfArrays());
  CheckTrue("colours", vtkUnsignedCharArray::SafeDownCast(leaf->GetCellData()->GetArray("Color")) != nullptr);
  Check("field array", 0.25, leaf->GetFieldData()->GetArray("MeshDeviation")->GetTuple1(0), 0.0);
  CheckEqual("part name and path", "nut in arm/nut (" + std::to_string(static_cast<int>(shift)) + ")",
    leaf->GetPartName() + " in " + leaf->GetPartPath());
  Check("placement", 5.0 + shift, leaf->GetPlacementData()[3], 0.0);
}
}

int TestLeafBytes(int, char*[])
{
  const auto collection = MakeCollection();
  const sm::Bytes bytes = GetBytes(collection);
  vtkNew<vtkPartitionedDataSetCollection> read;
  if (!CheckTrue("read", Read(bytes, read)))
  {
    return Finish();
  }
  CheckLeaf(GetLeaf(read, 0), 0.0);
  CheckLeaf(GetLeaf(read, 2), 2.0);
  CheckTrue("no leaf where there was none", GetLeaf(read, 1) == nullptr);
  vtkTrimmedNURBSModel* model = GetLeaf(read, 0)->GetModel();
  CheckTrue("the model is shared", model && model == GetLeaf(read, 2)->GetModel());
  CheckTrue("and so is an array",
    GetLeaf(read, 0)->GetCellData()->GetArray("shared") ==
      GetLeaf(read, 2)->GetCellData()->GetArray("shared"));
  CheckModel(model);
  const sm::Bytes again = GetBytes(read);
  const auto first = std::mismatch(bytes.begin(), bytes.end(), again.begin(), again.end()).first;
  CheckTrue("bit for bit", again == bytes,
    "byte " + std::to_string(first - bytes.begin()) + " of " + std::to_string(bytes.size()));
  int complete = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size)
  {
    vtkNew<vtkPartitionedDataSetCollection> part;
    complete +=
      Read(sm::Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)), part) ? 1 : 0;
  }
  CheckEqual("messages that end early are refused", 0, complete);
  return Finish();
}
