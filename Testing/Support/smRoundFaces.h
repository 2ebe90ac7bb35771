/**
 * @file smRoundFaces.h
 * @brief Whole spheres and tori as faces without loops, for tests that need no file
 */
#ifndef smRoundFaces_h
#define smRoundFaces_h

#include "smFace.h"
#include "smVector.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTrimmedNURBSModel.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace smtest
{
/// An arc of the unit circle from one angle to another as a rational B-spline of degree 2: knots and points
/// (w x, w y, w) of arcs of 90 degrees at most.
struct CircularArc
{
  std::vector<double> Knots;
  std::vector<sm::Vector3> Points;

  CircularArc(double from, double to)
  {
    const int arcs = static_cast<int>(std::ceil((to - from) / (0.5 * vtkMath::Pi()) - 1e-9));
    const double half = 0.5 * (to - from) / arcs;
    this->Knots.assign(3, from);
    for (int k = 0; k <= 2 * arcs; ++k)
    {
      const double weight = k % 2 == 1 ? std::cos(half) : 1.0;
      const double angle = from + half * k;
      // The inner point of an arc lies at 1/w.
      this->Points.push_back({ std::cos(angle), std::sin(angle), weight });
      if (k % 2 == 0 && k > 0)
      {
        this->Knots.insert(this->Knots.end(), k == 2 * arcs ? 3 : 2, angle);
      }
    }
  }
};

/// A surface of revolution about an axis along z through `center`: a circle of the radius `tube` at the
/// distance `ring` from the axis, over these angles about the axis and in the circle.
inline std::shared_ptr<sm::Face> MakeRevolved(const sm::Vector3& center, double ring, double tube,
  const CircularArc& around, const CircularArc& along, bool outward = true)
{
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->FileId = 7;
  face->Reversed = !outward;
  sm::NURBSSurface& surface = face->Surface;
  surface.Rational = true;
  surface.Degree[0] = surface.Degree[1] = 2;
  surface.Knots[0] = around.Knots;
  surface.Knots[1] = along.Knots;
  surface.NumberOfControlPoints[0] = static_cast<int>(around.Points.size());
  surface.NumberOfControlPoints[1] = static_cast<int>(along.Points.size());
  for (const sm::Vector3& v : along.Points)
  {
    for (const sm::Vector3& u : around.Points)
    {
      const double w = u[2] * v[2];
      const double distance = ring * v[2] + tube * v[0];
      surface.ControlPoints.push_back({ w * center[0] + distance * u[0], w * center[1] + distance * u[1],
        w * center[2] + tube * v[1] * u[2], w });
    }
  }
  return face;
}

/// A ball's face, or that of a void.
inline std::shared_ptr<sm::Face> MakeBall(const sm::Vector3& center, double radius, bool outward = true)
{
  const double right = 0.5 * vtkMath::Pi();
  return MakeRevolved(center, 0.0, radius, { 0.0, 4.0 * right }, { -right, right }, outward);
}

inline std::shared_ptr<sm::Face> MakeTorus(
  const sm::Vector3& center, double ring, double tube, bool outward = true)
{
  const double whole = 2.0 * vtkMath::Pi();
  return MakeRevolved(center, ring, tube, { 0.0, whole }, { 0.0, whole }, outward);
}

/// Gives a leaf triangles on the first faces of its model, a grid of steps x steps on each, with their exact
/// normals.
inline void AddGrids(vtkNURBSDataSet* leaf, const std::vector<sm::FacePointer>& faces, int steps)
{
  const vtkSmartPointer<vtkTrimmedNURBSModel> model = leaf->GetModel();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIntArray> faceOfCell;
  faceOfCell->SetName(vtkNURBSDataSet::FaceIndexArrayName());
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const sm::NURBSSurface& surface = faces[f]->Surface;
    const vtkIdType first = points->GetNumberOfPoints();
    for (int k = 0; k < (steps + 1) * (steps + 1); ++k)
    {
      const int index[2] = { k % (steps + 1), k / (steps + 1) };
      double at[2];
      for (int d = 0; d < 2; ++d)
      {
        const double x = static_cast<double>(index[d]) / steps;
        at[d] = (1.0 - x) * surface.GetDomainStart(d) + x * surface.GetDomainEnd(d);
      }
      sm::Vector3 p;
      sm::Vector3 du;
      sm::Vector3 dv;
      surface.Evaluate(at[0], at[1], p.data(), du.data(), dv.data());
      const sm::Vector3 n = sm::Normalized(faces[f]->Reversed ? sm::Cross(dv, du) : sm::Cross(du, dv));
      points->InsertNextPoint(p.data());
      normals->InsertNextTuple(n.data());
      if (index[0] < steps && index[1] < steps)
      {
        const vtkIdType a = first + k;
        const vtkIdType halves[2][3] = { { a, a + 1, a + steps + 2 }, { a, a + steps + 2, a + steps + 1 } };
        for (const vtkIdType(&half)[3] : halves)
        {
          const vtkIdType reversed[3] = { half[0], half[2], half[1] };
          triangles->InsertNextCell(3, faces[f]->Reversed ? reversed : half);
          faceOfCell->InsertNextValue(static_cast<int>(f));
        }
      }
    }
  }
  leaf->SetPoints(points);
  leaf->SetPolys(triangles);
  leaf->GetPointData()->SetNormals(normals);
  leaf->GetCellData()->AddArray(faceOfCell);
  // A model belongs to the points that are there when it is set.
  leaf->SetModel(model);
}

/// Sets the bounds of the model to those of its control points.
inline void SetBounds(vtkTrimmedNURBSModel* model)
{
  vtkBoundingBox box;
  for (const sm::FacePointer& face : model->GetFaces())
  {
    for (const auto& p : face->Surface.ControlPoints)
    {
      box.AddPoint(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
    }
  }
  double bounds[6];
  box.GetBounds(bounds);
  model->SetLocalBounds(bounds);
}

/// A solid of these faces, each of them a shell, without any mesh.
inline vtkSmartPointer<vtkNURBSDataSet> MakeRoundBody(const std::vector<sm::FacePointer>& faces)
{
  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetName("round");
  std::vector<std::vector<int>> shells;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    shells.push_back({ static_cast<int>(f) });
  }
  model->SetFaces(faces);
  model->SetShells(shells);
  SetBounds(model);
  auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
  leaf->SetModel(model);
  return leaf;
}

/// Adds faces, each of them a shell, to the body of a leaf, which keeps its mesh.
inline void AddShells(vtkNURBSDataSet* leaf, const std::vector<sm::FacePointer>& added)
{
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(leaf->GetModel());
  std::vector<sm::FacePointer> faces = model->GetFaces();
  std::vector<std::vector<int>> shells = model->GetShells();
  for (const sm::FacePointer& face : added)
  {
    shells.push_back({ static_cast<int>(faces.size()) });
    faces.push_back(face);
  }
  model->SetFaces(faces);
  model->SetShells(shells);
  SetBounds(model);
  leaf->SetModel(model);
}
}

#endif
