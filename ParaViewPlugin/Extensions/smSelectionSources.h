/**
 * @file smSelectionSources.h
 * @brief Reads and makes ParaView's selections of rows, solids and faces of a filter
 *
 * Solids are partitioned datasets of a collection, in its order and numbered from 0; each has one partition.
 */
#ifndef smSelectionSources_h
#define smSelectionSources_h

#include "smSelectionTerms.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <optional>
#include <set>
#include <vector>

class vtkPVDataInformation;
class vtkSMSessionProxyManager;
class vtkSMSourceProxy;

namespace sm
{
///@{
/// Return the terms of a selection of a table or of meshes; for null those of an empty selection. There is no
/// value for a selection other than by row indices, cells or blocks, such as one by a frustum or a query,
/// whose result is not known on the client. `data` is the information of the meshes.
std::optional<SelectionTerms> ReadRowSelection(vtkSMSourceProxy* selection);
std::optional<SelectionTerms> ReadMeshSelection(vtkSMSourceProxy* selection, vtkPVDataInformation* data);
///@}

vtkSmartPointer<vtkSMSourceProxy> MakeRowSelection(
  vtkSMSessionProxyManager* manager, const std::vector<vtkIdType>& rows);
/// Makes a selection of whole solids, and of single cells of others, like clicks in a view.
vtkSmartPointer<vtkSMSourceProxy> MakeMeshSelection(vtkSMSessionProxyManager* manager,
  const std::set<vtkIdType>& solids, const std::map<vtkIdType, std::vector<vtkIdType>>& cells);
}

#endif
