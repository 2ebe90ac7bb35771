// TestSolidStability FOLDER SOLIDS MODE: bodies whose stability has a closed form.
#include "smStabilityTesting.h"
#include "smStandingSolids.h"

#include "smTestManifest.h"

#include "smStepFile.h"

#include <vtkDataSetAttributes.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkMath.h>
#include <vtkNURBSTransform.h>
#include <vtkTable.h>

#include <cmath>

namespace
{
using namespace smtest;
namespace names = sm::names;

void TestShapes(const std::string& folder)
{
  const double r = 10.0;
  for (const int backend : { vtkMassPropertiesGPU::OPENGL, vtkMassPropertiesGPU::CPU })
  {
    std::printf("-- backend %d\n", backend);
    {
      Case flat(WriteStanding(folder, "flat", MakeHemisphere(r, false)));
      flat.Filter->SetBackend(backend);
      flat.Filter->Update();
      CheckVerdict("hemisphere on its flat face", flat.Filter, "stable", "area", "margin");
      // Curves are refined to 1e-5 of the size where the verdict is certain.
      CheckStanding(flat.Filter, r, 0.375 * r, r, 1e-5);
      CheckEqual("one face touches", 1, static_cast<long long>(Get(flat.Filter, names::ContactFaces)));
      CheckTrue("rolling means nothing", std::isnan(Get(flat.Filter, names::RollingMargin)));
    }
    {
      Case dome(WriteStanding(folder, "dome", MakeHemisphere(r, true)));
      dome.Filter->SetBackend(backend);
      dome.Filter->Update();
      CheckVerdict("hemisphere on its dome", dome.Filter, "stable", "point", "rolling");
      CheckBounded(dome.Filter, names::StabilityMargin, 0.0, 1e-7 * r);
      CheckBounded(dome.Filter, names::CenterHeight, 0.625 * r, 1e-8 * r);
      CheckBounded(dome.Filter, names::RollingMargin, 0.375 * r, 1e-6 * r);
    }
  }
  {
    // Tilted by a twentieth: it will roll back, but does not stand so.
    const double axis[3] = { 0, 1, 0 };
    const double shift[3] = { 0, 0, 0 };
    Case tilted(WriteStanding(folder, "tilted", Rotated(MakeHemisphere(r, true), axis, 0.05, shift)));
    tilted.Filter->Update();
    CheckVerdict("tilted hemisphere", tilted.Filter, "unstable", "point", "margin");
    CheckBounded(tilted.Filter, names::StabilityMargin, -0.375 * r * std::sin(0.05), 1e-7 * r);
  }
  {
    Case lying(WriteStanding(folder, "cylinder", MakeLyingCylinder(r, 30.0)));
    lying.Filter->Update();
    CheckVerdict("lying cylinder", lying.Filter, "too-close", "line", "rolling");
    CheckBounded(lying.Filter, names::StabilityMargin, 0.0, 1e-7 * r);
    CheckBounded(lying.Filter, names::RollingMargin, 0.0, 1e-6 * r);
    vtkTable* sides = vtkTable::SafeDownCast(lying.Filter->GetOutputDataObject(3));
    if (CheckEqual("both ways to roll", 2, sides->GetNumberOfRows()))
      Check("length of the line", 30.0,
        std::fabs(sides->GetRowData()->GetArray(names::SideFrom)->GetComponent(0, 0) -
          sides->GetRowData()->GetArray(names::SideTo)->GetComponent(0, 0)),
        1e-9);
  }
  {
    Case half(WriteStanding(folder, "half_cylinder", MakeLyingHalfCylinder(r, 30.0)));
    half.Filter->Update();
    CheckVerdict("half a cylinder on its round side", half.Filter, "stable", "line", "rolling");
    CheckBounded(half.Filter, names::RollingMargin, 4.0 * r / (3.0 * vtkMath::Pi()), 1e-6 * r);
    half.Filter->SetGravityDirection(0, 0, 1);
    half.Filter->Update();
    CheckVerdict("half a cylinder on its flat side", half.Filter, "stable", "area", "margin");
    CheckStanding(half.Filter, r, 4.0 * r / (3.0 * vtkMath::Pi()), r);
  }
  {
    Case tripod(WriteStanding(folder, "tripod", MakeTripod(10.0)));
    tripod.Filter->Update();
    CheckVerdict("tripod on three balls", tripod.Filter, "stable", "area", "margin");
    CheckBounded(tripod.Filter, names::StabilityMargin, 5.0, 1e-6);
    CheckEqual(
      "three sides", 3, vtkTable::SafeDownCast(tripod.Filter->GetOutputDataObject(3))->GetNumberOfRows());
  }
  {
    Case dumbbell(WriteStanding(folder, "dumbbell", MakeDumbbell(3.0, 20.0)));
    dumbbell.Filter->Update();
    CheckVerdict("dumbbell", dumbbell.Filter, "too-close", "line", "rolling");
    CheckBounded(dumbbell.Filter, names::RollingMargin, 0.0, 1e-6);
  }
  {
    Case cone(WriteStanding(folder, "tip", MakeTipCone(5.0, 10.0)));
    cone.Filter->Update();
    CheckVerdict("cone on its tip", cone.Filter, "unstable", "point", "rolling");
    CheckBounded(cone.Filter, names::RollingMargin, -7.5, 1e-6);
  }
}

/// Where one side of the contact is round and the other is not, it rolls back from one and tips over the
/// other.
void TestOneSided(const std::string& folder)
{
  Case rocker(WriteStanding(folder, "rocker", MakeHalfRocker()));
  rocker.Filter->Update();
  CheckVerdict("half a rocker", rocker.Filter, "unstable", "line", "rolling");
  CheckBounded(rocker.Filter, names::StabilityMargin, 0.0, 1e-6);
  CheckBounded(rocker.Filter, names::RollingMargin, -Get(rocker.Filter, names::CenterHeight), 1e-6);
}

/// The pole of half a ball is on the border of its sphere: to one side it rolls back, to the other it falls
/// over.
void TestHalfBall(const std::string& folder)
{
  Case half(WriteStanding(folder, "half_ball", MakeHalfBall()));
  half.Filter->Update();
  CheckVerdict("half a ball on its pole", half.Filter, "unstable", "point", "rolling");
  CheckBounded(half.Filter, names::StabilityMargin, 0.0, 1e-6);
  CheckBounded(half.Filter, names::RollingMargin, -Get(half.Filter, names::CenterHeight), 1e-6);
}

/// On a slope the contact moves on by cos^2 of the angle only, seen from above: a dome with its centre of
/// mass above the contact, which is `angle` from its pole, rolls back while cos(angle) > 3/8.
void TestDomeOnSlopes(const std::string& folder)
{
  const double r = 10.0;
  const std::string path = WriteStanding(folder, "dome_on_slope", MakeHemisphere(r, true));
  for (const double angle : { 0.3, 1.0, 1.18, 1.19, 1.3 })
  {
    const double up[3] = { -r * std::sin(angle), 0.0, r * std::cos(angle) - 0.375 * r };
    const double z = r - 0.375 * r * std::cos(angle);
    Case dome(path);
    dome.Filter->SetGravityDirection(-up[0], -up[1], -up[2]);
    dome.Filter->SetGroundNormal(-std::sin(angle), 0, std::cos(angle));
    dome.Filter->Update();
    CheckVerdict("dome on a slope, " + std::to_string(angle), dome.Filter,
      std::cos(angle) > 0.375 ? "stable" : "unstable", "point", "rolling");
    CheckBounded(dome.Filter, names::CenterHeight, z, 1e-8 * r);
    CheckBounded(dome.Filter, names::RollingMargin, r - (up[0] * up[0] + up[2] * up[2]) / z, 1e-6 * r);
  }
}

/// On nearly vertical ground the rounding of its directions moves the projected centre of mass far.
void TestSteepGround(const Manifest& manifest)
{
  using Wide = long double;
  const Expected expected = manifest.GetSolid("sphere", "plain")[0];
  const Wide radius = std::cbrt(3 * static_cast<Wide>(expected.Volume) / (4 * 3.14159265358979323846L));
  Case ball(expected.Path);
  ball.Filter->SetRelativeTolerance(1e-13);
  for (const double steep : { 1.0, 30.0, 1e3, 3e4, 9e5 })
  {
    const double n[3] = { 0.31, 0.57, -0.76 };
    const double up[3] = { n[0] + steep * 0.57, n[1] - steep * 0.31, n[2] };
    const Wide dot =
      static_cast<Wide>(n[0]) * up[0] + static_cast<Wide>(n[1]) * up[1] + static_cast<Wide>(n[2]) * up[2];
    Wide squared = 0;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const Wide cross = static_cast<Wide>(n[i]) * up[j] - static_cast<Wide>(n[j]) * up[i];
      squared += cross * cross;
    }
    ball.Filter->SetGravityDirection(-up[0], -up[1], -up[2]);
    ball.Filter->SetGroundNormal(n);
    ball.Filter->Update();
    const double exact = static_cast<double>(-radius * std::sqrt(squared) / dot);
    Check("ball on ground of slope " + std::to_string(steep), exact, ball.Filter->GetStabilityMargin(),
      ball.Filter->GetStabilityMarginBound(), "its own bound");
  }
}

/// The bound of a centre is that of its components, and the foot may be off along all of them.
void TestCenterBound(const std::string& folder)
{
  Case half(WriteStanding(folder, "loose", MakeLyingHalfCylinder(10.0, 30.0)));
  half.Filter->SetGravityDirection(0, 0, 1);
  half.Filter->SetRelativeTolerance(1e-2);
  half.Filter->Update();
  CheckRange("bound of the margin in those of the centre's components", std::sqrt(3.0),
    half.Filter->GetStabilityMarginBound() / half.Filter->GetMassProperties()->GetCenterOfMassBound(), 1e300);
}

/// A torus that lies touches along a circle, and one that stands in a point; a ball anywhere.
void TestCatalogue(const Manifest& manifest)
{
  // The catalogue's torus: radii 20 and 6, axis z where it is not rotated.
  for (const char* variant : { "plain", "far", "nurbs" })
  {
    Case lying(manifest.GetSolid("torus", variant)[0].Path);
    lying.Filter->Update();
    CheckVerdict(std::string("lying torus, ") + variant, lying.Filter, "stable", "area", "margin");
    CheckStanding(lying.Filter, 20.0, 6.0, 26.0, 1e-5);
    lying.Filter->SetGravityDirection(3, -4, 0);
    lying.Filter->Update();
    CheckVerdict(std::string("standing torus, ") + variant, lying.Filter, "unstable", "point", "rolling");
    CheckBounded(lying.Filter, names::RollingMargin, 6.0 - 26.0, 1e-6 * 26.0);
  }
  for (const char* variant : { "plain", "turned", "inch" })
  {
    Case ball(manifest.GetSolid("sphere", variant)[0].Path);
    ball.Filter->Update();
    CheckVerdict(std::string("ball, ") + variant, ball.Filter, "too-close", "point", "rolling");
  }
}

/// Margin a/2 - lean/2 about the edge x = a.
void CheckPrism(const std::string& folder, const std::string& name, double share, const char* verdict)
{
  const double a = 10.0;
  const double height = 30.0;
  const double lean = a * (1.0 - 2.0 * share);
  const TopoDS_Shape prism = MakeLeaningPrism(a, 20.0, height, lean);
  const double exact = 0.5 * (a - lean);
  {
    Case standing(WriteStanding(folder, "prism_" + name, prism));
    standing.Filter->Update();
    CheckVerdict("prism, " + name, standing.Filter, verdict, "area", "margin");
    CheckBounded(standing.Filter, names::StabilityMargin, exact, 1e-10);
    CheckBounded(standing.Filter, names::TipAngle, std::atan2(exact, 0.5 * height) * Degrees, 1e-9);
    CheckEqual(
      "four sides", 4, vtkTable::SafeDownCast(standing.Filter->GetOutputDataObject(3))->GetNumberOfRows());
  }
  {
    // Rotated with gravity, 1e5 away: the file's numbers have 11 digits behind the point there.
    const double axis[3] = { 1, 2, -2 };
    const double shift[3] = { 1e5, -1e5, 1e5 };
    const double angle = 1.1;
    Case far(WriteStanding(folder, "far_" + name, Rotated(prism, axis, angle, shift)));
    // Rodrigues' formula for -z.
    const double k[3] = { 1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0 };
    const double c = std::cos(angle);
    const double sine = std::sin(angle);
    far.Filter->SetGravityDirection(-(k[1] * sine + k[0] * k[2] * (1 - c)),
      -(-k[0] * sine + k[1] * k[2] * (1 - c)), -(c + k[2] * k[2] * (1 - c)));
    far.Filter->Update();
    CheckVerdict("far prism, " + name, far.Filter, verdict, "area", "margin");
    Check("margin of the far prism", exact, far.Filter->GetStabilityMargin(),
      far.Filter->GetStabilityMarginBound() + 4e-11, "its bound, and what the file's digits hold");
  }
}

void TestTipping(const std::string& folder)
{
  CheckPrism(folder, "inside", 1e-9, "stable");
  CheckPrism(folder, "outside", -1e-9, "unstable");
  CheckPrism(folder, "upright", 0.5, "stable");
  const double a = 10.0;
  for (const double share : { 0.0, 1e-14, -1e-14 })
  {
    Case over(WriteStanding(folder, "prism_over", MakeLeaningPrism(a, 20.0, 30.0, a * (1.0 - 2.0 * share))));
    over.Filter->Update();
    CheckVerdict("prism over its edge", over.Filter, "too-close", "area", "margin");
    CheckBounded(over.Filter, names::StabilityMargin, share * a, 1e-10);
  }
  {
    // Mirrored: the same on the other side. And it follows a move.
    Case prism(WriteStanding(folder, "prism_mirror", MakeLeaningPrism(a, 20.0, 30.0, 8.0)));
    vtkNew<vtkNURBSTransform> mirror;
    mirror->SetInputConnection(prism.Reader->GetOutputPort());
    mirror->SetMirror(vtkNURBSTransform::X);
    prism.Filter->SetInputConnection(mirror->GetOutputPort());
    prism.Filter->Update();
    CheckVerdict("mirrored prism", prism.Filter, "stable", "area", "margin");
    CheckBounded(prism.Filter, names::StabilityMargin, 1.0, 1e-9);
    Check("projected centre of mass", -9.0, Get(prism.Filter, names::ProjectedCenterOfMass, 0), 1e-9);
    mirror->SetTranslation(100, 0, 50);
    prism.Filter->Update();
    Check("projected centre of mass after the move", 91.0, Get(prism.Filter, names::ProjectedCenterOfMass, 0),
      1e-9);
    Check("its height", 50.0, Get(prism.Filter, names::ProjectedCenterOfMass, 2), 1e-9);
    mirror->SetRotation(0, 40, 0);
    prism.Filter->Update();
    CheckTrue("a turn is seen",
      prism.Filter->GetStability() != "stable" || prism.Filter->GetSupport() != "area",
      prism.Filter->GetStability());
  }
}

void TestGround(const std::string& folder)
{
  const double a = 10.0;
  const double h = 30.0;
  const std::string path = WriteStanding(folder, "box", MakeLeaningPrism(a, 20.0, h, 0.0));
  // On a slope the box tips about its lower edge at tan(angle) = a / h.
  const double limit = std::atan2(a, h);
  for (const double angle : { 0.1, limit * (1 - 1e-9), limit * (1 + 1e-9), 1.0 })
  {
    Case slope(path);
    slope.Filter->SetGravityDirection(-std::sin(angle), 0, -std::cos(angle));
    slope.Filter->SetGroundNormal(0, 0, -2);
    slope.Filter->SetDensity(1000.0);
    slope.Filter->Update();
    CheckVerdict("box on a slope", slope.Filter, angle < limit ? "stable" : "unstable", "area", "margin");
    CheckBounded(slope.Filter, names::StabilityMargin, 0.5 * a - 0.5 * h * std::tan(angle), 1e-9);
    CheckBounded(slope.Filter, names::TipAngle, (limit - angle) * Degrees, 1e-8);
    // 1 - cos without its cancellation.
    const double half = std::sin(0.5 * (limit - angle));
    const double rise = angle < limit ? 2.0 * std::hypot(0.5 * a, 0.5 * h) * half * half : 0.0;
    CheckBounded(slope.Filter, names::CenterOfMassRise, rise, 1e-9);
    // 6 cm^3 of water.
    Check("joules", 6e-3 * 9.80665 * rise * 1e-3, Get(slope.Filter, names::TipEnergy), 1e-12);
  }
  {
    Case plane(path);
    plane.Filter->SetGround(vtkSolidStability::PLANE);
    plane.Filter->Update();
    CheckVerdict("box on the plane z = 0", plane.Filter, "stable", "area", "margin");
    plane.Filter->SetGroundOrigin(7, 7, -5);
    plane.Filter->Update();
    CheckVerdict("plane below", plane.Filter, "no-contact", "none", "none");
    CheckBounded(plane.Filter, names::Clearance, 5.0, 1e-9);
    const auto says = [&plane](const std::string& words)
    {
      auto* text = vtkTable::SafeDownCast(plane.Filter->GetOutputDataObject(2));
      return text->GetValueByName(0, names::Text).ToString().find(words) != std::string::npos;
    };
    CheckTrue("how far above, in words", says("no-contact: its lowest point is 5 mm above the ground"));
    CheckTrue("no margin", std::isnan(plane.Filter->GetStabilityMargin()));
    plane.Filter->SetGroundOrigin(7, 7, 5);
    plane.Filter->Update();
    CheckVerdict("plane through the box", plane.Filter, "below-ground", "none", "none");
    CheckTrue("how far below, in words", says("below-ground: it reaches 5 mm below the ground"));
    // Within the tolerance of 1e-6 of the diagonal, 37.4.
    plane.Filter->SetGroundOrigin(0, 0, -3e-5);
    plane.Filter->Update();
    CheckVerdict("plane hardly below", plane.Filter, "stable", "area", "margin");
    plane.Filter->SetContactTolerance(1e-7);
    plane.Filter->Update();
    CheckVerdict("the same with a finer tolerance", plane.Filter, "no-contact", "none", "none");
  }
  {
    // Tilted by an angle that the tolerance takes for level, and by one that it does not.
    const double axis[3] = { 0, 1, 0 };
    const double shift[3] = { 0, 0, 0 };
    for (const double angle : { 1e-7, 1e-4 })
    {
      Case tilted(
        WriteStanding(folder, "tilted_box", Rotated(MakeLeaningPrism(a, 20.0, h, 0.0), axis, angle, shift)));
      tilted.Filter->Update();
      CheckEqual("support of a box tilted by " + std::to_string(angle), angle < 1e-6 ? "area" : "line",
        tilted.Filter->GetSupport());
      CheckEqual("its verdict", angle < 1e-6 ? "stable" : "unstable", tilted.Filter->GetStability());
    }
  }
}
}

int TestSolidStability(int argc, char* argv[])
{
  RequireUsage(argc == 4, "TestSolidStability FOLDER SOLIDS MODE");
  QuietOcct();
  const std::string folder = argv[1];
  const Manifest manifest(argv[2]);
  const std::string mode = argv[3];
  if (mode == "shapes")
  {
    TestShapes(folder);
    TestOneSided(folder);
    TestHalfBall(folder);
    TestCenterBound(folder);
    TestCatalogue(manifest);
  }
  else if (mode == "tipping")
  {
    TestTipping(folder);
  }
  else
  {
    TestGround(folder);
    TestDomeOnSlopes(folder);
    TestSteepGround(manifest);
  }
  return Finish();
}
