#include "smSphereMesh.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>

namespace sm
{
vtkSmartPointer<vtkPolyData> MakeSphereMesh(
  const double center[3], double radius, int meridians, int parallels)
{
  // Both poles are parallels, and no points of meridians.
  const int inner = parallels - 2;
  vtkNew<vtkDoubleArray> points;
  vtkNew<vtkFloatArray> normals;
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(points), static_cast<vtkDataArray*>(normals) })
  {
    array->SetNumberOfComponents(3);
    array->Allocate(3 * (2 + static_cast<vtkIdType>(meridians) * inner));
  }
  normals->SetName("Normals");
  for (const double side : { 1.0, -1.0 })
  {
    points->InsertNextTuple3(center[0], center[1], center[2] + side * radius);
    normals->InsertNextTuple3(0.0, 0.0, side);
  }
  const double thetaStep = vtkMath::RadiansFromDegrees(360.0) / meridians;
  const double phiStep = vtkMath::RadiansFromDegrees(180.0) / (parallels - 1);
  for (int i = 0; i < meridians; ++i)
  {
    const double theta = i * thetaStep;
    for (int j = 1; j <= inner; ++j)
    {
      const double phi = j * phiStep;
      const double distance = radius * std::sin(phi);
      const double n[3] = { distance * std::cos(theta), distance * std::sin(theta), radius * std::cos(phi) };
      points->InsertNextTuple3(n[0] + center[0], n[1] + center[1], n[2] + center[2]);
      const double length = vtkMath::Norm(n);
      normals->InsertNextTuple3(n[0] / length, n[1] / length, n[2] / length);
    }
  }
  vtkNew<vtkCellArray> triangles;
  const auto add = [&triangles](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const vtkIdType corners[3] = { a, b, c };
    triangles->InsertNextCell(3, corners);
  };
  const auto getPoint = [inner, meridians](int i, int j) -> vtkIdType
  { return 2 + static_cast<vtkIdType>(i % meridians) * inner + j; };
  for (int i = 0; i < meridians; ++i)
  {
    add(getPoint(i, 0), getPoint(i + 1, 0), 0);
  }
  for (int i = 0; i < meridians; ++i)
  {
    add(getPoint(i, inner - 1), 1, getPoint(i + 1, inner - 1));
  }
  for (int i = 0; i < meridians; ++i)
  {
    for (int j = 0; j + 1 < inner; ++j)
    {
      add(getPoint(i, j), getPoint(i, j + 1), getPoint(i + 1, j + 1));
      add(getPoint(i, j), getPoint(i + 1, j + 1), getPoint(i + 1, j));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> positions;
  positions->SetData(points);
  mesh->SetPoints(positions);
  mesh->SetPolys(triangles);
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}
}
