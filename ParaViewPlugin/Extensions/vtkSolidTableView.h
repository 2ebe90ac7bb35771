/**
 * @class   vtkSolidTableView
 * @brief   ParaView's spreadsheet view with the columns of this project's tables in an order of their own
 *
 * vtkSpreadSheetView sorts columns by name, so that Name and Volume of a solid come after a hundred others.
 * This class shows and exports the tables of Mass Properties with its parts list, Surface Integral, Buoyancy
 * and Static Stability in this order: the row's number; Name, Path, Id, Status; the main results, such as
 * Volume, Mass, SurfaceArea, CenterOfMass; integrals by the names that the user gave them; units, tensors and
 * gaps; each followed by its bound. The magnitudes that the view adds to centres, tensors and axes have no
 * meaning and are left out. Numbers are shown and exported with all their digits. Any other table is shown as
 * ParaView does. A table of this project has the columns Name, Id and Status, Name, Level and CountInAll, or
 * Solid with FaceId, EdgeId or StabilityMargin.
 *
 * The plugin registers it as the class of the view SpreadSheetView.
 */
#ifndef vtkSolidTableView_h
#define vtkSolidTableView_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSmartPointer.h"            // for the blocks
#include "vtkSpreadSheetView.h"

#include <map>    // for the blocks
#include <string> // for the columns
#include <vector> // for the columns

class SMPARAVIEWEXTENSIONS_EXPORT vtkSolidTableView : public vtkSpreadSheetView
{
public:
  static vtkSolidTableView* New();
  vtkTypeMacro(vtkSolidTableView, vtkSpreadSheetView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Returns 0 while the first block of a table with other columns is fetched. ParaView 5.11 then queries the
   * number of columns within a reset of its model, and would fit the widths of columns that its header does
   * not have yet; with 0 it fits them afterwards, to their contents.
   */
  vtkIdType GetNumberOfColumns() override;
  const char* GetColumnName(vtkIdType index) override;
  using Superclass::GetColumnLabel;
  /** The name with its unit, "Volume (mm^3)", in a table of this project with a column LengthUnit. */
  std::string GetColumnLabel(const char* columnName) override;
  using Superclass::IsColumnInternal;
  bool IsColumnInternal(vtkIdType index) override;
  bool IsColumnInternal(const char* columnName) override;

protected:
  vtkSolidTableView();
  ~vtkSolidTableView() override;

  vtkTable* FetchBlock(vtkIdType blockindex) override;

private:
  vtkSolidTableView(const vtkSolidTableView&) = delete;
  void operator=(const vtkSolidTableView&) = delete;

  /// A block of rows as the superclass returns it and with its columns in order.
  struct Block
  {
    vtkSmartPointer<vtkTable> Sorted;
    vtkSmartPointer<vtkTable> Shown;
  };

  /// Sets SortedColumns and ShownColumns.
  void Arrange(const std::vector<std::string>& sorted);

  bool IsFetching = false;
  /// Columns of the last block, in the order of the superclass.
  std::vector<std::string> KnownColumns;
  /// Columns of the last table of this project, in the order of the superclass, and in the order in which
  /// they are shown.
  std::vector<std::string> SortedColumns;
  std::vector<std::string> ShownColumns;
  std::map<vtkIdType, Block> Blocks;
};

#endif
