/**
 * @file smGappedSolids.h
 * @brief Opens gaps between the faces of a solid by moves of its edges and trim curves
 */
#ifndef smGappedSolids_h
#define smGappedSolids_h

#include "smFace.h"
#include "smVector.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTrimmedNURBSModel.h>

#include <map>
#include <memory>
#include <random>

namespace smtest
{
/// Raises the degree of all pieces of a curve by one.
template <int Dimension>
sm::PolynomialCurve<Dimension> Elevate(const sm::PolynomialCurve<Dimension>& curve)
{
  sm::PolynomialCurve<Dimension> result;
  result.Breaks = { curve.Breaks.front() };
  result.Residual = curve.Residual;
  for (int piece = 0; piece < curve.GetNumberOfPieces(); ++piece)
  {
    const sm::BernsteinPiece<Dimension> source = curve.GetPiece(piece);
    const int n = source.Degree + 1;
    std::vector<std::array<double, Dimension>> points(n + 1);
    for (int i = 0; i <= n; ++i)
    {
      for (int d = 0; d < Dimension; ++d)
      {
        const double before = i > 0 ? source.Coefficients[i - 1][d] : 0.0;
        const double here = i < n ? source.Coefficients[i][d] : 0.0;
        points[i][d] = (i * before + (n - i) * here) / n;
      }
    }
    points.front() = source.Coefficients[0];
    points.back() = source.Coefficients[source.Degree];
    result.AppendPiece(curve.Breaks[piece + 1], points.data(), n);
  }
  return result;
}

/// Moves the coefficients inside of all pieces by random vectors; ends of pieces stay. `scale` has the
/// largest move of each coordinate.
template <int Dimension>
void MoveInside(
  sm::PolynomialCurve<Dimension>& curve, const std::array<double, Dimension>& scale, std::mt19937& random)
{
  while (curve.GetDegree(0) < 4)
  {
    curve = Elevate(curve);
  }
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int piece = 0; piece < curve.GetNumberOfPieces(); ++piece)
  {
    for (std::size_t i = curve.Offsets[piece] + 1; i + 1 < curve.Offsets[piece + 1]; ++i)
    {
      for (int d = 0; d < Dimension; ++d)
      {
        curve.Coefficients[i][d] += scale[d] * draw(random);
      }
    }
  }
}

/// Returns a copy of a model with gaps of about `gap`, whose edges have the tolerance `tolerance`.
inline vtkSmartPointer<vtkTrimmedNURBSModel> OpenGaps(
  vtkTrimmedNURBSModel* source, double gap, double tolerance, std::mt19937& random)
{
  std::map<const sm::Edge*, std::shared_ptr<const sm::Edge>> edges;
  std::vector<sm::FacePointer> faces;
  for (const sm::FacePointer& face : source->GetFaces())
  {
    auto copy = std::make_shared<sm::Face>(*face);
    copy->Id = sm::NewId();
    for (sm::Loop& loop : copy->Loops)
    {
      for (sm::Coedge& coedge : loop.Coedges)
      {
        if (coedge.Use->Degenerate)
        {
          continue;
        }
        std::shared_ptr<const sm::Edge>& edge = edges[coedge.Use.get()];
        if (!edge)
        {
          auto moved = std::make_shared<sm::Edge>(*coedge.Use);
          moved->Id = sm::NewId();
          moved->Tolerance = tolerance;
          MoveInside<3>(moved->Curve, { gap, gap, gap }, random);
          edge = moved;
        }
        coedge.Use = edge;
        const std::array<double, 2> at =
          coedge.Curve.Evaluate(0.5 * (coedge.Curve.GetStart() + coedge.Curve.GetEnd()));
        sm::Vector3 point;
        sm::Vector3 du;
        sm::Vector3 dv;
        face->Surface.Evaluate(at[0], at[1], point.data(), du.data(), dv.data());
        MoveInside<2>(coedge.Curve, { gap / sm::Norm(du), gap / sm::Norm(dv) }, random);
      }
    }
    faces.push_back(copy);
  }
  auto model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  model->ShallowCopy(source);
  model->SetFaces(faces);
  model->SetFileUncertainty(0.0);
  return model;
}
}

#endif
