// Loops cut where they turn in v: every part monotone, nothing lost, and few parts whatever rounding makes of
// a level curve.
#include "Detail/smTrimRises.h"
#include "smPaperReference.h"
#include "smSchemeFaces.h"
#include "smTesting.h"

#include <algorithm>
#include <random>

namespace
{
using namespace smtest;

std::vector<sm::TrimRise> Cut(const std::vector<sm::Loop>& loops)
{
  return sm::CutIntoRises(*MakeFace(sm::NURBSSurface(), loops));
}

/// The largest step against its direction that a rise takes, relative to its ends' distance in v.
double MeasureTurning(const sm::TrimRise& rise)
{
  const sm::BernsteinPiece<2> piece{ rise.data(), static_cast<int>(rise.size()) - 1 };
  const double height = rise.back()[1] - rise.front()[1];
  double worst = 0.0;
  double last = rise.front()[1];
  for (int i = 1; i <= 400; ++i)
  {
    const double v = piece.Evaluate(i / 400.0)[1];
    worst = std::max(worst, (last - v) / height);
    last = v;
  }
  return worst;
}

/// Signed crossings of the line at v right of u, by bisection on every rise.
int CountCrossings(const std::vector<sm::TrimRise>& rises, double u, double v)
{
  int winding = 0;
  for (const sm::TrimRise& rise : rises)
  {
    const double from = rise.front()[1];
    const double to = rise.back()[1];
    if (v < std::min(from, to) || v >= std::max(from, to))
    {
      continue;
    }
    const sm::BernsteinPiece<2> piece{ rise.data(), static_cast<int>(rise.size()) - 1 };
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 60; ++i)
    {
      const double x = 0.5 * (low + high);
      ((piece.Evaluate(x)[1] < v) == (from < to) ? low : high) = x;
    }
    winding += piece.Evaluate(low)[0] > u ? (from < to ? 1 : -1) : 0;
  }
  return winding;
}

/// Closed loops of random pieces that turn as they like, against the winding number of dense polygons.
void CheckRandomLoops()
{
  std::mt19937 random(54);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double turning = 0.0;
  int wrong = 0;
  int inside = 0;
  long long maximum = 0;
  for (int degree = 1; degree <= sm::MaximumDegree; ++degree)
  {
    sm::Loop loop;
    Point2 last = { unit(random), unit(random) };
    for (int k = 0; k < 4; ++k)
    {
      std::vector<Point2> b(degree + 1);
      for (Point2& p : b)
      {
        p = { 3.0 * unit(random), 3.0 * unit(random) };
      }
      // The third piece begins elsewhere, and the loop ends elsewhere than it begins.
      b.front() = k == 2 ? b.front() : last;
      last = b.back();
      loop.Coedges.push_back(MakeCoedge({ b }, k % 2 == 1));
    }
    const sm::FacePointer face = MakeFace(sm::NURBSSurface(), { loop });
    const std::vector<sm::TrimRise> rises = sm::CutIntoRises(*face);
    maximum = std::max(maximum, static_cast<long long>(rises.size()));
    for (const sm::TrimRise& rise : rises)
    {
      turning = std::max(turning, MeasureTurning(rise));
    }
    const PaperPolygons polygons = SamplePolygons(*face, 4000);
    for (int i = 0; i < 300; ++i)
    {
      const double u = 2.0 * unit(random);
      const double v = 2.0 * unit(random);
      const int winding = CountCrossings(rises, u, v);
      wrong += winding != GetWindingNumber(polygons, u, v) ? 1 : 0;
      inside += winding != 0 ? 1 : 0;
    }
  }
  // Where a rise begins at a turn, v is level to second order, and its values round.
  CheckRange("steps back, relative", 0.0, turning, 1e-12);
  CheckEqual("points with another winding number", 0, wrong);
  CheckRange("points with one", 500, inside, 5000);
  CheckRange("parts of four pieces and two closing ones", 6.0, static_cast<double>(maximum), 120.0,
    "a piece of degree 25 turns a few times, and halves");
}

void CheckParts()
{
  // v = 4 t (1 - t): one turn, at (1, 1).
  const std::vector<sm::TrimRise> hill =
    Cut({ sm::Loop{ { MakeCoedge({ { { 0.0, 0.0 }, { 1.0, 2.0 }, { 2.0, 0.0 } } }, false) } } });
  CheckEqual(
    "up and down, and a level closing piece that is left out", 2LL, static_cast<long long>(hill.size()));
  CheckTrue("they meet at the top", hill.at(0).back() == hill.at(1).front());
  Check("its height", 1.0, hill[0].back()[1], 4.5e-16);
  Check("its place", 1.0, hill[0].back()[0], 4.5e-16);
  const std::vector<sm::TrimRise> square =
    Cut({ MakePolygonLoop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } }), sm::Loop() });
  CheckTrue("level sides are left out",
    square == std::vector<sm::TrimRise>{ { { 1.0, 0.0 }, { 1.0, 1.0 } }, { { 0.0, 1.0 }, { 0.0, 0.0 } } });
  // v = (t - 1/2)^3: level at one place, and no turn.
  const double e = 1.0 / 8.0;
  const std::vector<sm::TrimRise> saddle =
    Cut({ sm::Loop{ { MakeCoedge({ { { 0.0, -e }, { 1.0, e }, { 2.0, -e }, { 3.0, e } } }, false) } } });
  CheckRange("a level place costs few parts", 3.0, static_cast<double>(saddle.size()), 90.0);
}

/// Curves that are level except for rounding fall apart into no more parts than halvings.
void CheckLevel()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const double noise : { 1e-16, 1e-15, 1e-14, 1e-13, 1e-10 })
  {
    std::size_t maximum = 0;
    for (int i = 0; i < 50; ++i)
    {
      std::vector<Point2> b(10);
      for (std::size_t j = 0; j < b.size(); ++j)
      {
        b[j] = { static_cast<double>(j), 1.0 + noise * unit(random) };
      }
      maximum = std::max(maximum, Cut({ sm::Loop{ { MakeCoedge({ b }, false) } } }).size());
    }
    CheckRange("parts of a level curve", 1.0, static_cast<double>(maximum), 60.0);
  }
}
}

int TestTrimRises(int, char*[])
{
  CheckRandomLoops();
  CheckParts();
  CheckLevel();
  return Finish();
}
