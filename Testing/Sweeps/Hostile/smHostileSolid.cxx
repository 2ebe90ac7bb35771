#include "smHostileSolid.h"

#include "smHostileShape.h"
#include "smHostileTrims.h"

#include <algorithm>
#include <cmath>

namespace smhostile
{
namespace
{
std::array<double, 16> MakePlacement(Random& random, double size)
{
  std::array<double, 16> m = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  if (random.Chance(0.3))
  {
    return m;
  }
  const std::array<double, 9> r = MakeRotation(random);
  const double side = random.Chance(0.3) ? -1.0 : 1.0;
  const double far = random.Chance(0.5) ? random.LogUniform(1.0, 1e5) : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      m[4 * i + j] = r[3 * i + j] * (j == 0 ? side : 1.0);
    }
    m[4 * i + 3] = size * far * random.Uniform(-1.0, 1.0);
  }
  return m;
}

/// Computes the integrals by other formulas than the patches' fluxes, and returns the largest difference from
/// the truth over the error that the truth states.
Real CheckTruth(const Shape& shape, const ReferenceIntegrals& truth)
{
  Real worst = 0;
  if (std::isfinite(shape.FormulaVolume))
  {
    // The map of a sheared ball may turn the orientation.
    worst = std::abs(std::abs(truth.Value[0]) - std::abs(shape.FormulaVolume)) / truth.Error[0];
  }
  const ReferenceBlock& block = shape.Block;
  const int degree = std::max({ block.Degree[0], block.Degree[1], block.Degree[2] });
  const bool polynomial =
    std::all_of(block.Points.begin(), block.Points.end(), [](const RealPoint& p) { return p[3] == 1.0L; });
  if (degree > 0 && degree <= 5 && polynomial)
  {
    const std::array<Real, NumberOfIntegrals> map = IntegrateBlock(block, (5 * degree + 1) / 2);
    for (int k = 0; k < AreaIntegral; ++k)
    {
      worst = std::max(worst, std::abs(truth.Value[k] - map[k]) / truth.Error[k]);
    }
  }
  return worst;
}
}

HostileSolid MakeHostileSolid(std::uint64_t seed, int maximumCells, bool checkTruth)
{
  HostileSolid solid;
  solid.Seed = seed;
  Random random(seed);
  Shape shape;
  // A folded solid may have next to no volume: then nothing is relative to it, and the next one is taken.
  for (int attempt = 0; attempt < 20; ++attempt)
  {
    shape = MakeShape(random);
    solid.Truth = IntegratePatches(shape.Patches, maximumCells);
    // The error is about 1e-18 of what the fluxes would be without any cancellation.
    if (std::abs(solid.Truth.Value[0]) > 1e14L * solid.Truth.Error[0])
    {
      break;
    }
  }
  const bool insideOut = random.Chance(0.1);
  const TrimmedSolid trimmed = TrimShape(shape, insideOut, random);
  solid.Family = shape.Family;
  solid.Description = trimmed.Description + (insideOut ? "; inside out" : "");

  solid.Model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  solid.Model->SetName("seed " + std::to_string(seed));
  solid.Model->SetFaces(trimmed.Faces);
  if (random.Chance(0.5))
  {
    const double far = shape.Size * (random.Chance(0.5) ? random.LogUniform(1.0, 1e5) : 1.0);
    solid.Model->SetOrigin(
      far * random.Uniform(-1.0, 1.0), far * random.Uniform(-1.0, 1.0), far * random.Uniform(-1.0, 1.0));
  }
  if (random.Chance(0.8))
  {
    // As from a display mesh: a percent off.
    solid.Model->SetVolumeScale(
      static_cast<double>(std::abs(solid.Truth.Value[0])) * random.Uniform(0.97, 1.0));
    solid.Model->SetAreaScale(
      static_cast<double>(solid.Truth.Value[AreaIntegral]) * random.Uniform(0.97, 1.0));
  }
  const int instances = random.Chance(0.1) ? 3 : 1;
  for (int i = 0; i < instances; ++i)
  {
    solid.Placements.push_back(MakePlacement(random, shape.Size));
  }
  if (checkTruth)
  {
    solid.TruthDisagreement = CheckTruth(shape, solid.Truth);
  }
  return solid;
}
}
