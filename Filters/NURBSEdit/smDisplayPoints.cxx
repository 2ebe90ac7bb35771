#include "Detail/smDisplayPoints.h"

#include "smParallelFor.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkNURBSPointEvaluator.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTrimmedNURBSModel.h"

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

/// Gives `edited` the scale mesh of `before`, with its points moved to the faces of `edited`.
bool MoveScaleMesh(
  vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* edited, vtkNURBSPointEvaluator* evaluator)
{
  vtkNew<vtkNURBSDataSet> mesh;
  mesh->ShallowCopy(before->GetScaleMesh());
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
