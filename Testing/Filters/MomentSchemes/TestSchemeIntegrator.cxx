// TestSchemeIntegrator: the paper's schemes, on the GPU and on the CPU, against the plain reference written
// from its equations; exactness by degree; a trim texture counted by hand.
#include "smPaperReference.h"
#include "smSchemeTesting.h"
#include "smUnitRoundoff.h"

#include <cstdio>

namespace
{
using namespace smtest;

// Chords of a trim piece in the reference, so many that no texel's centre here is between a curve and its
// chord (1e-7 or so).
constexpr int ReferenceChords = 1024;

bool IsStraight(const sm::Face& face)
{
  for (const sm::Loop& loop : face.Loops)
  {
    for (const sm::Coedge& coedge : loop.Coedges)
    {
      if (coedge.Curve.Coefficients.size() != coedge.Curve.Breaks.size())
      {
        return false;
      }
    }
  }
  return true;
}

/// The reference with polygons sampled from the trim curves; of a plane those that it was flattened to, which
/// are another test's.
PaperResult GetReference(
  const sm::FacePointer& face, const sm::SchemeIntegrator::Setup& setup, PaperPolygons& polygons)
{
  sm::SchemeOptions options = setup.Options;
  options.ChordTolerance = 1e-6;
  const sm::SubPatchFace prepared = sm::PrepareSubPatchFace(face, options);
  CheckTrue("the face can be prepared", prepared.Error.empty(), prepared.Error);
  polygons = prepared.Planar ? prepared.Polygons.Loops
                             : SamplePolygons(*face, IsStraight(*face) ? 1 : ReferenceChords);
  if (prepared.Planar)
  {
    PaperResult result;
    result.Integrals = IntegratePlane(*face, polygons);
    return result;
  }
  PaperOptions plain;
  plain.Points = setup.Points;
  plain.Factor = setup.Options.Factor;
  plain.TextureFactor = setup.Options.TextureFactor;
  const sm::DeviationMode mode = setup.Options.Deviation;
  plain.Deviation = [mode](const sm::NURBSSurface& surface, double u0, double u1, double v0, double v1)
  { return sm::ComputeDeviation(surface, u0, u1, v0, v1, mode); };
  return IntegrateCurved(*face, polygons, plain);
}

/// Texels that are not what the winding number says, and sub-patches that have one in the face.
void CheckTexture(const sm::SchemeResult& result, const PaperPolygons& polygons, const sm::SubPatchGrid& grid,
  int factor, std::int64_t& covered)
{
  const sm::TrimTexture& texture = result.Texture;
  CheckEqual("texels in a row", grid.GetNumberOfColumns() * factor, texture.Width);
  CheckEqual("rows of texels", grid.GetNumberOfRows() * factor, texture.Height);
  int wrong = 0;
  covered = 0;
  for (int row = 0; row < grid.GetNumberOfRows() && !texture.Texels.empty(); ++row)
  {
    for (int column = 0; column < grid.GetNumberOfColumns(); ++column)
    {
      bool any = false;
      for (int t = 0; t < factor * factor; ++t)
      {
        const int i = t % factor;
        const int j = t / factor;
        const double u = grid.U[column] + (grid.U[column + 1] - grid.U[column]) * (i + 0.5) / factor;
        const double v = grid.V[row] + (grid.V[row + 1] - grid.V[row]) * (j + 0.5) / factor;
        const int inside = GetWindingNumber(polygons, u, v) != 0 ? 1 : 0;
        wrong += inside != texture.Texels[(row * factor + j) * texture.Width + column * factor + i] ? 1 : 0;
        any = any || inside != 0;
      }
      covered += any ? 1 : 0;
    }
  }
  CheckEqual("wrong texels", 0, wrong);
}

void CheckFace(const NamedFace& named, const sm::SchemeIntegrator::Setup& setup)
{
  std::printf("--- %s, %d points, k = %d, %d texels\n", named.Name.c_str(), setup.Points,
    setup.Options.Factor, setup.Options.TextureFactor);
  PaperPolygons polygons;
  const PaperResult expected = GetReference(named.Face, setup, polygons);
  const std::vector<double> scales = GetScales(*named.Face, expected.Integrals[sm::MassArea]);
  std::vector<double> all[2];
  for (const bool gpu : { true, false })
  {
    std::int64_t evaluations = 0;
    const Results results = Integrate(gpu, { named.Face }, setup, &evaluations);
    const sm::SchemeResult& result = results[0];
    CheckTrue("no error", result.Integrals.Error.empty(), result.Integrals.Error);
    double worst = 0.0;
    for (int i = 0; i < sm::NumberOfMassIntegrands; ++i)
    {
      const double off = std::fabs(result.Integrals.Face[i] - expected.Integrals[i]) / scales[i];
      worst = off <= worst ? worst : off;
    }
    // The reference adds plainly, up to some thousand terms; weights of e^(+-0.4) and degree 25 cost digits,
    // too.
    Check("14 integrals, relative", 0.0, worst, 2e-13);
    const double maximum = 1e-12 * expected.EstimateWithBoundary;
    Check("estimate", expected.Estimate, result.Estimate, maximum);
    Check("estimate with the boundary", expected.EstimateWithBoundary, result.EstimateWithBoundary, maximum);
    CheckEqual("sub-patches", expected.SubPatches, result.SubPatches);
    std::int64_t covered = expected.SubPatches;
    if (!named.Face->Loops.empty() && expected.SubPatches > 0)
    {
      CheckTexture(result, polygons, sm::MakeSubPatchGrid(named.Face->Surface, setup.Options.Factor),
        setup.Options.TextureFactor, covered);
    }
    CheckEqual("evaluations", covered * setup.Points * setup.Points, evaluations);
    all[gpu ? 0 : 1] = GetAll(result);
    CheckTrue("no bound", std::isnan(result.Integrals.GetBound(sm::MassVolume)));
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < all[0].size(); ++i)
  {
    const double scale = i < scales.size() ? scales[i] : std::max(all[0][i], 1e-300);
    const double off = std::fabs(all[0][i] - all[1][i]) / scale;
    worst = off <= worst ? worst : off;
  }
  Check("GPU and CPU, relative", 0.0, worst, 1e-13);
}

void CheckAgainstReference()
{
  for (const NamedFace& named : MakeFaces())
  {
    const int settings[][4] = { { 1, 1, 4, 0 }, { 2, 2, 4, 0 }, { 3, 5, 3, 1 }, { 2, 1, 16, 1 },
      { 3, 2, 1, 0 } };
    for (const auto& chosen : settings)
    {
      sm::SchemeIntegrator::Setup setup;
      setup.Points = chosen[0];
      setup.Options.Factor = chosen[1];
      setup.Options.TextureFactor = chosen[2];
      setup.Options.Deviation = chosen[3] ? sm::DeviationMode::Sampled : sm::DeviationMode::Bounded;
      setup.KeepTextures = true;
      CheckFace(named, setup);
    }
  }
}

/// z = P(u,v) over the unit square, nz = 1: the flux of g(x,y) z has the degree of its integrand in u and in
/// v. Coefficients of both signs, and not a plane.
sm::FacePointer MakeGraph(int degree)
{
  return MakeFace(MakeSurface(degree, degree, { 0.0, 1.0 }, { 0.0, 1.0 },
                    [degree](int i, int j)
                    {
                      return std::array<double, 4>{ static_cast<double>(i) / degree,
                        static_cast<double>(j) / degree, 1.0 + std::cos(3.0 * i) * std::sin(1.0 + 2.0 * j),
                        1.0 };
                    }),
    {});
}

/// The integral of z x^power over the unit square: Bernstein polynomials' own moments, B(i + 1 + power,
/// degree - i + 1) each.
double IntegrateGraph(const sm::Face& face, int power)
{
  const int degree = face.Surface.Degree[0];
  double sum = 0.0;
  for (int j = 0; j <= degree; ++j)
  {
    for (int i = 0; i <= degree; ++i)
    {
      // C(d,i) (i+p)! (d-i)! / (d+1+p)! = (i+1) .. (i+p) / ((d+1) .. (d+1+p))
      double moment = 1.0 / (degree + 1 + power);
      for (int p = 1; p <= power; ++p)
      {
        moment *= static_cast<double>(i + p) / (degree + p);
      }
      sum += face.Surface.ControlPoints[i + j * (degree + 1)][2] * moment / (degree + 1);
    }
  }
  return sum;
}

void CheckExactness()
{
  for (int points = 1; points <= 3; ++points)
  {
    // x^power z has degree d + power in u.
    for (int power = 0; power <= 2; ++power)
    {
      for (int degree = 1; degree + power <= 2 * points; ++degree)
      {
        const sm::FacePointer face = MakeGraph(degree);
        const double exact = IntegrateGraph(*face, power);
        const int column = power == 0 ? sm::MassVolume : power == 1 ? sm::MassFirst : sm::MassSecond;
        for (const bool gpu : { true, false })
        {
          sm::SchemeIntegrator::Setup setup;
          setup.Points = points;
          setup.Options.Factor = 1;
          const double once = Integrate(gpu, { face }, setup)[0].Integrals.Face[column];
          setup.Options.Factor = 4;
          const double finer = Integrate(gpu, { face }, setup)[0].Integrals.Face[column];
          const std::string name = std::to_string(points) + " points, degree " + std::to_string(degree) +
            " times x^" + std::to_string(power);
          if (degree + power <= 2 * points - 1)
          {
            Check(name, exact, once, 64 * sm::UnitRoundoff, "roundings of values below 2");
            Check(name + ", k = 4", exact, finer, 64 * sm::UnitRoundoff);
          }
          else
          {
            CheckTrue(name + " is not exact", std::fabs(once - exact) > 1e-5, std::to_string(once - exact));
            // One more degree: order 2n, 4^-2n at k = 4, give or take what cross terms add.
            CheckRange(name + ", k = 4: what is left", 0.0,
              std::fabs(finer - exact) / std::fabs(once - exact), 4.0 * std::pow(0.25, 2 * points));
          }
        }
      }
    }
  }
}

void CheckTextureByHand()
{
  // z = 1 + u v over the unit square; a disc of radius 0.3 at its centre is cut out. k = 2 and 4 texels: 8 x
  // 8 centres at odd sixteenths. From the disc's centre they lie at odd sixteenths, too: within 4.8/16 are
  // (1,1), (1,3), (3,1) and (3,3), at sqrt(18) = 4.24; (1,5) is at 5.1. Four in each quadrant, 12 of 16
  // texels are left of every sub-patch.
  const sm::FacePointer face =
    MakeFace(MakeSurface(1, 1, { 0.0, 1.0 }, { 0.0, 1.0 },
               [](int i, int j) {
                 return std::array<double, 4>{ 1.0 * i, 1.0 * j, 1.0 + i * j, 1.0 };
               }),
      { MakePolygonLoop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } }),
        MakeLeaf(0.5, 0.5, 0.3, std::sqrt(2.0) - 1.0, true) });
  const char* const rows[8] = { "11111111", "11111111", "11000011", "11000011", "11000011", "11000011",
    "11111111", "11111111" };
  for (const bool gpu : { true, false })
  {
    sm::SchemeIntegrator::Setup setup;
    setup.KeepTextures = true;
    const sm::SchemeResult result = Integrate(gpu, { face }, setup)[0];
    const sm::TrimTexture& texture = result.Texture;
    CheckTrue("8 x 8 texels", texture.Width == 8 && texture.Height == 8 && texture.Texels.size() == 64);
    for (int row = 0; row < 8 && texture.Texels.size() == 64; ++row)
    {
      std::string text;
      for (int column = 0; column < 8; ++column)
      {
        text += texture.Texels[8 * row + column] ? '1' : '0';
      }
      CheckEqual("row " + std::to_string(row), rows[row], text);
    }
    Check("first centre", 1.0 / 16.0, texture.Origin[0], sm::UnitRoundoff);
    Check("spacing", 1.0 / 8.0, texture.Spacing[1], sm::UnitRoundoff);
    // The integral of 1 + u v is 5/4; a bilinear integrand is exact on every sub-patch.
    Check(
      "volume of three quarters", 0.75 * 1.25, result.Integrals.Face[sm::MassVolume], 16 * sm::UnitRoundoff);
    // K = (K1 + 2 K2 + K3) / 8 with K2 = 1/4 on a half by half: 1/16. 2 K |nz| over four quarters: 1/8, all
    // on the boundary.
    Check("no sub-patch is whole", 0.0, result.Estimate, 0.0);
    Check(
      "estimate with the boundary", 0.125, result.EstimateWithBoundary, 1e-12, "K is bounded up to rounding");
    setup.Options.Factor = 4;
    const sm::SchemeResult finer = Integrate(gpu, { face }, setup)[0];
    // K2 = 1/16: K = 1/64. In 32nds from the centre texels are odd numbers again, the disc reaches 9.6, and
    // sub-patches are 8 wide: the one next to the axis loses (9,1), the one in the corner begins with (9,9)
    // and is whole, the innermost keeps (7,7), at 9.9.
    Check("the corners are whole", 4.0 / 16.0 * 2.0 / 64.0, finer.Estimate, 1e-12);
    Check("all count with the boundary", 2.0 / 64.0, finer.EstimateWithBoundary, 1e-12);
  }
}

/// Every texel at a fine k against the formula of its border. A leaf's arc from (1,0) to (0,1) with the
/// middle coefficient at (m,m), m = 1/2 + bulge, has x - y = 1 - 2t and x + y = 1 + (4m - 2) t (1 - t): its
/// inside is |x| + |y| < 1 + bulge (1 - (|x| - |y|)^2).
void CheckTextureOfDisc(int factor)
{
  const double x = 0.503;
  const double y = 0.496;
  const double radius = 0.421;
  const double bulge = std::sqrt(2.0) - 1.0;
  const sm::FacePointer face =
    MakeFace(MakeSurface(1, 1, { 0.0, 0.7, 1.0 }, { 0.0, 1.0 },
               [](int i, int j) {
                 return std::array<double, 4>{ 1.0 * i, 1.0 * j, 1.0 + i * j, 1.0 };
               }),
      { MakeLeaf(x, y, radius, bulge, false) });
  for (const bool gpu : { true, false })
  {
    sm::SchemeIntegrator::Setup setup;
    setup.Points = 1;
    setup.Options.Factor = factor;
    setup.KeepTextures = true;
    const sm::TrimTexture texture = Integrate(gpu, { face }, setup)[0].Texture;
    const int size = 4 * factor;
    CheckTrue("texels", texture.Width == 2 * size && texture.Height == size);
    int wrong = 0;
    int inside = 0;
    for (std::size_t i = 0; i < texture.Texels.size(); ++i)
    {
      const int column = static_cast<int>(i) % (2 * size);
      const double share = (column % size + 0.5) / size;
      const double a = std::fabs((column < size ? 0.7 * share : 0.7 + 0.3 * share) - x) / radius;
      const double b = std::fabs((static_cast<int>(i) / (2 * size) + 0.5) / size - y) / radius;
      const double within = 1.0 + bulge * (1.0 - (a - b) * (a - b)) - a - b;
      // Where rounding decides either will do.
      wrong += std::fabs(within) > 1e-13 && (within > 0.0) != (texture.Texels[i] != 0) ? 1 : 0;
      inside += texture.Texels[i] != 0 ? 1 : 0;
    }
    CheckEqual("texels on the wrong side, k = " + std::to_string(factor), 0, wrong);
    CheckRange("texels in the face", 0.4 * size * size, inside, 1.2 * size * size);
  }
}

/// How far a trim leaves its surface reaches those who judge a body.
void CheckOutside()
{
  const sm::NURBSSurface surface = MakeParaboloid(0.1, 0.0, 0.1, { 0.0, 1.0 }, { 0.0, 1.0 });
  const std::vector<sm::FacePointer> faces = { MakeFace(surface, { MakeLeaf(0.5, 0.5, 0.3, 0.2, false) }),
    MakeFace(surface, { MakeLeaf(0.9, 0.5, 0.3, 0.2, false) }) };
  const Results results = Integrate(true, faces, {});
  Check("no trim leaves its surface", 0.0, results[0].Integrals.Outside.Distance, 0.0);
  // The patch's radius is about 0.72.
  CheckRange("one does by 0.2 of a side", 0.2, results[1].Integrals.Outside.Distance, 0.4);
}
}

int TestSchemeIntegrator(int, char*[])
{
  if (!Start())
  {
    return Skipped;
  }
  CheckAgainstReference();
  CheckExactness();
  CheckTextureByHand();
  CheckOutside();
  for (const int factor : { 1, 16, 128 })
  {
    CheckTextureOfDisc(factor);
  }
  return Finish();
}
