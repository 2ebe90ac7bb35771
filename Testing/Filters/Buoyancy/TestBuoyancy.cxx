// TestBuoyancy FOLDER MODE BACKEND: volume and centre below waterlines against closed forms, each within its
// bound, and the bound within a tolerance of 1e-6, 1e-9 and 1e-12.
#include "smBuoyancyTesting.h"
#include "smTestManifest.h"

#include <algorithm>
#include <cstdio>

namespace
{
using namespace smtest;

constexpr double Tolerances[] = { 1e-6, 1e-9, 1e-12 };
/// Factor of the error of the file's numbers that a bound may have: reading rounds every coordinate more than
/// once, and the area of a ball is more than the square of its size.
constexpr double ReadingRoundings = 40.0;
/// The same for a placement, whose translation may be off by 32 u (PlacementError); the area of the patches
/// of the torus, as the bound takes it, is less than four times the square of its size.
constexpr double PlacementRoundings = 4.0 * 32.0;

/// `size`: the diameter of the body. `given`: how far the rounded numbers of the plane or of the file are
/// from the exact ones, a length.
void CheckPlanes(const std::string& what, Scene& scene, const std::vector<Plane>& planes, const Part& whole,
  Real size, Real given = 0, double roundings = ReadingRoundings)
{
  for (const double tolerance : Tolerances)
  {
    scene.Filter->SetRelativeTolerance(tolerance);
    vtkTypeInt64 evaluations = 0;
    double seconds = 0.0;
    for (const Plane& plane : planes)
    {
      SetPlane(scene.Filter, plane);
      scene.Filter->Update();
      evaluations += scene.Filter->GetEvaluations();
      seconds += scene.Filter->GetPrepareSeconds() + scene.Filter->GetIntegrateSeconds();
      char label[16];
      std::snprintf(label, sizeof(label), ", %g", tolerance);
      const std::string name = what + ": " + plane.Name + label;
      const auto area = static_cast<double>(size * size * given);
      if (tolerance > 1e-10 && roundings * area < tolerance * static_cast<double>(whole.Volume))
      {
        CheckEqual(name + ", status", "ok", scene.Filter->GetStatus());
        std::printf("%s", scene.Filter->GetStatus() == "ok" ? "" : GetMessages(scene.Filter).c_str());
      }
      const double bound = scene.Filter->GetDisplacedVolumeBound();
      Check(name, static_cast<double>(plane.Below.Volume), scene.Filter->GetDisplacedVolume(),
        bound + area + 2.3e-16 * static_cast<double>(plane.Below.Volume), "the bound");
      // 20: the volume's scale is rounded down to a power of two; rounding is 1e-12 of the box at most.
      CheckRange(name + ", bound", 0.0, bound,
        2.0 * tolerance * static_cast<double>(whole.Volume) + roundings * area +
          7e-13 * static_cast<double>(size * size * size));
      double center[3];
      scene.Filter->GetCenterOfBuoyancy(center);
      const double centerBound = scene.Filter->GetCenterOfBuoyancyBound();
      if (plane.Below.Volume == 0)
      {
        CheckTrue(name + ", no centre", std::isnan(center[0]) && std::isnan(centerBound));
        continue;
      }
      if (plane.Below.Volume < 1e-2L * whole.Volume)
      {
        // So small a volume may have no centre; a centre that is there is within its bound.
        if (std::isnan(centerBound))
        {
          continue;
        }
      }
      else
      {
        CheckRange(name + ", bound of the centre", 0.0, centerBound,
          (200.0 * tolerance + 1e-10) * static_cast<double>(size) +
            2.0 * roundings * area * static_cast<double>(size / plane.Below.Volume));
      }
      for (int c = 0; c < 3; ++c)
      {
        const Real exact = plane.Below.First[c] / plane.Below.Volume;
        Check(name + ", centre " + "xyz"[c], static_cast<double>(exact), center[c],
          centerBound + static_cast<double>(given) * 10.0 + 1.2e-16 * std::abs(static_cast<double>(exact)),
          "the bound");
      }
    }
    std::printf("     %s, %g: %lld evaluations for %d planes, %.2g s\n", what.c_str(), tolerance,
      static_cast<long long>(evaluations), static_cast<int>(planes.size()), seconds);
  }
}

Part Ball(Real radius, const Vector& center)
{
  const Real volume = 4 * Pi / 3 * radius * radius * radius;
  return { volume, Scaled(center, volume) };
}

/// A ball below the plane at distance d above its centre.
Plane BallPlane(const std::string& name, Real radius, const Vector& center, const Vector& up, Real d)
{
  const Vector unit = Unit(up);
  const Real h = std::clamp<Real>(d, -radius, radius);
  Plane plane{ name, Sum(center, Scaled(unit, d)), up, {} };
  plane.Below.Volume = Pi * (radius + h) * (radius + h) * (2 * radius - h) / 3;
  const Real square = radius * radius - h * h;
  plane.Below.First = Sum(Scaled(center, plane.Below.Volume), Scaled(unit, -Pi / 4 * square * square));
  return plane;
}

void CheckBalls(const Manifest& manifest)
{
  for (const Expected& part : manifest.GetSolid("sphere"))
  {
    if (!part.HasPcurves || part.Variant == "reversed")
    {
      continue;
    }
    const Vector center = { part.Center[0], part.Center[1], part.Center[2] };
    const Real radius = std::cbrt(3 * static_cast<Real>(part.Volume) / (4 * Pi));
    std::vector<Plane> planes;
    const std::pair<const char*, Vector> directions[] = { { "z", { 0, 0, 1 } }, { "-z", { 0, 0, -2 } },
      { "x", { 1e-3L, 0, 0 } }, { "askew", { 1, -2, 3 } }, { "nearly z", { 1e-5L, 2e-5L, 1 } } };
    for (const auto& [label, up] : directions)
    {
      // Points of the plane are doubles: far away they cannot be nearer to where they should be.
      for (const Real depth : { -1.5L, -0.999999L, -0.6L, 0.0L, 0.25L, 0.9999L, 1.5L })
      {
        char name[40];
        std::snprintf(name, sizeof(name), "%s %g", label, static_cast<double>(depth));
        planes.push_back(BallPlane(name, radius, center, up, depth * radius));
      }
    }
    Scene scene(part.Path);
    const Real far = 3e-16L * part.GetDistance();
    CheckPlanes("sphere " + part.Variant, scene, planes, Ball(radius, center), 2 * radius,
      far + 4e-16L * radius + static_cast<Real>(part.VolumeAccuracy) / (radius * radius));
  }
}

void CheckTangentBalls(const Manifest& manifest)
{
  Scene scene(manifest.GetSolid("sphere", "plain")[0].Path);
  std::vector<Plane> planes;
  for (const auto& [label, up] :
    { std::make_pair("z", Vector{ 0, 0, 1 }), std::make_pair("x", Vector{ 1, 0, 0 }) })
  {
    for (const double height : { -10.0, 10.0, std::nextafter(-10.0, 0.0), std::nextafter(10.0, 0.0), 0.0 })
    {
      char name[40];
      std::snprintf(name, sizeof(name), "%s %.17g", label, height);
      planes.push_back(BallPlane(name, 10, {}, up, height));
    }
  }
  CheckPlanes("touched sphere", scene, planes, Ball(10, {}), 20);
}

/// A cone about z of radius `bottom` at 0 and `top` at `height`, below z = h.
Part ConePart(Real bottom, Real top, Real height, Real h)
{
  const Real z = std::clamp<Real>(h, 0, height);
  const Real slope = (top - bottom) / height;
  Part part;
  part.Volume = Pi * (bottom * bottom * z + bottom * slope * z * z + slope * slope * z * z * z / 3);
  part.First[2] = Pi * z * z * (bottom * bottom / 2 + 2 * bottom * slope * z / 3 + slope * slope * z * z / 4);
  return part;
}

void CheckCones(const Manifest& manifest)
{
  const auto check = [](const Expected& file, Real top)
  {
    const Part whole = ConePart(12, top, 20, 20);
    std::vector<Plane> planes;
    for (const double height : { -1.0, 0.0, 1e-9, 0.3, 10.0, 17.5, 19.999, 20.0, 21.0 })
    {
      char name[40];
      std::snprintf(name, sizeof(name), "at %g", height);
      planes.push_back({ name, { 3, 4, height }, { 0, 0, 1 }, ConePart(12, top, 20, height) });
      planes.push_back(Opposite(planes.back(), whole));
    }
    // Through the axis, and through the tip: half of it.
    Plane half{ "half", { 0, 0, 20 }, { 0, -1, 0 }, {} };
    half.Below.Volume = whole.Volume / 2;
    half.Below.First[2] = whole.First[2] / 2;
    // The half disk's first moment is 2/3 r^3.
    Real cubes = 0;
    for (int i = 0; i <= 3; ++i)
    {
      cubes += std::pow(static_cast<Real>(12), 3 - i) * std::pow(top, i) * 20 / 4;
    }
    half.Below.First[1] = 2 * cubes / 3;
    planes.push_back(half);
    planes.push_back(Opposite(half, whole));
    Scene scene(file.Path);
    CheckPlanes(top > 0 ? "frustum" : "cone", scene, planes, whole, 30);
  };
  check(manifest.GetSolid("cone", "plain")[0], 5);
  const Expected tip = manifest.GetSpecial("cone_tip");
  check(tip, 0);
  // Oblique through the tip, touching it, and missing most of the cone.
  Scene scene(tip.Path);
  std::vector<Plane> planes;
  const Part whole = ConePart(12, 0, 20, 20);
  planes.push_back({ "touching the tip askew", { 0, 0, 20 }, { 0.3L, 0.1L, 1 }, whole });
  planes.push_back({ "touching the tip from above", { 0, 0, 20 }, { -0.3L, -0.1L, -1 }, {} });
  CheckPlanes("cone", scene, planes, whole, 30);
}

/// A box at the origin's corner below n . x = d, n > 0: by inclusion and exclusion of corner tetrahedra.
Part BoxPart(const Vector& sides, const Vector& n, Real d)
{
  Part part;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector at{};
    int count = 0;
    for (int c = 0; c < 3; ++c)
    {
      at[c] = corner >> c & 1 ? sides[c] : 0;
      count += corner >> c & 1;
    }
    const Real t = d - Dot(n, at);
    if (t > 0)
    {
      const Real volume = (count % 2 ? -1 : 1) * t * t * t / (6 * n[0] * n[1] * n[2]);
      part.Volume += volume;
      for (int c = 0; c < 3; ++c)
      {
        part.First[c] += volume * (at[c] + t / (4 * n[c]));
      }
    }
  }
  return part;
}

void CheckBoxes(const Manifest& manifest)
{
  const Vector sides = { 30, 20, 10 };
  const Part whole = { 6000, { 90000, 60000, 30000 } };
  Scene scene(manifest.GetSolid("box", "plain")[0].Path);
  std::vector<Plane> planes;
  const Vector n = { 0.25L, 0.5L, 1 };
  for (const Real d : { -1.0L, 0.0L, 0.01L, 4.0L, 10.0L, 13.75L, 20.0L, 27.5L, 28.0L })
  {
    char name[40];
    std::snprintf(name, sizeof(name), "tilted %g", static_cast<double>(d));
    planes.push_back({ name, { 0, 0, d }, n, BoxPart(sides, n, d) });
    planes.push_back(Opposite(planes.back(), whole));
  }
  // Along faces, through an edge, and level.
  for (const double h : { 0.0, 1e-13, 5.0, 10.0 - 1e-13, 10.0 })
  {
    char name[40];
    std::snprintf(name, sizeof(name), "level %.17g", h);
    planes.push_back({ name, { 7, 7, h }, { 0, 0, 1 },
      { 600 * static_cast<Real>(h),
        { 9000 * static_cast<Real>(h), 6000 * static_cast<Real>(h), 300 * static_cast<Real>(h) * h } } });
    planes.push_back(Opposite(planes.back(), whole));
  }
  planes.push_back({ "diagonal", { 0, 0, 0 }, { -1, 0, 3 }, { 3000, { 60000, 30000, 10000 } } });
  CheckPlanes("box", scene, planes, whole, 38);
}

/// The torus about z below z = d.
Part TorusPart(Real R, Real r, Real d)
{
  const Real z = std::clamp<Real>(d, -r, r);
  Part part;
  part.Volume = 2 * Pi * R * (r * r * (Pi - std::acos(z / r)) + z * std::sqrt(r * r - z * z));
  part.First[2] = -4 * Pi * R * std::pow(r * r - z * z, static_cast<Real>(1.5)) / 3;
  return part;
}

std::vector<Plane> MakeTorusPlanes(Part& whole)
{
  whole = TorusPart(20, 6, 6);
  std::vector<Plane> planes;
  for (const double d : { -6.0, -5.9999, -3.0, 0.0, 2.5, 5.9999, 6.0 })
  {
    char name[40];
    std::snprintf(name, sizeof(name), "level %g", d);
    planes.push_back({ name, { 0, 0, d }, { 0, 0, 1 }, TorusPart(20, 6, d) });
    planes.push_back(Opposite(planes.back(), whole));
  }
  Plane half{ "half", {}, { 1, 0, 0 }, { whole.Volume / 2, {} } };
  half.Below.First[0] = -2 * (Pi * 36 * 400 + Pi * 1296 / 4);
  planes.push_back(half);
  planes.push_back(Opposite(half, whole));
  // By symmetry about the centre half of it is below any plane through it.
  return planes;
}

void CheckTori(const Manifest& manifest)
{
  Part whole;
  const std::vector<Plane> planes = MakeTorusPlanes(whole);
  Scene scene(manifest.GetSolid("torus", "plain")[0].Path);
  CheckPlanes("torus", scene, planes, whole, 60);
}

/// Checks bodies whose placement mirrors, then rotates about y, x and z, then moves.
void CheckPlacements(const Manifest& manifest)
{
  Part whole;
  const std::vector<Plane> planes = MakeTorusPlanes(whole);
  for (const bool mirror : { false, true })
  {
    const Real angle = 30 * Pi / 180;
    const Real c = std::cos(angle);
    const Real s = std::sin(angle);
    const Vector move = { 1e5L, -2e4L, 300 };
    const auto turn = [&](const Vector& v) -> Vector
    {
      const Vector m = { mirror ? -v[0] : v[0], v[1], v[2] };
      const Vector y = { c * m[0] + s * m[2], m[1], -s * m[0] + c * m[2] };
      const Vector x = { y[0], c * y[1] - s * y[2], s * y[1] + c * y[2] };
      return { c * x[0] - s * x[1], s * x[0] + c * x[1], x[2] };
    };
    const auto place = [&](const Part& part) -> Part {
      return { part.Volume, Sum(turn(part.First), Scaled(move, part.Volume)) };
    };
    std::vector<Plane> placed;
    for (const Plane& plane : planes)
    {
      placed.push_back({ plane.Name, Sum(turn(plane.Point), move), turn(plane.Up), place(plane.Below) });
    }
    Scene scene(manifest.GetSolid("torus", "plain")[0].Path);
    scene.Move->SetRotation(30, 30, 30);
    scene.Move->SetTranslation(1e5, -2e4, 300);
    scene.Move->SetMirror(mirror ? vtkNURBSTransform::X : vtkNURBSTransform::NONE);
    // The plane's point and direction and the matrix are rounded, at a distance of 1e5.
    CheckPlanes(mirror ? "mirrored torus" : "moved torus", scene, placed, place(whole), 60, 1.2e-10L,
      PlacementRoundings);
  }
}

/// Bicubic heights of the wavy plate's floor over [0, 30] x [0, 24], which is 6 thick.
Real Floor(Real x, Real y)
{
  const Real heights[4][4] = { { 0, 3, -2, 1 }, { 2, 9, -5, 0.5L }, { -4, 6, 8, -3 }, { 1, -2, 4, 2.5L } };
  const Real u = x / 30;
  const Real v = y / 24;
  const Real a[4] = { (1 - u) * (1 - u) * (1 - u), 3 * u * (1 - u) * (1 - u), 3 * u * u * (1 - u),
    u * u * u };
  const Real b[4] = { (1 - v) * (1 - v) * (1 - v), 3 * v * (1 - v) * (1 - v), 3 * v * v * (1 - v),
    v * v * v };
  Real z = 0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      z += a[i] * b[j] * heights[i][j];
    }
  }
  return z;
}

void CheckPlates(const Manifest& manifest)
{
  // An upright plane y + k x = d: columns stay whole, and integrals over a triangle or trapezium of the
  // floor's powers are exact by Gauss' rule of five points in both directions, up to degree 9.
  const Real nodes[5] = { 0, 0.538469310105683091036314420700208805L,
    -0.538469310105683091036314420700208805L, 0.906179845938663992797626878299392965L,
    -0.906179845938663992797626878299392965L };
  const Real weights[5] = { 0.568888888888888888888888888888888889L, 0.478628670499366468041291514835638193L,
    0.478628670499366468041291514835638193L, 0.236926885056189087514264040719917363L,
    0.236926885056189087514264040719917363L };
  const auto below = [&](Real k, Real d)
  {
    Part part;
    for (int i = 0; i < 5; ++i)
    {
      const Real x = 15 + 15 * nodes[i];
      const Real end = d - k * x;
      for (int j = 0; j < 5; ++j)
      {
        const Real y = 0.5L * end * (1 + nodes[j]);
        const Real weight = 15 * weights[i] * 0.5L * end * weights[j];
        const Real floor = Floor(x, y);
        part.Volume += weight * 6;
        part.First = Sum(part.First, { weight * 6 * x, weight * 6 * y, weight * (6 * floor + 18) });
      }
    }
    return part;
  };
  const Part whole = below(0, 24);
  std::vector<Plane> planes;
  for (const auto& [k, d] : { std::pair<Real, Real>(0, 7), std::pair<Real, Real>(0.5L, 20),
         std::pair<Real, Real>(-0.25L, 10), std::pair<Real, Real>(0.7L, 21.0L) })
  {
    char name[40];
    std::snprintf(name, sizeof(name), "y + %g x = %g", static_cast<double>(k), static_cast<double>(d));
    planes.push_back({ name, { 0, d, 0 }, { k, 1, 0 }, below(k, d) });
    planes.push_back(Opposite(planes.back(), whole));
  }
  Scene scene(manifest.GetSolid("wavy_plate", "plain")[0].Path);
  CheckPlanes("plate", scene, planes, whole, 40);

  // A level plane cuts floor and ceiling in curves. No closed form: columns summed at a million points.
  scene.Filter->SetRelativeTolerance(1e-9);
  const double level = 4.5;
  scene.Filter->SetPoint(0, 0, level);
  scene.Filter->SetNormal(0, 0, 1);
  scene.Filter->Update();
  double volume = 0.0;
  double moment = 0.0;
  constexpr int Count = 1000;
  for (int i = 0; i < Count; ++i)
  {
    for (int j = 0; j < Count; ++j)
    {
      const auto floor = static_cast<double>(Floor((i + 0.5L) * 30 / Count, (j + 0.5L) * 24 / Count));
      const double top = std::clamp(level, floor, floor + 6.0);
      volume += (top - floor) * 720.0 / Count / Count;
      moment += 0.5 * (top * top - floor * floor) * 720.0 / Count / Count;
    }
  }
  double center[3];
  scene.Filter->GetCenterOfBuoyancy(center);
  Check("plate, level", volume, scene.Filter->GetDisplacedVolume(), 1e-5 * volume, "the sum's");
  Check("plate, level, centre", moment / volume, center[2], 1e-4, "the sum's");
}
}

int TestBuoyancy(int argc, char* argv[])
{
  return RunMode(argc, argv, "TestBuoyancy",
    { { "balls", CheckBalls }, { "tangent", CheckTangentBalls }, { "cones", CheckCones },
      { "boxes", CheckBoxes }, { "tori", CheckTori }, { "placements", CheckPlacements },
      { "plates", CheckPlates } });
}
