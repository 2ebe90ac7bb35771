// A solid built by hand, without a file: half a ball, from a rational B-spline hemisphere and a plane trimmed
// by a circle.
//   BuildByHand [RADIUS]    prints volume and area with their bounds next to the closed forms; the radius is
//   10 unless given
// Exit status: 0 when the status is ok and both closed forms are within the bounds, 1 for a wrong argument, 3
// otherwise.
#include <smFace.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkTrimmedNURBSModel.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;
using EdgePointer = std::shared_ptr<const sm::Edge>;

const double Pi = std::acos(-1.0);
const int PiecesPerQuarter = 16;

/// radius (cos(angle) a + sin(angle) b) in cubic pieces. The parameter is that of rational quarter arcs, one
/// unit for a quarter: angle = pi/4 + 2 atan((2 t - 1) tan(pi/8)) in the first.
sm::EdgeCurve MakeArc(double radius, int quarters, const Point3& a, const Point3& b)
{
  sm::EdgeCurve curve;
  curve.Breaks = { 0.0 };
  double from = 0.0;
  for (int step = 1; step <= quarters * PiecesPerQuarter; ++step)
  {
    const double t = static_cast<double>(step) / PiecesPerQuarter;
    const double quarter = std::ceil(t) - 1.0;
    const double to =
      Pi / 2 * quarter + Pi / 4 + 2.0 * std::atan((2.0 * (t - quarter) - 1.0) * std::tan(Pi / 8));
    const double reach = 4.0 / 3.0 * std::tan((to - from) / 4.0);
    const double x[4] = { std::cos(from), std::cos(from) - reach * std::sin(from),
      std::cos(to) + reach * std::sin(to), std::cos(to) };
    const double y[4] = { std::sin(from), std::sin(from) + reach * std::cos(from),
      std::sin(to) - reach * std::cos(to), std::sin(to) };
    Point3 points[4];
    for (int i = 0; i < 4; ++i)
    {
      for (int d = 0; d < 3; ++d)
      {
        points[i][d] = radius * (x[i] * a[d] + y[i] * b[d]);
      }
    }
    curve.AppendPiece(t, points, 3);
    from = to;
  }
  return curve;
}

/// Largest distance of MakeArc() from the circle: 4/27 sin^6(x/4) / cos^2(x/4) radii where a piece spans the
/// angle x, here at most 1.1 times its mean.
double GetArcResidual(double radius)
{
  const double x = 1.1 * Pi / 2.0 / PiecesPerQuarter;
  return radius * 4.0 / 27.0 * std::pow(std::sin(x / 4.0), 6) / std::pow(std::cos(x / 4.0), 2);
}

EdgePointer MakeEdge(const sm::EdgeCurve& curve)
{
  auto edge = std::make_shared<sm::Edge>();
  edge->Id = sm::NewId();
  edge->Curve = curve;
  edge->StartVertex = curve.GetStartPoint();
  edge->EndVertex = curve.GetEndPoint();
  edge->Degenerate = curve.Coefficients.size() == 1;
  return edge;
}

/// The curve that stays at a point from 0 to `end`.
sm::EdgeCurve MakePoint(double end, const Point3& point)
{
  sm::EdgeCurve curve;
  curve.Breaks = { 0.0 };
  curve.AppendPiece(end, &point, 0);
  return curve;
}

/// A coedge along the straight line from `start` to `end` in (u,v), over the parameter range of its edge.
sm::Coedge MakeStraightCoedge(const EdgePointer& edge, bool reversed, const Point2& start, const Point2& end)
{
  const Point2 points[2] = { start, end };
  sm::Coedge coedge{ edge, reversed, {} };
  coedge.Curve.Breaks = { edge->Curve.GetStart() };
  coedge.Curve.AppendPiece(edge->Curve.GetEnd(), points, 1);
  return coedge;
}

/// The coedge of an edge in the plane z = 0, where x and y are the parameters.
sm::Coedge MakePlaneCoedge(const EdgePointer& edge, bool reversed, double residual)
{
  sm::Coedge coedge{ edge, reversed, {} };
  coedge.Curve.Breaks = edge->Curve.Breaks;
  coedge.Curve.Offsets = edge->Curve.Offsets;
  for (const Point3& p : edge->Curve.Coefficients)
  {
    coedge.Curve.Coefficients.push_back({ p[0], p[1] });
  }
  coedge.Curve.Residual.fill(residual);
  return coedge;
}

sm::FacePointer MakeFace(const sm::NURBSSurface& surface, bool reversed, const sm::Loop& loop)
{
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->Surface = surface;
  face->Reversed = reversed;
  face->Loops = { loop };
  return face;
}

vtkSmartPointer<vtkNURBSDataSet> MakeHalfBall(double r)
{
  // [half a ball]
  // The hemisphere: u runs around the axis, one unit for a quarter, v from the equator to the pole. Weights
  // are homogeneous.
  const double h = std::sqrt(0.5);
  const int x[9] = { 1, 1, 0, -1, -1, -1, 0, 1, 1 }, y[9] = { 0, 1, 1, 1, 0, -1, -1, -1, 0 };
  std::vector<std::array<double, 4>> points;
  for (const auto& [rho, z, weight] : { Point3{ r, 0, 1 }, Point3{ r, r, h }, Point3{ 0, r, 1 } })
  {
    for (int i = 0; i < 9; ++i)
    {
      const double w = weight * (i % 2 == 0 ? 1.0 : h);
      points.push_back({ w * rho * x[i], w * rho * y[i], w * z, w });
    }
  }
  const sm::NURBSSurface sphere{ { 2, 2 }, { { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 }, { 0, 0, 0, 1, 1, 1 } },
    { 9, 3 }, points, true };
  // The plane z = 0 with x and y as parameters, larger than the disc that is trimmed out of it.
  const double a = 1.5 * r;
  const sm::NURBSSurface plane{ { 1, 1 }, { { -a, -a, a, a }, { -a, -a, a, a } }, { 2, 2 },
    { { -a, -a, 0, 1 }, { a, -a, 0, 1 }, { -a, a, 0, 1 }, { a, a, 0, 1 } } };
  // The equator belongs to both faces, the seam is used twice by the hemisphere, the pole is a point.
  const EdgePointer equator = MakeEdge(MakeArc(r, 4, { 1, 0, 0 }, { 0, 1, 0 }));
  const EdgePointer seam = MakeEdge(MakeArc(r, 1, { 1, 0, 0 }, { 0, 0, 1 }));
  const EdgePointer pole = MakeEdge(MakePoint(4.0, { 0, 0, r }));
  // Loops run counter-clockwise in (u,v). The outward normal of the disc is -z, against Su x Sv: that face is
  // reversed.
  const sm::Loop around{ { MakeStraightCoedge(equator, false, { 0, 0 }, { 4, 0 }),
    MakeStraightCoedge(seam, false, { 4, 0 }, { 4, 1 }), MakeStraightCoedge(pole, true, { 0, 1 }, { 4, 1 }),
    MakeStraightCoedge(seam, true, { 0, 0 }, { 0, 1 }) } };
  const sm::Loop rim{ { MakePlaneCoedge(equator, false, GetArcResidual(r)) } };
  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetFaces({ MakeFace(sphere, false, around), MakeFace(plane, true, rim) });
  const auto halfBall = vtkSmartPointer<vtkNURBSDataSet>::New();
  halfBall->SetModel(model);
  // [half a ball]
  return halfBall;
}

bool IsWithin(const char* what, double value, double bound, double exact)
{
  std::cout << what << " " << value << " +/- " << bound << ", closed form " << exact << ", difference "
            << value - exact << "\n";
  return std::abs(value - exact) <= bound;
}
}

int main(int argc, char** argv)
{
  const char* const usage = "usage: BuildByHand [RADIUS], above 0 and below 1e6\n";
  if (argc == 2 && (argv[1] == std::string("--help") || argv[1] == std::string("-h")))
  {
    std::cout << usage;
    return 0;
  }
  char* end = nullptr;
  const double r = argc == 2 ? std::strtod(argv[1], &end) : 10.0;
  if (argc > 2 || (end && *end != '\0') || !(r > 0.0 && r < 1e6))
  {
    std::cerr << usage;
    return 1;
  }
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputData(MakeHalfBall(r));
  mass->Update();
  std::cout.precision(15);
  const bool volume =
    IsWithin("volume", mass->GetVolume(), mass->GetVolumeBound(), 2.0 / 3.0 * Pi * r * r * r);
  const bool area = IsWithin("area", mass->GetSurfaceArea(), mass->GetSurfaceAreaBound(), 3.0 * Pi * r * r);
  double center[3];
  mass->GetCenterOfMass(center);
  const bool height =
    IsWithin("height of the centre", center[2], mass->GetCenterOfMassBound(), 3.0 / 8.0 * r);
  std::cout << "status " << mass->GetStatus() << "\n";
  return volume && area && height && mass->GetStatus() == "ok" ? 0 : 3;
}
