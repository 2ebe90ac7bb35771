#include "vtkSelectedPlacesInformation.h"

#include "smEdgeGaps.h"
#include "smEdgeLines.h"
#include "smIntegralNames.h"
#include "smOutputData.h"
#include "smPlaceTexts.h"

#include "vtkCellData.h"
#include "vtkClientServerStream.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessStream.h"
#include "vtkNURBSDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTrimmedNURBSModel.h"

#include <cstddef>

vtkStandardNewMacro(vtkSelectedPlacesInformation);

namespace
{
namespace names = sm::names;

vtkDataArray* GetNumbers(vtkTable* table, const char* name)
{
  return table ? vtkDataArray::SafeDownCast(table->GetColumnByName(name)) : nullptr;
}

vtkNURBSDataSet* GetMesh(vtkPartitionedDataSetCollection* meshes, vtkIdType solid)
{
  return meshes && solid >= 0 && solid < static_cast<vtkIdType>(meshes->GetNumberOfPartitionedDataSets())
    ? vtkNURBSDataSet::SafeDownCast(meshes->GetPartitionAsDataObject(static_cast<unsigned int>(solid), 0))
    : nullptr;
}

vtkDataArray* GetFaceIndices(vtkNURBSDataSet* mesh)
{
  return mesh ? mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName()) : nullptr;
}

template <typename T>
bool Take(const vtkClientServerStream* stream, int& argument, T* value)
{
  return stream->GetArgument(0, argument++, value) != 0;
}

/// Numbers with their count before them, and back.
template <typename T>
void Write(vtkClientServerStream* stream, const std::vector<T>& numbers)
{
  *stream << static_cast<int>(numbers.size());
  if (!numbers.empty())
  {
    *stream << vtkClientServerStream::InsertArray(numbers.data(), static_cast<int>(numbers.size()));
  }
}

template <typename T>
bool Read(const vtkClientServerStream* stream, int& argument, std::vector<T>& numbers)
{
  int count = 0;
  if (!Take(stream, argument, &count) || count < 0)
  {
    return false;
  }
  numbers.resize(static_cast<std::size_t>(count));
  return count == 0 ||
    stream->GetArgument(0, argument++, numbers.data(), static_cast<vtkTypeUInt32>(count)) != 0;
}

using Pairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

std::vector<vtkTypeInt64> ToNumbers(const Pairs& pairs)
{
  std::vector<vtkTypeInt64> numbers;
  for (const auto& [first, second] : pairs)
  {
    numbers.insert(numbers.end(), { first, second });
  }
  return numbers;
}

Pairs ToPairs(const std::vector<vtkTypeInt64>& numbers)
{
  Pairs pairs;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
  {
    pairs.emplace_back(numbers[i], numbers[i + 1]);
  }
  return pairs;
}

std::vector<vtkTypeInt64> ToNumbers(const std::map<vtkIdType, std::set<vtkIdType>>& faces)
{
  std::vector<vtkTypeInt64> numbers;
  for (const auto& [solid, indices] : faces)
  {
    for (const vtkIdType index : indices)
    {
      numbers.insert(numbers.end(), { solid, index });
    }
  }
  return numbers;
}
}

vtkSelectedPlacesInformation::vtkSelectedPlacesInformation() = default;
vtkSelectedPlacesInformation::~vtkSelectedPlacesInformation() = default;

void vtkSelectedPlacesInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Table: " << this->Table << "\n"
     << indent << "Rows: " << this->Rows.size() << "\n"
     << indent << "Cells: " << this->Cells.size() << "\n"
     << indent << "Text: " << this->Text << "\n";
}

void vtkSelectedPlacesInformation::SelectRows(Port table, const std::vector<vtkIdType>& rows)
{
  this->Table = table;
  this->Rows = rows;
  this->Cells.clear();
}

void vtkSelectedPlacesInformation::SelectMeshes(
  const std::set<vtkIdType>& solids, const std::vector<std::pair<vtkIdType, vtkIdType>>& cells)
{
  this->Table = MeshesPort;
  this->Rows.assign(solids.begin(), solids.end());
  this->Cells = cells;
}

void vtkSelectedPlacesInformation::CopyFromObject(vtkObject* object)
{
  this->Solids.clear();
  this->Faces.clear();
  this->FaceCells.clear();
  this->FaceRows.clear();
  this->Lines.clear();
  auto* solids = vtkTable::SafeDownCast(sm::GetOutputData(object, SolidsPort));
  auto* faces = vtkTable::SafeDownCast(sm::GetOutputData(object, FacesPort));
  auto* edges = vtkTable::SafeDownCast(sm::GetOutputData(object, EdgesPort));
  auto* meshes = vtkPartitionedDataSetCollection::SafeDownCast(sm::GetOutputData(object, MeshesPort));
  if (this->Table == FacesPort)
  {
    this->FindFacesOfRows(faces);
    this->FindCellsOfFaces(meshes);
  }
  else if (this->Table == EdgesPort)
  {
    this->DrawEdges(edges, meshes);
  }
  else
  {
    this->FindSolids(solids);
    this->FindFacesOfCells(meshes, faces);
  }
  this->Text = this->Table == EdgesPort
    ? sm::DescribeEdges(solids, edges, this->Rows)
    : sm::DescribePlaces(solids, { this->Solids.begin(), this->Solids.end() }, faces, this->FaceRows);
}

void vtkSelectedPlacesInformation::FindSolids(vtkTable* solids)
{
  auto* ids = solids ? vtkStringArray::SafeDownCast(solids->GetColumnByName(names::Id)) : nullptr;
  for (const vtkIdType row : this->Rows)
  {
    if (!ids || row < 0 || row >= ids->GetNumberOfValues())
    {
      continue;
    }
    if (!ids->GetValue(row).empty())
    {
      this->Solids.insert(row);
      continue;
    }
    // The total.
    for (vtkIdType solid = 0; solid < row; ++solid)
    {
      this->Solids.insert(solid);
    }
  }
}

void vtkSelectedPlacesInformation::FindFacesOfRows(vtkTable* faces)
{
  vtkDataArray* solid = GetNumbers(faces, names::Solid);
  vtkDataArray* index = GetNumbers(faces, vtkNURBSDataSet::FaceIndexArrayName());
  for (const vtkIdType row : this->Rows)
  {
    if (solid && index && row >= 0 && row < faces->GetNumberOfRows())
    {
      this->Faces[static_cast<vtkIdType>(solid->GetComponent(row, 0))].insert(
        static_cast<vtkIdType>(index->GetComponent(row, 0)));
      this->FaceRows.push_back(row);
    }
  }
}

void vtkSelectedPlacesInformation::FindCellsOfFaces(vtkPartitionedDataSetCollection* meshes)
{
  for (const auto& [solid, faces] : this->Faces)
  {
    vtkDataArray* index = GetFaceIndices(GetMesh(meshes, solid));
    for (vtkIdType cell = 0; index && cell < index->GetNumberOfTuples(); ++cell)
    {
      if (faces.count(static_cast<vtkIdType>(index->GetComponent(cell, 0))) > 0)
      {
        this->FaceCells.emplace_back(solid, cell);
      }
    }
  }
}

void vtkSelectedPlacesInformation::FindFacesOfCells(vtkPartitionedDataSetCollection* meshes, vtkTable* faces)
{
  for (const auto& [solid, cell] : this->Cells)
  {
    vtkDataArray* index = GetFaceIndices(GetMesh(meshes, solid));
    if (index && cell >= 0 && cell < index->GetNumberOfTuples())
    {
      this->Faces[solid].insert(static_cast<vtkIdType>(index->GetComponent(cell, 0)));
    }
  }
  vtkDataArray* solid = GetNumbers(faces, names::Solid);
  vtkDataArray* index = GetNumbers(faces, vtkNURBSDataSet::FaceIndexArrayName());
  for (vtkIdType row = 0; !this->Faces.empty() && solid && index && row < faces->GetNumberOfRows(); ++row)
  {
    const auto found = this->Faces.find(static_cast<vtkIdType>(solid->GetComponent(row, 0)));
    if (found != this->Faces.end() &&
      found->second.count(static_cast<vtkIdType>(index->GetComponent(row, 0))) > 0)
    {
      this->FaceRows.push_back(row);
    }
  }
}

void vtkSelectedPlacesInformation::DrawEdges(vtkTable* edges, vtkPartitionedDataSetCollection* meshes)
{
  vtkDataArray* solid = GetNumbers(edges, names::Solid);
  vtkDataArray* index = GetNumbers(edges, names::EdgeIndex);
  // The edges of a solid by their index.
  std::map<vtkIdType, std::vector<sm::EdgeGap>> edgesOfSolids;
  for (const vtkIdType row : this->Rows)
  {
    if (!solid || !index || row < 0 || row >= edges->GetNumberOfRows())
    {
      continue;
    }
    const auto number = static_cast<vtkIdType>(solid->GetComponent(row, 0));
    vtkNURBSDataSet* mesh = GetMesh(meshes, number);
    vtkTrimmedNURBSModel* model = mesh ? mesh->GetModel() : nullptr;
    const auto [found, isNew] = edgesOfSolids.emplace(number, std::vector<sm::EdgeGap>());
    if (isNew && model)
    {
      found->second = sm::CollectEdgeGaps(*model, nullptr);
    }
    for (const sm::EdgeGap& edge : found->second)
    {
      if (edge.Index == static_cast<int>(index->GetComponent(row, 0)))
      {
        const double line = this->Lines.empty() ? 0.0 : this->Lines.back()[3] + 1.0;
        for (const sm::Vector3& stored : sm::SampleEdge(*edge.Source))
        {
          const sm::Vector3 p = sm::PlacePoint(*model, mesh->GetPlacementData(), stored);
          this->Lines.push_back({ p[0], p[1], p[2], line });
        }
      }
    }
  }
}

void vtkSelectedPlacesInformation::AddInformation(vtkPVInformation* other)
{
  // One rank has the results, the others have tables without rows.
  auto* same = vtkSelectedPlacesInformation::SafeDownCast(other);
  if (same && this->Text.empty())
  {
    this->Solids = same->Solids;
    this->Faces = same->Faces;
    this->FaceCells = same->FaceCells;
    this->FaceRows = same->FaceRows;
    this->Lines = same->Lines;
    this->Text = same->Text;
  }
}

void vtkSelectedPlacesInformation::CopyToStream(vtkClientServerStream* stream)
{
  std::vector<double> coordinates;
  for (const std::array<double, 4>& point : this->Lines)
  {
    coordinates.insert(coordinates.end(), point.begin(), point.end());
  }
  stream->Reset();
  *stream << vtkClientServerStream::Reply << this->Text.c_str();
  Write(stream, std::vector<vtkTypeInt64>(this->Solids.begin(), this->Solids.end()));
  Write(stream, ToNumbers(this->Faces));
  Write(stream, ToNumbers(this->FaceCells));
  Write(stream, std::vector<vtkTypeInt64>(this->FaceRows.begin(), this->FaceRows.end()));
  Write(stream, coordinates);
  *stream << vtkClientServerStream::End;
}

void vtkSelectedPlacesInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  int argument = 0;
  std::vector<vtkTypeInt64> solids;
  std::vector<vtkTypeInt64> faces;
  std::vector<vtkTypeInt64> cells;
  std::vector<vtkTypeInt64> rows;
  std::vector<double> coordinates;
  const bool isRead = Take(stream, argument, &this->Text) && Read(stream, argument, solids) &&
    Read(stream, argument, faces) && Read(stream, argument, cells) && Read(stream, argument, rows) &&
    Read(stream, argument, coordinates);
  this->Faces.clear();
  this->Lines.clear();
  if (!isRead)
  {
    this->Text.clear();
    solids.clear();
    cells.clear();
    rows.clear();
    vtkErrorMacro("The server sent no information about what is selected.");
  }
  this->Solids = { solids.begin(), solids.end() };
  this->FaceCells = ToPairs(cells);
  this->FaceRows = { rows.begin(), rows.end() };
  for (std::size_t i = 0; isRead && i + 1 < faces.size(); i += 2)
  {
    this->Faces[faces[i]].insert(faces[i + 1]);
  }
  for (std::size_t i = 0; isRead && i + 3 < coordinates.size(); i += 4)
  {
    this->Lines.push_back({ coordinates[i], coordinates[i + 1], coordinates[i + 2], coordinates[i + 3] });
  }
}

void vtkSelectedPlacesInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << static_cast<int>(this->Table) << static_cast<int>(this->Rows.size())
         << static_cast<int>(this->Cells.size());
  for (const vtkIdType row : this->Rows)
  {
    stream << static_cast<vtkTypeInt64>(row);
  }
  for (const auto& [solid, cell] : this->Cells)
  {
    stream << static_cast<vtkTypeInt64>(solid) << static_cast<vtkTypeInt64>(cell);
  }
}

void vtkSelectedPlacesInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  int table = 0;
  int rows = 0;
  int cells = 0;
  stream >> table >> rows >> cells;
  this->Table = static_cast<Port>(table);
  this->Rows.clear();
  this->Cells.clear();
  for (int i = 0; i < rows; ++i)
  {
    vtkTypeInt64 row = 0;
    stream >> row;
    this->Rows.push_back(row);
  }
  for (int i = 0; i < cells; ++i)
  {
    vtkTypeInt64 solid = 0;
    vtkTypeInt64 cell = 0;
    stream >> solid >> cell;
    this->Cells.emplace_back(solid, cell);
  }
}
