// Largest magnitudes of integrals over patches with weights of 1 to 1e12: they are finite, no less than the area and the flux of a fine
// triangulation, and no more than the degrees times those of the box of the control points.
#include "smQuadraturePlan.h"
#include "smTesting.h"
#include "smVector.h"

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{
constexpr int Steps = 96;

sm::Face MakePatchFace(int p, int q, double exponent, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  sm::Face face;
  const int degree[2] = { p, q };
  for (int d = 0; d < 2; ++d)
  {
    face.Surface.Degree[d] = degree[d];
    face.Surface.NumberOfControlPoints[d] = degree[d] + 1;
    face.Surface.Knots[d].assign(degree[d] + 1, 0.0);
    face.Surface.Knots[d].insert(face.Surface.Knots[d].end(), degree[d] + 1, 1.0);
  }
  face.Surface.Rational = true;
  for (int i = 0; i < (p + 1) * (q + 1); ++i)
  {
    const double w = std::pow(10.0, exponent * unit(random));
    face.Surface.ControlPoints.push_back(
      { w * (unit(random) + 5.0), w * (unit(random) - 0.5), w * (unit(random) - 0.5), w });
  }
  return face;
}

/// Parameters that are dense at both ends, where weights of 1e12 leave most of the surface.
double GetParameter(int i)
{
  const double x = 40.0 * (static_cast<double>(i) / Steps - 0.5);
  return i == 0 ? 0.0 : i == Steps ? 1.0 : 1.0 / (1.0 + std::exp(-x));
}

void CheckMagnitudes(int p, int q, double exponent, std::mt19937_64& random)
{
  const sm::Face face = MakePatchFace(p, q, exponent, random);
  const sm::FacePanels panels = sm::BuildFacePanels(face);
  sm::PlanRequest request;
  request.Classes = { { sm::BoundClass::VolumeMoment, 0 }, { sm::BoundClass::AreaMoment, 0 } };
  request.Tolerances = { 1e-9, 1e-9 };
  const sm::FacePlan plan = sm::PlanFace(face, panels, request);
  double area = 0.0;
  double flux = 0.0;
  std::vector<sm::Vector3> points;
  for (int j = 0; j <= Steps; ++j)
  {
    for (int i = 0; i <= Steps; ++i)
    {
      points.emplace_back();
      face.Surface.Evaluate(GetParameter(i), GetParameter(j), points.back().data());
    }
  }
  for (int j = 0; j < Steps; ++j)
  {
    for (int i = 0; i < Steps; ++i)
    {
      const sm::Vector3* a = &points[i + (Steps + 1) * j];
      for (const auto& [b, c] :
        { std::make_pair(a[1], a[Steps + 2]), std::make_pair(a[Steps + 2], a[Steps + 1]) })
      {
        const sm::Vector3 n = sm::Cross(sm::Subtract(b, *a), sm::Subtract(c, *a));
        area += 0.5 * sm::Norm(n);
        flux += sm::Dot(*a, n) / 6.0;
      }
    }
  }
  const std::string name =
    std::to_string(p) + " x " + std::to_string(q) + ", weights to 1e" + std::to_string(exponent);
  smtest::CheckTrue(
    name + ": area " + std::to_string(area) + " of at most " + std::to_string(plan.Magnitude[1]),
    area <= plan.Magnitude[1]);
  smtest::CheckTrue(
    name + ": flux " + std::to_string(flux) + " of at most " + std::to_string(plan.Magnitude[0]),
    std::abs(flux) <= plan.Magnitude[0]);
  // The unit box has a surface of 6, and no point is farther than 6.05 from the origin.
  smtest::CheckTrue(name + ": no more than the hull's",
    plan.Magnitude[1] <= 6.0 * p * q && plan.Magnitude[0] <= 6.0 * p * q * 6.05 / 3.0);
}
}

int TestHullBound(int, char*[])
{
  std::mt19937_64 random(1);
  for (const double exponent : { 3.0, 6.0, 12.0 })
  {
    for (int p = 1; p <= 4; ++p)
    {
      for (int q = p; q <= 4; ++q)
      {
        CheckMagnitudes(p, q, exponent, random);
      }
    }
  }
  return smtest::Finish();
}
