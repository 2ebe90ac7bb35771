#include "vtkSelectedEntitiesInformation.h"

#include "smColumns.h"
#include "smEdgeGaps.h"
#include "smEdgeLines.h"
#include "smEntityTexts.h"
#include "smIntegralNames.h"
#include "smOutputData.h"
#include "smPolylineText.h"
#include "smTableCells.h"

#include "vtkCellData.h"
#include "vtkClientServerStream.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessStream.h"
#include "vtkNURBSDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTable.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cstddef>

vtkStandardNewMacro(vtkSelectedEntitiesInformation);

namespace
{
namespace names = sm::names;

/// Largest number of single cells that are highlighted. ParaView's time grows with their number, and with the
/// cube of the number of their solids.
constexpr std::size_t MaxHighlightedCells = 50000;
constexpr std::size_t MaxSolidsWithHighlightedCells = 50;
constexpr std::size_t MaxDrawnEdges = 1000;

vtkPolyData* GetMesh(vtkPartitionedDataSetCollection* meshes, vtkIdType solid)
{
  return meshes && solid >= 0 && solid < static_cast<vtkIdType>(meshes->GetNumberOfPartitionedDataSets())
    ? vtkPolyData::SafeDownCast(meshes->GetPartitionAsDataObject(static_cast<unsigned int>(solid), 0))
    : nullptr;
}

vtkDataArray* GetFaceIndices(vtkPolyData* mesh)
{
  return mesh ? mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName()) : nullptr;
}

template <typename T>
bool Take(const vtkClientServerStream* stream, int& argument, T* value)
{
  return stream->GetArgument(0, argument++, value) != 0;
}

/// Write a list of numbers, preceded by its length, to a stream, and read it.
void Write(vtkClientServerStream* stream, const std::vector<vtkTypeInt64>& numbers)
{
  *stream << static_cast<int>(numbers.size());
  if (!numbers.empty())
  {
    *stream << vtkClientServerStream::InsertArray(numbers.data(), static_cast<int>(numbers.size()));
  }
}

bool Read(const vtkClientServerStream* stream, int& argument, std::vector<vtkTypeInt64>& numbers)
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

void WriteNumbers(vtkMultiProcessStream& stream, const std::vector<vtkTypeInt64>& numbers)
{
  stream << static_cast<vtkTypeInt64>(numbers.size());
  for (const vtkTypeInt64 number : numbers)
  {
    stream << number;
  }
}

std::vector<vtkTypeInt64> ReadNumbers(vtkMultiProcessStream& stream)
{
  vtkTypeInt64 count = 0;
  stream >> count;
  std::vector<vtkTypeInt64> numbers(static_cast<std::size_t>(std::max<vtkTypeInt64>(count, 0)));
  for (vtkTypeInt64& number : numbers)
  {
    stream >> number;
  }
  return numbers;
}

template <typename Numbers>
std::vector<vtkTypeInt64> ToList(const Numbers& numbers)
{
  return { numbers.begin(), numbers.end() };
}

/// Returns consecutive pairs of a solid and one of its faces or cells.
template <typename Members>
std::vector<vtkTypeInt64> ToPairs(const std::map<vtkIdType, Members>& membersOfSolids)
{
  std::vector<vtkTypeInt64> pairs;
  for (const auto& [solid, members] : membersOfSolids)
  {
    for (const vtkIdType member : members)
    {
      pairs.insert(pairs.end(), { solid, member });
    }
  }
  return pairs;
}

template <typename Members>
std::map<vtkIdType, Members> FromPairs(const std::vector<vtkTypeInt64>& pairs)
{
  std::map<vtkIdType, Members> membersOfSolids;
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
  {
    Members& members = membersOfSolids[pairs[i]];
    members.insert(members.end(), pairs[i + 1]);
  }
  return membersOfSolids;
}
}

vtkSelectedEntitiesInformation::vtkSelectedEntitiesInformation() = default;
vtkSelectedEntitiesInformation::~vtkSelectedEntitiesInformation() = default;

void vtkSelectedEntitiesInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Selected: " << this->Selected << "\n"
     << indent << "Sets: " << this->Terms.Sets.size() << "\n"
     << indent << "Text: " << this->Text << "\n";
}

void vtkSelectedEntitiesInformation::Select(Port port, const sm::SelectionTerms& terms, Port meshes)
{
  this->Selected = port;
  this->Meshes = port == ClippedPort ? port : meshes;
  this->Terms = terms;
}

void vtkSelectedEntitiesInformation::SetBefore(
  const std::set<vtkIdType>& solids, const std::map<vtkIdType, std::set<vtkIdType>>& faces)
{
  this->SolidsBefore = solids;
  this->FacesBefore = faces;
}

void vtkSelectedEntitiesInformation::Clear()
{
  this->Solids.clear();
  this->Faces.clear();
  this->FaceRows.clear();
  this->SolidIds.clear();
  this->Shown = {};
  this->EdgeLines.clear();
  this->Text.clear();
}

void vtkSelectedEntitiesInformation::CopyFromObject(vtkObject* object)
{
  this->Clear();
  auto* solids = vtkTable::SafeDownCast(sm::GetOutputData(object, SolidsPort));
  auto* faces = vtkTable::SafeDownCast(sm::GetOutputData(object, FacesPort));
  if (this->Selected == EdgesPort)
  {
    this->FindEdges(solids, vtkTable::SafeDownCast(sm::GetOutputData(object, EdgesPort)),
      vtkPartitionedDataSetCollection::SafeDownCast(sm::GetOutputData(object, MeshesPort)));
    return;
  }
  auto* meshes = vtkPartitionedDataSetCollection::SafeDownCast(sm::GetOutputData(object, this->Meshes));
  if (this->Selected == SolidsPort)
  {
    this->FindSolidsOfRows(solids);
  }
  else if (this->Selected == FacesPort)
  {
    this->FindFacesOfRows(faces);
  }
  else
  {
    this->FindSolidsAndFacesOfCells(meshes, faces);
  }
  this->FindSolidIds(solids);
  this->Text =
    sm::DescribeSolidsAndFaces(solids, { this->Solids.begin(), this->Solids.end() }, faces, this->FaceRows);
  this->FindHighlight(meshes);
}

std::vector<vtkIdType> vtkSelectedEntitiesInformation::FindRows(vtkTable* table) const
{
  const vtkIdType count = sm::CountRows(table);
  sm::SelectedElements selected = sm::FindSelectedElements(this->Terms, 0, count);
  for (vtkIdType row = 0; selected.IsWhole && row < count; ++row)
  {
    selected.Elements.push_back(row);
  }
  return selected.Elements;
}

void vtkSelectedEntitiesInformation::FindSolidsOfRows(vtkTable* solids)
{
  for (const vtkIdType row : this->FindRows(solids))
  {
    if (!sm::columns::IsTotalRow(solids, row))
    {
      this->Solids.insert(row);
      continue;
    }
    for (vtkIdType solid = 0; solid < row; ++solid)
    {
      this->Solids.insert(solid);
    }
  }
}

void vtkSelectedEntitiesInformation::FindFacesOfRows(vtkTable* faces)
{
  for (const vtkIdType row : this->FindRows(faces))
  {
    this->Faces[sm::GetIndex(faces, names::Solid, row)].insert(
      sm::GetIndex(faces, vtkNURBSDataSet::FaceIndexArrayName(), row));
    this->FaceRows.push_back(row);
  }
}

void vtkSelectedEntitiesInformation::FindSolidsAndFacesOfCells(
  vtkPartitionedDataSetCollection* meshes, vtkTable* faces)
{
  const auto count = static_cast<vtkIdType>(meshes ? meshes->GetNumberOfPartitionedDataSets() : 0);
  for (vtkIdType solid = 0; solid < count; ++solid)
  {
    vtkDataArray* index = GetFaceIndices(GetMesh(meshes, solid));
    const sm::SelectedElements selected =
      sm::FindSelectedElements(this->Terms, solid, index ? index->GetNumberOfTuples() : 0);
    if (selected.IsWhole)
    {
      this->Solids.insert(solid);
    }
    this->AddFacesOfCells(solid, selected.Elements, index);
  }
  for (vtkIdType row = 0; !this->Faces.empty() && row < sm::CountRows(faces); ++row)
  {
    const auto found = this->Faces.find(sm::GetIndex(faces, names::Solid, row));
    if (found != this->Faces.end() &&
      found->second.count(sm::GetIndex(faces, vtkNURBSDataSet::FaceIndexArrayName(), row)) > 0)
    {
      this->FaceRows.push_back(row);
    }
  }
}

void vtkSelectedEntitiesInformation::AddFacesOfCells(
  vtkIdType solid, const std::vector<vtkIdType>& cells, vtkDataArray* index)
{
  if (cells.empty())
  {
    return;
  }
  std::map<vtkIdType, vtkIdType> counts;
  for (const vtkIdType cell : cells)
  {
    ++counts[static_cast<vtkIdType>(index->GetComponent(cell, 0))];
  }
  std::map<vtkIdType, vtkIdType> all;
  for (vtkIdType cell = 0; cell < index->GetNumberOfTuples(); ++cell)
  {
    ++all[static_cast<vtkIdType>(index->GetComponent(cell, 0))];
  }
  const auto before = this->FacesBefore.find(solid);
  for (const auto& [face, count] : counts)
  {
    // A single set is a new selection, which takes the place of what was selected before.
    const bool wasSelected = this->Terms.Sets.size() > 1 &&
      (this->SolidsBefore.count(solid) > 0 ||
        (before != this->FacesBefore.end() && before->second.count(face) > 0));
    if (count == all[face] || !wasSelected)
    {
      this->Faces[solid].insert(face);
    }
  }
}

void vtkSelectedEntitiesInformation::FindHighlight(vtkPartitionedDataSetCollection* meshes)
{
  this->Shown.Solids = this->Solids;
  std::size_t count = 0;
  for (const auto& [solid, faces] : this->Faces)
  {
    vtkDataArray* index = GetFaceIndices(GetMesh(meshes, solid));
    std::vector<vtkIdType> cells;
    for (vtkIdType cell = 0; index && cell < index->GetNumberOfTuples(); ++cell)
    {
      if (faces.count(static_cast<vtkIdType>(index->GetComponent(cell, 0))) > 0)
      {
        cells.push_back(cell);
      }
    }
    if (index && static_cast<vtkIdType>(cells.size()) == index->GetNumberOfTuples())
    {
      this->Shown.Solids.insert(solid);
    }
    else if (!cells.empty())
    {
      count += cells.size();
      this->Shown.Cells[solid] = std::move(cells);
    }
  }
  if (count > MaxHighlightedCells || this->Shown.Cells.size() > MaxSolidsWithHighlightedCells)
  {
    if (this->Selected == MeshesPort || this->Selected == ClippedPort)
    {
      // The cells that were picked stay as they are.
      this->Shown = {};
      return;
    }
    for (const auto& solid : this->Shown.Cells)
    {
      this->Shown.Solids.insert(solid.first);
    }
    this->Shown.Cells.clear();
    if (this->Selected == FacesPort)
    {
      this->Text += "Too many faces to highlight each: their whole solids are highlighted.\n";
    }
  }
}

void vtkSelectedEntitiesInformation::FindEdges(
  vtkTable* solids, vtkTable* edges, vtkPartitionedDataSetCollection* meshes)
{
  const std::vector<vtkIdType> rows = this->FindRows(edges);
  this->Text = sm::DescribeEdges(solids, edges, rows);
  const std::size_t drawn = std::min(rows.size(), MaxDrawnEdges);
  if (drawn < rows.size())
  {
    this->Text += "The first " + std::to_string(drawn) + " edges are drawn.\n";
  }
  std::map<vtkIdType, std::map<vtkIdType, const sm::Edge*>> edgesOfSolids;
  std::vector<std::vector<sm::Vector3>> lines;
  for (std::size_t i = 0; i < drawn; ++i)
  {
    const vtkIdType solid = sm::GetIndex(edges, names::Solid, rows[i]);
    auto* mesh = vtkNURBSDataSet::SafeDownCast(GetMesh(meshes, solid));
    vtkTrimmedNURBSModel* model = mesh ? mesh->GetModel() : nullptr;
    const auto [known, isNew] = edgesOfSolids.try_emplace(solid);
    if (isNew && model)
    {
      for (const sm::EdgeGap& edge : sm::CollectEdgeGaps(*model, nullptr))
      {
        known->second[edge.Index] = edge.Source;
      }
    }
    const auto edge = known->second.find(sm::GetIndex(edges, names::EdgeIndex, rows[i]));
    if (edge != known->second.end())
    {
      lines.emplace_back();
      for (const sm::Vector3& stored : sm::SampleEdge(*edge->second))
      {
        lines.back().push_back(sm::PlacePoint(*model, mesh->GetPlacementData(), stored));
      }
    }
  }
  this->EdgeLines = sm::FormatPolylines(lines);
}

void vtkSelectedEntitiesInformation::FindSolidIds(vtkTable* solids)
{
  std::set<vtkIdType> all = this->Solids;
  for (const auto& faces : this->Faces)
  {
    all.insert(faces.first);
  }
  for (const vtkIdType solid : all)
  {
    this->SolidIds.push_back(sm::GetText(solids, names::Id, solid));
  }
}

void vtkSelectedEntitiesInformation::AddInformation(vtkPVInformation* other)
{
  // Only one rank has results; the tables of the others have no rows.
  auto* same = vtkSelectedEntitiesInformation::SafeDownCast(other);
  if (same && this->Text.empty())
  {
    this->Solids = same->Solids;
    this->Faces = same->Faces;
    this->FaceRows = same->FaceRows;
    this->SolidIds = same->SolidIds;
    this->Shown = same->Shown;
    this->EdgeLines = same->EdgeLines;
    this->Text = same->Text;
  }
}

void vtkSelectedEntitiesInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << this->Text.c_str() << this->EdgeLines.c_str();
  Write(stream, ToList(this->Solids));
  Write(stream, ToPairs(this->Faces));
  Write(stream, ToList(this->FaceRows));
  Write(stream, ToList(this->Shown.Solids));
  Write(stream, ToPairs(this->Shown.Cells));
  *stream << static_cast<int>(this->SolidIds.size());
  for (const std::string& id : this->SolidIds)
  {
    *stream << id.c_str();
  }
  *stream << vtkClientServerStream::End;
}

void vtkSelectedEntitiesInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  this->Clear();
  int argument = 0;
  int ids = 0;
  std::vector<vtkTypeInt64> solids;
  std::vector<vtkTypeInt64> faces;
  std::vector<vtkTypeInt64> rows;
  std::vector<vtkTypeInt64> shownSolids;
  std::vector<vtkTypeInt64> shownCells;
  bool isRead = Take(stream, argument, &this->Text) && Take(stream, argument, &this->EdgeLines) &&
    Read(stream, argument, solids) && Read(stream, argument, faces) && Read(stream, argument, rows) &&
    Read(stream, argument, shownSolids) && Read(stream, argument, shownCells) && Take(stream, argument, &ids);
  for (int i = 0; isRead && i < ids; ++i)
  {
    this->SolidIds.emplace_back();
    isRead = Take(stream, argument, &this->SolidIds.back());
  }
  if (!isRead)
  {
    this->Clear();
    vtkErrorMacro("The server sent no information about what is selected.");
    return;
  }
  this->Solids = { solids.begin(), solids.end() };
  this->Faces = FromPairs<std::set<vtkIdType>>(faces);
  this->FaceRows = { rows.begin(), rows.end() };
  this->Shown.Solids = { shownSolids.begin(), shownSolids.end() };
  this->Shown.Cells = FromPairs<std::vector<vtkIdType>>(shownCells);
}

void vtkSelectedEntitiesInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << static_cast<int>(this->Selected) << static_cast<int>(this->Meshes);
  sm::Write(this->Terms, stream);
  WriteNumbers(stream, ToList(this->SolidsBefore));
  WriteNumbers(stream, ToPairs(this->FacesBefore));
}

void vtkSelectedEntitiesInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  int port = 0;
  int meshes = 0;
  stream >> port >> meshes;
  this->Selected = static_cast<Port>(port);
  this->Meshes = static_cast<Port>(meshes);
  sm::Read(this->Terms, stream);
  const std::vector<vtkTypeInt64> solids = ReadNumbers(stream);
  this->SolidsBefore = { solids.begin(), solids.end() };
  this->FacesBefore = FromPairs<std::set<vtkIdType>>(ReadNumbers(stream));
}
