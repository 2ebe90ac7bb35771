#include "smColumns.h"

#include "smIntegralNames.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkMath.h"
#include "vtkNURBSDataSet.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <utility>

namespace sm
{
namespace columns
{
Column::Column(const std::string& name, int components)
{
  this->Array->SetName(name.c_str());
  this->Array->SetNumberOfComponents(components);
}

void Column::AddTo(vtkFieldData* data) const
{
  data->AddArray(this->Array);
}

void SetDoubles(vtkFieldData* data, const std::string& name, const double* values, int components)
{
  Column column(name, components);
  column.Append(values);
  column.AddTo(data);
}

void SetInteger(vtkFieldData* data, const std::string& name, vtkTypeInt64 value)
{
  vtkNew<vtkLongLongArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  data->AddArray(array);
}

void SetString(vtkFieldData* data, const std::string& name, const std::string& value)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  data->AddArray(array);
}

void AddBodyColumns(const std::vector<BodyIntegrals>& bodies, vtkTable* solids)
{
  vtkNew<vtkStringArray> name;
  vtkNew<vtkStringArray> id;
  vtkNew<vtkStringArray> status;
  vtkNew<vtkStringArray> unit;
  vtkNew<vtkIntArray> open;
  vtkNew<vtkIntArray> flipped;
  vtkNew<vtkIntArray> estimated;
  vtkNew<vtkIntArray> faces;
  name->SetName(names::Name);
  id->SetName(names::Id);
  status->SetName(names::Status);
  unit->SetName(names::LengthUnit);
  open->SetName(names::OpenEdges);
  flipped->SetName(names::FlippedShells);
  estimated->SetName(names::BoundsEstimated);
  faces->SetName(names::Faces);
  for (const BodyIntegrals& body : bodies)
  {
    name->InsertNextValue(body.Name);
    id->InsertNextValue(body.Id);
    status->InsertNextValue(GetText(body.Status));
    unit->InsertNextValue(body.Model->GetLengthUnit());
    open->InsertNextValue(body.OpenEdges);
    flipped->InsertNextValue(body.FlippedShells);
    estimated->InsertNextValue(body.IsEstimated() ? 1 : 0);
    faces->InsertNextValue(static_cast<int>(body.Model->GetNumberOfFaces()));
  }
  // The columns of labels are the first ones in a spreadsheet.
  vtkNew<vtkDataSetAttributes> values;
  values->ShallowCopy(solids->GetRowData());
  solids->GetRowData()->Initialize();
  solids->AddColumn(name);
  solids->AddColumn(id);
  solids->AddColumn(status);
  for (int i = 0; i < values->GetNumberOfArrays(); ++i)
  {
    solids->AddColumn(values->GetAbstractArray(i));
  }
  solids->AddColumn(unit);
  solids->AddColumn(open);
  solids->AddColumn(flipped);
  solids->AddColumn(estimated);
  solids->AddColumn(faces);
}

void AppendTotalRow(vtkFieldData* totals, const std::string& name, vtkTable* solids)
{
  const vtkIdType row = solids->GetNumberOfRows();
  for (vtkIdType i = 0; i < solids->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = solids->GetColumn(i);
    vtkAbstractArray* total = totals->GetAbstractArray(column->GetName());
    const bool hasTotal = total && total->GetNumberOfTuples() > 0 &&
      total->GetNumberOfComponents() == column->GetNumberOfComponents();
    if (auto* texts = vtkStringArray::SafeDownCast(column))
    {
      auto* text = vtkStringArray::SafeDownCast(total);
      const bool isName = texts->GetName() == std::string(names::Name);
      texts->InsertNextValue(isName ? name : hasTotal && text ? text->GetValue(0) : vtkStdString());
      continue;
    }
    auto* numbers = vtkDataArray::SafeDownCast(column);
    auto* sum = vtkDataArray::SafeDownCast(total);
    for (int k = 0; numbers && k < numbers->GetNumberOfComponents(); ++k)
    {
      const double missing = vtkDoubleArray::SafeDownCast(numbers) ? vtkMath::Nan() : 0.0;
      numbers->InsertComponent(row, k, hasTotal && sum ? sum->GetComponent(0, k) : missing);
    }
  }
}

bool IsTotalRow(vtkTable* solids, vtkIdType row)
{
  auto* ids = solids ? vtkStringArray::SafeDownCast(solids->GetColumnByName(names::Id)) : nullptr;
  return ids && row >= 0 && row < ids->GetNumberOfValues() && ids->GetValue(row).empty();
}

void AddFaceRows(const std::vector<BodyIntegrals>& bodies, const std::vector<Integrand>& integrands,
  vtkTable* faces, const std::vector<int>& wanted)
{
  vtkNew<vtkIntArray> solid;
  vtkNew<vtkIntArray> index;
  vtkNew<vtkIntArray> id;
  vtkNew<vtkIntArray> estimated;
  solid->SetName(names::Solid);
  index->SetName(vtkNURBSDataSet::FaceIndexArrayName());
  id->SetName(names::FaceId);
  estimated->SetName(names::BoundsEstimated);
  Column widest(names::MaxGap, 1);
  std::vector<Column> values;
  for (const int k : wanted)
  {
    values.emplace_back(integrands[k].Name, 1);
    values.emplace_back(integrands[k].Name + names::BoundSuffix, 1);
  }
  for (std::size_t row = 0; row < bodies.size(); ++row)
  {
    const std::vector<FacePointer>& sources = bodies[row].Model->GetFaces();
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      solid->InsertNextValue(static_cast<int>(row));
      index->InsertNextValue(static_cast<int>(i));
      id->InsertNextValue(sources[i]->FileId);
      const FaceIntegrals* result = bodies[row].Faces ? &(*bodies[row].Faces)[i] : nullptr;
      const bool known = result && result->Error.empty();
      estimated->InsertNextValue(known && result->Estimated ? 1 : 0);
      const double gap = known && !result->Skipped ? result->MaxGap : vtkMath::Nan();
      widest.Append(&gap);
      for (std::size_t column = 0; column < wanted.size(); ++column)
      {
        const int k = wanted[column];
        const double bodySign = bodies[row].InsideOut ? -1.0 : 1.0;
        const double side = integrands[k].ClosedChain ? bodySign * bodies[row].GetSide(i) : 1.0;
        const double value = known ? side * (result->Face[k] + result->Closing[k]) : vtkMath::Nan();
        const double bound = known ? result->GetBound(k) : vtkMath::Nan();
        values[2 * column].Append(&value);
        values[2 * column + 1].Append(&bound);
      }
    }
  }
  faces->AddColumn(solid);
  faces->AddColumn(index);
  faces->AddColumn(id);
  for (const Column& column : values)
  {
    column.AddTo(faces->GetRowData());
  }
  widest.AddTo(faces->GetRowData());
  faces->AddColumn(estimated);
}

void AddEdgeRows(const std::vector<BodyIntegrals>& bodies, vtkTable* edges)
{
  std::vector<std::pair<int, const EdgeGap*>> rows;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    if (bodies[i].Edges)
    {
      for (const EdgeGap& edge : *bodies[i].Edges)
      {
        rows.emplace_back(static_cast<int>(i), &edge);
      }
    }
  }
  std::stable_sort(
    rows.begin(), rows.end(), [](const auto& a, const auto& b) { return IsWider(*a.second, *b.second); });
  vtkNew<vtkIntArray> solid;
  vtkNew<vtkIntArray> index;
  vtkNew<vtkIntArray> id;
  vtkNew<vtkStringArray> name;
  vtkNew<vtkIntArray> uses;
  vtkNew<vtkIntArray> open;
  solid->SetName(names::Solid);
  index->SetName(names::EdgeIndex);
  id->SetName(names::EdgeId);
  name->SetName(names::Name);
  uses->SetName(names::Uses);
  open->SetName(names::Open);
  Column widest(names::MaxGap, 1);
  Column area(names::GapArea, 1);
  Column squared(names::GapSquared, 1);
  for (const auto& [row, edge] : rows)
  {
    solid->InsertNextValue(row);
    index->InsertNextValue(edge->Index);
    id->InsertNextValue(edge->Source->FileId);
    name->InsertNextValue(edge->Source->Name);
    uses->InsertNextValue(edge->Uses);
    open->InsertNextValue(edge->IsOpen() ? 1 : 0);
    widest.Append(&edge->MaxGap);
    area.Append(&edge->GapArea);
    squared.Append(&edge->GapSquared);
  }
  edges->AddColumn(solid);
  edges->AddColumn(index);
  edges->AddColumn(id);
  edges->AddColumn(name);
  edges->AddColumn(uses);
  edges->AddColumn(open);
  widest.AddTo(edges->GetRowData());
  area.AddTo(edges->GetRowData());
  squared.AddTo(edges->GetRowData());
}
}
}
