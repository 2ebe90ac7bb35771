// Edges without trim curves: a rough curve on the surface is replaced by the edge's projection, to rounding, and left alone where that is
// not what the file says.
#include "smChebyshevFit.h"
#include "smTesting.h"
#include "smTrimProjection.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace
{
using namespace smtest;
using Point2 = sm::TrimCurve::Point;
using Vector3 = std::array<double, 3>;

constexpr std::array<double, 2> Tolerance{ 1e-13, 1e-13 };

/// A bicubic graph over [0,1]^2 that is bent in both directions.
sm::NURBSSurface MakeSurface()
{
  sm::NURBSSurface surface;
  for (int d = 0; d < 2; ++d)
  {
    surface.Degree[d] = 3;
    surface.NumberOfControlPoints[d] = 4;
    surface.Knots[d] = { 0, 0, 0, 0, 1, 1, 1, 1 };
  }
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      surface.ControlPoints.push_back({ i / 3.0, j / 3.0, 0.3 * std::sin(1.0 + 2.0 * i + j), 1.0 });
    }
  }
  return surface;
}

Point2 GetTrim(double t)
{
  return { 0.1 + 0.8 * t, 0.2 + 0.5 * t * t };
}

/// The image of GetTrim(), lifted by `height`.
sm::EdgeCurve MakeEdge(const sm::NURBSSurface& surface, double height)
{
  std::array<Vector3, sm::FitOrder + 1> samples;
  for (int i = 0; i <= sm::FitOrder; ++i)
  {
    const Point2 uv = GetTrim(sm::GetFitNodes()[i]);
    surface.Evaluate(uv[0], uv[1], samples[i].data());
    samples[i][2] += height;
  }
  sm::FittedPiece<3> piece;
  sm::FitPiece<3>(samples, 12, { 1e-16, 1e-16, 1e-16 }, piece);
  sm::EdgeCurve edge;
  edge.Breaks = { 0.0 };
  edge.AppendPiece(1.0, piece.Coefficients.data(), piece.Degree);
  return edge;
}

/// GetTrim() as two pieces, each with a bump of this size.
sm::TrimCurve MakeRough(double bump)
{
  sm::TrimCurve trim;
  trim.Breaks = { 0.0 };
  for (int k = 0; k < 2; ++k)
  {
    const Point2 start = GetTrim(0.5 * k);
    const Point2 end = GetTrim(0.5 * k + 0.5);
    const double slope = 0.5 * k;
    const Point2 middle{ 0.5 * (start[0] + end[0]), start[1] + 0.25 * slope };
    const Point2 points[3] = { start, { middle[0], middle[1] + bump }, end };
    trim.AppendPiece(0.5 * k + 0.5, points, 2);
  }
  return trim;
}

double GetGap(const sm::NURBSSurface& surface, const sm::EdgeCurve& edge, const sm::TrimCurve& trim)
{
  double largest = 0.0;
  for (int i = 0; i <= 200; ++i)
  {
    const double t = i / 200.0;
    const Point2 uv = trim.Evaluate(t);
    Vector3 point;
    surface.Evaluate(uv[0], uv[1], point.data());
    largest = std::max(largest, sm::Norm(sm::Subtract(point, edge.Evaluate(t))));
  }
  return largest;
}

void CheckKept(
  const char* label, const sm::NURBSSurface& surface, const sm::EdgeCurve& edge, sm::TrimCurve trim)
{
  const sm::TrimCurve before = trim;
  CheckTrue(std::string(label) + ": left", !sm::ProjectEdge(surface, edge, Tolerance, trim));
  CheckTrue(std::string(label) + ": the same bits",
    trim.Coefficients == before.Coefficients && trim.Breaks == before.Breaks &&
      trim.Residual == before.Residual);
}
}

int TestTrimProjection(int, char*[])
{
  const sm::NURBSSurface surface = MakeSurface();
  const sm::EdgeCurve edge = MakeEdge(surface, 0.0);
  sm::TrimCurve trim = MakeRough(1e-5);
  CheckRange("a rough curve", 1e-6, GetGap(surface, edge, trim), 1e-4);
  CheckTrue("is projected", sm::ProjectEdge(surface, edge, Tolerance, trim));
  Check("to rounding", 0.0, GetGap(surface, edge, trim), 1e-12, "ten times the tolerance of the fit");
  CheckTrue("its ends stay", trim.GetStartPoint() == GetTrim(0.0) && trim.GetEndPoint() == GetTrim(1.0));
  Check("its residual", 0.0, trim.GetLargestResidual(), 1e-12, "the fit's");
  CheckKept("what is right", surface, edge, trim);
  CheckKept("an edge off the surface", surface, MakeEdge(surface, 1e-3), MakeRough(1e-5));
  CheckKept("far away", surface, edge, MakeRough(0.1));
  sm::TrimCurve line;
  line.Breaks = { 0.0 };
  const Point2 ends[2] = { { 0.5, 0.2 }, { 0.5, 0.7 } };
  line.AppendPiece(1.0, ends, 1);
  CheckKept("a line of constant parameter", surface, edge, line);
  return Finish();
}
