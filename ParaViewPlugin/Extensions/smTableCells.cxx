#include "smTableCells.h"

#include "vtkDataArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <cmath>

namespace sm
{
namespace
{
template <typename Array>
Array* FindColumn(vtkTable* table, const std::string& column, vtkIdType row)
{
  auto* array = table ? Array::SafeDownCast(table->GetColumnByName(column.c_str())) : nullptr;
  return array && row >= 0 && row < array->GetNumberOfTuples() ? array : nullptr;
}
}

double GetNumber(vtkTable* table, const std::string& column, vtkIdType row)
{
  auto* numbers = FindColumn<vtkDataArray>(table, column, row);
  return numbers ? numbers->GetComponent(row, 0) : std::nan("");
}

vtkIdType GetIndex(vtkTable* table, const std::string& column, vtkIdType row)
{
  // A double does not hold all entity numbers.
  if (auto* numbers = FindColumn<vtkTypeInt64Array>(table, column, row))
  {
    return static_cast<vtkIdType>(numbers->GetValue(row));
  }
  const double number = GetNumber(table, column, row);
  return std::isfinite(number) ? static_cast<vtkIdType>(number) : -1;
}

std::string GetText(vtkTable* table, const std::string& column, vtkIdType row)
{
  auto* texts = FindColumn<vtkStringArray>(table, column, row);
  return texts ? std::string(texts->GetValue(row)) : std::string();
}

vtkIdType CountRows(vtkTable* table)
{
  return table ? table->GetNumberOfRows() : 0;
}
}
