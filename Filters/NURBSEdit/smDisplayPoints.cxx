#include "Detail/smDisplayPoints.h"

#include "smParallelFor.h"
#include "smVector.h"
#include "smWholeSphere.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkNURBSPointEvaluator.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

#include <array>
#include <cstddef>
#include <vector>

namespace sm
{
namespace
{
void Apply(const double matrix[16], const double from[3], double to[3])
{
  for (int r = 0; r < 3; ++r)
  {
    to[r] = vtkMath::Dot(matrix + 4 * r, from) + matrix[4 * r + 3];
  }
}

void MapPoints(vtkNURBSDataSet* leaf, const double origin[3], const PointMap& map)
{
  const double* placement = leaf->GetPlacementData();
  double inverse[16];
  vtkMatrix4x4::Invert(placement, inverse);
  vtkPoints* old = leaf->GetPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(old->GetDataType());
  points->SetNumberOfPoints(old->GetNumberOfPoints());
  ParallelFor(static_cast<std::size_t>(old->GetNumberOfPoints()), 256,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto i = static_cast<vtkIdType>(begin); i < static_cast<vtkIdType>(end); ++i)
      {
        double world[3];
        double part[3];
        old->GetPoint(i, world);
        Apply(inverse, world, part);
        const std::array<double, 3> to =
          map({ part[0] - origin[0], part[1] - origin[1], part[2] - origin[2] });
        for (int c = 0; c < 3; ++c)
        {
          part[c] = to[c] + origin[c];
        }
        Apply(placement, part, world);
        points->SetPoint(i, world);
      }
    });
  leaf->SetPoints(points);
}

/// Steps around a sphere in a mesh that is as fine as those of other faces.
constexpr int FineSteps = 96;

/// Returns the spheres among the faces of `before` that are none in `edited`; empty if there are none.
std::vector<WholeSphere> FindLostSpheres(vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* edited)
{
  std::vector<WholeSphere> spheres = FindWholeSpheres(before->GetFaces());
  const std::vector<FacePointer>& faces = edited->GetFaces();
  bool isLost = false;
  for (std::size_t f = 0; f < spheres.size(); ++f)
  {
    if (f >= faces.size() || faces[f] == before->GetFaces()[f] || FindWholeSphere(*faces[f]))
    {
      spheres[f] = WholeSphere();
    }
    isLost = isLost || spheres[f];
  }
  return isLost ? spheres : std::vector<WholeSphere>();
}

/// Returns a scale mesh in which these spheres have fine grids. Whole spheres have few triangles, because
/// they are compared by formulas; an edit may make any surface of them.
vtkSmartPointer<vtkPolyData> RefineSpheres(
  vtkTrimmedNURBSModel* model, const std::vector<WholeSphere>& spheres)
{
  vtkPolyData* from = model->GetScaleMesh();
  const auto copy = [](vtkDataArray* array)
  {
    const auto result = vtk::TakeSmartPointer(array->NewInstance());
    result->DeepCopy(array);
    return result;
  };
  vtkPointData* attributes = from->GetPointData();
  const auto normals = copy(attributes->GetNormals());
  const auto faceOfPoint = copy(attributes->GetArray(vtkNURBSDataSet::FaceIndexArrayName()));
  const auto parameters = copy(attributes->GetArray(vtkNURBSDataSet::ParametersArrayName()));
  vtkDataArray* oldFaces = from->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  const auto faceOfCell = vtk::TakeSmartPointer(oldFaces->NewInstance());
  faceOfCell->SetName(oldFaces->GetName());
  vtkNew<vtkPoints> points;
  points->SetDataType(from->GetPoints()->GetDataType());
  points->DeepCopy(from->GetPoints());
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < from->GetNumberOfPolys(); ++i)
  {
    if (!spheres[static_cast<std::size_t>(oldFaces->GetComponent(i, 0))])
    {
      vtkIdType size;
      const vtkIdType* ids;
      from->GetPolys()->GetCellAtId(i, size, ids);
      cells->InsertNextCell(size, ids);
      faceOfCell->InsertNextTuple1(oldFaces->GetComponent(i, 0));
    }
  }
  const double* const origin = model->GetOrigin();
  for (std::size_t f = 0; f < spheres.size(); ++f)
  {
    const SphereGrid grid =
      spheres[f] ? MakeSphereGrid(*model->GetFaces()[f], spheres[f], FineSteps) : SphereGrid();
    const vtkIdType first = points->GetNumberOfPoints();
    for (std::size_t i = 0; i < grid.Points.size(); ++i)
    {
      const Vector3& p = grid.Points[i];
      points->InsertNextPoint(p[0] + origin[0], p[1] + origin[1], p[2] + origin[2]);
      normals->InsertNextTuple(grid.Normals[i].data());
      faceOfPoint->InsertNextTuple1(static_cast<double>(f));
      parameters->InsertNextTuple(grid.Parameters[i].data());
    }
    for (const std::array<int, 3>& t : grid.Triangles)
    {
      const vtkIdType ids[3] = { first + t[0], first + t[1], first + t[2] };
      cells->InsertNextCell(3, ids);
      faceOfCell->InsertNextTuple1(static_cast<double>(f));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->AddArray(faceOfPoint);
  mesh->GetPointData()->AddArray(parameters);
  mesh->GetCellData()->AddArray(faceOfCell);
  return mesh;
}

/// Gives `edited` the scale mesh of `before`, with its points moved to the faces of `edited`.
bool MoveScaleMesh(
  vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* edited, vtkNURBSPointEvaluator* evaluator)
{
  const std::vector<WholeSphere> lost = FindLostSpheres(before, edited);
  vtkNew<vtkNURBSDataSet> mesh;
  mesh->ShallowCopy(lost.empty() ? before->GetScaleMesh() : RefineSpheres(before, lost).Get());
  mesh->SetModel(before);
  if (!evaluator->UpdatePoints(mesh, edited))
  {
    return false;
  }
  vtkNew<vtkPolyData> moved;
  moved->ShallowCopy(mesh);
  edited->SetScaleMesh(moved);
  return true;
}
}

bool SetEditedModel(vtkNURBSDataSet* leaf, vtkTrimmedNURBSModel* edited, const PointMap& map,
  vtkNURBSPointEvaluator* evaluator, std::string& error)
{
  vtkDataArray* parameters = leaf->GetPointData()->GetArray(vtkNURBSDataSet::ParametersArrayName());
  // The scale mesh is moved even if no mesh is shown, because the checks of shells use it.
  const vtkSmartPointer<vtkTrimmedNURBSModel> before = leaf->GetModel();
  const bool hasScaleMesh =
    before && before->GetScaleMesh() && before->GetScaleMesh()->GetNumberOfPoints() > 0;
  if (hasScaleMesh && !edited->GetScaleMesh() && !MoveScaleMesh(before, edited, evaluator))
  {
    error = evaluator->GetMessage();
    return false;
  }
  const bool known = leaf->GetPointData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName()) && parameters &&
    parameters->GetNumberOfComponents() == 2;
  // The bounds of the mesh are those of the surfaces before.
  leaf->GetFieldData()->RemoveArray(vtkNURBSDataSet::MeshDeviationArrayName());
  leaf->GetFieldData()->RemoveArray(vtkNURBSDataSet::MeshAngleArrayName());
  if (known && leaf->GetPoints())
  {
    const bool done = evaluator->UpdatePoints(leaf, edited);
    error = done ? "" : evaluator->GetMessage();
    return done;
  }
  if (leaf->GetPoints())
  {
    MapPoints(leaf, edited->GetOrigin(), map);
  }
  leaf->SetModel(edited);
  return true;
}
}
