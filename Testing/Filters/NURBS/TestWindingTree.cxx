// Winding numbers about closed meshes: the hierarchy against the sum over all triangles, both against whole
// numbers, and the distance from the mesh against every triangle's.
#include "smTesting.h"
#include "smWindingTree.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace smtest;
using Triangles = std::vector<sm::MeshTriangle>;

/// A torus about the z axis. With tube > ring it is a spindle: the surface is its own continuation through
/// the axis, with its normal inwards, and does not wind about the points near its centre.
void AddTorus(double ring, double tube, int n, Triangles& triangles)
{
  const auto point = [=](int i, int j)
  {
    const double a = 2.0 * M_PI * i / n;
    const double b = 2.0 * M_PI * j / n;
    const double rho = ring + tube * std::cos(b);
    return sm::Vector3{ rho * std::cos(a), rho * std::sin(a), tube * std::sin(b) };
  };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      triangles.push_back({ { point(i, j), point(i + 1, j), point(i + 1, j + 1) }, 0.01 * (j % 5) });
      triangles.push_back({ { point(i, j), point(i + 1, j + 1), point(i, j + 1) }, 0.0 });
    }
  }
}

void CheckTorus(const char* name, double ring, double tube)
{
  std::printf("--- %s\n", name);
  Triangles triangles;
  AddTorus(ring, tube, 40, triangles);
  const sm::WindingTree tree(triangles);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-4.0, 4.0);
  double worst = 0.0;
  double exact = 0.0;
  int wrong = 0;
  int disagreements = 0;
  int far = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const sm::Vector3 p{ uniform(random), uniform(random), 0.5 * uniform(random) };
    const double quick = tree.EvaluateWindingNumber(p);
    const double slow = tree.EvaluateExactWindingNumber(p);
    worst = std::max(worst, std::abs(quick - slow));
    exact = std::max(exact, std::abs(slow - std::round(slow)));
    const double rho = std::hypot(p[0], p[1]);
    // In the half plane of p the torus is two circles.
    const double d[2] = { std::hypot(rho - ring, p[2]) - tube, std::hypot(rho + ring, p[2]) - tube };
    const bool isClear = std::min(std::abs(d[0]), std::abs(d[1])) > 0.05;
    wrong += isClear && std::round(slow) != (d[0] < 0.0 ? 1.0 : 0.0) - (d[1] < 0.0 ? 1.0 : 0.0) ? 1 : 0;
    const bool isFar = std::all_of(triangles.begin(), triangles.end(),
      [&p](const sm::MeshTriangle& t) { return sm::GetDistance(p, t.Corners) > t.Deviation + 0.1; });
    far += isFar ? 1 : 0;
    disagreements += isFar != tree.IsFarFrom(p, 0.1) ? 1 : 0;
  }
  CheckRange("the hierarchy's error: first order, from twice the radius", 1e-6, worst, 0.1);
  CheckRange("the sum is a whole number", 0.0, exact, 1e-9);
  CheckEqual("wrong winding numbers", 0, wrong);
  CheckEqual("points with another distance", 0, disagreements);
  CheckRange("points far from the mesh", 200.0, far, 990.0);
}

/// Counts along rays against the sums of solid angles, where they do not refuse.
void CheckCounts(const char* name, double ring, double tube)
{
  std::printf("--- counts about %s\n", name);
  Triangles triangles;
  AddTorus(ring, tube, 40, triangles);
  // Corners of the first and the last ring are the same up to rounding.
  CheckTrue("corners differ in bits", !sm::IsClosed(triangles));
  for (sm::MeshTriangle& triangle : triangles)
  {
    for (sm::Vector3& corner : triangle.Corners)
    {
      for (double& x : corner)
      {
        x = std::round(x * 1e9) * 1e-9;
      }
    }
  }
  CheckTrue("is closed", sm::IsClosed(triangles));
  const sm::WindingTree tree(triangles);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-4.0, 4.0);
  int wrong = 0;
  int refused = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const sm::Vector3 p{ uniform(random), uniform(random), 0.5 * uniform(random) };
    int number = 99;
    const bool isCounted = tree.CountCrossings(p, number);
    refused += isCounted ? 0 : 1;
    wrong += isCounted && number != std::round(tree.EvaluateExactWindingNumber(p)) ? 1 : 0;
  }
  CheckEqual("wrong counts", 0, wrong);
  CheckEqual("counts refused at points of no symmetry", 0, refused);
  // Just outside and just inside of triangles.
  for (std::size_t t = 0; t < triangles.size(); t += 7)
  {
    const auto& c = triangles[t].Corners;
    if (c[0][0] * c[1][0] + c[0][1] * c[1][1] < 0.0 || c[0][0] * c[2][0] + c[0][1] * c[2][1] < 0.0)
    {
      // Cells that the axis crosses lie on themselves.
      continue;
    }
    const sm::Vector3 n = sm::Cross(sm::Subtract(c[1], c[0]), sm::Subtract(c[2], c[0]));
    for (const double side : { 1e-7, -1e-7 })
    {
      sm::Vector3 p;
      for (int d = 0; d < 3; ++d)
      {
        p[d] = 0.21 * c[0][d] + 0.32 * c[1][d] + 0.47 * c[2][d] + side * n[d] / sm::Norm(n);
      }
      int number = 99;
      const bool isCounted = tree.CountCrossings(p, number);
      refused += isCounted ? 0 : 1;
      wrong += isCounted && number != std::round(tree.EvaluateExactWindingNumber(p)) ? 1 : 0;
    }
  }
  CheckEqual("wrong counts on triangles", 0, wrong);
  CheckRange("refused", 0.0, refused, 0.01 * static_cast<double>(triangles.size()));

  // A triangle less, one inverted, and a corner that is moved by a bit.
  Triangles open(triangles.begin() + 1, triangles.end());
  CheckTrue("a triangle is missing", !sm::IsClosed(open));
  open = triangles;
  std::swap(open[7].Corners[0], open[7].Corners[1]);
  CheckTrue("a triangle is inverted", !sm::IsClosed(open));
  open = triangles;
  open[7].Corners[0][0] = std::nextafter(open[7].Corners[0][0], 9.0);
  CheckTrue("a corner is moved", !sm::IsClosed(open));
}

/// A triangle in the plane z = 1, and one far away in the plane where the axis has the value `far`: the end
/// of the mesh that is nearest to points between them is at the first one.
sm::WindingTree MakeSteeredTree(int axis, double far)
{
  Triangles triangles{ { { { { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 } } }, 0.0 } };
  std::array<sm::Vector3, 3> corners{ { { -50, -50, -50 }, { 50, 50, 50 }, { -50, 50, 50 } } };
  for (sm::Vector3& corner : corners)
  {
    corner[axis] = far;
  }
  triangles.push_back({ corners, 0.0 });
  return sm::WindingTree(triangles);
}

void CheckRefusals()
{
  std::printf("--- rays that meet sides\n");
  const sm::WindingTree up = MakeSteeredTree(2, -50.0);
  const sm::WindingTree down = MakeSteeredTree(2, 50.0);
  int number = 99;
  const auto count = [&](const sm::Vector3& p, bool upwards)
  { return (upwards ? up : down).CountCrossings(p, number); };
  CheckTrue("from below, left through", count({ 0.3, 0.3, 0 }, true) && number == 1);
  CheckTrue("from above, entered through", count({ 0.3, 0.3, 2 }, false) && number == -1);
  CheckTrue("behind the ray", count({ 0.3, 0.3, 2 }, true) && number == 0);
  CheckTrue("off the triangle", count({ 0.7, 0.7, 0 }, true) && number == 0);
  CheckTrue("at a side: refused", !count({ 0.5, 0.5, 0 }, true));
  CheckTrue("at a corner: refused", !count({ 0, 0, 0 }, true));
  CheckTrue("at a side within rounding: refused", !count({ 0.3, 0.7, 0 }, true));
  CheckTrue("next to a side", count({ 1e-12, 0.5, 0 }, true) && number == 1);
  CheckTrue("next to a side, outside", count({ -1e-12, 0.5, 0 }, true) && number == 0);
  CheckTrue("on the triangle: refused", !count({ 0.3, 0.3, 1 }, true));
  CheckTrue("just below it", count({ 0.3, 0.3, 1 - 1e-12 }, true) && number == 1);
  // A wall along the ray.
  CheckTrue(
    "in the plane of a triangle: refused", !MakeSteeredTree(0, -50.0).CountCrossings({ -1, 0.3, 1 }, number));
  CheckTrue("far away", up.CountCrossings({ 5, 5, 5 }, number) && number == 0);
}

void CheckSmall()
{
  std::printf("--- small meshes\n");
  const sm::WindingTree none({});
  Check("no triangle", 0.0, none.EvaluateWindingNumber({ 1, 2, 3 }), 0.0);
  CheckTrue("no triangle is far", none.IsFarFrom({ 1, 2, 3 }, 1e9));
  const sm::Vector3 o{ 0, 0, 0 };
  const sm::Vector3 x{ 1, 0, 0 };
  const sm::Vector3 y{ 0, 1, 0 };
  const sm::Vector3 z{ 0, 0, 1 };
  const Triangles corner = { { { o, y, x } }, { { o, x, z } }, { { o, z, y } }, { { x, y, z } } };
  const sm::WindingTree tree(corner);
  Check("inside", 1.0, tree.EvaluateWindingNumber({ 0.1, 0.1, 0.1 }), 1e-14, "rounding");
  Check("on a face, without its triangle", 0.5, tree.EvaluateWindingNumber({ 0.2, 0.2, 0.0 }, 0), 1e-14,
    "rounding");
  const sm::WindingTree single({ corner[0] });
  Check("an octant's share of a face", 0.125, single.EvaluateWindingNumber({ 0, 0, 1e-9 }), 1e-8,
    "1e-9 above the corner");
  const sm::WindingTree points(Triangles(20, { { x, x, x } }));
  Check("triangles that are points", 0.0, points.EvaluateExactWindingNumber({ 1, 0, 0 }), 0.0);
}
}

int TestWindingTree(int, char*[])
{
  CheckTorus("a ring", 2.5, 1.0);
  CheckTorus("a spindle", 1.0, 1.8);
  CheckCounts("a ring", 2.5, 1.0);
  CheckCounts("a spindle", 1.0, 1.8);
  CheckRefusals();
  CheckSmall();
  return Finish();
}
