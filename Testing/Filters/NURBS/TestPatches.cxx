// Patches of random rational B-spline surfaces: how far rounding moved them, and what bounds their
// derivatives, against the surface evaluated in extended precision by Cox and de Boor's recurrence.
#include "smFacePanels.h"
#include "smReferenceBernstein.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using smtest::Bernstein;
using smtest::BernsteinSlope;
using Real = long double;
using RealPoint = std::array<Real, 3>;

/// N_i^p(u) for u inside the knots' domain.
Real EvaluateBasis(const std::vector<double>& knots, int i, int p, Real u)
{
  if (p == 0)
  {
    return knots[i] <= u && u < knots[i + 1] ? 1 : 0;
  }
  Real value = 0;
  if (knots[i + p] > knots[i])
  {
    value +=
      (u - knots[i]) / (static_cast<Real>(knots[i + p]) - knots[i]) * EvaluateBasis(knots, i, p - 1, u);
  }
  if (knots[i + p + 1] > knots[i + 1])
  {
    value += (knots[i + p + 1] - u) / (static_cast<Real>(knots[i + p + 1]) - knots[i + 1]) *
      EvaluateBasis(knots, i + 1, p - 1, u);
  }
  return value;
}

RealPoint EvaluateSurface(const sm::NURBSSurface& surface, Real u, Real v)
{
  Real h[4] = {};
  for (int j = 0; j < surface.NumberOfControlPoints[1]; ++j)
  {
    for (int i = 0; i < surface.NumberOfControlPoints[0]; ++i)
    {
      const Real basis = EvaluateBasis(surface.Knots[0], i, surface.Degree[0], u) *
        EvaluateBasis(surface.Knots[1], j, surface.Degree[1], v);
      for (int c = 0; c < 4; ++c)
      {
        h[c] += basis * surface.ControlPoints[i + j * surface.NumberOfControlPoints[0]][c];
      }
    }
  }
  return { h[0] / h[3], h[1] / h[3], h[2] / h[3] };
}

/// Position, in model coordinates, and derivatives in s and r.
void EvaluatePatch(const sm::FacePanels& panels, const sm::Patch& patch, Real s, Real r, RealPoint x[3])
{
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  Real h[3][4] = {};
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      const Real factors[3] = { Bernstein(p, i, s) * Bernstein(q, j, r),
        BernsteinSlope(p, i, s) * Bernstein(q, j, r), Bernstein(p, i, s) * BernsteinSlope(q, j, r) };
      for (int k = 0; k < 3; ++k)
      {
        for (int c = 0; c < 4; ++c)
        {
          h[k][c] += factors[k] * panels.Points[patch.FirstPoint + i + (p + 1) * j][c];
        }
      }
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    const Real local = h[0][c] / h[0][3];
    x[0][c] = local + patch.Center[c];
    x[1][c] = (h[1][c] - local * h[1][3]) / h[0][3];
    x[2][c] = (h[2][c] - local * h[2][3]) / h[0][3];
  }
}

double Norm(const RealPoint& a)
{
  return static_cast<double>(std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]));
}

sm::Face MakeRandomFace(int p, int q, int spans, double weights, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  sm::Face face;
  sm::NURBSSurface& surface = face.Surface;
  surface.Degree[0] = p;
  surface.Degree[1] = q;
  for (int d = 0; d < 2; ++d)
  {
    std::vector<double>& knots = surface.Knots[d];
    knots.assign(surface.Degree[d] + 1, 0.1);
    for (int k = 1; k < spans; ++k)
    {
      knots.push_back(0.1 + k + 0.3 * uniform(random));
    }
    knots.insert(knots.end(), surface.Degree[d] + 1, 0.1 + spans);
    surface.NumberOfControlPoints[d] = static_cast<int>(knots.size()) - surface.Degree[d] - 1;
  }
  surface.Rational = weights > 1.0;
  for (int j = 0; j < surface.NumberOfControlPoints[1]; ++j)
  {
    for (int i = 0; i < surface.NumberOfControlPoints[0]; ++i)
    {
      const double w = std::pow(weights, 0.5 * (1.0 + uniform(random)));
      surface.ControlPoints.push_back({ w * (i + 0.4 * uniform(random) + 20.0),
        w * (j + 0.4 * uniform(random) - 7.0), w * 0.5 * uniform(random), w });
    }
  }
  return face;
}

/// From [0,1] to the span that starts at `start`. Not by the patch's Width, which is rounded: that moves
/// points along the surface only.
Real MapToSpan(const std::vector<double>& breaks, double start, Real x)
{
  const auto found = std::find(breaks.begin(), breaks.end(), start);
  return start + x * (static_cast<Real>(*(found + 1)) - start);
}

void CheckFace(int p, int q, int spans, double weights, std::mt19937& random)
{
  const std::string name = "degrees " + std::to_string(p) + "," + std::to_string(q) + ", " +
    std::to_string(spans) + " spans, weights up to " + std::to_string(static_cast<int>(weights)) + ": ";
  const sm::Face face = MakeRandomFace(p, q, spans, weights, random);
  const sm::FacePanels panels = sm::BuildFacePanels(face);
  smtest::Check(
    name + "patches", spans * spans, static_cast<double>(panels.Patches.size()), 0.0, "one a cell");
  double moved = 0.0;
  double sharp = 0.0;
  double stretch[2] = { 0.0, 0.0 };
  double normal = 0.0;
  for (const sm::Patch& patch : panels.Patches)
  {
    sharp = std::max(sharp, *std::max_element(patch.Displacement, patch.Displacement + 3) / patch.Radius);
    for (int k = 0; k < 49; ++k)
    {
      // (Not the upper knot lines: the recurrence belongs to half-open spans.)
      const Real s = (k % 7) / 6.5L;
      const Real r = (k / 7) / 6.5L;
      RealPoint x[3];
      EvaluatePatch(panels, patch, s, r, x);
      const RealPoint truth =
        EvaluateSurface(face.Surface, MapToSpan(face.Surface.GetSpanBreaks(0), patch.Start[0], s),
          MapToSpan(face.Surface.GetSpanBreaks(1), patch.Start[1], r));
      for (int c = 0; c < 3; ++c)
      {
        moved = std::max(moved, static_cast<double>(std::abs(x[0][c] - truth[c])) / patch.Displacement[c]);
        const int a = (c + 1) % 3;
        const int b = (c + 2) % 3;
        normal = std::max(
          normal, static_cast<double>(std::abs(x[1][a] * x[2][b] - x[1][b] * x[2][a])) / patch.Normal[c]);
      }
      for (int d = 0; d < 2; ++d)
      {
        stretch[d] = std::max(stretch[d], Norm(x[1 + d]) / patch.Stretch[d]);
      }
    }
  }
  const double one = 1.0 + 1e-14;
  const double minimum = weights > 10.0 ? 0.001 : 0.1;
  smtest::CheckRange(name + "displacement used", 0.0, moved, one, "(true displacement over Displacement)");
  smtest::CheckRange(
    name + "displacement", 0.0, sharp, 1e-16 * (6.0 + 4.0 * weights), "(over the radius: a rounding or two)");
  smtest::CheckRange(name + "Stretch of s used", minimum, stretch[0], one, "(|Ss| over Stretch)");
  smtest::CheckRange(name + "Stretch of r used", minimum, stretch[1], one, "(|Sr| over Stretch)");
  smtest::CheckRange(name + "Normal used", 0.0, normal, one, "(components of |Ss x Sr| over Normal)");
}
}

int TestPatches(int, char*[])
{
  std::mt19937 random(5);
  for (const double weights : { 1.0, 3.0, 1000.0 })
  {
    CheckFace(1, 1, 1, weights, random);
    CheckFace(1, 2, 3, weights, random);
    CheckFace(2, 2, 1, weights, random);
    CheckFace(3, 3, 4, weights, random);
    CheckFace(2, 7, 2, weights, random);
  }
  return smtest::Finish();
}
