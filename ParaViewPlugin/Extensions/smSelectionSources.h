/**
 * @file smSelectionSources.h
 * @brief Reads and makes ParaView's selections of rows, solids and faces of a filter
 *
 * Solids are partitioned datasets of a collection, in its order and numbered from 0; each has one partition.
 */
#ifndef smSelectionSources_h
#define smSelectionSources_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <set>
#include <utility>
#include <vector>

class vtkDataAssembly;
class vtkSMSessionProxyManager;
class vtkSMSourceProxy;

namespace sm
{
/// What is selected in a view: whole solids, and cells by the number of their solid.
struct SelectedMeshes
{
  std::set<vtkIdType> Solids;
  std::vector<std::pair<vtkIdType, vtkIdType>> Cells;
  bool IsEmpty() const { return this->Solids.empty() && this->Cells.empty(); }
};

/// The rows that a selection has by their index, as a spreadsheet makes it; none for other selections and null.
std::vector<vtkIdType> GetSelectedRows(vtkSMSourceProxy* selection);
/// The blocks and cells of a selection as a click in a view makes it; none for other selections and null. `hierarchy` names the blocks.
SelectedMeshes GetSelectedMeshes(vtkSMSourceProxy* selection, vtkDataAssembly* hierarchy);

vtkSmartPointer<vtkSMSourceProxy> MakeRowSelection(
  vtkSMSessionProxyManager* manager, const std::vector<vtkIdType>& rows);
vtkSmartPointer<vtkSMSourceProxy> MakeSolidSelection(
  vtkSMSessionProxyManager* manager, const std::set<vtkIdType>& solids);
/// Cells by the number of their solid, as a click in a view selects them. One condition per solid instead makes ParaView's extraction take
/// time with the cube of their number.
vtkSmartPointer<vtkSMSourceProxy> MakeCellSelection(
  vtkSMSessionProxyManager* manager, const std::vector<std::pair<vtkIdType, vtkIdType>>& cells);
}

#endif
