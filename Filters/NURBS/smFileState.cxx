#include "smFileState.h"

#include "smDrawingTolerances.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace sm
{
namespace
{
void SetStrings(vtkFieldData* fields, const char* name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  fields->AddArray(array);
}

std::vector<std::string> GetStrings(vtkFieldData* fields, const char* name)
{
  std::vector<std::string> values;
  auto* array = fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray(name)) : nullptr;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    values.push_back(array->GetValue(i));
  }
  return values;
}

std::string GetFirst(const std::vector<std::string>& values)
{
  return values.empty() ? std::string() : values.front();
}
}

void SetFileState(vtkDataObject* data, const FileState& state)
{
  vtkFieldData* fields = data->GetFieldData();
  SetStrings(fields, FileStatusArrayName, { state.Status });
  SetStrings(fields, FileProblemArrayName, { state.Problem });
  SetStrings(fields, FileDefectsArrayName, state.Defects);
  SetStrings(fields, FileNotesArrayName, state.Notes);
}

FileState GetFileState(vtkDataObject* data)
{
  vtkFieldData* fields = data ? data->GetFieldData() : nullptr;
  FileState state;
  state.Status = GetFirst(GetStrings(fields, FileStatusArrayName));
  state.Problem = GetFirst(GetStrings(fields, FileProblemArrayName));
  state.Defects = GetStrings(fields, FileDefectsArrayName);
  state.Notes = GetStrings(fields, FileNotesArrayName);
  return state;
}

void RemoveFileState(vtkDataObject* data)
{
  for (const char* name :
    { FileStatusArrayName, FileProblemArrayName, FileDefectsArrayName, FileNotesArrayName })
  {
    data->GetFieldData()->RemoveArray(name);
  }
  RemoveDrawingTolerances(data);
}
}
