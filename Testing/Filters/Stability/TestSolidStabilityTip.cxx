// TestSolidStabilityTip FOLDER: minimum angle and rise over round contacts and over corners, where the centre
// of mass is beyond them.
#include "smBoxBodies.h"
#include "smStabilityTesting.h"
#include "smStandingSolids.h"

#include "smStepFile.h"

#include <vtkMassPropertiesGPU.h>

#include <cmath>
#include <functional>

namespace
{
using namespace smtest;
namespace names = sm::names;
using Real = long double;
const Real Pi = 3.141592653589793238462643383279503L;

const double Radius = 5.0;
const double Height = 20.0;

/// An oblique cylinder on z = 0, or the half of it in x > 0, with the centre of mass at c and gravity against
/// `up`.
struct Standing
{
  bool Half;
  Real Center[3];
  Real Up[3];

  /// Distance of the centre from the line that touches the base from outside across a direction.
  Real GetDistance(Real x, Real y) const
  {
    const Real support = this->Half && x < 0 ? std::fabs(y) : 1;
    return Radius * support - x * this->Center[0] - y * this->Center[1];
  }
  Real GetAngle(Real direction) const
  {
    const Real x = std::cos(direction);
    const Real y = std::sin(direction);
    return std::atan2(this->GetDistance(x, y), this->Center[2]) -
      std::atan2(-x * this->Up[0] - y * this->Up[1], this->Up[2]);
  }
  Real GetRise(Real direction) const
  {
    const Real x = std::cos(direction);
    const Real y = std::sin(direction);
    const Real phi = this->GetAngle(direction);
    const Real half = std::sin(phi / 2);
    return phi > 0 ? 2 * std::hypot(x * this->Up[0] + y * this->Up[1], this->Up[2]) *
        std::hypot(this->GetDistance(x, y), this->Center[2]) * half * half
                   : 0;
  }
};

/// The minimum over the circle: the best of many directions, then thirds of the range around it.
Real FindMinimum(const std::function<Real(Real)>& f)
{
  const int count = 20000;
  int best = 0;
  for (int i = 1; i < count; ++i)
  {
    best = f(2 * Pi * i / count) < f(2 * Pi * best / count) ? i : best;
  }
  Real low = 2 * Pi * (best - 1) / count;
  Real high = 2 * Pi * (best + 1) / count;
  for (int i = 0; i < 80; ++i)
  {
    const Real a = low + (high - low) / 3;
    const Real b = high - (high - low) / 3;
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return f(low);
}

/// The top is displaced by `lean` in the direction `turn`; the ground is level, or gravity leans by a slope
/// against x.
void CheckOblique(
  const std::string& folder, bool half, double lean, double turn, double slope, double maximum)
{
  const double leanX = lean * std::cos(turn);
  const double leanY = lean * std::sin(turn);
  const std::string name = (half ? "half " : "oblique ") + std::to_string(lean) + " to " +
    std::to_string(turn) + " on " + std::to_string(slope);
  std::printf("-- %s\n", name.c_str());
  Standing exact{ half, { 0.5 * leanX, 0.5 * leanY, 0.5 * Height }, { std::sin(slope), 0, std::cos(slope) } };
  exact.Center[0] += half ? 4 * Radius / (3 * Pi) : 0;
  Case standing(WriteStanding(folder, "oblique", MakeObliqueCylinder(Radius, Height, leanX, leanY, half)));
  standing.Filter->SetBackend(vtkMassPropertiesGPU::CPU);
  standing.Filter->SetGravityDirection(-std::sin(slope), 0, -std::cos(slope));
  standing.Filter->SetGroundNormal(0, 0, 1);
  standing.Filter->Update();
  const Real angle = FindMinimum([&](Real d) { return exact.GetAngle(d); });
  CheckEqual(name, angle < 0 ? "unstable" : "stable", standing.Filter->GetStability());
  CheckBounded(standing.Filter, names::TipAngle, static_cast<double>(angle) * Degrees, maximum * Degrees);
  CheckBounded(standing.Filter, names::CenterOfMassRise,
    static_cast<double>(FindMinimum([&](Real d) { return exact.GetRise(d); })), maximum * Height);
}

/// A plate lies on the ground, which may slope against its short side: it tips by nearly a right angle, over
/// the middle of a side.
void CheckPlate(double thickness, double slope)
{
  BoxBody body;
  body.Add({ { 0, 0, 0 }, { 300, 200, thickness } });
  vtkNew<vtkSolidStability> filter;
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetInputDataObject(body.Make());
  filter->SetGroundNormal(0, 0, 1);
  filter->SetGravityDirection(0, -std::sin(slope), -std::cos(slope));
  filter->Update();
  const std::string label = "plate of " + std::to_string(thickness) + " on " + std::to_string(slope);
  const Real z = Real(thickness) / 2;
  const Real angle = std::atan2(Real(100), z) - slope;
  const Real half = std::sin(angle / 2);
  Check(label + ", tip angle", static_cast<double>(angle * 180 / Pi), filter->GetTipAngle(),
    filter->GetTipAngleBound(), "the bound");
  CheckRange(label + ", bound of the tip angle", 0.0, filter->GetTipAngleBound(), 1e-5);
  Check(label + ", rise", static_cast<double>(2 * std::hypot(Real(100), z) * half * half),
    filter->GetCenterOfMassRise(), filter->GetCenterOfMassRiseBound(), "the bound");
  CheckRange(label + ", bound of the rise", 0.0, filter->GetCenterOfMassRiseBound(), 1e-5);
}
}

int TestSolidStabilityTip(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestSolidStabilityTip FOLDER");
  QuietOcct();
  const std::string folder = argv[1];
  // A curved contact is refined to 1e-5 of the size where the verdict is certain.
  const double curved = 1e-4;
  for (const double lean : { 4.0, 12.0, 13.0, 14.5, 16.0, 18.0 })
  {
    for (const double turn : { 0.0, 0.3, 0.77, 1.9, 4.4 })
    {
      CheckOblique(folder, false, lean, turn, 0.0, curved);
    }
    CheckOblique(folder, false, lean, 0.3, 0.1, curved);
    CheckOblique(folder, false, lean, 2.0, 0.1, curved);
  }
  // Beyond the straight side, the corners, and the round side.
  for (const double lean : { 1.0, 13.0, 17.0 })
  {
    for (const double turn : { 0.0, 0.9, 1.4, 1.8, 2.2, 3.0, 3.14159 })
    {
      CheckOblique(folder, true, lean, turn, 0.0, curved);
      CheckOblique(folder, true, lean, turn, 0.15, curved);
    }
  }
  // Nearly over the round side.
  CheckOblique(folder, false, 10.0 + 1e-6, 0.77, 0.0, 1e-8);
  for (const double thickness : { 100.0, 5.0, 0.5, 0.05 })
  {
    CheckPlate(thickness, 0.0);
    CheckPlate(thickness, 0.02);
  }
  return Finish();
}
