/**
 * @file smQuantities.h
 * @brief What vtkMassPropertiesGPU puts out, as JSON
 *
 * `data` is the field data of port 0 (row 0) or the columns of a table. Null stands for what is missing or not a number.
 */
#ifndef smQuantities_h
#define smQuantities_h

#include "smJson.h"

#include "vtkType.h"

#include <string>

class vtkFieldData;

namespace sm
{
Json GetNumber(vtkFieldData* data, vtkIdType row, const std::string& name);
/// Three numbers; null unless all are.
Json GetPoint(vtkFieldData* data, vtkIdType row, const std::string& name);
/// A number without a fraction.
Json GetCount(vtkFieldData* data, vtkIdType row, const std::string& name);
/// Empty when it is missing.
std::string GetText(vtkFieldData* data, vtkIdType row, const char* name);

/// The quantities of the whole (field data of port 0) or of one solid (a row of port 1), with the keys of "total" (DESIGN 6).
Json GetQuantities(vtkFieldData* data, vtkIdType row);
}

#endif
