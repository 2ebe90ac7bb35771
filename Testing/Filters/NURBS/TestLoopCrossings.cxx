// Loops that cross themselves or each other are distinguished from loops that touch, and from overlaps below
// the tolerances.
#include "smLoopCrossings.h"
#include "smTesting.h"

#include <cmath>

namespace
{
using namespace smtest;
using Point2 = std::array<double, 2>;
using Polygon = std::vector<Point2>;

/// A plane with 10 mm per unit of u and v, and with loops of straight coedges.
sm::Face MakePolygonFace(const std::vector<Polygon>& polygons, double tolerance = 0.0)
{
  sm::Face face;
  face.Surface.Knots[0] = face.Surface.Knots[1] = { -10.0, -10.0, 10.0, 10.0 };
  face.Surface.NumberOfControlPoints[0] = face.Surface.NumberOfControlPoints[1] = 2;
  for (const double y : { -100.0, 100.0 })
  {
    face.Surface.ControlPoints.push_back({ -100.0, y, 0.0, 1.0 });
    face.Surface.ControlPoints.push_back({ 100.0, y, 0.0, 1.0 });
  }
  for (const Polygon& polygon : polygons)
  {
    sm::Loop loop;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      auto edge = std::make_shared<sm::Edge>();
      edge->Tolerance = tolerance;
      sm::Coedge coedge;
      coedge.Use = edge;
      coedge.Curve.Breaks = { 0.0 };
      const Point2 ends[2] = { polygon[i], polygon[(i + 1) % polygon.size()] };
      coedge.Curve.AppendPiece(1.0, ends, 1);
      loop.Coedges.push_back(coedge);
    }
    face.Loops.push_back(loop);
  }
  return face;
}

/// Counter-clockwise, or clockwise with a negative radius.
Polygon MakeCircle(double x, double y, double radius, int n)
{
  Polygon circle;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2.0 * M_PI * i / n;
    circle.push_back({ x + std::abs(radius) * std::cos(angle), y + radius * std::sin(angle) });
  }
  return circle;
}

void CheckLoops(const char* name, bool crosses, const std::vector<Polygon>& polygons, double tolerance = 0.0)
{
  CheckEqual(name, crosses ? "crosses" : "does not cross",
    sm::HasWrongLoops(MakePolygonFace(polygons, tolerance)) ? "crosses" : "does not cross");
}

/// A loop whose last edge leads to a point next to the first one: behind their crossing it winds the wrong
/// way. It may where an edge that is none fills the gap, of at most a tenth of the face.
void CheckCorner()
{
  for (const double gap : { 0.02, 0.2 })
  {
    sm::Face face = MakePolygonFace({ { { -gap, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, -gap } } });
    for (const bool isFilled : { false, true })
    {
      auto last = std::make_shared<sm::Edge>();
      last->Degenerate = isFilled;
      face.Loops[0].Coedges.back().Use = last;
      const bool crosses = !isFilled || gap > 0.1;
      CheckEqual("a corner that crosses itself", crosses, sm::HasWrongLoops(face));
      const std::vector<bool> far = sm::AreFarFromLoops(face, { { -gap / 3, -gap / 3 }, { 0.5, 0.5 } });
      CheckTrue("  its middle counts, or not", far[0] == crosses && far[1]);
    }
  }
}

/// A loop without the edge along its upper side, as near a pole: the gap hides no hole that leaves the
/// face.
void CheckWideGap()
{
  for (const double x : { 0.5, 1.0 })
  {
    sm::Face face =
      MakePolygonFace({ { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, MakeCircle(x, 0.5, -0.2, 12) });
    face.Loops[0].Coedges.erase(face.Loops[0].Coedges.begin() + 2);
    CheckEqual("a hole next to a gap as wide as the face", x > 0.5, sm::HasWrongLoops(face));
  }
}

void CheckCurves()
{
  // Between two parabolas whose tops are at 0.1 and at half of `height`.
  for (const double height : { 0.4, 0.3 })
  {
    sm::Face face = MakePolygonFace({ { { 0, 0 }, { 1, 0 } } });
    for (int i = 0; i < 2; ++i)
    {
      const Point2 parabola[3] = { { 0.0, 0.0 }, { 0.5, i == 0 ? 0.2 : height }, { 1.0, 0.0 } };
      sm::Coedge& coedge = face.Loops[0].Coedges[i];
      coedge.Reversed = i == 1;
      coedge.Curve = {};
      coedge.Curve.Breaks = { 0.0 };
      coedge.Curve.AppendPiece(1.0, parabola, 2);
    }
    CheckTrue("a lens is not a crossing", !sm::HasWrongLoops(face));
    const sm::Loop hole = MakePolygonFace({ MakeCircle(0.5, 0.15, -0.03, 12) }).Loops[0];
    face.Loops.push_back(hole);
    CheckTrue("its hole crosses its border, or not", sm::HasWrongLoops(face) == (height < 0.4));
  }
}
}

int TestLoopCrossings(int, char*[])
{
  const Polygon square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  CheckLoops("a square", false, { square });
  CheckLoops("no loop", false, {});
  CheckLoops("a loop that turns back on itself", false, { { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 0 } } });
  CheckLoops("a figure of eight", true, { { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } } });
  CheckLoops("an unequal one", true, { { { 0, 0 }, { 1, 1 }, { 1, 0.9 }, { 0, 0.1 } } });
  CheckLoops("a loop that winds twice", true,
    { { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 1, 4 }, { 1, 1 }, { 3, 1 }, { 3, 3 }, { 0, 3 } } });
  CheckLoops("a loop that touches itself at a corner", false,
    { { { 0, 0 }, { 5, 5 }, { 10, 0 }, { 10, 10 }, { 5, 5 }, { 0, 10 } } });
  CheckLoops("one that crosses itself there", true,
    { { { 0, 0 }, { 5, 5 }, { 10, 10 }, { 10, 0 }, { 5, 5 }, { 0, 10 } } });
  CheckLoops("a corner on an edge", false, { { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 2, 0 }, { 0, 4 } } });
  CheckLoops("a corner through an edge", true, { { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 2, -0.5 }, { 0, 4 } } });
  CheckLoops("a slit", false, { { { 0, 0 }, { 4, 0 }, { 4, 2 }, { 2, 2 }, { 4, 2 }, { 4, 4 }, { 0, 4 } } });
  CheckLoops("a hole", false, { MakeCircle(0, 0, 5, 64), MakeCircle(1, 1, -1, 64) });
  // Loops that cross none, but lie where they must not.
  const Polygon border = { { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 } };
  CheckLoops("a hole in a hole", true, { border, MakeCircle(4, 4, -3, 64), MakeCircle(4, 4, -1, 64) });
  CheckLoops("an island in a hole", false, { border, MakeCircle(4, 4, -3, 64), MakeCircle(4, 4, 1, 64) });
  CheckLoops("a hole next to the border", true, { border, MakeCircle(12, 4, -1, 64) });
  CheckLoops("a small one, far away", true, { border, MakeCircle(90, 4, -0.5, 64) });
  CheckLoops("an island next to the border", false, { border, MakeCircle(12, 4, 1, 64) });
  CheckLoops("a hole that is reversed", true, { border, MakeCircle(4, 4, 1, 64) });
  CheckLoops("a border that is reversed", true, { { border.rbegin(), border.rend() } });
  CheckLoops("a hole around the border", true, { border, MakeCircle(4.5, 4.5, -9, 64) });
  std::vector<Polygon> sieve = { border };
  for (int i = 0; i < 64; ++i)
  {
    sieve.push_back(MakeCircle(1 + i % 8, 1 + i / 8, -0.4, 32));
  }
  CheckLoops("a sieve", false, sieve);
  sieve.push_back(MakeCircle(6, 7, -0.2, 32));
  CheckLoops("a sieve with a hole in a hole", true, sieve);
  CheckLoops("two holes that touch", false,
    { MakeCircle(0, 0, 5, 64), MakeCircle(1, 0, -1, 64), MakeCircle(-1, 0, -1, 64) });
  CheckLoops("two holes that overlap", true,
    { MakeCircle(0, 0, 5, 64), MakeCircle(0.9, 0, -1, 64), MakeCircle(-0.9, 0, -1, 64) });
  CheckLoops(
    "a hole that touches the outer loop", false, { MakeCircle(0, 0, 5, 64), MakeCircle(4, 0, -1, 64) });
  CheckLoops(
    "a hole that leaves the outer loop", true, { MakeCircle(0, 0, 5, 64), MakeCircle(4.2, 0, -1, 64) });
  CheckLoops(
    "beyond it by less than a thousandth", false, { MakeCircle(0, 0, 5, 64), MakeCircle(4.002, 0, -1, 64) });
  // The face is 100 mm wide, of which the tolerance excuses 0.1 mm at most.
  const auto overlap = [](double u) {
    return std::vector<Polygon>{ MakeCircle(0, 0, 5, 64), MakeCircle(4 + u, 0, -1, 64) };
  };
  CheckLoops("by more than a tolerance may excuse", true, overlap(0.2), 3.0);
  CheckLoops("a strip whose ends cross by a ten-thousandth of its length", false,
    { { { 0, 0 }, { 9, 1e-3 }, { 9, 0 }, { 0, 1e-3 } } });
  CheckCorner();
  CheckWideGap();
  CheckCurves();
  return Finish();
}
