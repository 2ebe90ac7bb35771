// Sub-patches of the paper's schemes: their grid, K bounded above and below, and what a face gives the
// schemes.
#include "Detail/smSubPatches.h"
#include "smPaperReference.h"
#include "smSchemeFaces.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{
using namespace smtest;
using sm::DeviationMode;

void CheckGrid()
{
  const std::vector<double> u = { 0.1, 0.3, 1.7 };
  const std::vector<double> v = { -2.0, 3.0 };
  const sm::NURBSSurface surface = MakeParaboloid(1.0, 2.0, 3.0, u, v);
  const sm::SubPatchGrid grid = sm::MakeSubPatchGrid(surface, 3);
  CheckEqual("columns", 6LL, grid.GetNumberOfColumns());
  CheckEqual("rows", 3LL, grid.GetNumberOfRows());
  CheckTrue(
    "knots to the bit", grid.U[0] == u[0] && grid.U[3] == u[1] && grid.U[6] == u[2] && grid.V[3] == v[1]);
  Check("a third of the second interval", 0.3 + 1.4 / 3.0, grid.U[4], 4.5e-16, "rounding");
  Check("a third of the rows", -2.0 + 5.0 / 3.0, grid.V[1], 4.5e-16, "rounding");
  CheckEqual("an empty grid", 0LL, sm::SubPatchGrid().GetNumberOfColumns());
}

/// The extremes of K over all sub-patches of random rational surfaces, against 21 x 21 samples of each.
struct Extremes
{
  double MinimumBound = HUGE_VAL;
  double MaxBound = 0.0;
  double MinimumSample = HUGE_VAL;
  double MaxSample = 0.0;
};

void CheckRandomSurfaces(int count, int lowest, int highest, double spread, const std::vector<int>& factors,
  std::vector<Extremes>& extremes)
{
  std::mt19937 random(4);
  std::uniform_int_distribution<int> degree(lowest, highest);
  extremes.assign(factors.size(), {});
  for (int i = 0; i < count; ++i)
  {
    const int p = degree(random);
    const int q = degree(random);
    const sm::NURBSSurface surface =
      MakeRandomSurface(random, p, q, { -1.0, 0.5, 0.75 }, { 0.0, 4.0 }, 0.4, spread);
    for (std::size_t f = 0; f < factors.size(); ++f)
    {
      const sm::SubPatchGrid grid = sm::MakeSubPatchGrid(surface, factors[f]);
      // Some of the sub-patches of fine grids, all of coarse ones.
      const int step = std::max(1, factors[f] / 2);
      for (int column = 0; column < grid.GetNumberOfColumns(); column += step)
      {
        for (int row = 0; row < grid.GetNumberOfRows(); row += step)
        {
          const double u0 = grid.U[column], u1 = grid.U[column + 1];
          const double v0 = grid.V[row], v1 = grid.V[row + 1];
          const double dense = SampleDeviation(surface, u0, u1, v0, v1, 21);
          const double bounded = sm::ComputeDeviation(surface, u0, u1, v0, v1, DeviationMode::Bounded);
          const double sampled = sm::ComputeDeviation(surface, u0, u1, v0, v1, DeviationMode::Sampled);
          if (p == 1 && q == 1 && spread == 0.0)
          {
            // One constant mixed derivative: all three are equal, and show nothing about bounds.
            Check("bilinear", dense, bounded, 1e-12 * dense, "rounding");
            continue;
          }
          // Rounding of second derivatives of degree 6 of coordinates of at most 10: some 30 64 10 u / k^2.
          const double rounding = 1e-13 / dense;
          Extremes& e = extremes[f];
          e.MinimumBound = std::min(e.MinimumBound, bounded / dense + rounding);
          e.MaxBound = std::max(e.MaxBound, bounded / dense);
          e.MinimumSample = std::min(e.MinimumSample, sampled / dense);
          e.MaxSample = std::max(e.MaxSample, sampled / bounded - rounding);
        }
      }
    }
  }
}

/// The excess of bounds over the true K falls faster than 1/k.
void CheckBounds(int count, int lowest, int highest, double spread, double excess)
{
  const std::vector<int> factors = { 1, 4, 16 };
  std::vector<Extremes> extremes;
  CheckRandomSurfaces(count, lowest, highest, spread, factors, extremes);
  const std::string name = "degrees " + std::to_string(lowest) + ".." + std::to_string(highest) +
    ", weights e^+-" + std::to_string(spread).substr(0, 3);
  for (std::size_t f = 0; f < factors.size(); ++f)
  {
    std::printf("--- %s, k = %d\n", name.c_str(), factors[f]);
    const Extremes& e = extremes[f];
    CheckRange("smallest bound / true", 1.0 - 1e-14, e.MinimumBound, 1.0 + excess / factors[f], "rounding");
    CheckRange("largest bound / true", 1.0, e.MaxBound, 1.0 + excess / factors[f]);
    CheckRange("smallest sample / true", 1.0 - 1.0 / factors[f], e.MinimumSample, 1.0 + 1e-9);
    CheckRange(
      "largest sample / bound", 1.0 / (1.0 + excess / factors[f]), e.MaxSample, 1.0 + 1e-14, "rounding");
  }
}

/// Same shape elsewhere, same K; knots of another unit, same K; twice as large, twice K.
void CheckInvariance()
{
  std::mt19937 random(28);
  for (const DeviationMode mode : { DeviationMode::Bounded, DeviationMode::Sampled })
  {
    const sm::NURBSSurface surface = MakeRandomSurface(random, 3, 2, { 0.0, 1.0 }, { 0.0, 1.0 }, 0.4, 0.7);
    const double k = sm::ComputeDeviation(surface, 0.25, 0.5, 0.5, 0.75, mode);
    CheckRange("K", 1e-3, k, 10.0);
    sm::NURBSSurface moved = surface;
    for (std::array<double, 4>& p : moved.ControlPoints)
    {
      p = { 2.0 * p[0] + 1000.0 * p[3], 2.0 * p[1] - 500.0 * p[3], 2.0 * p[2] + 70.0 * p[3], p[3] };
    }
    for (double& knot : moved.Knots[0])
    {
      knot = 100.0 * knot - 30.0;
    }
    // Coordinates of 1000 rounded, in second differences of cubics: 1000 u 6 4 64.
    Check("moved, scaled, with other knots", 2.0 * k,
      sm::ComputeDeviation(moved, -5.0, 20.0, 0.5, 0.75, mode), 2e-11, "rounding of coordinates of 1000");
  }
}

void CheckPrepared()
{
  std::mt19937 random(11);
  const sm::NURBSSurface surface =
    MakeRandomSurface(random, 3, 2, { 0.0, 1.0, 5.0 }, { 0.0, 0.5, 0.75 }, 0.4, 0.7);
  sm::SchemeOptions options;
  options.Factor = 3;
  options.TextureFactor = 3;
  const sm::FacePointer source = MakeFace(surface, { MakeLeaf(3.0, 0.4, 0.3, 0.2, false) });
  const sm::SubPatchFace face = sm::PrepareSubPatchFace(source, options);
  CheckTrue("prepared", face.Error.empty() && !face.Planar && face.Source == source, face.Error);
  CheckEqual("patches", 4LL, static_cast<long long>(face.Patches.size()));
  CheckEqual("points", 48LL, static_cast<long long>(face.Points.size()));
  CheckEqual("deviations", 36LL, static_cast<long long>(face.Deviations.size()));
  const sm::Patch& patch = face.Patches[1];
  CheckTrue("u is fastest",
    patch.Start[0] == 1.0 && patch.Start[1] == 0.0 && patch.Width[0] == 4.0 && patch.Width[1] == 0.5);
  const double k = sm::ComputeDeviation(
    surface, face.Grid.U[4], face.Grid.U[5], face.Grid.V[2], face.Grid.V[3], DeviationMode::Bounded);
  CheckTrue("K of column 4, row 2", face.Deviations[4 + 2 * 6] == k && k > 0.0);
  double farthest = 0.0;
  double radius = 0.0;
  for (const sm::Patch& cell : face.Patches)
  {
    for (int i = 0; i < 25; ++i)
    {
      const double s = (i % 5) / 4.0;
      const double r = (i / 5) / 4.0;
      std::array<double, 4> line[3];
      for (int j = 0; j < 3; ++j)
      {
        line[j] = sm::BernsteinPiece<4>{ face.Points.data() + cell.FirstPoint + 4 * j, 3 }.Evaluate(s);
      }
      const std::array<double, 4> h = sm::BernsteinPiece<4>{ line, 2 }.Evaluate(r);
      double position[3];
      surface.Evaluate(cell.Start[0] + s * cell.Width[0], cell.Start[1] + r * cell.Width[1], position);
      double squared = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        farthest = std::max(farthest, std::abs(cell.Center[c] + h[c] / h[3] - position[c]));
        squared += h[c] * h[c] / h[3] / h[3];
      }
      radius = std::max(radius, std::sqrt(squared) / cell.Radius);
    }
  }
  CheckRange("patches are the surface", 0.0, farthest, 4e-15, "rounding of coordinates of 5");
  CheckRange("within their radius", 0.1, radius, 1.0 + 1e-15);
  // Four arcs, of which none turns in v; they are the face's own to the bit.
  CheckEqual("rises", 4LL, static_cast<long long>(face.Rises.size()));
  CheckTrue("the curves themselves",
    face.Rises.at(0) == sm::CutIntoRises(*source).at(0) && face.Rises[0].size() == 3 &&
      face.Rises[0].front() == Point2{ 3.3, 0.4 } && face.HasTexture());
  CheckTrue("no polygons of a curved face", face.Polygons.Loops.empty());
}

/// A trim that leaves its surface is measured by the surface's size.
void CheckPatchOutside()
{
  // x = u and y = v from 0 to 1 in patches of 1/2 by 1; z is below 1/4, so that a patch's radius is between
  // 0.55 and 0.6.
  const sm::NURBSSurface surface = MakeParaboloid(0.1, 0.0, 0.1, { 0.0, 0.5, 1.0 }, { 0.0, 1.0 });
  const auto measure = [&surface](double x, double y)
  { return sm::PrepareSubPatchFace(MakeFace(surface, { MakeLeaf(x, y, 0.25, 0.2, false) }), {}).Outside; };
  Check("inside", 0.0, measure(0.5, 0.5), 0.0);
  CheckRange("0.15 out on the right", 2.0 * 0.55 * 0.15 / 0.5, measure(0.9, 0.5), 2.0 * 0.6 * 0.15 / 0.5);
  CheckRange("0.1 out below", 2.0 * 0.55 * 0.1, measure(0.5, 0.15), 2.0 * 0.6 * 0.1);
}

void CheckPlanar()
{
  const auto plane = [](double twist, double weight)
  {
    sm::NURBSSurface surface =
      MakePlane({ 100.1, 7.3, 0.3 }, { 1.0 / 3.0, 0.7, 0.1 }, { 0.2, 0.9, 0.6 }, 0.1, 0.7, -3.0, 9.0);
    surface.ControlPoints[3][2] += twist;
    surface.ControlPoints[1][3] = weight;
    return surface;
  };
  CheckTrue("a parallelogram is planar", sm::IsPlanar(plane(0.0, 1.0)));
  CheckTrue("a twisted one is not", !sm::IsPlanar(plane(1e-9, 1.0)));
  CheckTrue("nor one with other weights", !sm::IsPlanar(plane(0.0, 1.0 + 1e-15)));
  CheckTrue("nor a cylinder", !sm::IsPlanar(MakeQuarterCylinder(1.0, 1.0)));
  CheckTrue("nor one of two pieces",
    !sm::IsPlanar(MakeSurface(1, 1, { 0.0, 0.5, 1.0 }, { 0.0, 1.0 },
      [](int i, int j) {
        return std::array<double, 4>{ 0.5 * i, 1.0 * j, 0.0, 1.0 };
      })));
}

/// The face is refused, by a sentence that names it and holds `word`.
void CheckError(const std::string& what, const sm::FacePointer& face, const sm::SchemeOptions& options,
  const std::string& word)
{
  const sm::SubPatchFace prepared = sm::PrepareSubPatchFace(face, options);
  CheckTrue(what,
    prepared.Error.find(word) != std::string::npos && prepared.Deviations.empty() &&
      prepared.Patches.empty() && (!face || prepared.Error.find("#31") != std::string::npos),
    prepared.Error);
}

void CheckErrors()
{
  const sm::NURBSSurface good = MakeParaboloid(1.0, 0.0, 1.0, { 0.0, 1.0 }, { 0.0, 1.0 });
  const sm::SchemeOptions options;
  CheckError("no face", nullptr, options, "no face");
  sm::NURBSSurface bad = good;
  bad.ControlPoints[2][3] = 0.0;
  CheckError("a weight of 0", MakeFace(bad, {}), options, "control point 2");
  bad = good;
  bad.Knots[0].pop_back();
  CheckError("a missing knot", MakeFace(bad, {}), options, "knots");
  bad = good;
  bad.Knots[1].back() = std::numeric_limits<double>::infinity();
  CheckError("an infinite knot", MakeFace(bad, {}), options, "knot is not finite");
  sm::Loop loop = MakeLeaf(0.5, 0.5, 0.3, 0.2, false);
  loop.Coedges[1].Curve.Coefficients[2][1] = std::numeric_limits<double>::quiet_NaN();
  CheckError("a trim curve of NaN", MakeFace(good, { loop }), options, "finite");
  loop.Coedges[1].Curve = sm::TrimCurve();
  CheckError("a coedge without a trim curve", MakeFace(good, { loop }), options, "no trim curve");
  loop.Coedges[1] = MakeCoedge({ std::vector<Point2>(27, Point2{ 0.5, 0.5 }) }, false);
  CheckError("a trim curve of degree 26", MakeFace(good, { loop }), options, "degree above 25");
  sm::SchemeOptions wrong;
  wrong.Factor = 0;
  CheckError("k = 0", MakeFace(good, {}), wrong, "at least 1");
  wrong.Factor = 1 << 20;
  CheckError("too many sub-patches", MakeFace(good, {}), wrong, "1099511627776 sub-patches");
  const sm::NURBSSurface plane = MakePlane({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 0.0, 1.0, 0.0, 1.0);
  CheckError("a trimmed plane without a chord tolerance",
    MakeFace(plane, { MakeLeaf(0.5, 0.5, 0.3, 0.2, false) }), options, "chord tolerance");
}
}

int TestSubPatches(int, char*[])
{
  CheckGrid();
  // Weights 1: second differences. Others: quotients of products; of more than 64 control points, intervals.
  CheckBounds(120, 1, 6, 0.0, 3.0);
  CheckBounds(120, 1, 6, 0.2, 3.0);
  CheckBounds(120, 1, 6, 1.0, 3.0);
  CheckBounds(6, 8, 10, 0.2, 30.0);
  CheckInvariance();
  CheckPrepared();
  CheckPatchOutside();
  CheckPlanar();
  CheckErrors();
  return Finish();
}
