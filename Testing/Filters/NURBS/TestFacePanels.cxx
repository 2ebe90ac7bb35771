// Cutting into panels on a flat surface S(u,v) = (u, v, 0): the panels' signed areas must add up to the
// shoelace area of the trim polygons, for any loop, whichever knots and degrees.
#include "smFacePanels.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using Point2 = std::array<double, 2>;

std::vector<double> MakeKnots(int degree, const std::vector<double>& breaks)
{
  std::vector<double> knots(degree, breaks.front());
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), degree, breaks.back());
  return knots;
}

/// The identity on the domain as a B-spline: control points at the Greville abscissae.
sm::NURBSSurface MakePlane(
  int degreeU, int degreeV, const std::vector<double>& u, const std::vector<double>& v)
{
  sm::NURBSSurface surface;
  surface.Degree[0] = degreeU;
  surface.Degree[1] = degreeV;
  surface.Knots[0] = MakeKnots(degreeU, u);
  surface.Knots[1] = MakeKnots(degreeV, v);
  for (int d = 0; d < 2; ++d)
  {
    surface.NumberOfControlPoints[d] = static_cast<int>(surface.Knots[d].size()) - surface.Degree[d] - 1;
  }
  const auto greville = [&surface](int direction, int i)
  {
    double sum = 0.0;
    for (int k = 1; k <= surface.Degree[direction]; ++k)
    {
      sum += surface.Knots[direction][i + k];
    }
    return sum / surface.Degree[direction];
  };
  for (int j = 0; j < surface.NumberOfControlPoints[1]; ++j)
  {
    for (int i = 0; i < surface.NumberOfControlPoints[0]; ++i)
    {
      surface.ControlPoints.push_back({ greville(0, i), greville(1, j), 0.0, 1.0 });
    }
  }
  return surface;
}

/// A loop of straight coedges whose edges lie exactly on the surface. Every other one runs against its edge.
sm::Loop MakePolygon(const std::vector<Point2>& corners)
{
  sm::Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    Point2 ends[2] = { corners[i], corners[(i + 1) % corners.size()] };
    sm::Coedge coedge;
    coedge.Reversed = i % 2 == 1;
    if (coedge.Reversed)
    {
      std::swap(ends[0], ends[1]);
    }
    auto edge = std::make_shared<sm::Edge>();
    edge->Id = sm::NewId();
    edge->StartVertex = { ends[0][0], ends[0][1], 0.0 };
    edge->EndVertex = { ends[1][0], ends[1][1], 0.0 };
    const std::array<double, 3> line[2] = { edge->StartVertex, edge->EndVertex };
    edge->Curve.Breaks = { 0.0 };
    edge->Curve.AppendPiece(1.0, line, 1);
    coedge.Use = edge;
    coedge.Curve.Breaks = { 0.0 };
    coedge.Curve.AppendPiece(1.0, ends, 1);
    loop.Coedges.push_back(coedge);
  }
  return loop;
}

/// Where the vertices of two edges that follow each other differ, the way between them leads by the end of
/// the second curve.
void CheckOpenCorner(const sm::NURBSSurface& plane)
{
  constexpr double apart = 1e-6;
  constexpr double off = 1e-3;
  sm::Face face;
  face.Id = sm::NewId();
  face.Surface = plane;
  face.Loops = { MakePolygon({ { 0.5, 0.25 }, { 3, 0.25 }, { 3, 2 }, { 0.5, 2 } }) };
  smtest::Check("edges that meet", 0.0, sm::BuildFacePanels(face).OpenCorners, 0.0);
  auto second = std::make_shared<sm::Edge>(*face.Loops[0].Coedges[1].Use);
  // It runs against its edge, whose end is its start.
  second->EndVertex[2] += off;
  face.Loops[0].Coedges[1].Use = second;
  auto first = std::make_shared<sm::Edge>(*face.Loops[0].Coedges[0].Use);
  first->EndVertex[2] += off + apart;
  face.Loops[0].Coedges[0].Use = first;
  const double side = off + apart + off;
  smtest::Check("vertices off the curve's end", side * side, sm::BuildFacePanels(face).OpenCorners,
    1e-12 * side, "the square of both distances");
}

double GetPolygonArea(const std::vector<Point2>& p)
{
  long double sum = 0.0L;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const Point2& a = p[i];
    const Point2& b = p[(i + 1) % p.size()];
    sum += (static_cast<long double>(a[0]) * b[1] - static_cast<long double>(b[0]) * a[1]) / 2.0L;
  }
  return static_cast<double>(sum);
}

/// Sum of the panels' areas in (u,v): each is the integral of s dr, exact with 2 Simpson-like points for
/// lines.
double SumPanels(const sm::FacePanels& panels)
{
  double area = 0.0;
  for (const sm::Panel& panel : panels.Panels)
  {
    const sm::Patch& patch = panels.Patches[panel.Patch];
    const double* c = panels.Coefficients.data() + panel.Trim;
    double ends[2][2];
    for (int side = 0; side < 2; ++side)
    {
      const double t = side == 0 ? panel.Start : panel.End;
      for (int d = 0; d < 2; ++d)
      {
        const double x = (1.0 - t) * c[d] + t * c[2 + d];
        ends[side][d] = (x - patch.Start[d]) / patch.Width[d];
      }
    }
    const double value = 0.5 * (ends[0][0] + ends[1][0]) * (ends[1][1] - ends[0][1]);
    area += (panel.Negative ? -1.0 : 1.0) * value * patch.Width[0] * patch.Width[1];
  }
  return area;
}

void CheckLoops(const std::string& name, const sm::NURBSSurface& surface,
  const std::vector<std::vector<Point2>>& polygons, int defects)
{
  sm::Face face;
  face.Id = sm::NewId();
  face.Surface = surface;
  double expected = 0.0;
  for (const std::vector<Point2>& polygon : polygons)
  {
    face.Loops.push_back(MakePolygon(polygon));
    expected += GetPolygonArea(polygon);
  }
  const sm::FacePanels panels = sm::BuildFacePanels(face);
  const double scale = std::abs(surface.GetDomainEnd(0) * surface.GetDomainEnd(1)) + 1.0;
  smtest::Check(name, expected, SumPanels(panels), 64 * 1.1e-16 * scale, "rounding of a sum over the panels");
  if (defects >= 0)
  {
    smtest::CheckEqual(
      name + ": defects of coverage", static_cast<long long>(defects), panels.CoverageDefects);
  }
}

/// Trims that leave the domain by rounding belong to the nearest cell, whose polynomial goes on.
void CheckRounding(const std::string& name, const sm::NURBSSurface& plane)
{
  for (const double by : { 4e-16, 1e-12 })
  {
    const std::vector<Point2> loop = { { -by, -1 - by }, { 4 + by, -1 + by }, { 4 - by, 3 + by },
      { by, 3 - by } };
    CheckLoops(name + "leaving the domain by rounding", plane, { loop }, 0);
    sm::Face face;
    face.Surface = plane;
    face.Loops.push_back(MakePolygon(loop));
    // In space: the surface is the identity, a cell's diameter over its width at most 6.
    smtest::CheckRange("  and how far is reported", by, sm::BuildFacePanels(face).Outside.Distance, 8.0 * by);
  }
}

/// A curve on a rational patch that leads beyond the domain between its ends: the bound against dense points.
void CheckOverhang()
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const double by : { 1e-9, 1e-4, 1e-2 })
  {
    for (int k = 0; k < 20; ++k)
    {
      const double h = std::sqrt(0.5);
      sm::NURBSSurface surface{ { 2, 3 }, { { 0, 0, 0, 1, 1, 1 }, { 0, 0, 0, 0, 1, 1, 1, 1 } }, { 3, 4 }, {},
        true };
      for (int j = 0; j < 4; ++j)
      {
        for (int i = 0; i < 3; ++i)
        {
          const double w = (i == 1 ? h : 1.0) * (1.0 + 0.2 * uniform(random));
          surface.ControlPoints.push_back(
            { w * (i + 0.3 * uniform(random)), w * (j + 0.3 * uniform(random)), w * uniform(random), w });
        }
      }
      const std::vector<Point2> curve = { { 0.1, 1.0 - by }, { 0.5, 1.0 + 3.0 * by }, { 0.9, 1.0 - by } };
      std::vector<std::array<double, 4>> points;
      const sm::Patch patch = sm::MakePatch(surface, 0.0, 1.0, 0.0, 1.0, points);
      const sm::BernsteinPiece<2> piece{ curve.data(), 2 };
      const sm::Overhang bound = sm::BoundOverhang(patch, points.data(), piece, 0.0, 1.0, { 0, 0 }, { 1, 1 });
      double farthest = 0.0;
      for (int i = 0; i <= 1000; ++i)
      {
        const Point2 at = piece.Evaluate(i / 1000.0);
        double ds[3];
        double dr[3];
        double beyond[3];
        double border[3];
        sm::EvaluatePatch(patch, points.data(), at[0], at[1], beyond, ds, dr);
        sm::EvaluatePatch(patch, points.data(), at[0], std::min(at[1], 1.0), border, ds, dr);
        farthest =
          std::max(farthest, std::hypot(beyond[0] - border[0], beyond[1] - border[1], beyond[2] - border[2]));
      }
      smtest::CheckRange("overhang by " + std::to_string(by), farthest, bound.Distance, 12.0 * farthest);
      smtest::CheckRange("its squared integral", 0.0, bound.Squared, 10.0 * bound.Distance * bound.Distance);
      const std::vector<Point2> inside = { { 0, 0 }, { 1, 1 }, { 1, 0 } };
      smtest::CheckEqual("none inside", true,
        sm::BoundOverhang(patch, points.data(), { inside.data(), 2 }, 0.0, 1.0, { 0, 0 }, { 1, 1 })
            .Distance == 0.0);
    }
  }
}

std::vector<Point2> MakeStar(
  std::mt19937& random, double x, double y, double radius, int corners, bool clockwise)
{
  std::uniform_real_distribution<double> share(0.4, 1.0);
  std::vector<Point2> star;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * 3.14159265358979 * (clockwise ? corners - i : i) / corners;
    const double r = radius * share(random);
    star.push_back({ x + r * std::cos(angle), y + r * std::sin(angle) });
  }
  return star;
}
}

int TestFacePanels(int, char*[])
{
  const std::vector<double> u = { 0.0, 0.5, 1.0, 2.0, 2.25, 4.0 };
  const std::vector<double> v = { -1.0, 0.0, 1.0, 1.5, 3.0 };
  const int degrees[4][2] = { { 1, 1 }, { 2, 3 }, { 3, 2 }, { 5, 1 } };
  std::mt19937 random(20101);
  for (const auto& degree : degrees)
  {
    const sm::NURBSSurface plane = MakePlane(degree[0], degree[1], u, v);
    const std::string name = "degrees " + std::to_string(degree[0]) + "," + std::to_string(degree[1]) + " ";

    sm::Face whole;
    whole.Surface = plane;
    smtest::Check(
      name + "untrimmed", 16.0, SumPanels(sm::BuildFacePanels(whole)), 1e-14, "a sum of 20 cells");

    CheckLoops(name + "domain's own border", plane, { { { 0, -1 }, { 4, -1 }, { 4, 3 }, { 0, 3 } } }, 0);
    CheckLoops(name + "along knot lines", plane, { { { 0.5, 0 }, { 2, 0 }, { 2, 1.5 }, { 0.5, 1.5 } } }, 0);
    CheckLoops(name + "corner on a grid point", plane, { { { 1, 1 }, { 3, 0.25 }, { 2.25, 2 } } }, 0);
    CheckLoops(name + "diagonal through grid points", plane, { { { 0, -1 }, { 2, 1 }, { 0, 3 } } }, 0);
    CheckLoops(name + "touching loops", plane,
      { { { 0.5, 0 }, { 1, 0 }, { 1, 1 }, { 0.5, 1 } }, { { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 } } }, 0);
    CheckLoops(name + "touching at a corner", plane,
      { { { 0.25, -0.75 }, { 1.5, -0.75 }, { 1.5, 0.5 } }, { { 1.5, 0.5 }, { 3.5, 1.0 }, { 1.5, 2.5 } } }, 0);
    CheckLoops(name + "holes touching at a corner of the grid", plane,
      { { { 0, -1 }, { 4, -1 }, { 4, 3 }, { 0, 3 } }, { { 1, 1 }, { 0.75, 0.25 }, { 0.25, 0.5 } },
        { { 1, 1 }, { 2.125, 2 }, { 3, 1.25 } } },
      0);
    CheckLoops(name + "a hole touching the border between its corners", plane,
      { { { 0, -1 }, { 4, -1 }, { 4, 3 }, { 0, 3 } }, { { 0, 1.25 }, { 1.75, 2 }, { 1.75, 0.5 } } }, 0);
    CheckLoops(name + "a loop through its own corner", plane,
      { { { 0.25, -0.5 }, { 2, 1 }, { 3.75, -0.5 }, { 3.75, 2.5 }, { 2, 1 }, { 0.25, 2.5 } } }, 0);
    CheckLoops(name + "three outer loops, one in the hole of another", plane,
      { { { 0.25, -0.75 }, { 3, -0.75 }, { 3, 2 }, { 0.25, 2 } },
        { { 0.75, -0.25 }, { 0.75, 1.75 }, { 2.75, 1.75 }, { 2.75, -0.25 } },
        { { 1.25, 0.25 }, { 2.125, 0.25 }, { 1.75, 1.25 } }, { { 3.25, 0 }, { 3.75, 0 }, { 3.5, 2.75 } } },
      0);
    CheckLoops(name + "tiny edges", plane,
      { { { 0.5, 0 }, { 3, 0 }, { 3, 1e-13 }, { 3 + 1e-15, 2e-13 }, { 3, 2 }, { 3, 2 }, { 0.5, 2 } } }, 0);
    CheckRounding(name, plane);
    CheckLoops(name + "outside the domain", plane, { { { -0.5, -0.5 }, { 5, 0.5 }, { 3, 3.5 } } }, -1);
    CheckLoops(name + "inside out", plane, { { { 0.5, 0 }, { 0.5, 2 }, { 3, 2 }, { 3, 0 } } }, -1);
    CheckLoops(
      name + "figure of eight", plane, { { { 0.25, 0 }, { 3.5, 2.5 }, { 3.5, 0 }, { 0.25, 2.5 } } }, -1);
    for (int i = 0; i < 50; ++i)
    {
      CheckLoops(name + "star with a hole " + std::to_string(i), plane,
        { MakeStar(random, 2.0, 1.0, 1.9, 3 + i, false), MakeStar(random, 2.0, 1.0, 0.7, 3 + i % 7, true) },
        0);
    }
  }

  CheckOverhang();
  CheckOpenCorner(MakePlane(1, 1, u, v));

  // A wrong model is refused by name, not integrated.
  sm::Face broken;
  broken.FileId = 77;
  broken.Surface = MakePlane(1, 1, u, v);
  broken.Surface.ControlPoints[3][3] = -1.0;
  std::string message;
  try
  {
    sm::BuildFacePanels(broken);
  }
  catch (const std::exception& error)
  {
    message = error.what();
  }
  smtest::CheckTrue("a negative weight names face and control point",
    message.find("#77") != std::string::npos && message.find("control point 3") != std::string::npos,
    message);
  return smtest::Finish();
}
