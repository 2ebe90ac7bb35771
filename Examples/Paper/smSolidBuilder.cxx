#include "smSolidBuilder.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace smfigure
{
using namespace sm;
namespace
{
constexpr int FitDegree = 9;
constexpr int FitPoints = FitDegree + 1;

/// Inverse of the matrix of Bernstein polynomials at the Chebyshev points of the second kind: values ->
/// coefficients.
struct BernsteinInterpolation
{
  std::array<double, FitPoints> Nodes;
  std::array<std::array<double, FitPoints>, FitPoints> Inverse{};

  BernsteinInterpolation()
  {
    const double pi = std::acos(-1.0);
    std::array<std::array<double, FitPoints>, FitPoints> matrix;
    for (int i = 0; i < FitPoints; ++i)
    {
      this->Nodes[i] = 0.5 - 0.5 * std::cos(pi * i / FitDegree);
      double binomial = 1.0;
      for (int j = 0; j < FitPoints; ++j)
      {
        matrix[i][j] = binomial * std::pow(this->Nodes[i], j) * std::pow(1.0 - this->Nodes[i], FitDegree - j);
        binomial *= static_cast<double>(FitDegree - j) / (j + 1);
      }
      this->Inverse[i][i] = 1.0;
    }
    // Gauss-Jordan without pivoting: the matrix is totally positive.
    for (int c = 0; c < FitPoints; ++c)
    {
      for (int r = 0; r < FitPoints; ++r)
      {
        const double factor = matrix[r][c] / matrix[c][c];
        for (int k = 0; r != c && k < FitPoints; ++k)
        {
          matrix[r][k] -= factor * matrix[c][k];
          this->Inverse[r][k] -= factor * this->Inverse[c][k];
        }
      }
    }
    for (int r = 0; r < FitPoints; ++r)
    {
      for (double& entry : this->Inverse[r])
      {
        entry /= matrix[r][r];
      }
    }
  }
};

bool Equal(const Point3& a, const Point3& b)
{
  return a == b;
}
}

template <int Dimension>
PolynomialCurve<Dimension> FitCurve(
  const std::function<std::array<double, Dimension>(double)>& function, double start, double end, int pieces)
{
  static const BernsteinInterpolation interpolation;
  PolynomialCurve<Dimension> curve;
  curve.Breaks = { start };
  for (int p = 0; p < pieces; ++p)
  {
    const double from = start + (end - start) * p / pieces;
    const double to = start + (end - start) * (p + 1) / pieces;
    std::array<double, Dimension> values[FitPoints];
    for (int i = 0; i < FitPoints; ++i)
    {
      values[i] = function(from + (to - from) * interpolation.Nodes[i]);
    }
    std::array<double, Dimension> coefficients[FitPoints] = {};
    for (int i = 0; i < FitPoints; ++i)
    {
      for (int j = 0; j < FitPoints; ++j)
      {
        for (int d = 0; d < Dimension; ++d)
        {
          coefficients[i][d] += interpolation.Inverse[i][j] * values[j][d];
        }
      }
    }
    coefficients[0] = values[0];
    coefficients[FitDegree] = values[FitDegree];
    curve.AppendPiece(to, coefficients, FitDegree);
    for (int i = 0; i < FitDegree; ++i)
    {
      const double t = from + (to - from) * 0.5 * (interpolation.Nodes[i] + interpolation.Nodes[i + 1]);
      const auto wanted = function(t);
      const auto got = curve.Evaluate(t);
      for (int d = 0; d < Dimension; ++d)
      {
        curve.RaiseResidual(d, std::abs(wanted[d] - got[d]));
      }
    }
  }
  return curve;
}

template <int Dimension>
PolynomialCurve<Dimension> MakeLine(
  const std::array<double, Dimension>& from, const std::array<double, Dimension>& to)
{
  PolynomialCurve<Dimension> line;
  line.Breaks = { 0.0 };
  const std::array<double, Dimension> ends[2] = { from, to };
  line.AppendPiece(1.0, ends, 1);
  return line;
}

template TrimCurve FitCurve<2>(const std::function<Point2(double)>&, double, double, int);
template EdgeCurve FitCurve<3>(const std::function<Point3(double)>&, double, double, int);
template TrimCurve MakeLine<2>(const Point2&, const Point2&);
template EdgeCurve MakeLine<3>(const Point3&, const Point3&);

NURBSSurface MakePlaneSurface(const Point3 (&corners)[4])
{
  NURBSSurface surface;
  surface.Knots[0] = surface.Knots[1] = { 0.0, 0.0, 1.0, 1.0 };
  surface.NumberOfControlPoints[0] = surface.NumberOfControlPoints[1] = 2;
  for (const int i : { 0, 1, 3, 2 })
  {
    surface.ControlPoints.push_back({ corners[i][0], corners[i][1], corners[i][2], 1.0 });
  }
  return surface;
}

SolidBuilder::EdgePointer SolidBuilder::AddEdge(const EdgeCurve& curve)
{
  auto edge = std::make_shared<Edge>();
  edge->Id = NewId();
  edge->Curve = curve;
  edge->StartVertex = curve.GetStartPoint();
  edge->EndVertex = curve.GetEndPoint();
  return edge;
}

SolidBuilder::EdgePointer SolidBuilder::GetStraightEdge(const Point3& from, const Point3& to)
{
  for (const EdgePointer& edge : this->StraightEdges)
  {
    if ((Equal(edge->StartVertex, from) && Equal(edge->EndVertex, to)) ||
      (Equal(edge->StartVertex, to) && Equal(edge->EndVertex, from)))
    {
      return edge;
    }
  }
  this->StraightEdges.push_back(this->AddEdge(MakeLine<3>(from, to)));
  return this->StraightEdges.back();
}

Coedge SolidBuilder::MakeCoedge(const EdgePointer& edge, bool reversed, const TrimCurve& curve)
{
  Coedge coedge;
  coedge.Use = edge;
  coedge.Reversed = reversed;
  coedge.Curve = curve;
  return coedge;
}

Coedge SolidBuilder::MakeStraightCoedge(
  const Point3& from, const Point3& to, const Point2& from2, const Point2& to2)
{
  const EdgePointer edge = this->GetStraightEdge(from, to);
  const bool reversed = !Equal(edge->StartVertex, from);
  return MakeCoedge(edge, reversed, reversed ? MakeLine<2>(to2, from2) : MakeLine<2>(from2, to2));
}

void SolidBuilder::AddFace(NURBSSurface surface, std::vector<Loop> loops, bool reversed)
{
  auto face = std::make_shared<Face>();
  face->Id = NewId();
  face->FileId = static_cast<int>(this->Faces.size()) + 1;
  face->Surface = std::move(surface);
  face->Reversed = reversed;
  face->Loops = std::move(loops);
  this->Faces.push_back(face);
}

void SolidBuilder::AddPlane(const Point3 (&corners)[4], std::vector<Loop> holes)
{
  const Point2 at[4] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
  Loop outer;
  for (int i = 0; i < 4; ++i)
  {
    const int next = (i + 1) % 4;
    outer.Coedges.push_back(this->MakeStraightCoedge(corners[i], corners[next], at[i], at[next]));
  }
  holes.insert(holes.begin(), outer);
  this->AddFace(MakePlaneSurface(corners), std::move(holes));
}

vtkSmartPointer<vtkNURBSDataSet> SolidBuilder::Make(
  const char* name, bool solid, const double bounds[6]) const
{
  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetName(name);
  model->SetBody(solid ? vtkTrimmedNURBSModel::SOLID : vtkTrimmedNURBSModel::SHELL);
  model->SetFaces(this->Faces);
  std::vector<int> shell;
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    shell.push_back(static_cast<int>(f));
  }
  model->SetShells({ shell });
  double copy[6];
  std::copy(bounds, bounds + 6, copy);
  model->SetLocalBounds(copy);
  vtkNew<vtkPoints> points;
  for (int corner = 0; corner < 8; ++corner)
  {
    points->InsertNextPoint(bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + (corner >> 2)]);
  }
  auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
  leaf->SetPoints(points);
  leaf->SetModel(model);
  return leaf;
}
}
