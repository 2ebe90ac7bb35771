// Largest magnitudes of integrals over patches with weights of 1 to 1e12: they are finite, no less than the
// area and the flux of a fine triangulation, and no more than the degrees times those of the box of the
// control points.
#include "smQuadraturePlan.h"
#include "smTesting.h"
#include "smVector.h"

#include <array>
#include <cmath>
#include <memory>
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

/// Residuals of curves count along ribbons without an ellipse, too.
void CheckResidual(double exponent, std::mt19937_64& random)
{
  sm::Face face = MakePatchFace(3, 3, 0.0, random);
  // Next to a corner of weight 1.
  for (std::size_t i = 1; i < face.Surface.ControlPoints.size(); ++i)
  {
    for (double& coordinate : face.Surface.ControlPoints[i])
    {
      coordinate *= std::pow(10.0, exponent);
    }
  }
  const std::array<double, 2> corners[5] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0 } };
  sm::Loop loop;
  for (int i = 0; i < 4; ++i)
  {
    auto edge = std::make_shared<sm::Edge>();
    std::array<double, 3> ends[2];
    for (int k = 0; k < 2; ++k)
    {
      face.Surface.Evaluate(corners[i + k][0], corners[i + k][1], ends[k].data(), nullptr, nullptr);
    }
    edge->StartVertex = ends[0];
    edge->EndVertex = ends[1];
    edge->Curve.Breaks = { 0.0 };
    edge->Curve.AppendPiece(1.0, ends, 1);
    sm::Coedge coedge;
    coedge.Use = edge;
    coedge.Curve.Breaks = { 0.0 };
    coedge.Curve.AppendPiece(1.0, corners + i, 1);
    loop.Coedges.push_back(coedge);
  }
  face.Loops.push_back(loop);
  sm::PlanRequest request;
  request.Classes = { { sm::BoundClass::VolumeMoment, 0 }, { sm::BoundClass::AreaMoment, 0 } };
  request.Tolerances = { 1e-9, 1e-9 };
  const double exact = sm::PlanFace(face, sm::BuildFacePanels(face), request).ResidualBound[0];
  for (sm::Coedge& coedge : face.Loops[0].Coedges)
  {
    coedge.Curve.Residual = { 1e-30, 1e-30 };
  }
  const double fitted = sm::PlanFace(face, sm::BuildFacePanels(face), request).ResidualBound[0];
  const std::string label = "weights of 1 to 1e" + std::to_string(static_cast<int>(exponent));
  smtest::CheckEqual(label + ", exact curves", 0.0, exact);
  // The residual is far below the surface's size, 1, but where no ellipse exists it counts as much as the
  // surface.
  smtest::CheckRange(
    label + ", fitted curves", exponent < 1.0 ? 1e-31 : 1.0, fitted, exponent < 1.0 ? 1e-27 : 1e4);
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
  for (const double exponent : { 0.0, 15.0 })
  {
    CheckResidual(exponent, random);
  }
  return smtest::Finish();
}
