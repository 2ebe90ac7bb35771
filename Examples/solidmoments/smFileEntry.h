/**
 * @file smFileEntry.h
 * @brief The entry of a file in the JSON document, from the outputs of vtkMassPropertiesGPU
 */
#ifndef smFileEntry_h
#define smFileEntry_h

#include "smJson.h"

#include <string>

class vtkDataObject;
class vtkFieldData;
class vtkTable;

namespace sm
{
/// Returns the quantities of all solids together, from the field data of port 0.
Json GetTotal(vtkFieldData* fields);
/// Returns an entry for every row of port 1; `edges` is port 4.
Json GetSolids(vtkTable* table, vtkTable* edges);
/// Returns the diagonal of the bounding box of all display meshes; null if there are none.
Json GetDiagonal(vtkDataObject* input);
/// Returns the entry of a file before it is read: it has every key, and all values are null.
Json MakeEmptyFile(const std::string& fileName);
}

#endif
