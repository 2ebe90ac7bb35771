// The sphere of the drawings is that of vtkSphereSource, to the last bit of every point, normal and corner.
#include "smSphereMesh.h"
#include "smTesting.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

namespace
{
using smtest::CheckEqual;
using smtest::CheckTrue;

/// Returns the number of values that differ; those of the longer array that the other one has not are
/// different.
vtkIdType CountDifferences(vtkDataArray* expected, vtkDataArray* actual)
{
  vtkIdType count = std::abs(expected->GetNumberOfValues() - actual->GetNumberOfValues());
  const int components = expected->GetNumberOfComponents();
  for (vtkIdType i = 0; i < std::min(expected->GetNumberOfTuples(), actual->GetNumberOfTuples()); ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      count += expected->GetComponent(i, k) != actual->GetComponent(i, k) ? 1 : 0;
    }
  }
  return count;
}

void CheckSphere(const std::string& what, const double center[3], double radius, int meridians, int parallels)
{
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetCenter(center[0], center[1], center[2]);
  source->SetRadius(radius);
  source->SetThetaResolution(meridians);
  source->SetPhiResolution(parallels);
  source->Update();
  vtkPolyData* expected = source->GetOutput();
  const vtkSmartPointer<vtkPolyData> actual = sm::MakeSphereMesh(center, radius, meridians, parallels);
  CheckTrue(what + ": points", expected->GetNumberOfPoints() == 2 + meridians * (parallels - 2));
  CheckEqual(what + ": points that differ", 0,
    static_cast<int>(CountDifferences(expected->GetPoints()->GetData(), actual->GetPoints()->GetData())));
  CheckEqual(
    what + ": type of the points", expected->GetPoints()->GetDataType(), actual->GetPoints()->GetDataType());
  vtkDataArray* normals = expected->GetPointData()->GetNormals();
  CheckEqual(what + ": normals that differ", 0,
    static_cast<int>(CountDifferences(normals, actual->GetPointData()->GetNormals())));
  CheckEqual(what + ": name of the normals", std::string(normals->GetName()),
    actual->GetPointData()->GetNormals()->GetName());
  CheckEqual(what + ": type of the normals", normals->GetDataType(),
    actual->GetPointData()->GetNormals()->GetDataType());
  CheckEqual(what + ": corners that differ", 0,
    static_cast<int>(CountDifferences(
      expected->GetPolys()->GetConnectivityArray(), actual->GetPolys()->GetConnectivityArray())));
  CheckEqual(what + ": cells", static_cast<int>(expected->GetNumberOfCells()),
    static_cast<int>(actual->GetNumberOfCells()));
}
}

int TestSphereMesh(int, char*[])
{
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double far[3] = { 1e5, -3.3, 0.7 };
  CheckSphere("the glyph of a centre of mass", origin, 1.0, 32, 24);
  CheckSphere("a small sphere far away", far, 0.013, 24, 16);
  CheckSphere("the fewest points", far, 2.0, 3, 3);
  return smtest::Finish();
}
