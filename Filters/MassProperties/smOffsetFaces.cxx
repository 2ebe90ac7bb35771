#include "Detail/smOffsetParts.h"

#include "smBernstein.h"
#include "smFacePanels.h"
#include "smGaussLegendre.h"
#include "smPolynomialCurve.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

namespace sm
{
namespace
{
/// Points of both rules in either direction of a panel.
constexpr int CoarseNodes = 8;
constexpr int FineNodes = 12;
/// Minimum weight of a point that counts, relative to the square of the patch's radius.
constexpr double MinAreaWeight = 1e-12;
/// Distance of control points from a plane, relative to their distances from each other, at which a face is
/// flat.
constexpr double FlatTolerance = 1e-12;

/// Values and the first two derivatives of the Bernstein polynomials of a degree at a point: differences of
/// those of lower degrees.
struct BernsteinBasis
{
  double Value[3][MaximumDegree + 1];

  BernsteinBasis(int degree, double x)
  {
    constexpr double signs[3][3] = { { 1.0, 0.0, 0.0 }, { -1.0, 1.0, 0.0 }, { 1.0, -2.0, 1.0 } };
    double factor = 1.0;
    for (int order = 0; order < 3; ++order)
    {
      std::fill_n(this->Value[order], degree + 1, 0.0);
      double lower[MaximumDegree + 1];
      if (order <= degree)
      {
        FillBernsteinBasis(degree - order, x, lower);
      }
      for (int i = 0; i <= degree - order; ++i)
      {
        for (int k = 0; k <= order; ++k)
        {
          this->Value[order][i + k] += factor * signs[order][k] * lower[i];
        }
      }
      factor *= degree - order;
    }
  }
};

/// The surface element of a patch at a point, and the sum and product of its principal curvatures, of which
/// those of a ball are positive where the normal Ss x Sr points outwards.
struct CurvaturePoint
{
  double Area = 0.0;
  double Mean = 0.0;
  double Gauss = 0.0;
};

CurvaturePoint EvaluateCurvature(const Patch& patch, const std::array<double, 4>* points, double s, double r)
{
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  const BernsteinBasis inS(p, s);
  const BernsteinBasis inR(q, r);
  // Homogeneous: value, s, r, ss, sr, rr.
  constexpr int orders[6][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 } };
  double h[6][4] = {};
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      const std::array<double, 4>& point = points[i + j * (p + 1)];
      for (int k = 0; k < 6; ++k)
      {
        const double weight = inS.Value[orders[k][0]][i] * inR.Value[orders[k][1]][j];
        for (int d = 0; d < 4; ++d)
        {
          h[k][d] += weight * point[d];
        }
      }
    }
  }
  const double w = h[0][3];
  Vector3 x;
  Vector3 first[2];
  Vector3 second[3];
  for (int d = 0; d < 3; ++d)
  {
    x[d] = h[0][d] / w;
    first[0][d] = (h[1][d] - h[1][3] * x[d]) / w;
    first[1][d] = (h[2][d] - h[2][3] * x[d]) / w;
    second[0][d] = (h[3][d] - 2.0 * h[1][3] * first[0][d] - h[3][3] * x[d]) / w;
    second[1][d] = (h[4][d] - h[1][3] * first[1][d] - h[2][3] * first[0][d] - h[4][3] * x[d]) / w;
    second[2][d] = (h[5][d] - 2.0 * h[2][3] * first[1][d] - h[5][3] * x[d]) / w;
  }
  const Vector3 normal = Cross(first[0], first[1]);
  const double squared = Dot(normal, normal);
  CurvaturePoint result;
  result.Area = std::sqrt(squared);
  if (squared > 0.0)
  {
    const double e = Dot(second[0], normal) / result.Area;
    const double f = Dot(second[1], normal) / result.Area;
    const double g = Dot(second[2], normal) / result.Area;
    result.Mean =
      -(e * Dot(first[1], first[1]) - 2.0 * f * Dot(first[0], first[1]) + g * Dot(first[0], first[0])) /
      squared;
    result.Gauss = (e * g - f * f) / squared;
  }
  return result;
}

struct CurvatureSums
{
  double Mean = 0.0;
  double Gauss = 0.0;
  double AbsoluteMean = 0.0;
  double AbsoluteGauss = 0.0;
};

/// Adds the integrals over a panel {(xi s(t), r(t))}, and extends the range of curvatures by those at points
/// of the patch.
void AddPanel(const FacePanels& cut, const Panel& panel, int nodes, CurvatureSums& sums, OffsetFace& face)
{
  const Patch& patch = cut.Patches[panel.Patch];
  const std::array<double, 4>* points = cut.Points.data() + patch.FirstPoint;
  std::array<double, 2> coefficients[MaximumDegree + 1];
  for (int i = 0; i <= panel.TrimDegree; ++i)
  {
    coefficients[i] = { cut.Coefficients[panel.Trim + 2 * i], cut.Coefficients[panel.Trim + 2 * i + 1] };
  }
  const BernsteinPiece<2> trim{ coefficients, panel.TrimDegree };
  const double* rule = GetRuleTable().data() + static_cast<std::size_t>(nodes) * (nodes - 1);
  const double side = panel.FlipNormal ? -1.0 : 1.0;
  for (int i = 0; i < nodes; ++i)
  {
    std::array<double, 2> slope;
    const double t = panel.Start + (panel.End - panel.Start) * rule[2 * i];
    const std::array<double, 2> at = trim.Evaluate(t, &slope);
    const double end = (at[0] - patch.Start[0]) / patch.Width[0];
    const double r = (at[1] - patch.Start[1]) / patch.Width[1];
    const double along = (panel.Negative ? -1.0 : 1.0) * rule[2 * i + 1] * (panel.End - panel.Start) * end *
      slope[1] / patch.Width[1];
    for (int j = 0; j < nodes; ++j)
    {
      const double s = rule[2 * j] * end;
      const CurvaturePoint point = EvaluateCurvature(patch, points, s, r);
      const double weight = along * rule[2 * j + 1] * point.Area;
      const double mean = side * point.Mean;
      sums.Mean += weight * mean;
      sums.Gauss += weight * point.Gauss;
      sums.AbsoluteMean += weight * std::abs(mean);
      sums.AbsoluteGauss += weight * std::abs(point.Gauss);
      // Pieces along a pole have no extent, and no curvature there counts.
      if (!(std::abs(weight) > MinAreaWeight * patch.Radius * patch.Radius))
      {
        continue;
      }
      const double root = std::sqrt(std::max(0.25 * mean * mean - point.Gauss, 0.0));
      face.Smallest = std::min(face.Smallest, 0.5 * mean - root);
      face.Largest = std::max(face.Largest, 0.5 * mean + root);
    }
  }
}

bool IsFlat(const NURBSSurface& surface)
{
  const std::vector<std::array<double, 4>>& points = surface.ControlPoints;
  const auto get = [&points](std::size_t i) {
    return Vector3{ points[i][0] / points[i][3], points[i][1] / points[i][3], points[i][2] / points[i][3] };
  };
  const Vector3 origin = get(0);
  Vector3 first{};
  Vector3 normal{};
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const Vector3 way = Subtract(get(i), origin);
    first = Norm(way) > Norm(first) ? way : first;
  }
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const Vector3 cross = Cross(first, Subtract(get(i), origin));
    normal = Norm(cross) > Norm(normal) ? cross : normal;
  }
  const double size = Norm(normal);
  return size > 0.0 &&
    std::all_of(points.begin(), points.end(),
      [&](const std::array<double, 4>& h)
      {
        return std::abs(Dot(Subtract({ h[0] / h[3], h[1] / h[3], h[2] / h[3] }, origin), normal)) <=
          FlatTolerance * size * (Norm(first) + Norm(origin));
      });
}

/// Extends the face's box by a point.
void Extend(OffsetFace& face, const double* point)
{
  for (int d = 0; d < 3; ++d)
  {
    face.Low[d] = std::min(face.Low[d], point[d]);
    face.High[d] = std::max(face.High[d], point[d]);
  }
}
}

OffsetFace MeasureOffsetFace(const Face& source)
{
  OffsetFace face;
  face.Low.fill(std::numeric_limits<double>::infinity());
  face.High.fill(-face.Low[0]);
  face.IsKnown = source.Surface.Check().empty();
  if (!face.IsKnown)
  {
    return face;
  }
  face.IsFlat = IsFlat(source.Surface);
  FindCreases(source, face);
  bool hasEdges = false;
  for (const Loop& loop : source.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      for (const Vector3& point : coedge.Use->Curve.Coefficients)
      {
        hasEdges = true;
        Extend(face, point.data());
      }
    }
  }
  // A flat face is in the hull of its edges, any face in that of its control points.
  if (face.IsFlat && hasEdges)
  {
    return face;
  }
  for (const std::array<double, 4>& h : source.Surface.ControlPoints)
  {
    Extend(face, Vector3{ h[0] / h[3], h[1] / h[3], h[2] / h[3] }.data());
  }
  if (face.IsFlat)
  {
    return face;
  }
  try
  {
    const FacePanels cut = BuildFacePanels(source);
    CurvatureSums sums[2];
    for (const Panel& panel : cut.Panels)
    {
      AddPanel(cut, panel, CoarseNodes, sums[0], face);
      AddPanel(cut, panel, FineNodes, sums[1], face);
    }
    face.Mean = sums[1].Mean;
    face.Gauss = sums[1].Gauss;
    face.AbsoluteMean = sums[1].AbsoluteMean + 10.0 * std::abs(sums[1].AbsoluteMean - sums[0].AbsoluteMean);
    face.AbsoluteGauss =
      sums[1].AbsoluteGauss + 10.0 * std::abs(sums[1].AbsoluteGauss - sums[0].AbsoluteGauss);
    face.MeanError += 10.0 * std::abs(sums[1].Mean - sums[0].Mean);
    face.GaussError += 10.0 * std::abs(sums[1].Gauss - sums[0].Gauss);
    face.IsKnown = std::isfinite(face.Mean + face.Gauss + face.MeanError + face.GaussError);
  }
  catch (const std::exception&)
  {
    face.IsKnown = false;
  }
  return face;
}
}
