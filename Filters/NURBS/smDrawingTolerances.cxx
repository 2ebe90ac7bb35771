#include "smDrawingTolerances.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <charconv>
#include <initializer_list>
#include <sstream>
#include <system_error>
#include <utility>

namespace sm
{
namespace
{
constexpr const char* AllFaces = "all";

std::string FormatFaces(const DrawingTolerance& tolerance)
{
  std::string text = tolerance.IsForAll ? AllFaces : "";
  for (const std::int64_t face : tolerance.Faces)
  {
    text += (text.empty() ? "#" : " #") + std::to_string(face);
  }
  return text;
}

void ParseFaces(const std::string& text, DrawingTolerance& tolerance)
{
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    std::int64_t face = 0;
    const auto [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), face);
    if (word == AllFaces)
    {
      tolerance.IsForAll = true;
    }
    else if (error == std::errc() && end == word.data() + word.size())
    {
      tolerance.Faces.push_back(face);
    }
  }
}
}

void SetDrawingTolerances(vtkDataObject* data, const std::vector<DrawingTolerance>& tolerances)
{
  RemoveDrawingTolerances(data);
  if (tolerances.empty())
  {
    return;
  }
  vtkNew<vtkTypeInt64Array> ids;
  vtkNew<vtkStringArray> kinds;
  vtkNew<vtkStringArray> faces;
  vtkNew<vtkDoubleArray> lower;
  vtkNew<vtkDoubleArray> upper;
  vtkNew<vtkStringArray> problems;
  for (const DrawingTolerance& tolerance : tolerances)
  {
    ids->InsertNextValue(tolerance.Id);
    kinds->InsertNextValue(tolerance.Kind);
    faces->InsertNextValue(FormatFaces(tolerance));
    lower->InsertNextValue(tolerance.Lower);
    upper->InsertNextValue(tolerance.Upper);
    problems->InsertNextValue(tolerance.Problem);
  }
  const std::pair<const char*, vtkAbstractArray*> columns[] = { { DrawingToleranceIdName, ids },
    { DrawingToleranceKindName, kinds }, { DrawingToleranceFacesName, faces },
    { DrawingToleranceLowerName, lower }, { DrawingToleranceUpperName, upper },
    { DrawingToleranceProblemName, problems } };
  for (const auto& [name, column] : columns)
  {
    column->SetName(name);
    data->GetFieldData()->AddArray(column);
  }
}

std::vector<DrawingTolerance> GetDrawingTolerances(vtkDataObject* data)
{
  vtkFieldData* fields = data ? data->GetFieldData() : nullptr;
  if (!fields)
  {
    return {};
  }
  auto* const ids = vtkTypeInt64Array::SafeDownCast(fields->GetAbstractArray(DrawingToleranceIdName));
  auto* const kinds = vtkStringArray::SafeDownCast(fields->GetAbstractArray(DrawingToleranceKindName));
  auto* const faces = vtkStringArray::SafeDownCast(fields->GetAbstractArray(DrawingToleranceFacesName));
  auto* const lower = vtkDoubleArray::SafeDownCast(fields->GetAbstractArray(DrawingToleranceLowerName));
  auto* const upper = vtkDoubleArray::SafeDownCast(fields->GetAbstractArray(DrawingToleranceUpperName));
  auto* const problems = vtkStringArray::SafeDownCast(fields->GetAbstractArray(DrawingToleranceProblemName));
  const vtkIdType count = ids ? ids->GetNumberOfValues() : 0;
  for (vtkAbstractArray* array :
    std::initializer_list<vtkAbstractArray*>{ kinds, faces, lower, upper, problems })
  {
    if (!array || array->GetNumberOfValues() != count)
    {
      return {};
    }
  }
  std::vector<DrawingTolerance> tolerances;
  for (vtkIdType i = 0; i < count; ++i)
  {
    DrawingTolerance tolerance;
    tolerance.Id = ids->GetValue(i);
    tolerance.Kind = kinds->GetValue(i);
    ParseFaces(faces->GetValue(i), tolerance);
    tolerance.Lower = lower->GetValue(i);
    tolerance.Upper = upper->GetValue(i);
    tolerance.Problem = problems->GetValue(i);
    tolerances.push_back(std::move(tolerance));
  }
  return tolerances;
}

void RemoveDrawingTolerances(vtkDataObject* data)
{
  for (const char* name : { DrawingToleranceIdName, DrawingToleranceKindName, DrawingToleranceFacesName,
         DrawingToleranceLowerName, DrawingToleranceUpperName, DrawingToleranceProblemName })
  {
    data->GetFieldData()->RemoveArray(name);
  }
}
}
