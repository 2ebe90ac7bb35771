#include "smFreeFormBody.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace smtest
{
namespace
{
using Point = std::array<double, 3>;
using Index = std::array<int, 3>;

constexpr int Degree = 3;

/// Maps the cube [-1,1]^3 to a rounded box that is bent along x and has bumps.
Point Bend(const Point& p)
{
  const auto round = [](double a, double b, double c)
  { return a * std::sqrt(1.0 - 0.35 * b * b - 0.35 * c * c + 0.2 * b * b * c * c); };
  Point q{ 60.0 * round(p[0], p[1], p[2]), 35.0 * round(p[1], p[2], p[0]), 25.0 * round(p[2], p[0], p[1]) };
  q[2] += 9.0 * std::cos(0.03 * q[0]) + 1.5 * std::sin(0.11 * q[0] + 0.4) * std::cos(0.13 * q[1]);
  q[1] *= 1.0 + 0.15 * std::sin(0.05 * q[0] + 0.02 * q[2]);
  return q;
}

class Maker
{
public:
  explicit Maker(const FreeFormBody& body)
    : Body(body)
  {
    this->Knots.assign(Degree + 1, 0.0);
    for (int i = 1; i < body.Points - Degree; ++i)
    {
      this->Knots.push_back(static_cast<double>(i) / (body.Points - Degree));
    }
    this->Knots.resize(this->Knots.size() + Degree + 1, 1.0);
  }

  std::vector<sm::FacePointer> MakeFaces()
  {
    std::vector<sm::FacePointer> faces;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        Index cell{};
        cell[axis] = side * FreeFormBody::Faces[axis];
        const int a = (axis + 1) % 3;
        const int b = (axis + 2) % 3;
        for (cell[a] = 0; cell[a] < FreeFormBody::Faces[a]; ++cell[a])
        {
          for (cell[b] = 0; cell[b] < FreeFormBody::Faces[b]; ++cell[b])
          {
            faces.push_back(this->MakeFace(axis, side, cell, static_cast<int>(faces.size())));
          }
        }
      }
    }
    return faces;
  }

private:
  /// Returns the lattice point of an index that counts from 0; a face has Points - 1 steps.
  Point GetPoint(const Index& at) const
  {
    Point p;
    for (int c = 0; c < 3; ++c)
    {
      p[c] = 2.0 * at[c] / (FreeFormBody::Faces[c] * (this->Body.Points - 1)) - 1.0;
    }
    return Bend(p);
  }

  /// u and v of a face are the next two axes; the faces of side 0 look the other way.
  sm::FacePointer MakeFace(int axis, int side, const Index& cell, int number)
  {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    auto face = std::make_shared<sm::Face>();
    face->Id = sm::NewId();
    face->FileId = 100 + number;
    face->Reversed = side == 0;
    sm::NURBSSurface& surface = face->Surface;
    for (int d = 0; d < 2; ++d)
    {
      surface.Degree[d] = Degree;
      surface.Knots[d] = this->Knots;
      surface.NumberOfControlPoints[d] = this->Body.Points;
    }
    const int steps = this->Body.Points - 1;
    for (int j = 0; j <= steps; ++j)
    {
      for (int i = 0; i <= steps; ++i)
      {
        Index at;
        at[axis] = cell[axis] * steps;
        at[a] = cell[a] * steps + i;
        at[b] = cell[b] * steps + j;
        const Point p = this->GetPoint(at);
        surface.ControlPoints.push_back({ p[0], p[1], p[2], 1.0 });
      }
    }
    Index across = cell;
    ++across[a];
    Index above = cell;
    ++above[b];
    sm::Loop loop;
    loop.Coedges = { this->MakeCoedge(surface, a, cell, 0, 0, false),
      this->MakeCoedge(surface, b, across, 1, 1, false), this->MakeCoedge(surface, a, above, 0, 1, true),
      this->MakeCoedge(surface, b, cell, 1, 0, true) };
    face->Loops.push_back(loop);
    return face;
  }

  /// The edge from lattice corner `from` along `axis`, which is the face's direction `along` at the start or
  /// the end of the other.
  sm::Coedge MakeCoedge(
    const sm::NURBSSurface& surface, int axis, const Index& from, int along, int atEnd, bool reversed)
  {
    sm::Coedge coedge;
    std::shared_ptr<const sm::Edge>& known = this->Edges[{ axis, from }];
    if (!known)
    {
      known = this->MakeEdge(surface, along, atEnd);
    }
    coedge.Use = known;
    coedge.Reversed = reversed;
    std::array<double, 2> ends[2];
    for (int end = 0; end < 2; ++end)
    {
      ends[end][along] = end;
      ends[end][1 - along] = atEnd;
    }
    coedge.Curve.Breaks = { 0.0 };
    coedge.Curve.AppendPiece(1.0, ends, 1);
    return coedge;
  }

  /// The boundary of the surface, Bezier piece by Bezier piece.
  std::shared_ptr<const sm::Edge> MakeEdge(const sm::NURBSSurface& surface, int along, int atEnd) const
  {
    auto edge = std::make_shared<sm::Edge>();
    edge->Id = sm::NewId();
    edge->FileId = 1000 + static_cast<int>(this->Edges.size());
    const std::vector<double> breaks = surface.GetSpanBreaks(along);
    const std::size_t last = breaks.size() - 1;
    const double low = atEnd ? breaks[last - 1] : 0.0;
    const double high = atEnd ? 1.0 : breaks[1];
    edge->Curve.Breaks = { 0.0 };
    for (std::size_t i = 0; i < last; ++i)
    {
      std::array<double, 4> cell[(Degree + 1) * (Degree + 1)];
      Point points[Degree + 1];
      const bool isU = along == 0;
      surface.ExtractBezier(isU ? breaks[i] : low, isU ? breaks[i + 1] : high, isU ? low : breaks[i],
        isU ? high : breaks[i + 1], cell);
      for (int k = 0; k <= Degree; ++k)
      {
        const int across = atEnd ? Degree : 0;
        std::copy_n(
          cell[isU ? k + across * (Degree + 1) : across + k * (Degree + 1)].begin(), 3, points[k].begin());
      }
      edge->Curve.AppendPiece(breaks[i + 1], points, Degree);
    }
    edge->StartVertex = edge->Curve.GetStartPoint();
    edge->EndVertex = edge->Curve.GetEndPoint();
    return edge;
  }

  const FreeFormBody& Body;
  std::vector<double> Knots;
  std::map<std::pair<int, Index>, std::shared_ptr<const sm::Edge>> Edges;
};

void AddMesh(vtkNURBSDataSet* leaf, const std::vector<sm::FacePointer>& faces, int n)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkIntArray> faceIndex;
  faceIndex->SetName(vtkNURBSDataSet::FaceIndexArrayName());
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetName(vtkNURBSDataSet::ParametersArrayName());
  parameters->SetNumberOfComponents(2);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int k = 0; k < (n + 1) * (n + 1); ++k)
    {
      const double uv[2] = { static_cast<double>(k % (n + 1)) / n, static_cast<double>(k / (n + 1)) / n };
      double p[3];
      double du[3];
      double dv[3];
      double normal[3];
      faces[f]->Surface.Evaluate(uv[0], uv[1], p, du, dv);
      vtkMath::Cross(du, dv, normal);
      vtkMath::Normalize(normal);
      vtkMath::MultiplyScalar(normal, faces[f]->Reversed ? -1.0 : 1.0);
      points->InsertNextPoint(p);
      normals->InsertNextTuple(normal);
      faceIndex->InsertNextValue(static_cast<int>(f));
      parameters->InsertNextTuple(uv);
    }
    for (int k = 0; k < n * n; ++k)
    {
      const vtkIdType p = first + k % n + static_cast<vtkIdType>(k / n) * (n + 1);
      const vtkIdType out[4] = { p, p + 1, p + n + 2, p + n + 1 };
      const vtkIdType in[4] = { p, p + n + 1, p + n + 2, p + 1 };
      quads->InsertNextCell(4, faces[f]->Reversed ? in : out);
    }
  }
  leaf->SetPoints(points);
  leaf->SetPolys(quads);
  leaf->GetPointData()->SetNormals(normals);
  leaf->GetPointData()->AddArray(faceIndex);
  leaf->GetPointData()->AddArray(parameters);
}
}

vtkSmartPointer<vtkNURBSDataSet> FreeFormBody::Make() const
{
  const std::vector<sm::FacePointer> faces = Maker(*this).MakeFaces();
  double bounds[6] = { 1e9, -1e9, 1e9, -1e9, 1e9, -1e9 };
  for (const sm::FacePointer& face : faces)
  {
    for (const std::array<double, 4>& p : face->Surface.ControlPoints)
    {
      for (int c = 0; c < 3; ++c)
      {
        bounds[2 * c] = std::min(bounds[2 * c], p[c]);
        bounds[2 * c + 1] = std::max(bounds[2 * c + 1], p[c]);
      }
    }
  }
  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetName("free form");
  model->SetFaces(faces);
  std::vector<int> shell(faces.size());
  std::iota(shell.begin(), shell.end(), 0);
  model->SetShells({ shell });
  model->SetLocalBounds(bounds);
  auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
  AddMesh(leaf, faces, this->Cells);
  leaf->SetModel(model);
  return leaf;
}
}
