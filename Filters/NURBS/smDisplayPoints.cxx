#include "smDisplayPoints.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// The rows of a leaf's placement about the model's origin.
struct Frame
{
  double Rows[3][4];
  double Inverse[3][4];

  explicit Frame(vtkNURBSDataSet* leaf, vtkTrimmedNURBSModel* model)
  {
    vtkNew<vtkMatrix4x4> placement;
    leaf->GetPlacement(placement);
    vtkNew<vtkMatrix4x4> inverse;
    vtkMatrix4x4::Invert(placement, inverse);
    const double* origin = model->GetOrigin();
    for (int r = 0; r < 3; ++r)
    {
      std::copy_n(placement->GetData() + 4 * r, 4, this->Rows[r]);
      std::copy_n(inverse->GetData() + 4 * r, 4, this->Inverse[r]);
      this->Rows[r][3] += vtkMath::Dot(this->Rows[r], origin);
      this->Inverse[r][3] -= origin[r];
    }
  }

  static void Apply(const double rows[3][4], const double from[3], double weight, double to[3])
  {
    for (int r = 0; r < 3; ++r)
    {
      to[r] = vtkMath::Dot(rows[r], from) + weight * rows[r][3];
    }
  }
};

void EvaluatePoint(const Face& face, const double uv[2], const Frame& frame, vtkPoints* points,
  vtkDataArray* normals, vtkIdType id)
{
  double position[3];
  double du[3];
  double dv[3];
  face.Surface.Evaluate(uv[0], uv[1], position, du, dv);
  double moved[3];
  Frame::Apply(frame.Rows, position, 1.0, moved);
  points->SetPoint(id, moved);
  double normal[3];
  vtkMath::Cross(du, dv, normal);
  const double length = vtkMath::Norm(normal);
  // At a pole there is none; the one from before will do for a picture.
  if (normals && length > 0.0)
  {
    vtkMath::MultiplyScalar(normal, (face.Reversed ? -1.0 : 1.0) / length);
    Frame::Apply(frame.Rows, normal, 0.0, moved);
    normals->SetTuple(id, moved);
  }
}
}

void SetEditedModel(
  vtkNURBSDataSet* leaf, vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* after, const PointMap& map)
{
  vtkPoints* old = leaf->GetPoints();
  if (!old)
  {
    leaf->SetModel(after);
    return;
  }
  const Frame frame(leaf, before);
  vtkNew<vtkPoints> points;
  points->SetDataType(old->GetDataType());
  points->DeepCopy(old);
  vtkSmartPointer<vtkDataArray> normals;
  if (vtkDataArray* oldNormals = leaf->GetPointData()->GetNormals())
  {
    normals.TakeReference(oldNormals->NewInstance());
    normals->DeepCopy(oldNormals);
  }
  vtkDataArray* faceIndex = leaf->GetPointData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  vtkDataArray* parameters = leaf->GetPointData()->GetArray(vtkNURBSDataSet::ParametersArrayName());
  const std::vector<FacePointer>& was = before->GetFaces();
  const std::vector<FacePointer>& is = after->GetFaces();
  const bool known = faceIndex && parameters && parameters->GetNumberOfComponents() == 2;
  vtkSMPTools::For(0, old->GetNumberOfPoints(), 256,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (!known)
        {
          double world[3];
          double stored[3];
          old->GetPoint(i, world);
          Frame::Apply(frame.Inverse, world, 1.0, stored);
          const std::array<double, 3> to = map({ stored[0], stored[1], stored[2] });
          Frame::Apply(frame.Rows, to.data(), 1.0, world);
          points->SetPoint(i, world);
          continue;
        }
        const auto f = static_cast<std::ptrdiff_t>(faceIndex->GetComponent(i, 0));
        if (f >= 0 && f < static_cast<std::ptrdiff_t>(is.size()) && is[f] != was[f])
        {
          const double uv[2] = { parameters->GetComponent(i, 0), parameters->GetComponent(i, 1) };
          EvaluatePoint(*is[f], uv, frame, points, normals, i);
        }
      }
    });
  leaf->SetPoints(points);
  if (normals)
  {
    leaf->GetPointData()->SetNormals(normals);
  }
  leaf->SetModel(after);
}
}
