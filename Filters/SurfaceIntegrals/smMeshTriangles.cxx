#include "smMeshTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNURBSDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>

namespace sm
{
void VisitTriangles(vtkPolyData* mesh, std::size_t faces, const TriangleVisitor& visit)
{
  using Point = std::array<double, 3>;
  vtkDataArray* faceOfCell =
    mesh ? mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName()) : nullptr;
  if (!faceOfCell || !mesh->GetPolys() || faceOfCell->GetNumberOfTuples() != mesh->GetNumberOfCells())
  {
    return;
  }
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  const auto corner = [mesh](vtkIdType id)
  {
    Point p;
    mesh->GetPoints()->GetPoint(id, p.data());
    return p;
  };
  const auto normal = [normals](vtkIdType id)
  {
    // Without normals the triangles are assumed to be flat.
    Point n{ 0.0, 0.0, 0.0 };
    if (normals)
    {
      normals->GetTuple(id, n.data());
    }
    return n;
  };
  // In the cell data of a polydata, polygons follow vertices and lines.
  vtkIdType cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    const auto face = static_cast<std::int64_t>(faceOfCell->GetComponent(cell, 0));
    if (face < 0 || face >= static_cast<std::int64_t>(faces))
    {
      continue;
    }
    for (vtkIdType i = 2; i < size; ++i)
    {
      visit(static_cast<std::size_t>(face), { corner(ids[0]), corner(ids[i - 1]), corner(ids[i]) },
        { normal(ids[0]), normal(ids[i - 1]), normal(ids[i]) });
    }
  }
}
}
