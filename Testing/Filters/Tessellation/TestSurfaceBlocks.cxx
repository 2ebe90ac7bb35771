// The bound of a triangle's distance from its surface: never below what is sampled, and not far above it.
#include "smMeshMeasures.h"
#include "smSurfaceBlocks.h"
#include "smTesting.h"

#include <random>

namespace
{
using namespace smtest;

/// A quarter of a torus of radii 5 and 2 by circular arcs.
sm::NURBSSurface MakeTorus()
{
  const double h = std::sqrt(0.5);
  sm::NURBSSurface s;
  for (int d = 0; d < 2; ++d)
  {
    s.Degree[d] = 2;
    s.Knots[d] = { 0, 0, 0, 1, 1, 1 };
    s.NumberOfControlPoints[d] = 3;
  }
  s.Rational = true;
  const double ring[3][3] = { { 1, 0, 1 }, { 1, 1, h }, { 0, 1, 1 } };
  const double tube[3][3] = { { 7, 0, 1 }, { 7, 2, h }, { 5, 2, 1 } };
  for (const auto& t : tube)
  {
    for (const auto& r : ring)
    {
      const double w = r[2] * t[2];
      s.ControlPoints.push_back({ w * t[0] * r[0], w * t[0] * r[1], w * t[1], w });
    }
  }
  return s;
}

/// A net of the given degrees and spans with points near a paraboloid; weights up to 1 + `spread`. `crease`:
/// a knot of full multiplicity.
sm::NURBSSurface MakeRandom(std::mt19937& random, int degree, double spread, bool crease)
{
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::uniform_real_distribution<double> weight(1.0, 1.0 + spread);
  sm::NURBSSurface s;
  s.Rational = spread > 0.0;
  for (int d = 0; d < 2; ++d)
  {
    s.Degree[d] = degree;
    s.Knots[d].assign(degree + 1, 0.0);
    s.Knots[d].insert(s.Knots[d].end(), crease ? degree : 1, 1.0);
    s.Knots[d].insert(s.Knots[d].end(), degree + 1, 2.5);
    s.NumberOfControlPoints[d] = static_cast<int>(s.Knots[d].size()) - degree - 1;
  }
  for (int j = 0; j < s.NumberOfControlPoints[1]; ++j)
  {
    for (int i = 0; i < s.NumberOfControlPoints[0]; ++i)
    {
      const double x = i + jitter(random);
      const double y = j + jitter(random);
      const double w = weight(random);
      s.ControlPoints.push_back({ w * x, w * y, w * (0.1 * x * y + 0.05 * x * x + 0.2 * jitter(random)), w });
    }
  }
  return s;
}

/// The polynomial surface of MakeRandom() in one span, with u = 2 t / (1 + t) and so for v: weights from 1 to
/// 2^degree in both directions.
sm::NURBSSurface MakeUneven(std::mt19937& random, int degree)
{
  sm::NURBSSurface s = MakeRandom(random, degree, 0.0, false);
  for (int d = 0; d < 2; ++d)
  {
    s.Knots[d].assign(degree + 1, 0.0);
    s.Knots[d].insert(s.Knots[d].end(), degree + 1, 1.0);
  }
  const int columns = s.NumberOfControlPoints[0];
  std::vector<std::array<double, 4>> points;
  for (int j = 0; j <= degree; ++j)
  {
    for (int i = 0; i <= degree; ++i)
    {
      std::array<double, 4> p = s.ControlPoints[i + j * columns];
      for (double& x : p)
      {
        x *= std::exp2(i + j);
      }
      points.push_back(p);
    }
  }
  s.ControlPoints = points;
  s.NumberOfControlPoints[0] = s.NumberOfControlPoints[1] = degree + 1;
  s.Rational = true;
  return s;
}

/// The smallest and the largest ratio of the distance and its bound over random triangles of about `width`.
void CheckTriangles(const std::string& what, const sm::NURBSSurface& surface, double width, double minimum)
{
  sm::ParameterBox domain{ { surface.GetDomainStart(0), surface.GetDomainStart(1) },
    { surface.GetDomainEnd(0), surface.GetDomainEnd(1) } };
  const sm::SurfaceBlocks blocks(surface, domain);
  sm::NURBSSurface::Walker walker(surface);
  std::mt19937 random(3);
  double largest = 0.0;
  for (int n = 0; n < 2000; ++n)
  {
    std::array<double, 2> uv[3];
    sm::Vector3 corner[3];
    std::array<double, 2> start;
    for (int d = 0; d < 2; ++d)
    {
      start[d] = std::uniform_real_distribution<double>(domain.Low[d], domain.High[d] - width)(random);
    }
    sm::ParameterBox box;
    for (int k = 0; k < 3; ++k)
    {
      for (int d = 0; d < 2; ++d)
      {
        uv[k][d] = start[d] + std::uniform_real_distribution<double>(0.0, width)(random);
      }
      box = k == 0 ? sm::ParameterBox{ uv[0], uv[0] } : box;
      box.Add(uv[k]);
      walker.Evaluate(uv[k][0], uv[k][1], corner[k].data());
    }
    const double bound = blocks.GetError(box);
    for (const auto& w :
      { std::array<double, 3>{ 1. / 3, 1. / 3, 1. / 3 }, { .5, .5, 0 }, { 0, .5, .5 }, { .5, 0, .5 } })
    {
      sm::Vector3 p{ 0, 0, 0 };
      double at[2] = { 0, 0 };
      for (int k = 0; k < 3; ++k)
      {
        for (int c = 0; c < 3; ++c)
        {
          p[c] += w[k] * corner[k][c];
        }
        at[0] += w[k] * uv[k][0];
        at[1] += w[k] * uv[k][1];
      }
      largest = std::max(largest, FindDistance(walker, surface, p, at[0], at[1]) / bound);
    }
  }
  CheckRange(what, minimum, largest, 1.0, "a bound, and no idle one");
}
/// A sharp bend in a span that is a 100,000th of the face: boxes that end in it are charged for it.
void CheckThinSpan()
{
  sm::NURBSSurface s;
  s.Degree[0] = 2;
  s.Degree[1] = 1;
  s.Knots[0] = { 0, 0, 0, 0.5, 0.5, 0.50001, 0.50001, 1, 1, 1 };
  s.Knots[1] = { 0, 0, 1, 1 };
  s.NumberOfControlPoints[0] = 7;
  s.NumberOfControlPoints[1] = 2;
  const double profile[7][2] = { { -40, 0 }, { -20, 0 }, { 0, 0 }, { 10, 0 }, { 10, 10 }, { 10, 20 },
    { 10, 40 } };
  for (int j = 0; j < 2; ++j)
  {
    for (const auto& p : profile)
    {
      s.ControlPoints.push_back({ p[0], p[1], 10.0 * j, 1.0 });
    }
  }
  const sm::SurfaceBlocks blocks(s, { { 0.0, 0.0 }, { 1.0, 1.0 } });
  for (const auto& [low, high] : { std::make_pair(0.5, 0.500005), std::make_pair(0.4, 0.500004),
         std::make_pair(0.500002, 0.500008), std::make_pair(0.500006, 0.9), std::make_pair(0.3, 0.8) })
  {
    double ends[2][3];
    s.Evaluate(low, 0.0, ends[0]);
    s.Evaluate(high, 0.0, ends[1]);
    double farthest = 0.0;
    for (int i = 0; i <= 1000; ++i)
    {
      const double u = low + (high - low) * i / 1000;
      double p[3];
      s.Evaluate(u, 0.0, p);
      const double x[2] = { ends[1][0] - ends[0][0], ends[1][1] - ends[0][1] };
      farthest = std::max(
        farthest, std::abs(x[0] * (p[1] - ends[0][1]) - x[1] * (p[0] - ends[0][0])) / std::hypot(x[0], x[1]));
    }
    CheckRange(
      "a thin span: distance / bound", 0.0, farthest / blocks.GetError({ { low, 0.0 }, { high, 0.1 } }), 1.0);
  }
}
}

int TestSurfaceBlocks(int, char*[])
{
  std::mt19937 random(5);
  CheckTriangles("a torus", MakeTorus(), 0.1, 0.4);
  CheckTriangles("a torus, large triangles", MakeTorus(), 0.6, 0.2);
  for (const int degree : { 2, 3, 5 })
  {
    const std::string name = " of degree " + std::to_string(degree);
    CheckTriangles("polynomials" + name, MakeRandom(random, degree, 0.0, false), 0.2, 0.1);
    CheckTriangles("rational surfaces" + name, MakeRandom(random, degree, 0.5, false), 0.2, 0.05);
    CheckTriangles("surfaces with a crease" + name, MakeRandom(random, degree, 0.0, true), 0.2, 0.1);
  }
  CheckTriangles("weights from 1 to 64 in each direction", MakeUneven(random, 6), 0.05, 0.04);
  CheckThinSpan();
  return Finish();
}
