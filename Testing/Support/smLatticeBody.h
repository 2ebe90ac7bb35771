/**
 * @file smLatticeBody.h
 * @brief A cuboid as six B-spline faces of one lattice of control points, with a mesh, and what moving a
 * point does to it
 *
 * The lattice's points lie at the Greville abscissae, so that the faces are planes and the edges are
 * straight, whatever the degree. Moving one point of the lattice by d maps x to x + d B(x), whose determinant
 * is 1 + d . grad B: the volume changes by d . (integral of grad B), in closed form and exactly linear in d.
 */
#ifndef smLatticeBody_h
#define smLatticeBody_h

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTrimmedNURBSModel.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace smtest
{
class LatticeBody
{
public:
  using Point = std::array<double, 3>;

  Point Size{ 2.0, 3.0, 5.0 };
  Point Origin{ 0.0, 0.0, 0.0 };
  int Degree = 3;
  /// Clamped knots over [0,1], the same in every direction.
  std::vector<double> Knots{ 0.0, 0.0, 0.0, 0.0, 0.375, 1.0, 1.0, 1.0, 1.0 };
  /// Cells of each face's mesh in each direction.
  int Cells = 8;

  int GetNumberOfPoints() const { return static_cast<int>(this->Knots.size()) - this->Degree - 1; }
  double GetVolume() const { return this->Size[0] * this->Size[1] * this->Size[2]; }

  /// The integral of basis function i over [0,1], and its difference between 1 and 0.
  double GetIntegral(int i) const
  {
    return (this->Knots[i + this->Degree + 1] - this->Knots[i]) / (this->Degree + 1);
  }
  double GetGain(int i) const { return i == 0 ? -1.0 : i == this->GetNumberOfPoints() - 1 ? 1.0 : 0.0; }

  /// Change of the volume when point (i,j,k) of the lattice moves by d.
  double GetVolumeChange(int i, int j, int k, const Point& d) const
  {
    const int at[3] = { i, j, k };
    double change = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const int a = (c + 1) % 3;
      const int b = (c + 2) % 3;
      change += d[c] * this->GetGain(at[c]) * this->GetIntegral(at[a]) * this->Size[a] *
        this->GetIntegral(at[b]) * this->Size[b];
    }
    return change;
  }

  /// Face 2 axis + side; its u and v are the next two axes, those of side 1 rotated by a quarter, so that
  /// rows meet reversed and across. Control point (i,j) of the face that is point (a,b) of the lattice in
  /// these axes.
  static std::array<int, 2> ToFace(int side, int last, int a, int b)
  {
    return side == 0 ? std::array<int, 2>{ a, b } : std::array<int, 2>{ b, last - a };
  }

  vtkSmartPointer<vtkNURBSDataSet> Make()
  {
    this->Edges.clear();
    std::vector<sm::FacePointer> faces;
    for (int axis = 0; axis < 3; ++axis)
    {
      faces.push_back(this->MakeFace(axis, 0));
      faces.push_back(this->MakeFace(axis, 1));
    }
    vtkNew<vtkTrimmedNURBSModel> model;
    model->SetName("lattice");
    model->SetFaces(faces);
    model->SetShells({ { 0, 1, 2, 3, 4, 5 } });
    model->SetOrigin(this->Origin.data());
    const double bounds[6] = { 0.0, this->Size[0], 0.0, this->Size[1], 0.0, this->Size[2] };
    model->SetLocalBounds(bounds);
    auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
    this->AddMesh(leaf, faces);
    leaf->SetModel(model);
    return leaf;
  }

private:
  double GetGreville(int i) const
  {
    double sum = 0.0;
    for (int k = 1; k <= this->Degree; ++k)
    {
      sum += this->Knots[i + k];
    }
    return sum / this->Degree;
  }

  sm::FacePointer MakeFace(int axis, int side)
  {
    const int count = this->GetNumberOfPoints();
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    auto face = std::make_shared<sm::Face>();
    face->Id = sm::NewId();
    face->FileId = 100 + 2 * axis + side;
    face->Reversed = side == 0;
    sm::NURBSSurface& surface = face->Surface;
    surface.Degree[0] = surface.Degree[1] = this->Degree;
    surface.NumberOfControlPoints[0] = surface.NumberOfControlPoints[1] = count;
    surface.Knots[0] = surface.Knots[1] = this->Knots;
    if (side == 1)
    {
      // v runs against the first axis.
      for (std::size_t i = 0; i < this->Knots.size(); ++i)
      {
        surface.Knots[1][i] = 1.0 - this->Knots[this->Knots.size() - 1 - i];
      }
    }
    surface.ControlPoints.resize(static_cast<std::size_t>(count) * count);
    for (int i = 0; i < count; ++i)
    {
      for (int j = 0; j < count; ++j)
      {
        Point p;
        p[axis] = side * this->Size[axis];
        p[a] = this->Size[a] * this->GetGreville(i);
        p[b] = this->Size[b] * this->GetGreville(j);
        const std::array<int, 2> at = ToFace(side, count - 1, i, j);
        surface.ControlPoints[at[0] + static_cast<std::size_t>(at[1]) * count] = { p[0], p[1], p[2], 1.0 };
      }
    }
    // Round the square of the axes a and b; a quarter turn keeps the sense.
    sm::Loop loop;
    loop.Coedges.push_back(this->MakeCoedge(axis, side, a, 0, false));
    loop.Coedges.push_back(this->MakeCoedge(axis, side, b, 1, false));
    loop.Coedges.push_back(this->MakeCoedge(axis, side, a, 1, true));
    loop.Coedges.push_back(this->MakeCoedge(axis, side, b, 0, true));
    face->Loops.push_back(loop);
    return face;
  }

  /// The edge of the face (axis, side) along `along`, at the side `other` of the face's third axis.
  sm::Coedge MakeCoedge(int axis, int side, int along, int other, bool reversed)
  {
    const int third = 3 - axis - along;
    std::array<int, 3> key{};
    key[axis] = side;
    key[third] = other;
    key[along] = 2;
    sm::Coedge coedge;
    coedge.Use = this->GetEdge(key, along);
    coedge.Reversed = reversed;
    std::array<double, 2> ends[2];
    for (int end = 0; end < 2; ++end)
    {
      const bool isFirst = along == (axis + 1) % 3;
      const double s = isFirst ? end : other;
      const double r = isFirst ? other : end;
      ends[end] = side == 0 ? std::array<double, 2>{ s, r } : std::array<double, 2>{ r, 1.0 - s };
    }
    coedge.Curve.Breaks = { 0.0 };
    coedge.Curve.AppendPiece(1.0, ends, 1);
    return coedge;
  }

  std::shared_ptr<const sm::Edge> GetEdge(const std::array<int, 3>& key, int along)
  {
    std::shared_ptr<const sm::Edge>& known = this->Edges[key];
    if (!known)
    {
      auto edge = std::make_shared<sm::Edge>();
      edge->Id = sm::NewId();
      edge->FileId = 1000 + static_cast<int>(this->Edges.size());
      for (int c = 0; c < 3; ++c)
      {
        edge->StartVertex[c] = c == along ? 0.0 : key[c] * this->Size[c];
        edge->EndVertex[c] = c == along ? this->Size[c] : key[c] * this->Size[c];
      }
      const Point line[2] = { edge->StartVertex, edge->EndVertex };
      edge->Curve.Breaks = { 0.0 };
      edge->Curve.AppendPiece(1.0, line, 1);
      known = edge;
    }
    return known;
  }

  void AddMesh(vtkNURBSDataSet* leaf, const std::vector<sm::FacePointer>& faces) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> quads;
    vtkNew<vtkIntArray> pointFace;
    pointFace->SetName(vtkNURBSDataSet::FaceIndexArrayName());
    vtkNew<vtkIntArray> cellFace;
    cellFace->SetName(vtkNURBSDataSet::FaceIndexArrayName());
    vtkNew<vtkDoubleArray> parameters;
    parameters->SetName(vtkNURBSDataSet::ParametersArrayName());
    parameters->SetNumberOfComponents(2);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    const int n = this->Cells;
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const vtkIdType first = points->GetNumberOfPoints();
      for (int k = 0; k < (n + 1) * (n + 1); ++k)
      {
        const double uv[2] = { static_cast<double>(k % (n + 1)) / n, static_cast<double>(k / (n + 1)) / n };
        double p[3];
        faces[f]->Surface.Evaluate(uv[0], uv[1], p);
        points->InsertNextPoint(p[0] + this->Origin[0], p[1] + this->Origin[1], p[2] + this->Origin[2]);
        pointFace->InsertNextValue(static_cast<int>(f));
        parameters->InsertNextTuple(uv);
        double normal[3] = { 0.0, 0.0, 0.0 };
        normal[f / 2] = f % 2 == 0 ? -1.0 : 1.0;
        normals->InsertNextTuple(normal);
      }
      for (int k = 0; k < n * n; ++k)
      {
        const vtkIdType p = first + k % n + static_cast<vtkIdType>(k / n) * (n + 1);
        const vtkIdType out[4] = { p, p + 1, p + n + 2, p + n + 1 };
        const vtkIdType in[4] = { p, p + n + 1, p + n + 2, p + 1 };
        quads->InsertNextCell(4, f % 2 == 0 ? in : out);
        cellFace->InsertNextValue(static_cast<int>(f));
      }
    }
    leaf->SetPoints(points);
    leaf->SetPolys(quads);
    leaf->GetPointData()->SetNormals(normals);
    leaf->GetPointData()->AddArray(pointFace);
    leaf->GetPointData()->AddArray(parameters);
    leaf->GetCellData()->AddArray(cellFace);
  }

  std::map<std::array<int, 3>, std::shared_ptr<const sm::Edge>> Edges;
};
}

#endif
