// Planes by triangles of their trim polygons: polyhedra to rounding, both orientations, curved trims to the
// chord tolerance.
#include "Detail/smPlaneMoments.h"
#include "smPaperReference.h"
#include "smSchemeFaces.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace smtest;
using Moments = std::array<double, 14>;
const char* const Names[14] = { "V", "X", "Y", "Z", "XX", "YY", "ZZ", "XY", "YZ", "XZ", "NX", "NY", "NZ",
  "area" };

Point3 Minus(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Determinant(const Point3& a, const Point3& b, const Point3& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

sm::SubPatchFace Prepare(const sm::FacePointer& face, double chord)
{
  sm::SchemeOptions options;
  options.ChordTolerance = chord;
  sm::SubPatchFace prepared = sm::PrepareSubPatchFace(face, options);
  CheckTrue("prepared as a plane", prepared.Planar && prepared.Error.empty(), prepared.Error);
  return prepared;
}

/// Largest |coordinate|^d |n| area that an integral sums: what its rounding is relative to.
double GetScale(int integral, double size, double area)
{
  const int degree = integral == 0 ? 1 : integral < 4 ? 2 : integral < 10 ? 3 : 0;
  return std::pow(size, degree) * area;
}

/// Moments of a tetrahedron: V = det / 6, first V/4 sum x_k, second V/20 (sum x_k sum y_k + sum x_k y_k).
Moments GetTetrahedronMoments(const Point3 (&p)[4])
{
  Moments m{};
  m[0] = Determinant(Minus(p[1], p[0]), Minus(p[2], p[0]), Minus(p[3], p[0])) / 6.0;
  const int pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
  double sums[3] = {};
  for (int c = 0; c < 3; ++c)
  {
    sums[c] = p[0][c] + p[1][c] + p[2][c] + p[3][c];
    m[1 + c] = m[0] / 4.0 * sums[c];
  }
  for (int k = 0; k < 6; ++k)
  {
    const int a = pairs[k][0];
    const int b = pairs[k][1];
    m[4 + k] = m[0] / 20.0 *
      (sums[a] * sums[b] + p[0][a] * p[0][b] + p[1][a] * p[1][b] + p[2][a] * p[2][b] + p[3][a] * p[3][b]);
  }
  return m;
}

/// Four trimmed planes, every second one reversed: the flux along z gives all ten moments about the origin.
void CheckTetrahedra()
{
  std::mt19937 random(16);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const double offset : { 0.0, 5.0, 1000.0 })
  {
    Point3 p[4];
    for (Point3& x : p)
    {
      x = { offset + unit(random), -offset + unit(random), 0.7 * offset + unit(random) };
    }
    if (Determinant(Minus(p[1], p[0]), Minus(p[2], p[0]), Minus(p[3], p[0])) < 0.0)
    {
      std::swap(p[2], p[3]);
    }
    const int corners[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
    Moments sum{};
    for (int f = 0; f < 4; ++f)
    {
      // Transposed: u and v change places, so that Su x Sv points inwards and Reversed outwards again.
      const bool transposed = f % 2 == 1;
      const Point3& a = p[corners[f][0]];
      const Point3& b = p[corners[f][transposed ? 2 : 1]];
      const Point3& c = p[corners[f][transposed ? 1 : 2]];
      const sm::NURBSSurface plane = MakePlane(a, Minus(b, a), Minus(c, a), -0.5, 2.0, -1.0, 1.5);
      const sm::FacePointer face =
        MakeFace(plane, { MakePolygonLoop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.0, 1.0 } }) }, transposed);
      const Moments m = sm::ComputePlaneMoments(Prepare(face, 1e-3));
      CheckRange("area is positive in both orientations", 0.01, m[13], 10.0);
      for (int i = 0; i < 14; ++i)
      {
        sum[i] += m[i];
      }
    }
    const Moments expected = GetTetrahedronMoments(p);
    for (int i = 0; i < 13; ++i)
    {
      Check(std::string("tetrahedron ") + Names[i], expected[i], sum[i],
        2e-15 * std::max(GetScale(i, 1.0 + 1.8 * offset, 10.0), 10.0 * (1.0 + 1.8 * offset)),
        "rounding of corners and of four faces about the far origin");
    }
  }
}

/// Six untrimmed planes: the box [1,3] x [2,5] x [-1,4].
void CheckBox()
{
  const Point3 o = { 1.0, 2.0, -1.0 };
  const Point3 e[3] = { { 2.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 }, { 0.0, 0.0, 5.0 } };
  Moments sum{};
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const Point3 from = { o[0] + side * e[axis][0], o[1] + side * e[axis][1], o[2] + side * e[axis][2] };
      const sm::NURBSSurface plane =
        MakePlane(from, e[(axis + 1) % 3], e[(axis + 2) % 3], 0.0, 1.0, 0.0, 1.0);
      const Moments m = sm::ComputePlaneMoments(Prepare(MakeFace(plane, {}, side == 0), 0.0));
      for (int i = 0; i < 14; ++i)
      {
        sum[i] += m[i];
      }
    }
  }
  // V = 30, centre (2, 3.5, 1.5); V times the means of x^2 = 4 + 4/12, y^2 = 12.25 + 9/12, z^2 = 2.25 +
  // 25/12; area 2 (6 + 15 + 10).
  const Moments expected = { 30.0, 60.0, 105.0, 45.0, 130.0, 390.0, 130.0, 210.0, 157.5, 90.0, 0.0, 0.0, 0.0,
    62.0 };
  for (int i = 0; i < 14; ++i)
  {
    Check(std::string("box ") + Names[i], expected[i], sum[i], 1e-15 * GetScale(i, 5.0, 62.0), "rounding");
  }
}

/// A leaf with a leaf cut out on an oblique plane of very unlike |Su| and |Sv|.
void CheckCurvedTrims()
{
  const Point3 u = { 6.0, 0.0, 8.0 };
  const Point3 v = { 0.06, 0.0, -0.03 };
  const sm::NURBSSurface plane = MakePlane({ 1.0, 2.0, -3.0 }, u, v, -4.0, 4.0, -3.0, 3.0);
  const std::vector<sm::Loop> loops = { MakeLeaf(0.2, -0.1, 2.5, 0.2, false),
    MakeLeaf(0.5, 0.25, 1.0, 0.15, true) };
  // Su x Sv = (0, 0.66, 0).
  const double area = 0.66 * (GetLeafArea(2.5, 0.2) - GetLeafArea(1.0, 0.15));
  for (const bool reversed : { false, true })
  {
    for (const double chord : { 1e-1, 1e-3, 1e-5, 1e-7 })
    {
      const sm::FacePointer face = MakeFace(plane, loops, reversed);
      const sm::SubPatchFace prepared = Prepare(face, chord);
      const Moments m = sm::ComputePlaneMoments(prepared);
      // Chords are within `chord` of borders that are 8 and 4 sides long, each at most 1.1 times its chord 10
      // sqrt 2 r / 2.
      const double border = 4.0 * 1.1 * 10.1 * (2.5 + 1.0);
      Check("area", area, m[13], chord * border, "border times chord tolerance");
      Check("NY", reversed ? -area : area, m[11], chord * border, "the same");
      const Moments other = IntegratePlane(*face, prepared.Polygons.Loops);
      for (int i = 0; i < 14; ++i)
      {
        const double expected = i == 13 ? std::abs(other[11]) : other[i];
        Check(std::string("by Green's theorem ") + Names[i], expected, m[i], 1e-13 * GetScale(i, 40.0, 10.0),
          "rounding of plain sums over some chords");
      }
    }
    // The tolerance is a length: with |Su| = 10 and 10 r u'' of 2.5 * 0.8 it takes that many chords, not a
    // power of ten more.
    const sm::SubPatchFace prepared = Prepare(MakeFace(plane, loops, reversed), 1e-5);
    const double chords = 4.0 * std::sqrt(2.0 * 2.0 * 10.0 / (8.0 * 1e-5));
    CheckRange(
      "chords at 1e-5", 0.5 * chords, static_cast<double>(prepared.Polygons.Loops[0].size()), 2.1 * chords);
  }
}

void CheckOthers()
{
  // A loop that encloses nothing, and one that runs twice round.
  const sm::NURBSSurface plane =
    MakePlane({ 0.0, 0.0, 2.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 0.0, 4.0, 0.0, 4.0);
  const Moments none = sm::ComputePlaneMoments(Prepare(MakeFace(plane, { sm::Loop() }), 1e-3));
  CheckTrue("a loop of nothing", none == Moments{});
  const std::vector<Point2> square = { { 1.0, 1.0 }, { 3.0, 1.0 }, { 3.0, 2.0 }, { 1.0, 2.0 } };
  const Moments twice = sm::ComputePlaneMoments(
    Prepare(MakeFace(plane, { MakePolygonLoop(square), MakePolygonLoop(square) }), 1e-3));
  Check("what two equal loops hold", 4.0, twice[13], 1e-14, "rounding");

  // A corner off by less than what counts as a plane: z = 100 + e u v on the unit square has V = 100 + e/4.
  sm::NURBSSurface twisted =
    MakePlane({ 0.0, 0.0, 100.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 0.0, 1.0, 0.0, 1.0);
  twisted.ControlPoints[3][2] += 8e-11;
  Check("a plane twisted by rounding", 2e-11,
    sm::ComputePlaneMoments(Prepare(MakeFace(twisted, {}), 0.0))[0] - 100.0, 2e-13, "rounding of 100");

  sm::SubPatchFace curved =
    sm::PrepareSubPatchFace(MakeFace(MakeQuarterCylinder(1.0, 1.0), {}), sm::SchemeOptions());
  CheckTrue(
    "a curved face has no such moments", !curved.Planar && sm::ComputePlaneMoments(curved) == Moments{});
}
}

int TestPlaneMoments(int, char*[])
{
  CheckTetrahedra();
  CheckBox();
  CheckCurvedTrims();
  CheckOthers();
  return Finish();
}
