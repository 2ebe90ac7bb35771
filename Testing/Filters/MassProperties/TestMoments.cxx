// Moments of point masses, where everything is a finite sum: moved, placed, added, and converted to mass
// properties, against extended precision; and every bound holds when the inputs are off by their bounds.
#include "smMoments.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
struct Mass
{
  long double X[3];
  long double M;
};

constexpr int Pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };

sm::Moments MakeMoments(const std::vector<Mass>& masses, const std::array<double, 3>& reference)
{
  long double v = 0.0L;
  long double first[3] = {};
  long double second[6] = {};
  for (const Mass& mass : masses)
  {
    v += mass.M;
    long double r[3];
    for (int i = 0; i < 3; ++i)
    {
      r[i] = mass.X[i] - reference[i];
      first[i] += mass.M * r[i];
    }
    for (int k = 0; k < 6; ++k)
    {
      second[k] += mass.M * r[Pairs[k][0]] * r[Pairs[k][1]];
    }
  }
  sm::Moments moments;
  moments.Reference = reference;
  moments.Volume = static_cast<double>(v);
  std::copy_n(first, 3, moments.First.begin());
  std::copy_n(second, 6, moments.Second.begin());
  return moments;
}

void CheckSame(const std::string& name, const sm::Moments& expected, const sm::Moments& actual)
{
  // The bounds of the operations themselves, since the inputs are exact to half a rounding.
  smtest::Check(name + " volume", expected.Volume, actual.Volume, 1e-15 * expected.Volume, "rounding");
  for (int i = 0; i < 3; ++i)
  {
    smtest::Check(name + " first", expected.First[i], actual.First[i],
      actual.FirstBound[i] + 1e-15 * std::abs(expected.First[i]), "its bound");
  }
  for (int i = 0; i < 6; ++i)
  {
    smtest::Check(name + " second", expected.Second[i], actual.Second[i],
      actual.SecondBound[i] + 1e-15 * std::abs(expected.Second[i]), "its bound");
  }
}

std::vector<Mass> Place(const std::vector<Mass>& masses, const double m[16])
{
  std::vector<Mass> placed = masses;
  for (std::size_t k = 0; k < masses.size(); ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      placed[k].X[i] = m[4 * i + 3];
      for (int j = 0; j < 3; ++j)
      {
        placed[k].X[i] += static_cast<long double>(m[4 * i + j]) * masses[k].X[j];
      }
    }
  }
  return placed;
}

void CheckBounds(const std::vector<Mass>& masses, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const sm::Moments exact = MakeMoments(masses, { 1.0, 2.0, 3.0 });
  const sm::MassProperties truth = sm::ComputeMassProperties(exact);
  double fullest = 0.0;
  for (int trial = 0; trial < 200; ++trial)
  {
    sm::Moments off = exact;
    off.VolumeBound = 1e-4 * exact.Volume;
    off.Volume += uniform(random) * off.VolumeBound;
    for (int i = 0; i < 3; ++i)
    {
      off.FirstBound[i] = 1e-4 * exact.Volume;
      off.First[i] += uniform(random) * off.FirstBound[i];
    }
    for (int i = 0; i < 6; ++i)
    {
      off.SecondBound[i] = 1e-4 * exact.Volume;
      off.Second[i] += uniform(random) * off.SecondBound[i];
    }
    const sm::MassProperties actual = sm::ComputeMassProperties(off);
    double worst = std::abs(actual.Volume - truth.Volume) / actual.VolumeBound;
    for (int i = 0; i < 3; ++i)
    {
      worst = std::max({ worst, std::abs(actual.Center[i] - truth.Center[i]) / actual.CenterBound,
        std::abs(actual.First[i] - truth.First[i]) / actual.FirstBound,
        std::abs(actual.Principal[i] - truth.Principal[i]) / actual.PrincipalBound,
        std::abs(actual.Gyration[i] - truth.Gyration[i]) / actual.GyrationBound });
    }
    for (int i = 0; i < 9; ++i)
    {
      worst = std::max({ worst, std::abs(actual.Inertia[i] - truth.Inertia[i]) / actual.InertiaBound,
        std::abs(actual.InertiaAtOrigin[i] - truth.InertiaAtOrigin[i]) / actual.InertiaAtOriginBound });
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      double cosine = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        cosine += actual.Axes[3 * axis + i] * truth.Axes[3 * axis + i];
      }
      worst = std::max(worst, std::acos(std::min(1.0, std::abs(cosine))) / actual.AxesBound);
    }
    fullest = std::max(fullest, worst);
  }
  smtest::CheckRange(
    "largest error over its bound, 200 trials", 0.2, fullest, 1.0, "neither exceeded nor idle");
}
}

int TestMoments(int, char*[])
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Mass> masses;
  for (int i = 0; i < 40; ++i)
  {
    masses.push_back(
      { { 3.0L * uniform(random), 2.0L * uniform(random), uniform(random) }, 1.0L + uniform(random) / 2 });
  }
  const std::array<double, 3> near = { 0.25, -0.5, 0.125 };
  const std::array<double, 3> far = { 1e5, -2e5, 3e5 };

  sm::Moments moved = MakeMoments(masses, near);
  moved.MoveReference(far);
  CheckSame("moved far", MakeMoments(masses, far), moved);

  const double c = 0.8;
  const double s = 0.6;
  const double rigid[16] = { c, -s, 0, 1e3, s, c, 0, -2e3, 0, 0, 1, 50, 0, 0, 0, 1 };
  const double mirror[16] = { c, s, 0, 1, s, -c, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1 };
  for (const double* placement : { rigid, mirror })
  {
    sm::Moments placed = MakeMoments(masses, near);
    placed.Place(placement);
    CheckSame(placement == rigid ? "rigid" : "mirrored",
      MakeMoments(Place(masses, placement), placed.Reference), placed);
  }

  const std::vector<Mass> other = Place(masses, rigid);
  std::vector<Mass> both = masses;
  both.insert(both.end(), other.begin(), other.end());
  sm::Moments sum = MakeMoments(masses, near);
  sum.Add(MakeMoments(other, { 1e3, -2e3, 50 }));
  CheckSame("added", MakeMoments(both, near), sum);

  CheckBounds(masses, random);

  // Two equal masses on the x axis: everything in closed form.
  const std::vector<Mass> dumbbell = { { { -1, 0, 0 }, 2 }, { { 3, 0, 0 }, 2 } };
  const sm::MassProperties p = sm::ComputeMassProperties(MakeMoments(dumbbell, { 0, 0, 0 }));
  smtest::Check("dumbbell centre", 1.0, p.Center[0], 1e-15);
  const double inertia[9] = { 0, 0, 0, 0, 16, 0, 0, 0, 16 };
  const double atOrigin[9] = { 0, 0, 0, 0, 20, 0, 0, 0, 20 };
  for (int i = 0; i < 9; ++i)
  {
    smtest::Check("dumbbell inertia", inertia[i], p.Inertia[i], 1e-14);
    smtest::Check("dumbbell inertia at the origin", atOrigin[i], p.InertiaAtOrigin[i], 1e-14);
  }
  smtest::CheckTrue("dumbbell: two moments coincide", p.AxesDegenerate);
  smtest::Check("dumbbell radius of gyration", 2.0, p.Gyration[2], 1e-15);

  // A body with missing faces has no bound, and no operation gives it one.
  sm::Moments unbounded = MakeMoments(masses, near);
  unbounded.VolumeBound = std::numeric_limits<double>::infinity();
  unbounded.FirstBound.fill(unbounded.VolumeBound);
  unbounded.SecondBound.fill(unbounded.VolumeBound);
  unbounded.Place(rigid);
  sm::Moments withUnbounded = MakeMoments(masses, near);
  withUnbounded.Add(unbounded);
  for (const sm::Moments& m : { unbounded, withUnbounded })
  {
    const sm::MassProperties u = sm::ComputeMassProperties(m);
    smtest::CheckTrue("no finite bound from an infinite one",
      !std::isfinite(u.VolumeBound) && !std::isfinite(u.FirstBound) &&
        !std::isfinite(u.InertiaAtOriginBound) && !std::isfinite(u.CenterBound) && std::isnan(u.Center[0]));
  }

  sm::Moments empty;
  empty.VolumeBound = 1e-3;
  const sm::MassProperties none = sm::ComputeMassProperties(empty);
  smtest::CheckTrue("no centre where the volume is within its bound of 0",
    std::isnan(none.Center[0]) && std::isnan(none.Principal[2]) && none.Volume == 0.0);
  return smtest::Finish();
}
