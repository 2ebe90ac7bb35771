// TestSchemeIntegrator: the paper's schemes, on the GPU and on the CPU, against the plain reference written from its equations;
// exactness by degree; a trim texture counted by hand; the same bits in any company; tiles that cut a face anywhere.
#include "NURBS/smPaperReference.h"
#include "NURBS/smSchemeFaces.h"

#include "smCPUSchemeRunner.h"
#include "smGPUSchemeRunner.h"
#include "smMassTolerance.h"
#include "smSchemeIntegrator.h"
#include "smTesting.h"

#include <vtkComputeContext.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

namespace
{
using namespace smtest;
using Results = std::vector<sm::SchemeResult>;

constexpr double Unit = 1.1102230246251565e-16;

vtkComputeContext* GetContext()
{
  static vtkNew<vtkComputeContext> context;
  return context;
}

std::unique_ptr<sm::SchemeRunner> MakeRunner(bool gpu)
{
  if (gpu)
  {
    return std::make_unique<sm::GPUSchemeRunner>(GetContext());
  }
  return std::make_unique<sm::CPUSchemeRunner>();
}

Results Integrate(bool gpu, const std::vector<sm::FacePointer>& faces,
  const sm::SchemeIntegrator::Setup& setup, std::int64_t* evaluations = nullptr)
{
  sm::SchemeIntegrator integrator;
  integrator.SetRunner(MakeRunner(gpu));
  std::vector<sm::SchemeTask> tasks;
  for (const sm::FacePointer& face : faces)
  {
    tasks.push_back({ face, 1e-6 });
  }
  Results results;
  CheckTrue(gpu ? "the GPU integrates" : "the CPU integrates",
    integrator.Integrate(tasks, setup, results, nullptr), integrator.GetError());
  if (evaluations)
  {
    *evaluations = integrator.GetEvaluations();
  }
  results.resize(faces.size());
  for (sm::SchemeResult& result : results)
  {
    result.Integrals.Face.resize(sm::NumberOfMassIntegrands, std::nan(""));
  }
  return results;
}

std::vector<double> GetAll(const sm::SchemeResult& result)
{
  std::vector<double> all = result.Integrals.Face;
  all.push_back(result.Estimate);
  all.push_back(result.EstimateWithBoundary);
  all.push_back(static_cast<double>(result.SubPatches));
  return all;
}

/// The size that rounding of each integral is relative to: area times the matching power of the farthest control point.
std::vector<double> GetScales(const sm::Face& face, double area)
{
  double reach = 0.0;
  for (const std::array<double, 4>& p : face.Surface.ControlPoints)
  {
    reach = std::max(reach, std::hypot(p[0], p[1], p[2]) / p[3]);
  }
  std::vector<double> scales = { area * reach };
  scales.insert(scales.end(), 3, area * reach * reach);
  scales.insert(scales.end(), 6, area * reach * reach * reach);
  scales.insert(scales.end(), 4, area);
  return scales;
}

struct NamedFace
{
  std::string Name;
  sm::FacePointer Face;
};

std::vector<NamedFace> MakeFaces()
{
  std::mt19937 random(41);
  const std::vector<double> one = { 0.0, 1.0 };
  const std::vector<double> two = { -1.0, 0.25, 1.0 };
  const std::vector<double> three = { 0.0, 0.5, 2.0, 3.0 };
  std::vector<NamedFace> faces;
  faces.push_back({ "paraboloid", MakeFace(MakeParaboloid(0.3, -0.7, 1.1, three, two), {}) });
  faces.push_back({ "quarter cylinder", MakeFace(MakeQuarterCylinder(3.0, 5.0), {}, true) });
  faces.push_back({ "degrees 1 2", MakeFace(MakeRandomSurface(random, 1, 2, two, three, 0.2, 0.3), {}) });
  faces.push_back({ "degrees 3 3", MakeFace(MakeRandomSurface(random, 3, 3, three, two, 0.2, 0.4), {}) });
  faces.push_back({ "degrees 5 4", MakeFace(MakeRandomSurface(random, 5, 4, two, two, 0.2, 0.2), {}, true) });
  faces.push_back({ "degree 25", MakeFace(MakeRandomSurface(random, 25, 2, one, one, 0.1, 0.1), {}) });
  faces.push_back({ "trimmed, polygon",
    MakeFace(MakeRandomSurface(random, 3, 3, three, three, 0.2, 0.4),
      { MakePolygonLoop(
        { { 0.31, 0.17 }, { 2.83, 0.41 }, { 2.2, 2.77 }, { 1.21, 1.13 }, { 0.2, 2.9 } }) }) });
  faces.push_back({ "trimmed, leaf with a hole",
    MakeFace(MakeQuarterCylinder(2.0, 3.0),
      { MakeLeaf(0.5, 0.49, 0.43, 0.41, false), MakeLeaf(0.44, 0.52, 0.19, 0.3, true) }, true) });
  faces.push_back({ "trimmed, loops inside out and twice around",
    MakeFace(MakeParaboloid(0.3, -0.7, 1.1, three, two),
      { MakeLeaf(1.1, -0.2, 0.71, 0.41, true), MakeLeaf(1.94, 0.3, 0.61, 0.3, false),
        MakeLeaf(2.07, 0.11, 0.43, 0.35, false) }) });
  faces.push_back({ "trimmed, a hole in all of it",
    MakeFace(MakeRandomSurface(random, 2, 4, three, three, 0.2, 0.2),
      { MakePolygonLoop({ { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 3.0 }, { 0.0, 3.0 } }),
        MakeLeaf(1.6, 1.3, 1.1, 0.4142, true) }) });
  faces.push_back({ "plane",
    MakeFace(MakePlane({ 1.0, 2.0, 3.0 }, { 2.0, 0.5, 0.25 }, { -0.25, 1.5, 1.0 }, 0.0, 1.0, 0.0, 1.0),
      { MakeLeaf(0.5, 0.49, 0.43, 0.41, false), MakeLeaf(0.44, 0.52, 0.19, 0.3, true) }, true) });
  return faces;
}

/// The reference with the polygons that the face was flattened to: whether these are near the curves is another test's.
PaperResult GetReference(
  const sm::FacePointer& face, const sm::SchemeIntegrator::Setup& setup, PaperPolygons& polygons)
{
  sm::SchemeOptions options = setup.Options;
  options.ChordTolerance = 1e-6;
  const sm::SubPatchFace prepared = sm::PrepareSubPatchFace(face, options);
  CheckTrue("the face can be prepared", prepared.Error.empty(), prepared.Error);
  polygons = prepared.Polygons.Loops;
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
    // The reference adds plainly, up to some thousand terms; weights of e^(+-0.4) and degree 25 cost digits, too.
    Check("14 integrals, relative", 0.0, worst, 2e-13);
    const double most = 1e-12 * expected.EstimateWithBoundary;
    Check("estimate", expected.Estimate, result.Estimate, most);
    Check("estimate with the boundary", expected.EstimateWithBoundary, result.EstimateWithBoundary, most);
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

/// z = P(u,v) over the unit square, nz = 1: the flux of g(x,y) z has the degree of its integrand in u and in v. Coefficients
/// of both signs, and not a plane.
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

/// The integral of z x^power over the unit square: Bernstein polynomials' own moments, B(i + 1 + power, degree - i + 1) each.
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
            Check(name, exact, once, 64 * Unit, "roundings of values below 2");
            Check(name + ", k = 4", exact, finer, 64 * Unit);
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
  // z = 1 + u v over the unit square; a disc of radius 0.3 at its centre is cut out. k = 2 and 4 texels: 8 x 8 centres at odd
  // sixteenths. From the disc's centre they lie at odd sixteenths, too: within 4.8/16 are (1,1), (1,3), (3,1) and (3,3), at
  // sqrt(18) = 4.24; (1,5) is at 5.1. Four in each quadrant, 12 of 16 texels are left of every sub-patch.
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
    Check("first centre", 1.0 / 16.0, texture.Origin[0], Unit);
    Check("spacing", 1.0 / 8.0, texture.Spacing[1], Unit);
    // The integral of 1 + u v is 5/4; a bilinear integrand is exact on every sub-patch.
    Check("volume of three quarters", 0.75 * 1.25, result.Integrals.Face[sm::MassVolume], 16 * Unit);
    // K = (K1 + 2 K2 + K3) / 8 with K2 = 1/4 on a half by half: 1/16. 2 K |nz| over four quarters: 1/8, all on the boundary.
    Check("no sub-patch is whole", 0.0, result.Estimate, 0.0);
    Check(
      "estimate with the boundary", 0.125, result.EstimateWithBoundary, 1e-12, "K is bounded up to rounding");
    setup.Options.Factor = 4;
    const sm::SchemeResult finer = Integrate(gpu, { face }, setup)[0];
    // K2 = 1/16: K = 1/64. In 32nds from the centre texels are odd numbers again, the disc reaches 9.6, and sub-patches are 8 wide: the
    // one beside the axis loses (9,1), the one in the corner begins with (9,9) and is whole, the innermost keeps (7,7), at 9.9.
    Check("the corners are whole", 4.0 / 16.0 * 2.0 / 64.0, finer.Estimate, 1e-12);
    Check("all count with the boundary", 2.0 / 64.0, finer.EstimateWithBoundary, 1e-12);
  }
}

void CheckBits()
{
  std::vector<sm::FacePointer> faces;
  for (const NamedFace& named : MakeFaces())
  {
    faces.push_back(named.Face);
  }
  sm::SchemeIntegrator::Setup setup;
  setup.Options.Factor = 7;
  for (const bool gpu : { true, false })
  {
    const Results together = Integrate(gpu, faces, setup);
    bool same = true;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      same = same && GetAll(Integrate(gpu, { faces[i] }, setup)[0]) == GetAll(together[i]);
    }
    CheckTrue("the same bits alone and in company", same);
    vtkSMPTools::Initialize(1);
    const Results again = Integrate(gpu, { faces.rbegin(), faces.rend() }, setup);
    vtkSMPTools::Initialize(0);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      same = same && GetAll(again[faces.size() - 1 - i]) == GetAll(together[i]);
    }
    CheckTrue("in any order, with one thread", same);
    setup.Perturbation = 1.0 + 1.0 / 1024.0;
    const Results perturbed = Integrate(gpu, faces, setup);
    setup.Perturbation = 1.0;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const bool planar = together[i].SubPatches == 0;
      const double area = together[i].Integrals.Face[sm::MassArea];
      Check(planar ? "a plane is no shader's" : "perturbed", area * (planar ? 1.0 : 1.0 + 1.0 / 1024.0),
        perturbed[i].Integrals.Face[sm::MassArea], 1e-13 * area);
    }
  }
}

/// Many tiles and batches; then tiles that cut rows and columns anywhere, against the whole.
void CheckTiles()
{
  std::mt19937 random(5);
  const sm::FacePointer face =
    MakeFace(MakeRandomSurface(random, 3, 3, { 0.0, 1.5, 3.0 }, { 0.0, 1.5, 3.0 }, 0.1, 0.2),
      { MakeLeaf(1.45, 1.55, 1.31, 0.37, false), MakeLeaf(1.61, 1.4, 0.61, 0.2, true) });
  sm::SchemeIntegrator::Setup setup;
  setup.Points = 1;
  setup.Options.Factor = 150;
  setup.KeepTextures = true;
  const sm::SchemeResult gpu = Integrate(true, { face }, setup)[0];
  const sm::SchemeResult cpu = Integrate(false, { face }, setup)[0];
  CheckEqual("sub-patches", 90000, gpu.SubPatches);
  CheckTrue(
    "the same texture", gpu.Texture.Texels == cpu.Texture.Texels && gpu.Texture.Texels.size() == 1440000);
  const auto inside = std::count(gpu.Texture.Texels.begin(), gpu.Texture.Texels.end(), 1);
  const double area = GetLeafArea(1.31, 0.37) - GetLeafArea(0.61, 0.2);
  // Chords are inside their curves by up to 1/16 of a texel of 0.0025, along 12 of length; texels average out better.
  Check("area of the texels", area, 9.0 * inside / 1440000.0, 12.0 * 0.0025 / 16.0);
  Check("GPU and CPU", gpu.Integrals.Face[sm::MassArea], cpu.Integrals.Face[sm::MassArea],
    1e-13 * gpu.Integrals.Face[sm::MassArea]);

  sm::SchemeOptions options;
  options.Factor = 5;
  options.ChordTolerance = 1e-6;
  const sm::SubPatchFace prepared = sm::PrepareSubPatchFace(face, options);
  const std::vector<sm::TileRange> whole = sm::MakeTiles(0, prepared, 4);
  CheckTrue("one tile", whole.size() == 1 && whole[0].Columns == 10 && whole[0].Rows == 10);
  const std::vector<sm::TileRange> cut = { { 0, 0, 0, 3, 10 }, { 0, 3, 0, 6, 1 }, { 0, 3, 1, 6, 9 },
    { 0, 9, 0, 1, 4 }, { 0, 9, 4, 1, 6 } };
  for (const bool isGpu : { true, false })
  {
    const std::unique_ptr<sm::SchemeRunner> runner = MakeRunner(isGpu);
    std::vector<double> sums[2];
    for (const auto& [tiles, which] : { std::make_pair(whole, 0), std::make_pair(cut, 1) })
    {
      sm::SchemeBatch batch;
      for (const sm::TileRange& tile : tiles)
      {
        CheckTrue("room", batch.Add(tile, prepared, 4, runner->GetMaximumBytes()));
      }
      sm::SchemeRunner::Results results;
      CheckTrue("it runs", runner->Run(batch, {}, results, nullptr), runner->GetError());
      CheckTrue("texels are not kept unless asked for", results.Texels.empty());
      sums[which].assign(sm::NumberOfSchemeColumns, 0.0);
      for (std::size_t i = 0; i < results.Sums.size(); ++i)
      {
        sums[which][i % sm::NumberOfSchemeColumns] += results.Sums[i];
      }
    }
    for (const int column : { 0, 5, 13, 14, 15 })
    {
      Check("tiles add up to the whole, column " + std::to_string(column), sums[0][column], sums[1][column],
        1e-13 * std::fabs(sums[0][column]) + 1e-14 * sums[0][sm::MassArea]);
    }
  }
}

void CheckRefusals()
{
  std::mt19937 random(5);
  const sm::FacePointer good =
    MakeFace(MakeRandomSurface(random, 3, 3, { 0.0, 1.0 }, { 0.0, 1.0 }, 0.1, 0.2), {});
  auto broken = std::make_shared<sm::Face>(*good);
  broken->Id = sm::NewId();
  broken->FileId = 77;
  broken->Surface.Knots[0].pop_back();
  sm::SchemeIntegrator::Setup setup;
  for (const bool gpu : { true, false })
  {
    const Results results = Integrate(gpu, { good, broken }, setup);
    CheckTrue("a broken face names itself", results[1].Integrals.Error.find("#77") != std::string::npos,
      results[1].Integrals.Error);
    CheckTrue("the other is there", results[0].Integrals.Error.empty() && results[0].SubPatches == 4);

    sm::SchemeIntegrator integrator;
    integrator.SetRunner(MakeRunner(gpu));
    Results none;
    sm::SchemeIntegrator::Setup costly = setup;
    costly.MaximumEvaluations = 15;
    CheckTrue("too costly", !integrator.Integrate({ { good, 1.0 } }, costly, none, nullptr) && none.empty());
    CheckTrue(
      "it says so", integrator.GetError().find("16 evaluations") != std::string::npos, integrator.GetError());
    costly.MaximumEvaluations = 16;
    CheckTrue(
      "just enough", integrator.Integrate({ { good, 1.0 } }, costly, none, nullptr), integrator.GetError());
    double last = 0.0;
    const auto stop = [&last](double fraction)
    {
      last = fraction;
      return fraction < 0.5;
    };
    costly.MaximumEvaluations = 2000000000;
    costly.Options.Factor = 400;
    CheckTrue(
      "stopped", !integrator.Integrate({ { good, 1.0 } }, costly, none, stop) && integrator.WasAborted());
    CheckTrue("half way", last >= 0.5 && last <= 1.0 && !integrator.WasTimedOut(), std::to_string(last));
    costly.MaximumSeconds = 1e-6;
    CheckTrue("out of time",
      !integrator.Integrate({ { good, 1.0 } }, costly, none, nullptr) && integrator.WasTimedOut() &&
        none.empty());
    CheckTrue("and on", integrator.Integrate({ { good, 1.0 } }, setup, none, nullptr) && none.size() == 1);
    CheckTrue("the same bits", GetAll(none[0]) == GetAll(results[0]));
  }
}
}

int main()
{
  vtkSMPTools::SetBackend("STDThread");
  if (GetContext()->Start() != vtkComputeContext::READY)
  {
    std::printf("skipped: %s\n", GetContext()->GetReason().c_str());
    return Skipped;
  }
  CheckAgainstReference();
  CheckExactness();
  CheckTextureByHand();
  CheckBits();
  CheckTiles();
  CheckRefusals();
  return Finish();
}
