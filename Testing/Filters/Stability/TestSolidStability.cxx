// TestSolidStability FOLDER SOLIDS MODE: bodies whose stability has a closed form.
#include "smStandingSolids.h"

#include "smBoxBodies.h"
#include "smDecimalCommas.h"
#include "smStabilityNames.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include "smStepFile.h"

#include <vtkCallbackCommand.h>
#include <vtkDataSetAttributes.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkMatrix4x4.h>
#include <vtkNURBSTransform.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSolidStability.h>
#include <vtkTable.h>
#include <vtkTrimmedNURBSModel.h>

#include <cmath>
#include <new>

namespace
{
namespace names = sm::names;
const double Pi = 3.14159265358979323846;
const double Degrees = 180.0 / Pi;
const double NaN = std::nan("");

struct Case
{
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<vtkSolidStability> Filter;

  explicit Case(const std::string& path)
  {
    this->Reader->SetFileName(path.c_str());
    this->Filter->SetInputConnection(this->Reader->GetOutputPort());
  }
};

double Get(vtkSolidStability* filter, const std::string& name, int component = 0)
{
  return smtest::GetField(filter->GetOutput()->GetFieldData(), name, component);
}

std::string GetText(vtkSolidStability* filter, const char* name)
{
  return smtest::GetFieldText(filter->GetOutput()->GetFieldData(), name);
}

/// |value - exact| <= bound, and the bound is worth having.
void CheckBounded(vtkSolidStability* filter, const char* name, double exact, double most)
{
  const double bound = Get(filter, std::string(name) + names::BoundSuffix);
  smtest::Check(name, exact, Get(filter, name), bound, "its own bound");
  smtest::CheckRange(std::string(name) + "Bound", 0.0, bound, most, "no vacuous bound");
}

void CheckVerdict(const std::string& what, vtkSolidStability* filter, const char* verdict,
  const char* support, const char* decider)
{
  smtest::CheckEqual(what, verdict, filter->GetStability());
  smtest::CheckEqual(what + ", support", support, filter->GetSupport());
  smtest::CheckEqual(what + ", decided by", decider, GetText(filter, names::DecidedBy));
}

/// Margin m and height z on level ground, with the angle and the work that follow.
void CheckStanding(vtkSolidStability* filter, double m, double z, double size, double relative = 1e-8)
{
  CheckBounded(filter, names::StabilityMargin, m, relative * size);
  CheckBounded(filter, names::CenterHeight, z, 1e-8 * size);
  CheckBounded(filter, names::TipAngle, std::atan2(m, z) * Degrees, 10.0 * Degrees * relative * size / z);
  CheckBounded(filter, names::CenterOfMassRise, std::hypot(m, z) - z, 10.0 * relative * size);
}

// --- shapes ------------------------------------------------------------------------------------

void TestShapes(const std::string& folder)
{
  const double r = 10.0;
  for (const int backend : { vtkMassPropertiesGPU::OPENGL, vtkMassPropertiesGPU::CPU })
  {
    std::printf("-- backend %d\n", backend);
    {
      Case flat(smtest::WriteStanding(folder, "flat", smtest::MakeHemisphere(r, false)));
      flat.Filter->SetBackend(backend);
      flat.Filter->Update();
      CheckVerdict("hemisphere on its flat face", flat.Filter, "stable", "area", "margin");
      // Curves are refined to 1e-5 of the size where the verdict is certain.
      CheckStanding(flat.Filter, r, 0.375 * r, r, 1e-5);
      smtest::CheckEqual(
        "one face touches", 1, static_cast<long long>(Get(flat.Filter, names::ContactFaces)));
      smtest::CheckTrue("rolling means nothing", std::isnan(Get(flat.Filter, names::RollingMargin)));
    }
    {
      Case dome(smtest::WriteStanding(folder, "dome", smtest::MakeHemisphere(r, true)));
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
    Case tilted(smtest::WriteStanding(
      folder, "tilted", smtest::Rotated(smtest::MakeHemisphere(r, true), axis, 0.05, shift)));
    tilted.Filter->Update();
    CheckVerdict("tilted hemisphere", tilted.Filter, "unstable", "point", "margin");
    CheckBounded(tilted.Filter, names::StabilityMargin, -0.375 * r * std::sin(0.05), 1e-7 * r);
  }
  {
    Case lying(smtest::WriteStanding(folder, "cylinder", smtest::MakeLyingCylinder(r, 30.0)));
    lying.Filter->Update();
    CheckVerdict("lying cylinder", lying.Filter, "too-close", "line", "rolling");
    CheckBounded(lying.Filter, names::StabilityMargin, 0.0, 1e-7 * r);
    CheckBounded(lying.Filter, names::RollingMargin, 0.0, 1e-6 * r);
    vtkTable* sides = vtkTable::SafeDownCast(lying.Filter->GetOutputDataObject(3));
    if (smtest::CheckEqual("both ways to roll", 2, sides->GetNumberOfRows()))
      smtest::Check("length of the line", 30.0,
        std::fabs(sides->GetRowData()->GetArray(names::SideFrom)->GetComponent(0, 0) -
          sides->GetRowData()->GetArray(names::SideTo)->GetComponent(0, 0)),
        1e-9);
  }
  {
    Case half(smtest::WriteStanding(folder, "half_cylinder", smtest::MakeLyingHalfCylinder(r, 30.0)));
    half.Filter->Update();
    CheckVerdict("half a cylinder on its round side", half.Filter, "stable", "line", "rolling");
    CheckBounded(half.Filter, names::RollingMargin, 4.0 * r / (3.0 * Pi), 1e-6 * r);
    half.Filter->SetGravityDirection(0, 0, 1);
    half.Filter->Update();
    CheckVerdict("half a cylinder on its flat side", half.Filter, "stable", "area", "margin");
    CheckStanding(half.Filter, r, 4.0 * r / (3.0 * Pi), r);
  }
  {
    Case tripod(smtest::WriteStanding(folder, "tripod", smtest::MakeTripod(10.0)));
    tripod.Filter->Update();
    CheckVerdict("tripod on three balls", tripod.Filter, "stable", "area", "margin");
    CheckBounded(tripod.Filter, names::StabilityMargin, 5.0, 1e-6);
    smtest::CheckEqual(
      "three sides", 3, vtkTable::SafeDownCast(tripod.Filter->GetOutputDataObject(3))->GetNumberOfRows());
  }
  {
    Case dumbbell(smtest::WriteStanding(folder, "dumbbell", smtest::MakeDumbbell(3.0, 20.0)));
    dumbbell.Filter->Update();
    CheckVerdict("dumbbell", dumbbell.Filter, "too-close", "line", "rolling");
    CheckBounded(dumbbell.Filter, names::RollingMargin, 0.0, 1e-6);
  }
  {
    Case cone(smtest::WriteStanding(folder, "tip", smtest::MakeTipCone(5.0, 10.0)));
    cone.Filter->Update();
    CheckVerdict("cone on its tip", cone.Filter, "unstable", "point", "rolling");
    CheckBounded(cone.Filter, names::RollingMargin, -7.5, 1e-6);
  }
}

/// Where one side of the contact is round and the other is not, it rolls back from one and tips over the other.
void TestOneSided(const std::string& folder)
{
  Case rocker(smtest::WriteStanding(folder, "rocker", smtest::MakeHalfRocker()));
  rocker.Filter->Update();
  CheckVerdict("half a rocker", rocker.Filter, "unstable", "line", "rolling");
  CheckBounded(rocker.Filter, names::StabilityMargin, 0.0, 1e-6);
  CheckBounded(rocker.Filter, names::RollingMargin, -Get(rocker.Filter, names::CenterHeight), 1e-6);
}

/// The pole of half a ball is on the border of its sphere: to one side it rolls back, to the other it falls over.
void TestHalfBall(const std::string& folder)
{
  Case half(smtest::WriteStanding(folder, "half_ball", smtest::MakeHalfBall()));
  half.Filter->Update();
  CheckVerdict("half a ball on its pole", half.Filter, "unstable", "point", "rolling");
  CheckBounded(half.Filter, names::StabilityMargin, 0.0, 1e-6);
  CheckBounded(half.Filter, names::RollingMargin, -Get(half.Filter, names::CenterHeight), 1e-6);
}

/// On a slope the contact moves on by cos^2 of the angle only, seen from above: a dome with its centre of mass above the contact,
/// which is `angle` from its pole, rolls back while cos(angle) > 3/8.
void TestDomeOnSlopes(const std::string& folder)
{
  const double r = 10.0;
  const std::string path = smtest::WriteStanding(folder, "dome_on_slope", smtest::MakeHemisphere(r, true));
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
void TestSteepGround(const smtest::Manifest& manifest)
{
  using Real = long double;
  const smtest::Expected expected = manifest.GetSolid("sphere", "plain")[0];
  const Real radius = std::cbrt(3 * static_cast<Real>(expected.Volume) / (4 * 3.14159265358979323846L));
  Case ball(expected.Path);
  ball.Filter->SetRelativeTolerance(1e-13);
  for (const double steep : { 1.0, 30.0, 1e3, 3e4, 9e5 })
  {
    const double n[3] = { 0.31, 0.57, -0.76 };
    const double up[3] = { n[0] + steep * 0.57, n[1] - steep * 0.31, n[2] };
    const Real dot =
      static_cast<Real>(n[0]) * up[0] + static_cast<Real>(n[1]) * up[1] + static_cast<Real>(n[2]) * up[2];
    Real squared = 0;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const Real cross = static_cast<Real>(n[i]) * up[j] - static_cast<Real>(n[j]) * up[i];
      squared += cross * cross;
    }
    ball.Filter->SetGravityDirection(-up[0], -up[1], -up[2]);
    ball.Filter->SetGroundNormal(n);
    ball.Filter->Update();
    const double exact = static_cast<double>(-radius * std::sqrt(squared) / dot);
    smtest::Check("ball on ground of slope " + std::to_string(steep), exact,
      ball.Filter->GetStabilityMargin(), ball.Filter->GetStabilityMarginBound(), "its own bound");
  }
}

/// The bound of a centre is that of its components, and the foot may be off along all of them.
void TestCenterBound(const std::string& folder)
{
  Case half(smtest::WriteStanding(folder, "loose", smtest::MakeLyingHalfCylinder(10.0, 30.0)));
  half.Filter->SetGravityDirection(0, 0, 1);
  half.Filter->SetRelativeTolerance(1e-2);
  half.Filter->Update();
  smtest::CheckRange("bound of the margin in those of the centre's components", std::sqrt(3.0),
    half.Filter->GetStabilityMarginBound() / half.Filter->GetMassProperties()->GetCenterOfMassBound(), 1e300);
}

/// A torus that lies touches along a circle, and one that stands in a point; a ball anywhere.
void TestCatalogue(const smtest::Manifest& manifest)
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

// --- tipping -----------------------------------------------------------------------------------

/// Margin a/2 - lean/2 about the edge x = a.
void CheckPrism(const std::string& folder, const std::string& name, double share, const char* verdict)
{
  const double a = 10.0;
  const double height = 30.0;
  const double lean = a * (1.0 - 2.0 * share);
  const TopoDS_Shape prism = smtest::MakeLeaningPrism(a, 20.0, height, lean);
  const double exact = 0.5 * (a - lean);
  {
    Case standing(smtest::WriteStanding(folder, "prism_" + name, prism));
    standing.Filter->Update();
    CheckVerdict("prism, " + name, standing.Filter, verdict, "area", "margin");
    CheckBounded(standing.Filter, names::StabilityMargin, exact, 1e-10);
    CheckBounded(standing.Filter, names::TipAngle, std::atan2(exact, 0.5 * height) * Degrees, 1e-9);
    smtest::CheckEqual(
      "four sides", 4, vtkTable::SafeDownCast(standing.Filter->GetOutputDataObject(3))->GetNumberOfRows());
  }
  {
    // Rotated with gravity, 1e5 away: the file's numbers have 11 digits behind the point there.
    const double axis[3] = { 1, 2, -2 };
    const double shift[3] = { 1e5, -1e5, 1e5 };
    const double angle = 1.1;
    Case far(smtest::WriteStanding(folder, "far_" + name, smtest::Rotated(prism, axis, angle, shift)));
    // Rodrigues' formula for -z.
    const double k[3] = { 1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0 };
    const double c = std::cos(angle);
    const double sine = std::sin(angle);
    far.Filter->SetGravityDirection(-(k[1] * sine + k[0] * k[2] * (1 - c)),
      -(-k[0] * sine + k[1] * k[2] * (1 - c)), -(c + k[2] * k[2] * (1 - c)));
    far.Filter->Update();
    CheckVerdict("far prism, " + name, far.Filter, verdict, "area", "margin");
    smtest::Check("margin of the far prism", exact, far.Filter->GetStabilityMargin(),
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
    Case over(smtest::WriteStanding(
      folder, "prism_over", smtest::MakeLeaningPrism(a, 20.0, 30.0, a * (1.0 - 2.0 * share))));
    over.Filter->Update();
    CheckVerdict("prism over its edge", over.Filter, "too-close", "area", "margin");
    CheckBounded(over.Filter, names::StabilityMargin, share * a, 1e-10);
  }
  {
    // Mirrored: the same on the other side. And it follows a move.
    Case prism(smtest::WriteStanding(folder, "prism_mirror", smtest::MakeLeaningPrism(a, 20.0, 30.0, 8.0)));
    vtkNew<vtkNURBSTransform> mirror;
    mirror->SetInputConnection(prism.Reader->GetOutputPort());
    mirror->SetMirror(vtkNURBSTransform::X);
    prism.Filter->SetInputConnection(mirror->GetOutputPort());
    prism.Filter->Update();
    CheckVerdict("mirrored prism", prism.Filter, "stable", "area", "margin");
    CheckBounded(prism.Filter, names::StabilityMargin, 1.0, 1e-9);
    smtest::Check("projected centre of mass", -9.0, Get(prism.Filter, names::ProjectedCenterOfMass, 0), 1e-9);
    mirror->SetTranslation(100, 0, 50);
    prism.Filter->Update();
    smtest::Check("projected centre of mass after the move", 91.0,
      Get(prism.Filter, names::ProjectedCenterOfMass, 0), 1e-9);
    smtest::Check("its height", 50.0, Get(prism.Filter, names::ProjectedCenterOfMass, 2), 1e-9);
    mirror->SetRotation(0, 40, 0);
    prism.Filter->Update();
    smtest::CheckTrue("a turn is seen",
      prism.Filter->GetStability() != "stable" || prism.Filter->GetSupport() != "area",
      prism.Filter->GetStability());
  }
}

// --- the ground --------------------------------------------------------------------------------

void TestGround(const std::string& folder)
{
  const double a = 10.0;
  const double h = 30.0;
  const std::string path = smtest::WriteStanding(folder, "box", smtest::MakeLeaningPrism(a, 20.0, h, 0.0));
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
    smtest::Check("joules", 6e-3 * 9.80665 * rise * 1e-3, Get(slope.Filter, names::TipEnergy), 1e-12);
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
    smtest::CheckTrue("no margin", std::isnan(plane.Filter->GetStabilityMargin()));
    plane.Filter->SetGroundOrigin(7, 7, 5);
    plane.Filter->Update();
    CheckVerdict("plane through the box", plane.Filter, "below-ground", "none", "none");
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
      Case tilted(smtest::WriteStanding(folder, "tilted_box",
        smtest::Rotated(smtest::MakeLeaningPrism(a, 20.0, h, 0.0), axis, angle, shift)));
      tilted.Filter->Update();
      smtest::CheckEqual("support of a box tilted by " + std::to_string(angle),
        angle < 1e-6 ? "area" : "line", tilted.Filter->GetSupport());
      smtest::CheckEqual("its verdict", angle < 1e-6 ? "stable" : "unstable", tilted.Filter->GetStability());
    }
  }
}

// --- bodies ------------------------------------------------------------------------------------

void TestBodies(const std::string& folder, const smtest::Manifest& manifest)
{
  // A cube of 10 and a plate at its side, up to x = 40, that only the cube holds.
  vtkNew<vtkPartitionedDataSetCollection> assembly;
  vtkSmartPointer<vtkNURBSDataSet> leaves[2];
  const smtest::BoxShell shells[2] = { { { 0, 0, 0 }, { 10, 10, 10 } }, { { 10, 0, 8 }, { 40, 10, 10 } } };
  for (unsigned int i = 0; i < 2; ++i)
  {
    smtest::BoxBody body;
    body.Add(shells[i]);
    leaves[i] = body.Make();
    assembly->SetPartition(i, 0, leaves[i]);
  }
  vtkNew<vtkSolidStability> filter;
  filter->SetInputDataObject(assembly);
  filter->Update();
  CheckVerdict("cube and plate", filter, "unstable", "area", "margin");
  // (1000 x 5 + 600 x 25) / 1600 = 12.5
  CheckBounded(filter, names::StabilityMargin, -2.5, 1e-9);
  smtest::CheckEqual("one row", 1, vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfRows());
  filter->SetBodies(vtkSolidStability::EACH);
  filter->Update();
  CheckVerdict("each alone", filter, "stable", "area", "margin");
  vtkTable* rows = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  if (smtest::CheckEqual("two rows", 2, rows->GetNumberOfRows()))
  {
    smtest::Check(
      "margin of the cube", 5.0, rows->GetValueByName(0, names::StabilityMargin).ToDouble(), 1e-9);
    smtest::Check(
      "margin of the plate", 5.0, rows->GetValueByName(1, names::StabilityMargin).ToDouble(), 1e-9);
  }
  // Stopped when the first stands: what is not known of the second is not known of the worst.
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* running = vtkAlgorithm::SafeDownCast(caller);
      running->SetAbortExecute(running->GetProgress() > 0.85 ? 1 : 0);
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  const smtest::MessageTrap stopped(filter);
  filter->Modified();
  filter->Update();
  smtest::CheckEqual("a warning that it was stopped", 1, stopped.NumberOfWarnings);
  smtest::CheckEqual("stopped", names::VerdictUnknown, filter->GetStability());
  rows = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  smtest::CheckEqual("the one that stood", "stable", rows->GetValueByName(0, names::Stability).ToString());
  smtest::CheckEqual(
    "the one that did not", names::VerdictUnknown, rows->GetValueByName(1, names::Stability).ToString());
  filter->RemoveObserver(tag);
  filter->Modified();
  filter->Update();
  smtest::CheckEqual("not stopped", "stable", filter->GetStability());
  // One density says nothing of the other.
  leaves[0]->GetModel()->SetDensity(8000.0);
  filter->SetBodies(vtkSolidStability::TOGETHER);
  filter->Update();
  CheckBounded(filter, names::StabilityMargin, -2.5, 1e-9);
  smtest::CheckTrue("a message",
    filter->GetNumberOfMessages() > 0 &&
      filter->GetMessage(filter->GetNumberOfMessages() - 1).find("by volume") != std::string::npos);
  smtest::CheckTrue("no joules", std::isnan(Get(filter, names::TipEnergy)));
  // A heavy cube holds the plate: (8e6 x 5 + 6e5 x 25) / 8.6e6.
  leaves[1]->GetModel()->SetDensity(1000.0);
  filter->Modified();
  filter->Update();
  CheckVerdict("heavy cube and plate", filter, "stable", "area", "margin");
  CheckBounded(filter, names::StabilityMargin, 10.0 - 5.5e7 / 8.6e6, 1e-9);

  // An edit of the input is seen: the second box goes, and the cube stands alone.
  assembly->SetNumberOfPartitionedDataSets(1);
  filter->Update();
  CheckBounded(filter, names::StabilityMargin, 5.0, 1e-9);

  Case open(manifest.GetSpecial("open_solid").Path);
  smtest::MessageTrap trap(open.Filter->GetMassProperties());
  open.Filter->Update();
  smtest::CheckEqual("status of an open solid", names::StatusOpen, open.Filter->GetStatus());
  smtest::CheckEqual("its field", names::StatusOpen, GetText(open.Filter, names::Status));
  smtest::CheckTrue("messages", open.Filter->GetNumberOfMessages() > 0);
  Case shell(manifest.GetSpecial("open_shell").Path);
  smtest::MessageTrap other(shell.Filter->GetMassProperties());
  shell.Filter->Update();
  smtest::CheckEqual("a surface has no centre", names::VerdictUnknown, shell.Filter->GetStability());
  smtest::CheckTrue("and no margin", std::isnan(shell.Filter->GetStabilityMargin()));
  (void)folder;
}

// --- errors ------------------------------------------------------------------------------------

/// An exception from within a run is an error of the filter with empty outputs; it does not leave Update().
void CheckOutOfMemory(const std::string& path)
{
  Case box(path);
  vtkNew<vtkCallbackCommand> fail;
  fail->SetCallback([](vtkObject*, unsigned long, void*, void*) { throw std::bad_alloc(); });
  const unsigned long tag = box.Filter->GetMassProperties()->AddObserver(vtkCommand::StartEvent, fail);
  smtest::MessageTrap trap(box.Filter);
  smtest::MessageTrap pipeline(box.Filter->GetExecutive());
  box.Filter->Update();
  smtest::CheckEqual("out of memory: errors", 1, trap.NumberOfErrors);
  smtest::CheckEqual("status", names::StabilityStatusFailed, box.Filter->GetStatus());
  smtest::CheckEqual("no verdict", names::VerdictUnknown, box.Filter->GetStability());
  smtest::CheckEqual(
    "no row", 0, vtkTable::SafeDownCast(box.Filter->GetOutputDataObject(1))->GetNumberOfRows());
  box.Filter->GetMassProperties()->RemoveObserver(tag);
  box.Filter->Modified();
  box.Filter->Update();
  smtest::CheckEqual("with memory again", "stable", box.Filter->GetStability());
}

void TestErrors(const std::string& folder, const smtest::Manifest&)
{
  const std::string path =
    smtest::WriteStanding(folder, "box_errors", smtest::MakeLeaningPrism(10, 20, 30, 0));
  CheckOutOfMemory(path);
  Case box(path);
  smtest::MessageTrap trap(box.Filter);
  box.Filter->SetGravityDirection(0, 0, 0);
  smtest::CheckEqual("no direction", 1, trap.NumberOfErrors);
  box.Filter->SetGravityDirection(0, NaN, -1);
  smtest::CheckEqual("not a number", 2, trap.NumberOfErrors);
  smtest::CheckTrue("the remedy", trap.Errors.find("0, 0, -1") != std::string::npos, trap.Errors);
  trap.Errors.clear();
  {
    const smtest::DecimalCommas commas;
    box.Filter->SetGroundNormal(0.25, NaN, 0);
  }
  smtest::CheckTrue("decimal points", trap.Errors.find("(0.25, nan, 0)") != std::string::npos, trap.Errors);
  box.Filter->SetGroundNormal(INFINITY, 0, 0);
  box.Filter->SetGroundOrigin(0, 0, NaN);
  box.Filter->SetContactTolerance(NaN);
  smtest::CheckEqual("six errors", 6, trap.NumberOfErrors);
  smtest::Check("gravity as it was", -1.0, box.Filter->GetGravityDirection()[2], 0.0);
  box.Filter->SetContactTolerance(7.0);
  smtest::Check("clamped", 0.1, box.Filter->GetContactTolerance(), 0.0);
  box.Filter->SetContactTolerance(1e-6);
  smtest::CheckEqual("before a run", names::VerdictUnknown, box.Filter->GetStability());
  box.Filter->SetGroundNormal(1, 0, 0);
  smtest::MessageTrap pipeline(box.Filter->GetExecutive());
  box.Filter->Update();
  smtest::CheckEqual("an upright ground", 7, trap.NumberOfErrors);
  smtest::CheckTrue("its remedy", trap.Errors.find("SetGroundNormal") != std::string::npos);
  box.Filter->SetGroundNormal(0, 0, 0);
  box.Filter->Update();
  smtest::CheckEqual("and level again", "stable", box.Filter->GetStability());

  vtkNew<vtkPolyData> plain;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  plain->SetPoints(points);
  box.Filter->SetInputDataObject(plain);
  box.Filter->Update();
  smtest::CheckEqual("a mesh", 8, trap.NumberOfErrors);
  smtest::CheckTrue("named", trap.Errors.find("exact geometry") != std::string::npos);
  smtest::CheckEqual("nothing is left of the last run", names::VerdictUnknown, box.Filter->GetStability());

  vtkNew<vtkPartitionedDataSetCollection> nothing;
  box.Filter->SetInputDataObject(nothing);
  box.Filter->Update();
  smtest::CheckEqual("no solid at all", names::VerdictUnknown, box.Filter->GetStability());
  smtest::CheckEqual("its status", names::StatusEmpty, box.Filter->GetStatus());
}
}

int TestSolidStability(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::fprintf(stderr, "usage: TestSolidStability FOLDER SOLIDS MODE\n");
    return 1;
  }
  smtest::QuietOcct();
  const std::string folder = argv[1];
  const smtest::Manifest manifest(argv[2]);
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
  else if (mode == "ground")
  {
    TestGround(folder);
    TestDomeOnSlopes(folder);
    TestSteepGround(manifest);
  }
  else if (mode == "bodies")
  {
    TestBodies(folder, manifest);
  }
  else
  {
    TestErrors(folder, manifest);
  }
  return smtest::Finish();
}
