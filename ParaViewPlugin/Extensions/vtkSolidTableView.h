/**
 * @class   vtkSolidTableView
 * @brief   ParaView's spreadsheet view, with the columns of this project's tables in their own order
 *
 * vtkSpreadSheetView sorts columns by name, so that Name and Volume of a solid stand behind a hundred others. Here the tables of the
 * mass filters, of Surface Integral and Solid Stability are shown and exported thus: the row's number; Name, Id, Status; Volume, Mass,
 * SurfaceArea, CenterOfMass; integrals by the names that the user gave them; units, tensors and gaps; each followed by its bound. The
 * magnitudes that the view adds to centres, tensors and axes, which mean nothing, are left out. Any other table is shown as ParaView
 * does. A table is known by its columns: Name, Id and Status; or Solid with FaceId, EdgeId or StabilityMargin.
 *
 * The plugin puts it in the place of the class of the view SpreadSheetView.
 */
#ifndef vtkSolidTableView_h
#define vtkSolidTableView_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSpreadSheetView.h"

#include <memory> // for the order

class SMPARAVIEWEXTENSIONS_EXPORT vtkSolidTableView : public vtkSpreadSheetView
{
public:
  static vtkSolidTableView* New();
  vtkTypeMacro(vtkSolidTableView, vtkSpreadSheetView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetColumnName(vtkIdType index) override;
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

  struct Order;
  std::unique_ptr<Order> Columns;
};

#endif
