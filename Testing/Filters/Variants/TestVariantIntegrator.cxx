// Moments of variants at frozen points: against closed forms, polynomials, and the mass properties of each
// variant.
#include "Detail/smVariantChain.h"
#include "Detail/smVariantErrors.h"
#include "smComputeMassProperties.h"
#include "smTesting.h"
#include "smVariantIntegrator.h"
#include "smVariantSolids.h"

#include <algorithm>
#include <random>

namespace
{
using namespace smtest;

constexpr std::size_t Count = 37;

std::vector<double> MakeNumbers(const VariantSolid& solid, double share)
{
  std::mt19937 random(11);
  std::vector<double> c(Count * solid.Ranges.size());
  for (std::size_t i = 0; i < c.size(); ++i)
  {
    c[i] = share * solid.Ranges[i % solid.Ranges.size()] *
      std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  }
  return c;
}

/// `poles`: the rounding of the truth's poles, see TestVariantPolynomial.
void CheckPoints(const VariantSolid& solid, double poles, double share)
{
  std::string error;
  sm::VariantOptions options;
  options.Ranges = solid.Ranges;
  const auto points = sm::VariantIntegrator::Make(solid.Shape, options, error, sm::VariantMethod::Points);
  const auto polynomial =
    sm::VariantIntegrator::Make(solid.Shape, options, error, sm::VariantMethod::Polynomial);
  if (!CheckTrue(solid.Name + " is made", points && polynomial, error))
  {
    return;
  }
  const std::vector<double> c = MakeNumbers(solid, share);
  const std::size_t k = solid.Ranges.size();
  std::vector<double> values[2];
  std::vector<double> bounds[2];
  for (int i = 0; i < 2; ++i)
  {
    values[i].resize(10 * Count);
    bounds[i].resize(10 * Count);
    (i == 0 ? points : polynomial)->Evaluate(c.data(), Count, values[i].data(), bounds[i].data());
  }
  int outside = 0;
  double widest = 0.0;
  double worst = 0.0;
  // Bounds grow with |c|: the largest variant is the scale.
  double volume = 0.0;
  for (std::size_t t = 0; t < Count; ++t)
  {
    volume = std::max(volume, std::abs(values[0][10 * t]));
  }
  for (std::size_t t = 0; t < Count; ++t)
  {
    const Numbers at(
      c.begin() + static_cast<std::ptrdiff_t>(t * k), c.begin() + static_cast<std::ptrdiff_t>((t + 1) * k));
    const bool isTrue = t < 8;
    const TenMoments truth = isTrue ? About(solid.Truth(at), points->GetReference()) : TenMoments{};
    for (std::size_t q = 0; q < 10; ++q)
    {
      const std::size_t i = 10 * t + q;
      const double size = std::pow(volume, q == 0 ? 1.0 : q < 4 ? 4.0 / 3.0 : 5.0 / 3.0);
      const double apart = std::abs(values[0][i] - values[1][i]);
      outside += apart <= bounds[0][i] + bounds[1][i] ? 0 : 1;
      if (isTrue)
      {
        const auto difference = static_cast<double>(std::abs(values[0][i] - truth[q]));
        outside += difference <= bounds[0][i] + poles * size ? 0 : 1;
        worst = std::max(worst, difference / bounds[0][i]);
      }
      widest = std::max(widest, bounds[0][i] / size);
    }
  }
  std::printf("     %lld samples; bounds up to %.1e of the size; error / bound up to %.1e\n",
    static_cast<long long>(points->GetNumberOfSamples()), widest, worst);
  CheckEqual(solid.Name + ": outside the bounds", 0LL, outside);
  CheckRange(solid.Name + ": widest bound", 0.0, widest, 1e-10, "some ten thousand roundings");
  // Batches of other sizes have the same bits.
  double alone[10];
  points->Evaluate(c.data() + 5 * k, 1, alone);
  CheckTrue(
    solid.Name + ": the bits of a variant alone", std::equal(alone, alone + 10, values[0].data() + 50));
}

/// Every variant as a model of its own, with its own plan.
void CheckFullPath(const VariantSolid& solid)
{
  std::string error;
  sm::VariantOptions options;
  options.Ranges = solid.Ranges;
  const auto points = sm::VariantIntegrator::Make(solid.Shape, options, error, sm::VariantMethod::Points);
  const std::vector<double> c = MakeNumbers(solid, 1.0);
  const std::size_t k = solid.Ranges.size();
  std::vector<double> values(10 * Count);
  std::vector<double> bounds(10 * Count);
  points->Evaluate(c.data(), Count, values.data(), bounds.data());
  int outside = 0;
  for (std::size_t t = 0; t < 10; ++t)
  {
    vtkNew<vtkNURBSDataSet> leaf;
    leaf->SetModel(solid.Shape->MakeModel(c.data() + t * k));
    const sm::BodyMassProperties full = sm::ComputeMassProperties(leaf).Total;
    const sm::VariantProperties derived =
      sm::DeriveProperties(values.data() + 10 * t, bounds.data() + 10 * t, points->GetReference());
    const auto compare = [&](double a, double b, double bound)
    { outside += std::abs(a - b) <= bound ? 0 : 1; };
    compare(derived.Volume, full.Volume.Value, derived.VolumeBound + full.Volume.Bound);
    for (int i = 0; i < 3; ++i)
    {
      compare(derived.Center[i], full.Center.Value[i], derived.CenterBound + full.Center.Bound);
      compare(derived.Principal[i], full.PrincipalMoments.Value[i],
        derived.PrincipalBound + full.PrincipalMoments.Bound);
    }
    for (int i = 0; i < 9; ++i)
    {
      compare(derived.Inertia[i], full.Inertia.Value[i], derived.InertiaBound + full.Inertia.Bound);
    }
  }
  CheckEqual(solid.Name + ": mass properties outside both bounds", 0LL, outside);
}

/// Ribbons of a rounding's length at the end of an edge's piece, whose middle lies in its neighbour.
void CheckEdgePieces()
{
  const std::array<double, 3> points[4] = {};
  sm::EdgeCurve curve;
  curve.Breaks = { 0.0 };
  curve.AppendPiece(0.5, points, 1);
  curve.AppendPiece(1.0, points, 3);
  sm::Ribbon ribbon{};
  ribbon.Start = std::nextafter(0.5, 0.0);
  ribbon.End = ribbon.Start;
  CheckEqual("the start of the second piece, below it", 1, sm::FindEdgePiece(curve, ribbon, 0.0, 1.0));
  ribbon.Start = ribbon.End = 0.5;
  ribbon.EdgeStart = ribbon.EdgeEnd = 1.0;
  CheckEqual("the end of the first piece, not below it", 0, sm::FindEdgePiece(curve, ribbon, 0.0, 1.0));
  ribbon.Start = 0.2;
  ribbon.End = 0.3;
  ribbon.EdgeStart = 0.4;
  ribbon.EdgeEnd = 0.6;
  CheckEqual("a ribbon inside a piece", 0, sm::FindEdgePiece(curve, ribbon, 0.0, 1.0));
}

/// A sum that loses almost half a unit in the last place at each of its terms.
void CheckSumRounding()
{
  constexpr int terms = 1000000;
  constexpr double term = 0.99 * sm::UnitRoundoff;
  double sum = 1.0;
  for (int i = 0; i < terms; ++i)
  {
    sum += term;
  }
  CheckTrue("a bound covers its own sum", sm::GetSumRounding(terms + 1) * sum >= 1.0 + terms * term);
}

void CheckChoice()
{
  const VariantSolid solid = MakeEllipsoid(false);
  std::string error;
  sm::VariantSettings settings(sm::VariantMethod::Automatic, sm::BackendChoice::CPU);
  settings.Expected = 1;
  const auto few = sm::VariantIntegrator::Make(solid.Shape, {}, error, settings);
  CheckTrue(
    "one variant at frozen points", few && few->GetMethod() == sm::VariantMethod::Points, few->GetReason());
  settings.Expected = 1000000000;
  const auto many = sm::VariantIntegrator::Make(solid.Shape, {}, error, settings);
  CheckTrue("a billion as polynomials", many && many->GetMethod() == sm::VariantMethod::Polynomial,
    many->GetReason());
}
}

int TestVariantIntegrator(int, char*[])
{
  for (const VariantSolid& solid : { MakeBoxOfSides(), MakePrism() })
  {
    CheckPoints(solid, 1e-17, 1.0);
  }
  // 8 roundings of the arcs' weights and points.
  for (const VariantSolid& solid : { MakeEllipsoid(true), MakeEllipsoid(false), MakeTorusOfRadii() })
  {
    CheckPoints(solid, 2e-15, 1.0);
  }
  CheckPoints(MakeBlock({ 2, 1, 3 }, false, 4), 2e-15, 1.0);
  CheckPoints(MakeBlock({ 2, 2, 2 }, true, 3), 2e-15, 1.0);
  // Beyond the ranges that the orders are for.
  CheckPoints(MakeBlock({ 2, 2, 2 }, true, 3), 2e-15, 1.5);
  for (const VariantSolid& solid :
    { MakeBoxOfSides(), MakeEllipsoid(false), MakeBlock({ 2, 1, 3 }, false, 4) })
  {
    CheckFullPath(solid);
  }
  CheckChoice();
  CheckEdgePieces();
  CheckSumRounding();
  return Finish();
}
