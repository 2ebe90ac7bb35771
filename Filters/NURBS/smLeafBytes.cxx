#include "smLeafBytes.h"

#include "smFaceBytes.h"
#include "vtkNURBSDataSet.h"
#include "vtkTrimmedNURBSModel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
/// The number that stands for a null pointer.
constexpr std::uint32_t Nothing = std::numeric_limits<std::uint32_t>::max();

/// Numbers objects in the order in which they are written. For an object that occurs again the message has
/// only its number.
template <typename Object>
class SharedWriter
{
public:
  /// Writes the number of the object; true if its content has to follow.
  bool Put(const Object* object, ByteWriter& to)
  {
    if (!object)
    {
      to.Put(Nothing);
      return false;
    }
    const auto [known, isNew] =
      this->Numbers.emplace(object, static_cast<std::uint32_t>(this->Numbers.size()));
    to.Put(known->second);
    return isNew;
  }

private:
  std::map<const Object*, std::uint32_t> Numbers;
};

template <typename Object>
class SharedReader
{
public:
  /// Reads a number and returns its object, whose content `read` reads when the number is new. Returns null
  /// for a null pointer and for invalid bytes.
  template <typename Function>
  Object* Get(ByteReader& from, const Function& read)
  {
    const auto number = from.Get<std::uint32_t>();
    if (!from.IsGood() || number == Nothing)
    {
      return nullptr;
    }
    if (number == this->Objects.size())
    {
      this->Objects.push_back(read());
    }
    return number < this->Objects.size() ? this->Objects[number] : nullptr;
  }

private:
  std::vector<vtkSmartPointer<Object>> Objects;
};

class LeafWriter
{
public:
  explicit LeafWriter(ByteWriter& to)
    : To(to)
    , Faces(to)
  {
  }
  void Put(vtkNURBSDataSet* leaf);

private:
  void Put(vtkDataArray* array);
  void Put(vtkFieldData* fields, vtkDataSetAttributes* attributes);
  void Put(vtkTrimmedNURBSModel* model);
  void PutMesh(vtkPolyData* mesh);

  ByteWriter& To;
  FaceWriter Faces;
  SharedWriter<vtkDataArray> Arrays;
  SharedWriter<vtkCellArray> Cells;
  SharedWriter<vtkTrimmedNURBSModel> Models;
};

void LeafWriter::Put(vtkDataArray* array)
{
  if (!this->Arrays.Put(array, this->To))
  {
    return;
  }
  this->To.Put(array->GetDataType());
  this->To.PutText(array->GetName() ? array->GetName() : "");
  this->To.Put(array->GetNumberOfComponents());
  this->To.Put(static_cast<std::int64_t>(array->GetNumberOfTuples()));
  this->To.PutBlock(array->GetVoidPointer(0),
    static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
}

void LeafWriter::Put(vtkFieldData* fields, vtkDataSetAttributes* attributes)
{
  std::vector<int> numbers;
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    if (fields->GetArray(i))
    {
      numbers.push_back(i);
    }
  }
  this->To.Put(static_cast<std::uint64_t>(numbers.size()));
  for (const int i : numbers)
  {
    this->Put(fields->GetArray(i));
    this->To.Put(attributes ? attributes->IsArrayAnAttribute(i) : -1);
  }
}

void LeafWriter::Put(vtkTrimmedNURBSModel* model)
{
  if (!this->Models.Put(model, this->To))
  {
    return;
  }
  this->To.Put(model->GetFileId());
  for (const int number : { model->GetBody(), model->GetNumberOfMissingFaces(), model->GetNumberOfDefects(),
         model->GetNumberOfOuterShells() })
  {
    this->To.Put(number);
  }
  for (const std::string& text :
    { model->GetName(), model->GetLengthUnit(), model->GetFileUnit(), model->GetMaterial() })
  {
    this->To.PutText(text);
  }
  for (const double number : { model->GetDensity(), model->GetFileVolume(), model->GetFileArea(),
         model->GetFileUncertainty(), model->GetVolumeScale(), model->GetAreaScale() })
  {
    this->To.Put(number);
  }
  this->To.PutBlock(model->GetOrigin(), 3 * sizeof(double));
  this->To.PutBlock(model->GetLocalBounds(), 6 * sizeof(double));
  this->To.Put(static_cast<std::uint64_t>(model->GetFaces().size()));
  for (const FacePointer& face : model->GetFaces())
  {
    this->Faces.Put(*face);
  }
  this->To.Put(static_cast<std::uint64_t>(model->GetShells().size()));
  for (const std::vector<int>& shell : model->GetShells())
  {
    this->To.PutAll(shell);
  }
  this->To.PutTexts(model->GetMessages());
  this->To.Put(model->GetScaleMesh() != nullptr);
  if (model->GetScaleMesh())
  {
    this->PutMesh(model->GetScaleMesh());
  }
}

void LeafWriter::PutMesh(vtkPolyData* mesh)
{
  this->Put(mesh->GetPoints() ? mesh->GetPoints()->GetData() : nullptr);
  if (this->Cells.Put(mesh->GetPolys(), this->To))
  {
    this->Put(mesh->GetPolys()->GetOffsetsArray());
    this->Put(mesh->GetPolys()->GetConnectivityArray());
  }
  this->Put(mesh->GetPointData(), mesh->GetPointData());
  this->Put(mesh->GetCellData(), mesh->GetCellData());
  this->Put(mesh->GetFieldData(), nullptr);
}

void LeafWriter::Put(vtkNURBSDataSet* leaf)
{
  this->PutMesh(leaf);
  this->To.PutBlock(leaf->GetPlacementData(), 16 * sizeof(double));
  this->To.PutText(leaf->GetPartName());
  this->To.PutText(leaf->GetPartPath());
  this->Put(leaf->GetModel());
}

class LeafReader
{
public:
  explicit LeafReader(ByteReader& from)
    : From(from)
    , Faces(from)
  {
  }
  vtkSmartPointer<vtkNURBSDataSet> Get();

private:
  vtkDataArray* GetArray();
  vtkSmartPointer<vtkDataArray> ReadArray();
  void GetArrays(vtkFieldData* fields, vtkDataSetAttributes* attributes);
  vtkSmartPointer<vtkCellArray> ReadCells();
  vtkSmartPointer<vtkTrimmedNURBSModel> ReadModel();
  void GetMesh(vtkPolyData* mesh);

  ByteReader& From;
  FaceReader Faces;
  SharedReader<vtkDataArray> Arrays;
  SharedReader<vtkCellArray> Cells;
  SharedReader<vtkTrimmedNURBSModel> Models;
};

vtkSmartPointer<vtkDataArray> LeafReader::ReadArray()
{
  const int type = this->From.Get<int>();
  const std::string name = this->From.GetText();
  const int components = this->From.Get<int>();
  const auto tuples = this->From.Get<std::int64_t>();
  if (!this->From.IsGood() || components < 1 || tuples < 0 ||
    static_cast<std::uint64_t>(tuples) > this->From.GetNumberOfBytesLeft())
  {
    return nullptr;
  }
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  if (!name.empty())
  {
    array->SetName(name.c_str());
  }
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  this->From.GetBlock(array->GetVoidPointer(0),
    static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
  return array;
}

vtkDataArray* LeafReader::GetArray()
{
  return this->Arrays.Get(this->From, [this]() { return this->ReadArray(); });
}

void LeafReader::GetArrays(vtkFieldData* fields, vtkDataSetAttributes* attributes)
{
  const std::size_t count = this->From.GetCount(sizeof(std::uint32_t));
  for (std::size_t i = 0; i < count && this->From.IsGood(); ++i)
  {
    vtkDataArray* array = this->GetArray();
    const int attribute = this->From.Get<int>();
    const int index = array ? fields->AddArray(array) : -1;
    if (attributes && index >= 0 && attribute >= 0)
    {
      attributes->SetActiveAttribute(index, attribute);
    }
  }
}

vtkSmartPointer<vtkCellArray> LeafReader::ReadCells()
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  vtkDataArray* offsets = this->GetArray();
  vtkDataArray* connectivity = this->GetArray();
  if (offsets && connectivity)
  {
    cells->SetData(offsets, connectivity);
  }
  return cells;
}

vtkSmartPointer<vtkTrimmedNURBSModel> LeafReader::ReadModel()
{
  auto model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  model->SetFileId(this->From.Get<vtkTypeInt64>());
  model->SetBody(this->From.Get<int>());
  model->SetNumberOfMissingFaces(this->From.Get<int>());
  model->SetNumberOfDefects(this->From.Get<int>());
  model->SetNumberOfOuterShells(this->From.Get<int>());
  model->SetName(this->From.GetText());
  model->SetLengthUnit(this->From.GetText());
  model->SetFileUnit(this->From.GetText());
  model->SetMaterial(this->From.GetText());
  model->SetDensity(this->From.Get<double>());
  model->SetFileVolume(this->From.Get<double>());
  model->SetFileArea(this->From.Get<double>());
  model->SetFileUncertainty(this->From.Get<double>());
  model->SetVolumeScale(this->From.Get<double>());
  model->SetAreaScale(this->From.Get<double>());
  std::array<double, 6> numbers{};
  this->From.GetBlock(numbers.data(), 3 * sizeof(double));
  model->SetOrigin(numbers.data());
  this->From.GetBlock(numbers.data(), 6 * sizeof(double));
  model->SetLocalBounds(numbers.data());
  std::vector<FacePointer> faces(this->From.GetCount(sizeof(int)));
  for (FacePointer& face : faces)
  {
    face = this->Faces.Get();
    if (!face)
    {
      return nullptr;
    }
  }
  model->SetFaces(std::move(faces));
  std::vector<std::vector<int>> shells(this->From.GetCount(sizeof(std::uint64_t)));
  for (std::vector<int>& shell : shells)
  {
    shell = this->From.GetAll<int>();
  }
  model->SetShells(std::move(shells));
  model->SetMessages(this->From.GetTexts());
  if (this->From.Get<bool>())
  {
    vtkNew<vtkPolyData> mesh;
    this->GetMesh(mesh);
    model->SetScaleMesh(mesh);
  }
  return model;
}

void LeafReader::GetMesh(vtkPolyData* mesh)
{
  if (vtkDataArray* coordinates = this->GetArray())
  {
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    mesh->SetPoints(points);
  }
  mesh->SetPolys(this->Cells.Get(this->From, [this]() { return this->ReadCells(); }));
  this->GetArrays(mesh->GetPointData(), mesh->GetPointData());
  this->GetArrays(mesh->GetCellData(), mesh->GetCellData());
  this->GetArrays(mesh->GetFieldData(), nullptr);
}

vtkSmartPointer<vtkNURBSDataSet> LeafReader::Get()
{
  auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
  this->GetMesh(leaf);
  vtkNew<vtkMatrix4x4> placement;
  this->From.GetBlock(placement->GetData(), 16 * sizeof(double));
  leaf->SetPlacement(placement);
  leaf->SetPartName(this->From.GetText());
  leaf->SetPartPath(this->From.GetText());
  leaf->SetModel(this->Models.Get(this->From, [this]() { return this->ReadModel(); }));
  return this->From.IsGood() ? leaf : nullptr;
}

vtkNURBSDataSet* GetLeaf(vtkPartitionedDataSetCollection* collection, unsigned int index)
{
  return collection->GetNumberOfPartitions(index) > 0
    ? vtkNURBSDataSet::SafeDownCast(collection->GetPartitionAsDataObject(index, 0))
    : nullptr;
}
}

void PutLeaves(vtkPartitionedDataSetCollection* from, ByteWriter& to)
{
  LeafWriter writer(to);
  for (unsigned int i = 0; i < from->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkNURBSDataSet* leaf = GetLeaf(from, i);
    to.Put(leaf != nullptr);
    if (leaf)
    {
      writer.Put(leaf);
    }
  }
}

bool GetLeaves(ByteReader& from, vtkPartitionedDataSetCollection* to)
{
  LeafReader reader(from);
  for (unsigned int i = 0; i < to->GetNumberOfPartitionedDataSets() && from.IsGood(); ++i)
  {
    if (from.Get<bool>())
    {
      const vtkSmartPointer<vtkNURBSDataSet> leaf = reader.Get();
      if (!leaf)
      {
        return false;
      }
      to->SetPartition(i, 0, leaf);
    }
  }
  return from.IsGood();
}
}
