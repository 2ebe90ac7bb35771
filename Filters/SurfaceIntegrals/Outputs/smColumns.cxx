#include "smColumns.h"

#include "smIntegralNames.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkMath.h"
#include "vtkNURBSDataSet.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sm
{
namespace columns
{
Writer::Writer(KeptArrays& arrays, vtkFieldData* data, std::size_t rows, int columns)
  : Arrays(arrays)
  , Data(data)
  , Rows(static_cast<vtkIdType>(rows))
{
  // Field data has room for one array more than it holds, and moves all of them to add the next.
  data->AllocateArrays(data->GetNumberOfArrays() + columns);
}

void Writer::AddArray(vtkAbstractArray* array)
{
  this->Data->AddArray(array);
}

double* Writer::AddDoubles(const std::string& name, int components)
{
  return this->Add<vtkDoubleArray>(name, components);
}

int* Writer::AddIntegers(const std::string& name)
{
  return this->Add<vtkIntArray>(name);
}

vtkTypeInt64* Writer::AddEntityNumbers(const std::string& name)
{
  return this->Add<vtkTypeInt64Array>(name);
}

vtkStdString* Writer::AddStrings(const std::string& name)
{
  return this->Add<vtkStringArray>(name);
}

void Writer::SetInteger(const std::string& name, vtkTypeInt64 value)
{
  *this->Add<vtkLongLongArray>(name) = value;
}

void Writer::SetString(const std::string& name, const std::string& value)
{
  *this->AddStrings(name) = value;
}

void AddBodyLabels(KeptArrays& arrays, const std::vector<BodyIntegrals>& bodies, vtkTable* solids)
{
  Writer writer(arrays, solids->GetRowData(), bodies.size());
  vtkStdString* name = writer.AddStrings(names::Name);
  vtkStdString* path = writer.AddStrings(names::Path);
  vtkStdString* id = writer.AddStrings(names::Id);
  vtkStdString* status = writer.AddStrings(names::Status);
  for (const BodyIntegrals& body : bodies)
  {
    *name++ = body.Name;
    *path++ = body.Path;
    *id++ = body.Id;
    *status++ = GetText(body.Status);
  }
}

void AddBodyCounts(KeptArrays& arrays, const std::vector<BodyIntegrals>& bodies, vtkTable* solids)
{
  Writer writer(arrays, solids->GetRowData(), bodies.size());
  vtkStdString* unit = writer.AddStrings(names::LengthUnit);
  int* open = writer.AddIntegers(names::OpenEdges);
  int* flipped = writer.AddIntegers(names::FlippedShells);
  int* estimated = writer.AddIntegers(names::BoundsEstimated);
  int* faces = writer.AddIntegers(names::Faces);
  for (const BodyIntegrals& body : bodies)
  {
    *unit++ = body.Model->GetLengthUnit();
    *open++ = body.OpenEdges;
    *flipped++ = body.FlippedShells;
    *estimated++ = body.IsEstimated() ? 1 : 0;
    *faces++ = static_cast<int>(body.Model->GetNumberOfFaces());
  }
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

void AddFaceRows(KeptArrays& arrays, const std::vector<BodyIntegrals>& bodies,
  const std::vector<Integrand>& integrands, vtkTable* faces, const std::vector<int>& wanted)
{
  std::size_t rows = 0;
  for (const BodyIntegrals& body : bodies)
  {
    rows += body.Model->GetFaces().size();
  }
  Writer writer(arrays, faces->GetRowData(), rows);
  int* solid = writer.AddIntegers(names::Solid);
  vtkStdString* name = writer.AddStrings(names::Name);
  vtkStdString* solidId = writer.AddStrings(names::Id);
  int* index = writer.AddIntegers(vtkNURBSDataSet::FaceIndexArrayName());
  vtkTypeInt64* id = writer.AddEntityNumbers(names::FaceId);
  std::vector<std::array<double*, 2>> values;
  for (const int k : wanted)
  {
    double* value = writer.AddDoubles(integrands[k].Name);
    values.push_back({ value, writer.AddDoubles(integrands[k].Name + names::BoundSuffix) });
  }
  double* widest = writer.AddDoubles(names::MaxGap);
  int* estimated = writer.AddIntegers(names::BoundsEstimated);
  vtkStdString* unit = writer.AddStrings(names::LengthUnit);
  for (std::size_t body = 0; body < bodies.size(); ++body)
  {
    const double bodySign = bodies[body].InsideOut ? -1.0 : 1.0;
    const std::vector<FacePointer>& sources = bodies[body].Model->GetFaces();
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      *solid++ = static_cast<int>(body);
      *name++ = bodies[body].Name;
      *solidId++ = bodies[body].Id;
      *unit++ = bodies[body].Model->GetLengthUnit();
      *index++ = static_cast<int>(i);
      *id++ = sources[i]->FileId;
      const FaceIntegrals* result = bodies[body].Faces ? &(*bodies[body].Faces)[i] : nullptr;
      const bool known = result && result->Error.empty();
      *estimated++ = known && result->Estimated ? 1 : 0;
      *widest++ = known && !result->Skipped ? result->MaxGap : vtkMath::Nan();
      for (std::size_t column = 0; column < wanted.size(); ++column)
      {
        const int k = wanted[column];
        const double side = integrands[k].ClosedChain ? bodySign * bodies[body].GetSide(i) : 1.0;
        *values[column][0]++ = known ? side * (result->Face[k] + result->Closing[k]) : vtkMath::Nan();
        *values[column][1]++ = known ? result->GetBound(k) : vtkMath::Nan();
      }
    }
  }
}

void AddEdgeRows(KeptArrays& arrays, const std::vector<BodyIntegrals>& bodies, vtkTable* edges)
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
  Writer writer(arrays, edges->GetRowData(), rows.size());
  int* solid = writer.AddIntegers(names::Solid);
  vtkStdString* solidId = writer.AddStrings(names::Id);
  int* index = writer.AddIntegers(names::EdgeIndex);
  vtkTypeInt64* id = writer.AddEntityNumbers(names::EdgeId);
  vtkStdString* name = writer.AddStrings(names::Name);
  int* uses = writer.AddIntegers(names::Uses);
  int* open = writer.AddIntegers(names::Open);
  double* widest = writer.AddDoubles(names::MaxGap);
  double* area = writer.AddDoubles(names::GapArea);
  double* squared = writer.AddDoubles(names::GapSquared);
  double* spread = writer.AddDoubles(names::ClosureSpread);
  vtkStdString* unit = writer.AddStrings(names::LengthUnit);
  for (const auto& [body, edge] : rows)
  {
    *solid++ = body;
    *solidId++ = bodies[static_cast<std::size_t>(body)].Id;
    *unit++ = bodies[static_cast<std::size_t>(body)].Model->GetLengthUnit();
    *index++ = edge->Index;
    *id++ = edge->Source->FileId;
    *name++ = edge->Source->Name;
    *uses++ = edge->Uses;
    *open++ = edge->IsOpen() ? 1 : 0;
    *widest++ = edge->MaxGap;
    *area++ = edge->GapArea;
    *squared++ = edge->GapSquared;
    *spread++ = edge->Spread;
  }
}
}
}
