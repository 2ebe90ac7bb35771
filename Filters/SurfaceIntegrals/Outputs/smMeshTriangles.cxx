#include "smMeshTriangles.h"

#include "smVector.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

#include <cstdint>
#include <utility>

namespace sm
{
namespace
{
/// The scale mesh of an instance of a model; null without one.
vtkPolyData* FindScaleMesh(vtkNURBSDataSet* instance)
{
  vtkTrimmedNURBSModel* model = instance ? instance->GetModel() : nullptr;
  return model ? model->GetScaleMesh() : nullptr;
}

/// Visits triangles whose points, normals and faces `getPoint`, `getNormal` and `getFace` return by the ids
/// of points and cells.
template <class GetPoint, class GetNormal, class GetFace>
void VisitCells(vtkPolyData* mesh, std::size_t faces, const TriangleVisitor& visit, const GetPoint& getPoint,
  const GetNormal& getNormal, const GetFace& getFace)
{
  // In the cell data of a polydata, polygons follow vertices and lines.
  vtkIdType cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    const auto face = static_cast<std::int64_t>(getFace(cell));
    if (face < 0 || face >= static_cast<std::int64_t>(faces))
    {
      continue;
    }
    for (vtkIdType i = 2; i < size; ++i)
    {
      visit(static_cast<std::size_t>(face), { getPoint(ids[0]), getPoint(ids[i - 1]), getPoint(ids[i]) },
        { getNormal(ids[0]), getNormal(ids[i - 1]), getNormal(ids[i]) });
    }
  }
}

/// Returns the values of an array of these types; null for another array.
template <class Value, class Array>
const Value* GetValues(vtkDataArray* array)
{
  Array* typed = Array::SafeDownCast(array);
  return typed ? typed->GetPointer(0) : nullptr;
}
}

void VisitShownTriangles(vtkPolyData* mesh, std::size_t faces, const TriangleVisitor& visit)
{
  vtkDataArray* faceOfCell =
    mesh ? mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName()) : nullptr;
  if (!faceOfCell || !mesh->GetPolys() || faceOfCell->GetNumberOfTuples() != mesh->GetNumberOfCells())
  {
    return;
  }
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  // The arrays of our own meshes are read directly.
  const auto* const points = GetValues<double, vtkDoubleArray>(mesh->GetPoints()->GetData());
  const auto* const directions = GetValues<float, vtkFloatArray>(normals);
  const auto* const indices = GetValues<int, vtkIntArray>(faceOfCell);
  if (points && directions && indices)
  {
    VisitCells(
      mesh, faces, visit,
      [points](vtkIdType id) {
        return Point3{ points[3 * id], points[3 * id + 1], points[3 * id + 2] };
      },
      [directions](vtkIdType id) {
        return Point3{ directions[3 * id], directions[3 * id + 1], directions[3 * id + 2] };
      },
      [indices](vtkIdType cell) { return indices[cell]; });
    return;
  }
  VisitCells(
    mesh, faces, visit,
    [mesh](vtkIdType id)
    {
      Point3 p;
      mesh->GetPoints()->GetPoint(id, p.data());
      return p;
    },
    [normals](vtkIdType id)
    {
      // Without normals the triangles are assumed to be flat.
      Point3 n{ 0.0, 0.0, 0.0 };
      if (normals)
      {
        normals->GetTuple(id, n.data());
      }
      return n;
    },
    [faceOfCell](vtkIdType cell) { return faceOfCell->GetComponent(cell, 0); });
}

void VisitTriangles(vtkPolyData* instance, std::size_t faces, const TriangleVisitor& visit)
{
  auto* leaf = vtkNURBSDataSet::SafeDownCast(instance);
  vtkPolyData* mesh = FindScaleMesh(leaf);
  if (!mesh)
  {
    VisitShownTriangles(instance, faces, visit);
    return;
  }
  const double* const m = leaf->GetPlacementData();
  const bool isMirrored = vtkMatrix4x4::Determinant(m) < 0.0;
  const auto place = [m](Point3& p, double translation)
  {
    const Point3 from = p;
    for (int r = 0; r < 3; ++r)
    {
      p[r] =
        m[4 * r] * from[0] + m[4 * r + 1] * from[1] + m[4 * r + 2] * from[2] + translation * m[4 * r + 3];
    }
  };
  VisitShownTriangles(mesh, faces,
    [&](std::size_t face, std::array<Point3, 3> corners, std::array<Point3, 3> normals)
    {
      for (int i = 0; i < 3; ++i)
      {
        place(corners[i], 1.0);
        place(normals[i], 0.0);
      }
      if (isMirrored)
      {
        std::swap(corners[1], corners[2]);
        std::swap(normals[1], normals[2]);
      }
      visit(face, corners, normals);
    });
}

std::size_t CountTriangles(vtkPolyData* instance)
{
  vtkPolyData* const scale = FindScaleMesh(vtkNURBSDataSet::SafeDownCast(instance));
  vtkPolyData* const mesh = scale ? scale : instance;
  return mesh ? static_cast<std::size_t>(mesh->GetNumberOfPolys()) : 0;
}
}
