// Loops as polygons: every chord within the tolerance of its curve, few of them, and nothing lost where
// coedges do not meet.
#include "smSchemeFaces.h"
#include "smTesting.h"
#include "smTrimPolygons.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace smtest;

double Shoelace(const std::vector<Point2>& p)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const Point2& a = p[i];
    const Point2& b = p[(i + 1) % p.size()];
    sum += 0.5 * ((a[0] - p[0][0]) * (b[1] - p[0][1]) - (b[0] - p[0][0]) * (a[1] - p[0][1]));
  }
  return sum;
}

/// Minimum over the chord from a to b of the larger of |du| and |dv| in tolerances: convex, so thirds close
/// in on it.
double Distance(const Point2& p, const Point2& a, const Point2& b, const Point2& tolerance)
{
  const auto at = [&](double x)
  {
    return std::max(std::abs((1.0 - x) * a[0] + x * b[0] - p[0]) / tolerance[0],
      std::abs((1.0 - x) * a[1] + x * b[1] - p[1]) / tolerance[1]);
  };
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i)
  {
    const double third = (high - low) / 3.0;
    (at(low + third) < at(high - third) ? high : low) =
      at(low + third) < at(high - third) ? high - third : low + third;
  }
  return at(0.5 * (low + high));
}

/// The farthest that samples of a curve with increasing u are from its polygon, in tolerances.
double MeasureDistance(
  const sm::BernsteinPiece<2>& piece, const std::vector<Point2>& polygon, const Point2& tolerance)
{
  double farthest = 0.0;
  for (int i = 0; i <= 3000; ++i)
  {
    const Point2 p = piece.Evaluate(i / 3000.0);
    const auto after = std::lower_bound(polygon.begin() + 1, polygon.end() - 1, p,
      [](const Point2& a, const Point2& b) { return a[0] < b[0]; });
    const std::size_t chord = after - polygon.begin() - 1;
    double nearest = HUGE_VAL;
    for (std::size_t k = chord - std::min<std::size_t>(chord, 2); k < std::min(chord + 3, polygon.size() - 1);
         ++k)
    {
      nearest = std::min(nearest, Distance(p, polygon[k], polygon[k + 1], tolerance));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

/// N chords leave c by about |c''|/(8 N^2): what N must be where |c''| is largest, over the whole piece.
double CountUniformChords(const sm::BernsteinPiece<2>& piece, const Point2& tolerance)
{
  double largest = 0.0;
  const double h = 1e-3;
  for (int i = 0; i <= 998; ++i)
  {
    const Point2 a = piece.Evaluate(i * h), b = piece.Evaluate((i + 1) * h), c = piece.Evaluate((i + 2) * h);
    for (int d = 0; d < 2; ++d)
    {
      largest = std::max(largest, std::abs(a[d] - 2.0 * b[d] + c[d]) / (h * h) / (8.0 * tolerance[d]));
    }
  }
  return std::sqrt(largest);
}

void CheckRandomCurves()
{
  std::mt19937 random(36);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double farthest = 0.0;
  double leastUsed = HUGE_VAL;
  double maximumChords = 0.0;
  double bound = 0.0;
  for (int degree = 2; degree <= sm::MaximumDegree; ++degree)
  {
    for (const double tolerance : { 0.3, 1e-2, 1e-4 })
    {
      std::vector<Point2> b(degree + 1);
      for (int i = 0; i <= degree; ++i)
      {
        // With increasing u: no two parts of the curve come near each other.
        b[i] = { 1000.0 + i + 0.3 * unit(random), 5.0 * unit(random) };
      }
      sm::Loop loop;
      loop.Coedges.push_back(MakeCoedge({ b }, degree % 2 == 1));
      const Point2 both = { tolerance, 0.5 * tolerance };
      const sm::TrimPolygons polygons = sm::FlattenLoops(*MakeFace(sm::NURBSSurface(), { loop }), both);
      const std::vector<Point2>& polygon = polygons.Loops.front();
      const double distance = MeasureDistance({ b.data(), degree }, polygon, both);
      farthest = std::max(farthest, distance);
      bound = std::max({ bound, polygons.Deviation[0] / both[0], polygons.Deviation[1] / both[1] });
      if (polygon.size() > 20)
      {
        leastUsed = std::min(leastUsed, distance);
        maximumChords =
          std::max(maximumChords, (polygon.size() - 1) / CountUniformChords({ b.data(), degree }, both));
      }
    }
  }
  CheckRange(
    "largest distance of a chord, in tolerances", 0.0, farthest, 1.0 + 1e-9, "rounding of 1000 / 1e-4");
  CheckRange("its bound", farthest - 1e-9, bound, 1.0);
  // Second differences are within a factor of d(d-1) of |c''|, far nearer after some cuts: measured 0.14
  // and 1.1.
  CheckRange("smallest distance where there are many chords", 0.05, leastUsed, 1.0);
  CheckRange("chords / those of equal ones where |c''| is largest", 0.0, maximumChords, 1.6);
}

void CheckLeafPolygons()
{
  const sm::Loop outer = MakeLeaf(3.0, 2.0, 2.0, 0.2, false);
  const sm::Loop hole = MakeLeaf(3.0, 2.0, 0.5, 0.1, true);
  const sm::FacePointer face = MakeFace(sm::NURBSSurface(), { outer, hole });
  for (const double tolerance : { 1e-2, 1e-4, 1e-6, 1e-8 })
  {
    const sm::TrimPolygons polygons = sm::FlattenLoops(*face, Point2{ tolerance, tolerance });
    CheckEqual("polygons", 2LL, static_cast<long long>(polygons.Loops.size()));
    const double area[2] = { GetLeafArea(2.0, 0.2), -GetLeafArea(0.5, 0.1) };
    for (int i = 0; i < 2; ++i)
    {
      const double found = Shoelace(polygons.Loops[i]);
      // Both enclose convex regions with corners on the curve: no area is won; and all is within sqrt 2
      // tolerance of the border, whose length is below 2 pi 2.2 (2 pi 0.6).
      const double limit = 1.415 * tolerance * 6.3 * (i == 0 ? 2.2 : 0.6);
      CheckRange(i == 0 ? "area within the leaf" : "area within the hole",
        area[i] - (i == 0 ? limit : 0.0) - 1e-13, found, area[i] + (i == 0 ? 0.0 : limit) + 1e-13,
        "a border as wide as the tolerance");
      // |c''| = 2 |b0 - 2 b1 + b2| = 4 bulge r in each coordinate (5 % for chord counts are powers of 2 times
      // at most 4).
      const double chords = 4.0 * std::sqrt(4.0 * (i == 0 ? 0.4 : 0.05) / (8.0 * tolerance));
      CheckRange("its chords", chords, static_cast<double>(polygons.Loops[i].size()), 2.1 * chords + 4.0,
        "smallest number for this |c''|, at most doubled by rounding up");
    }
  }
}

void CheckClosing()
{
  // The second coedge starts next to the end of the first, the loop ends next to its start.
  sm::Loop loop;
  loop.Coedges.push_back(MakeCoedge({ { { 0.0, 0.0 }, { 4.0, 0.0 } } }, false));
  loop.Coedges.push_back(
    MakeCoedge({ { { 4.0, 0.5 }, { 4.0, 3.0 } }, { { 4.0, 3.0 }, { 2.0, 3.5 } } }, true));
  loop.Coedges.push_back(MakeCoedge({ { { 2.0, 3.5 }, { 0.0, 3.0 } } }, false));
  sm::Loop nothing;
  const sm::TrimPolygons polygons =
    sm::FlattenLoops(*MakeFace(sm::NURBSSurface(), { loop, nothing }), Point2{ 1e-3, 1e-3 });
  const std::vector<Point2> expected = { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 0.5 }, { 4.0, 3.0 }, { 2.0, 3.5 },
    { 0.0, 3.0 } };
  CheckTrue("straight pieces close a loop", polygons.Loops[0] == expected);
  CheckTrue(
    "a loop without coedges is an empty polygon", polygons.Loops.size() == 2 && polygons.Loops[1].empty());
  CheckTrue("lines are exact", polygons.Deviation == Point2{ 0.0, 0.0 });
}

void CheckLimits()
{
  sm::Loop loop;
  loop.Coedges.push_back(MakeCoedge({ { { 0.0, 0.0 }, { 1.0, 2.0 }, { 2.0, 0.0 } } }, false));
  const sm::FacePointer face = MakeFace(sm::NURBSSurface(), { loop });
  const sm::TrimPolygons finest = sm::FlattenLoops(*face, Point2{ 1e-3, 0.0 });
  CheckRange("points at most", 60000.0, static_cast<double>(finest.Loops[0].size()), 65537.0);
  // v = 4 t (1 - t), |v''| = 8: 1 / N^2 of the tolerance's unit.
  Check("what 65536 chords leave", 1.0 / (65536.0 * 65536.0), finest.Deviation[1], 1e-13,
    "rounding of coordinates of 2");

  // Finer where u < 1/2 only: the tolerance of the box that a part is in.
  const sm::TrimPolygons local = sm::FlattenLoops(*face,
    [](const Point2& low, const Point2&) {
      return low[0] < 0.5 ? Point2{ 1e-6, 1e-6 } : Point2{ 1e-2, 1e-2 };
    });
  const std::vector<Point2>& p = local.Loops[0];
  const long long fine = std::count_if(p.begin(), p.end(), [](const Point2& x) { return x[0] < 0.5; });
  // A quarter of the parameter range at N = 1/sqrt(1e-6), the rest at 10 or, near the limit, halved until
  // clear of it.
  CheckRange("fine chords on their side", 250.0, static_cast<double>(fine), 260.0);
  CheckRange("coarse ones on theirs", 7.0, static_cast<double>(p.size() - fine), 40.0);
}
}

int TestTrimPolygons(int, char*[])
{
  CheckRandomCurves();
  CheckLeafPolygons();
  CheckClosing();
  CheckLimits();
  return Finish();
}
