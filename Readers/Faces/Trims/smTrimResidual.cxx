#include "smTrimResidual.h"

#include "Geometry/smChebyshevFit.h"
#include "smCellSurface.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sm
{
namespace
{
/// Returns by how much u and v of the pieces of a trim curve from `first` to before `last` differ from those
/// of the edge's points, at most, if either of the two differs alone; from the distance between both curves
/// across the edge, at some points of each piece.
TrimCurve::Point MeasureResidual(
  CellSurface& cells, const TrimCurve& trim, const EdgeCurve& edge, int first, int last)
{
  // What may be missed between the points, and the smallest speed along a parameter, relative to the largest
  // one.
  constexpr double between = 1.25;
  constexpr double minSpeed = 0.01;
  struct Sample
  {
    double Distance;
    TrimCurve::Point Speed;
  };
  std::vector<Sample> samples;
  TrimCurve::Point fastest{};
  for (int k = first; k < last; ++k)
  {
    for (const double x : GetFitNodes())
    {
      std::array<double, 3> du;
      std::array<double, 3> dv;
      const std::array<double, 3> position = cells.Evaluate(trim.GetPiece(k).Evaluate(x), &du, &dv);
      // A displacement along the edge does not move the border.
      std::array<double, 3> tangent;
      const std::array<double, 3> target =
        edge.Evaluate((1.0 - x) * trim.Breaks[k] + x * trim.Breaks[k + 1], &tangent);
      const std::array<double, 3> gap = { target[0] - position[0], target[1] - position[1],
        target[2] - position[2] };
      const double speed = Dot(tangent, tangent);
      const double along = speed > 0.0 ? Dot(gap, tangent) * Dot(gap, tangent) / speed : 0.0;
      const std::array<double, 3> normal = Cross(du, dv);
      const double squares[2] = { Dot(du, du), Dot(dv, dv) };
      const double sine =
        squares[0] * squares[1] > 0.0 ? std::sqrt(Dot(normal, normal) / (squares[0] * squares[1])) : 1.0;
      samples.push_back({ std::sqrt(std::max(0.0, Dot(gap, gap) - along)) / std::max(sine, minSpeed),
        { std::sqrt(squares[0]), std::sqrt(squares[1]) } });
      for (int d = 0; d < 2; ++d)
      {
        fastest[d] = std::max(fastest[d], samples.back().Speed[d]);
      }
    }
  }
  TrimCurve::Point residual{};
  for (const Sample& s : samples)
  {
    for (int d = 0; d < 2; ++d)
    {
      residual[d] = std::max(residual[d], between * s.Distance / std::max(s.Speed[d], minSpeed * fastest[d]));
    }
  }
  return residual;
}

double GetPieceArea(const TrimCurve& curve, int piece, const TrimCurve::Point& residual)
{
  double area = 0.0;
  const BernsteinPiece<2> part = curve.GetPiece(piece);
  for (int i = 1; i <= part.Degree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      area += residual[1 - d] * std::abs(part.Coefficients[i][d] - part.Coefficients[i - 1][d]);
    }
  }
  return area;
}
}

double GetSweptArea(const TrimCurve& curve)
{
  double area = 0.0;
  for (int k = 0; k < curve.GetNumberOfPieces(); ++k)
  {
    area += GetPieceArea(curve, k, curve.GetResidual(k));
  }
  return area;
}

void LowerResidual(const NURBSSurface& surface, const EdgeCurve& edge, TrimCurve& trim)
{
  CellSurface cells(surface);
  // u and v must be of the same comparison: a pair of the lesser u of one and the lesser v of the other
  // bounds neither displacement.
  const auto lower = [&](TrimCurve::Point& residual, int first, int last)
  {
    const TrimCurve::Point measured = MeasureResidual(cells, trim, edge, first, last);
    double area = 0.0;
    double measuredArea = 0.0;
    for (int k = first; k < last; ++k)
    {
      area += GetPieceArea(trim, k, residual);
      measuredArea += GetPieceArea(trim, k, measured);
    }
    residual = measuredArea < area ? measured : residual;
  };
  if (trim.PieceResiduals.empty())
  {
    lower(trim.Residual, 0, trim.GetNumberOfPieces());
    return;
  }
  trim.Residual = {};
  for (int k = 0; k < trim.GetNumberOfPieces(); ++k)
  {
    TrimCurve::Point& residual = trim.PieceResiduals[k];
    lower(residual, k, k + 1);
    for (int d = 0; d < 2; ++d)
    {
      trim.Residual[d] = std::max(trim.Residual[d], residual[d]);
    }
  }
}
}
