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
/// The terms of a selection of a table or of meshes; those of an empty one for null. Nothing for a selection that names neither rows by
/// index, nor cells, nor blocks, such as one by a frustum or a query: what it selects is not known on the client. `data` is of the meshes.
std::optional<SelectionTerms> ReadRowSelection(vtkSMSourceProxy* selection);
std::optional<SelectionTerms> ReadMeshSelection(vtkSMSourceProxy* selection, vtkPVDataInformation* data);
///@}

vtkSmartPointer<vtkSMSourceProxy> MakeRowSelection(
  vtkSMSessionProxyManager* manager, const std::vector<vtkIdType>& rows);
/// Whole solids and single cells of others, as clicks in a view select them.
vtkSmartPointer<vtkSMSourceProxy> MakeMeshSelection(vtkSMSessionProxyManager* manager,
  const std::set<vtkIdType>& solids, const std::map<vtkIdType, std::vector<vtkIdType>>& cells);
}

#endif
