// The paper's schemes by their reference: exact to the degree they claim, Eq. 36 and the trim texture by
// hand, the shape of Fig. 7.
#include "Detail/smSubPatches.h"
#include "smPaperReference.h"
#include "smSchemeFaces.h"
#include "smTesting.h"

#include <vtkMath.h>

#include <cmath>

namespace
{
using namespace smtest;
double GetBinomial(int n, int k)
{
  return k == 0 ? 1.0 : GetBinomial(n - 1, k - 1) * n / k;
}

PaperResult IntegrateReference(
  const sm::FacePointer& face, int points, int factor, const PaperDeviation& deviation = {})
{
  PaperOptions options;
  options.Points = points;
  options.Factor = factor;
  options.Deviation = deviation;
  return IntegrateCurved(*face, SamplePolygons(*face, 64), options);
}

/// S = (u, v, u^i v^j) on the unit square has nz = 1 and V = 1 / ((i+1)(j+1)): n points are exact up to
/// degree 2n-1 in each direction and not beyond.
void CheckDegrees()
{
  constexpr int degree = 7;
  for (int i = 0; i <= degree; ++i)
  {
    for (int j = 0; j <= degree; ++j)
    {
      // u^i = sum_k C(k,i) / C(7,i) B_k.
      const sm::NURBSSurface surface = MakeSurface(degree, degree, { 0.0, 1.0 }, { 0.0, 1.0 },
        [i, j](int a, int b)
        {
          const double z = (a < i ? 0.0 : GetBinomial(a, i) / GetBinomial(degree, i)) *
            (b < j ? 0.0 : GetBinomial(b, j) / GetBinomial(degree, j));
          return std::array<double, 4>{ 1.0 * a / degree, 1.0 * b / degree, z, 1.0 };
        });
      for (int points = 1; points <= 3; ++points)
      {
        const std::string name =
          std::to_string(points) + " points, u^" + std::to_string(i) + " v^" + std::to_string(j);
        const PaperResult result = IntegrateReference(MakeFace(surface, {}), points, 1);
        const double error = std::abs(result.Integrals[0] - 1.0 / ((i + 1) * (j + 1)));
        const bool exact = i <= 2 * points - 1 && j <= 2 * points - 1;
        CheckRange(
          name, exact ? 0.0 : 1e-5, error, exact ? 1e-15 : 1.0, exact ? "rounding" : "too high a degree");
        // x z, x^2 z and x^2 y.. raise the degree in u by one and two.
        const double errorXX = std::abs(result.Integrals[4] - 1.0 / ((i + 3) * (j + 1)));
        const bool exactXX = i + 2 <= 2 * points - 1 && j <= 2 * points - 1;
        CheckRange(name + ", XX", exactXX ? 0.0 : 1e-5, errorXX, exactXX ? 1e-15 : 1.0);
      }
    }
  }
}

/**
 * Eq. 36 by hand. S = (u, v, 3 u^2 - 2 u v + v^2 / 2) on [0,4] x [0,1] with knots u = 0, 1, 4, and k = 2. In
 * the unit domain of a knot interval of width h in u (and 1 in v) the second derivatives of z are 6 h^2, -2 h
 * and 1, those of x and y are 0; so K = (6 h^2 / 4 + 2 (2 h) / 4 + 1 / 4) / 8, Eq. 4 with n = m = 2: h = 1: K
 * = (6 + 4 + 1) / 32 = 11/32;    h = 3: K = (54 + 12 + 1) / 32 = 67/32. nz = 1, so the 8 sub-patches add up
 * to 2 (11/32) 1 + 2 (67/32) 3 = 424/32 = 13.25, whatever the rule.
 */
void CheckEstimateOfParaboloid()
{
  const sm::NURBSSurface surface = MakeParaboloid(3.0, -2.0, 0.5, { 0.0, 1.0, 4.0 }, { 0.0, 1.0 });
  const sm::FacePointer face = MakeFace(surface, {}, true);
  for (const sm::DeviationMode mode : { sm::DeviationMode::Bounded, sm::DeviationMode::Sampled })
  {
    sm::SchemeOptions options;
    options.Deviation = mode;
    const sm::SubPatchFace prepared = sm::PrepareSubPatchFace(face, options);
    for (int column = 0; column < 4; ++column)
    {
      Check("K of column " + std::to_string(column), column < 2 ? 11.0 / 32.0 : 67.0 / 32.0,
        prepared.Deviations[column + 4], 2e-14, "rounding of coordinates of 48");
    }
    for (int points = 1; points <= 3; ++points)
    {
      const auto deviation = [mode](const sm::NURBSSurface& s, double u0, double u1, double v0, double v1)
      { return sm::ComputeDeviation(s, u0, u1, v0, v1, mode); };
      const PaperResult result = IntegrateReference(face, points, 2, deviation);
      Check("estimate, " + std::to_string(points) + " points", 13.25, result.Estimate, 1e-12, "rounding");
      CheckTrue(
        "nothing is on a boundary", result.Estimate == result.EstimateWithBoundary && result.SubPatches == 8);
    }
  }
  Check("the reference's own K", 13.25, IntegrateReference(face, 2, 2).Estimate, 1e-12, "rounding");
}

/**
 * Eq. 36 by hand of a rational arc: x = R (1-u^2)/(1+u^2), z = 2 R u / (1+u^2), y = L v. Differentiated,
 *   x'' = 4 R (3u^2 - 1)/(1+u^2)^3,   z'' = 4 R u (u^2 - 3)/(1+u^2)^3,   all others 0.
 * On [0,1] the largest is |x''(0)| = 4 R (|z''| is at most 2.915 R, at u = sqrt 2 - 1), so k = 1 has K = 4 R
 * / 8 = R/2. |nz| = L |x'| = 4 R L u / (1+u^2)^2, at the middle 4 (1/2) / (5/4)^2 = 1.28 R L: MIDPOINT's
 * estimate is 2 (R/2) 1.28 R L. For k = 2 the first half has K = R/8, the second |z''(1/2)| / 32 = 4 (1/2)
 * (11/4) / (5/4)^3 / 32 R = 2.816 R / 32 = 0.088 R. With R = 2, L = 3: 15.36; and with the middles 1/4, 3/4
 * of the halves, |x'| = R / (17/16)^2 = R 256/289 and 3 R / (25/16)^2 = R 768/625, each half 1/2 wide: R^2 L
 * (2 (1/8) (256/289) + 2 (0.088) (768/625)) / 2.
 */
void CheckEstimateOfArc()
{
  const sm::FacePointer face = MakeFace(MakeQuarterCylinder(2.0, 3.0), {});
  const double halves = 12.0 * (0.25 * 256.0 / 289.0 + 0.176 * 768.0 / 625.0) / 2.0;
  const auto sampled = [](const sm::NURBSSurface& s, double u0, double u1, double v0, double v1)
  { return sm::ComputeDeviation(s, u0, u1, v0, v1, sm::DeviationMode::Sampled); };
  const auto bounded = [](const sm::NURBSSurface& s, double u0, double u1, double v0, double v1)
  { return sm::ComputeDeviation(s, u0, u1, v0, v1, sm::DeviationMode::Bounded); };
  Check("sampled, k = 1", 15.36, IntegrateReference(face, 1, 1, sampled).Estimate, 1e-14 * 16, "rounding");
  Check("sampled, k = 2", halves, IntegrateReference(face, 1, 2, sampled).Estimate, 1e-14 * 4, "rounding");
  Check(
    "the reference's own K, k = 1", 15.36, IntegrateReference(face, 1, 1).Estimate, 1e-14 * 16, "rounding");
  Check(
    "the reference's own K, k = 2", halves, IntegrateReference(face, 1, 2).Estimate, 1e-14 * 4, "rounding");
  // Never below what it bounds, and of degree 2 hardly above.
  CheckRange(
    "bounded, k = 1", 15.36 * (1.0 - 1e-14), IntegrateReference(face, 1, 1, bounded).Estimate, 1.05 * 15.36);
  CheckRange("bounded, k = 2", halves * (1.0 - 1e-14), IntegrateReference(face, 1, 2, bounded).Estimate,
    1.05 * halves);
  const double fine = IntegrateReference(face, 1, 32, sampled).Estimate;
  CheckRange("bounded, k = 32", fine, IntegrateReference(face, 1, 32, bounded).Estimate, 1.001 * fine);
}

/// A half of the square u + v < 1.05 of one patch: of 4 x 4 texel centres (i + 1/2, j + 1/2)/4 it holds those
/// of i + j <= 3, that is 10.
void CheckReferenceTexture()
{
  const sm::NURBSSurface surface = MakeParaboloid(1.0, 1.0, 1.0, { 0.0, 1.0 }, { 0.0, 1.0 });
  const sm::Loop loop = MakePolygonLoop({ { 0.0, 0.0 }, { 1.05, 0.0 }, { 0.0, 1.05 } });
  const PaperResult whole = IntegrateReference(MakeFace(surface, {}), 2, 1);
  const PaperResult part = IntegrateReference(MakeFace(surface, { loop }), 2, 1);
  for (int i = 0; i < 14; ++i)
  {
    Check("10/16 of integral " + std::to_string(i), whole.Integrals[i] * 10.0 / 16.0, part.Integrals[i],
      1e-15, "rounding");
  }
  // a = b = c = 1: K = (2 + 2 + 2) / 8, twice that times nz = 1.
  Check("whole", 1.5, whole.Estimate, 1e-14, "by hand");
  Check("on a boundary, strictly", 0.0, part.Estimate, 0.0,
    "the paper counts sub-patches outside the trimmed region");
  Check("on a boundary, counted whole", 1.5, part.EstimateWithBoundary, 1e-14, "by hand");
  // k = 2: one sub-patch whole, two half, and the last with its corner texels within: 1.05 > (4.5 + 4.5) / 8
  // is false.
  const PaperResult four = IntegrateReference(MakeFace(surface, { loop }), 2, 2);
  Check("k = 2, strictly", 1.5 / 16.0, four.Estimate, 1e-14, "K/4, a quarter of the square");
  Check("k = 2, counted whole", 3.0 * 1.5 / 16.0, four.EstimateWithBoundary, 1e-14, "three quarters");
}

/// The paper's Fig. 7: a quarter cylinder lying down, whose flux of z is the volume under it; and first order
/// with trims.
void CheckConvergence()
{
  const sm::FacePointer face = MakeFace(MakeSymmetricQuarterCylinder(2.0, 3.0), {}, true);
  const double exact = 0.25 * vtkMath::Pi() * 4.0 * 3.0;
  const auto error = [&face, exact](int points, int k)
  { return std::abs(std::abs(IntegrateReference(face, points, k).Integrals[0]) / exact - 1.0); };
  CheckRange("GAUSS3, 2 sub-patches across", 1e-9, error(3, 2), 1e-6, "the paper's Fig. 7a");
  CheckRange("GAUSS2, 8", 1e-9, error(2, 8), 1e-6, "the paper's Fig. 7a");
  CheckRange("MIDPOINT, 64", 1e-6, error(1, 64), 1e-3, "the paper's Fig. 7a");
  for (int points = 1; points <= 3; ++points)
  {
    const double order = std::log2(error(points, 4) / error(points, 8));
    CheckRange(
      "order of " + std::to_string(points) + " points", 2.0 * points - 0.3, order, 2.0 * points + 0.3);
  }
  // A leaf on a paraboloid, nz = 1: NZ is the leaf's area, and only the texture errs.
  const sm::NURBSSurface surface = MakeParaboloid(1.0, 1.0, 1.0, { 0.0, 1.0 }, { 0.0, 1.0 });
  const sm::FacePointer trimmed = MakeFace(surface, { MakeLeaf(0.52, 0.47, 0.4, 0.18, false) });
  const double area = GetLeafArea(0.4, 0.18);
  for (int k = 2; k <= 16; k *= 2)
  {
    // A border of length 2.5 crosses at most 2 * 2.5 * 4 k texels, each wrong by half of itself at most.
    Check("area of a leaf, k = " + std::to_string(k), area, IntegrateReference(trimmed, 2, k).Integrals[12],
      2.5 / (4.0 * k), "first order in the texel");
  }
}
}

int TestPaperReference(int, char*[])
{
  CheckDegrees();
  CheckEstimateOfParaboloid();
  CheckEstimateOfArc();
  CheckReferenceTexture();
  CheckConvergence();
  return Finish();
}
