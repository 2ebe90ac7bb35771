/**
 * @file smTableCells.h
 * @brief Cells of a table by the name of their column
 *
 * A table may be null, and may lack the column or the row.
 */
#ifndef smTableCells_h
#define smTableCells_h

#include "vtkType.h"

#include <string>

class vtkTable;

namespace sm
{
/// Returns a number; NaN if there is none.
double GetNumber(vtkTable* table, const std::string& column, vtkIdType row);
/// Returns a whole number, such as that of a solid; -1 if there is none.
vtkIdType GetIndex(vtkTable* table, const std::string& column, vtkIdType row);
/// Returns a text; empty if there is none.
std::string GetText(vtkTable* table, const std::string& column, vtkIdType row);
vtkIdType CountRows(vtkTable* table);
}

#endif
