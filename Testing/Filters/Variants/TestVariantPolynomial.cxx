// Moments as polynomials against closed forms: values within bounds, bounds that are not wide, exact
// gradients.
#include "smTesting.h"
#include "smVariantPolynomial.h"
#include "smVariantSolids.h"

#include <algorithm>
#include <random>

namespace
{
using namespace smtest;

/// The derivative by direction k of a polynomial of degree 5 at most, from seven values along a line: exact
/// except for the rounding of these.
TenMoments Differentiate(const VariantSolid& solid, Numbers c, int k, const std::array<double, 3>& about)
{
  const Real h = solid.Ranges[k] / 4;
  const Real weights[3] = { 45, -9, 1 };
  TenMoments slope{};
  const Real middle = c[k];
  for (int i = 1; i <= 3; ++i)
  {
    for (const int side : { -1, 1 })
    {
      c[k] = middle + side * i * h;
      const TenMoments m = About(solid.Truth(c), about);
      for (int q = 0; q < 10; ++q)
      {
        slope[q] += side * weights[i - 1] * m[q] / (60 * h);
      }
    }
  }
  return slope;
}

/// `poles`: the truth rounds its poles to double, by which moments move by that much of their size.
void CheckSolid(const VariantSolid& solid, double poles, int trials)
{
  std::string error;
  sm::VariantOptions options;
  options.Ranges = solid.Ranges;
  const auto polynomial = sm::VariantPolynomial::Make(solid.Shape, options, error);
  CheckTrue(solid.Name, polynomial != nullptr, error);
  if (!polynomial)
  {
    return;
  }
  const auto k = static_cast<std::size_t>(polynomial->GetNumberOfDirections());
  std::mt19937 random(7);
  std::vector<double> c(trials * k);
  for (std::size_t i = 0; i < c.size(); ++i)
  {
    c[i] = solid.Ranges[i % k] * std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  }
  std::fill(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(k), 0.0);
  std::vector<double> values(trials * std::size_t{ 10 });
  std::vector<double> alone(values.size());
  std::vector<double> bounds(values.size());
  std::vector<double> gradients(values.size() * k);
  std::vector<double> gradientBounds(gradients.size());
  polynomial->Evaluate(
    c.data(), trials, values.data(), bounds.data(), gradients.data(), gradientBounds.data());
  polynomial->Evaluate(c.data(), trials, alone.data());
  // Worst error, and widest bound, relative to the size of moments of that order; worst share of the bound.
  double worst = 0.0;
  double widest = 0.0;
  double share = 0.0;
  double slopeShare = 0.0;
  int outside = 0;
  // Bounds grow with |c|: the largest variant of the trials is the scale.
  Real size = 0;
  for (int t = 0; t < trials; ++t)
  {
    size = std::max(size, std::abs(static_cast<Real>(values[10 * static_cast<std::size_t>(t)])));
  }
  for (int t = 0; t < trials; ++t)
  {
    const Numbers at(
      c.begin() + static_cast<std::ptrdiff_t>(t * k), c.begin() + static_cast<std::ptrdiff_t>((t + 1) * k));
    const TenMoments truth = About(solid.Truth(at), polynomial->GetReference());
    for (int q = 0; q < 10; ++q)
    {
      const Real scale = q == 0 ? size : std::pow(size, q < 4 ? Real(4) / 3 : Real(5) / 3);
      const std::size_t i = 10 * static_cast<std::size_t>(t) + q;
      const auto rounding = static_cast<double>(poles * std::abs(scale));
      const auto difference = static_cast<double>(std::abs(values[i] - truth[q]));
      const auto other = static_cast<double>(std::abs(alone[i] - truth[q]));
      outside += difference <= bounds[i] + rounding && other <= bounds[i] + rounding ? 0 : 1;
      worst = std::max(worst, static_cast<double>(difference / scale));
      widest = std::max(widest, static_cast<double>(bounds[i] / scale));
      share = std::max(share, difference / bounds[i]);
    }
    for (std::size_t d = 0; d < std::min<std::size_t>(k, 3) && t < 2; ++d)
    {
      const TenMoments slope = Differentiate(solid, at, static_cast<int>(d), polynomial->GetReference());
      for (int q = 0; q < 10; ++q)
      {
        const std::size_t i = (10 * static_cast<std::size_t>(t) + q) * k + d;
        const double difference = static_cast<double>(std::abs(gradients[i] - slope[q]));
        // Seven values of the truth over a quarter of the range.
        const double rounding = 40.0 * (poles + 1e-18) *
          static_cast<double>(std::max(size, std::pow(size, Real(5) / 3))) / solid.Ranges[d];
        outside += difference <= gradientBounds[i] + rounding ? 0 : 1;
        slopeShare = std::max(slopeShare, difference / gradientBounds[i]);
      }
    }
  }
  std::printf("     %lld samples, %.2g s; errors of values up to %.1e, bounds up to %.1e of the scale; "
              "error / bound up to %.2e, of gradients %.2e\n",
    static_cast<long long>(polynomial->GetNumberOfSamples()), polynomial->GetSeconds(), worst, widest, share,
    slopeShare);
  CheckEqual(solid.Name + ": values and gradients outside their bounds", 0LL, outside);
  CheckRange(solid.Name + ": widest bound", 0.0, widest, 5e-11, "some ten thousand roundings");
}

void CheckCoefficients()
{
  const VariantSolid solid = MakeBoxOfSides();
  std::string error;
  const auto polynomial = sm::VariantPolynomial::Make(solid.Shape, {}, error);
  CheckEqual(
    "coefficients of a volume, K = 3", 20LL, static_cast<long long>(polynomial->GetNumberOfCoefficients(0)));
  for (std::size_t i = 0; i < polynomial->GetNumberOfCoefficients(0); ++i)
  {
    const std::vector<int> powers = polynomial->GetPowers(0, i);
    const bool isProduct = *std::max_element(powers.begin(), powers.end()) <= 1;
    const std::string name =
      "volume, powers " + std::to_string(powers[0]) + std::to_string(powers[1]) + std::to_string(powers[2]);
    Check(name, isProduct ? 1.0 : 0.0, polynomial->GetCoefficient(0, i),
      polynomial->GetCoefficientBound(0, i), "(1 + a)(1 + b)(1 + c), within the coefficient's bound");
    CheckRange(
      name + ", bound", 0.0, polynomial->GetCoefficientBound(0, i), 1e-12, "some thousand roundings");
  }
}

/// Centre, inertia and principal moments of an ellipsoid by its axes, within the derived bounds.
void CheckProperties()
{
  const VariantSolid solid = MakeEllipsoid(false);
  std::string error;
  const auto polynomial = sm::VariantPolynomial::Make(solid.Shape, {}, error);
  const double c[3] = { 0.1, 0.4, -0.2 };
  double values[10];
  double bounds[10];
  polynomial->Evaluate(c, 1, values, bounds);
  const sm::VariantProperties derived = sm::DeriveProperties(values, bounds, polynomial->GetReference());
  const double center[3] = { 3.0, -2.0, 1.0 };
  const double axes[3] = { 1.1, 1.4, 0.8 };
  const double volume = 4.0 / 3.0 * static_cast<double>(Pi) * axes[0] * axes[1] * axes[2];
  Check("volume of an ellipsoid", volume, derived.Volume, derived.VolumeBound, "the bound");
  double inertia[3];
  for (int i = 0; i < 3; ++i)
  {
    const double a = axes[(i + 1) % 3];
    const double b = axes[(i + 2) % 3];
    inertia[i] = volume * (a * a + b * b) / 5.0;
    Check("its centre", center[i], derived.Center[i], derived.CenterBound, "the bound");
    Check("its inertia", inertia[i], derived.Inertia[4 * i], derived.InertiaBound, "the bound");
  }
  std::sort(inertia, inertia + 3);
  for (int i = 0; i < 3; ++i)
  {
    Check("its principal moments", inertia[i], derived.Principal[i], derived.PrincipalBound, "the bound");
  }
  CheckRange(
    "bound of the inertia", 0.0, derived.InertiaBound, 1e-9 * inertia[2], "1e-9 of the largest moment");
}

/// A box of six faces without loops, side 10: no edge, so no ribbon follows a face that is offset, and the
/// volume would be 1000 + 33.3 c instead of 1000 + 100 c.
void CheckLoopless()
{
  BoxBody body;
  body.Add({ { 0.0, 0.0, 0.0 }, { 10.0, 10.0, 10.0 } });
  const vtkSmartPointer<vtkTrimmedNURBSModel> box = body.Make()->GetModel();
  std::vector<sm::FacePointer> faces;
  for (const sm::FacePointer& face : box->GetFaces())
  {
    auto bare = std::make_shared<sm::Face>(*face);
    bare->Id = sm::NewId();
    bare->Loops.clear();
    faces.push_back(bare);
  }
  const auto base = MakeModel(faces, { 0, 10, 0, 10, 0, 10 });
  std::string error;
  const auto fixed = sm::VariantPolynomial::Make(sm::VariantShape::Make(base, {}, error), {}, error);
  CheckTrue("a box without edges that does not move", fixed != nullptr, error);
  if (fixed)
  {
    double values[10];
    double bounds[10];
    fixed->Evaluate(nullptr, 1, values, bounds);
    Check("its volume", 1000.0, values[0], bounds[0], "the bound");
  }
  for (int f = 0; f < 6; ++f)
  {
    const auto moved = sm::MakeNormalOffset(base, f, error);
    const std::vector<sm::MovedModel> directions{ { moved, 1.0 } };
    CheckTrue("a face without edges is offset: refused",
      moved && !sm::VariantShape::Make(base, directions, error) &&
        error.find("no edge closes") != std::string::npos,
      error);
  }
}

/// Bases whose moments are not those of a solid.
void CheckBases()
{
  const auto make = [](const std::vector<BoxShell>& shells)
  {
    BoxBody body;
    for (const BoxShell& shell : shells)
    {
      body.Add(shell);
    }
    return vtkSmartPointer<vtkTrimmedNURBSModel>(body.Make()->GetModel());
  };
  const BoxShell outer{ { 0.0, 0.0, 0.0 }, { 4.0, 4.0, 4.0 } };
  const BoxShell inner{ { 1.0, 1.0, 1.0 }, { 2.0, 2.0, 2.0 }, false };
  std::string error;
  const auto hollow =
    sm::VariantPolynomial::Make(sm::VariantShape::Make(make({ outer, inner }), {}, error), {}, error);
  CheckTrue("a box with a void", hollow != nullptr, error);
  if (hollow)
  {
    double values[10];
    double bounds[10];
    hollow->Evaluate(nullptr, 1, values, bounds);
    Check("its volume", 63.0, values[0], bounds[0], "the bound");
  }
  const auto isRefused = [&](const std::vector<BoxShell>& shells, const std::string& reason)
  { return !sm::VariantShape::Make(make(shells), {}, error) && error.find(reason) != std::string::npos; };
  BoxShell wrong = inner;
  wrong.Outward = true;
  CheckTrue("a void that is inside out", isRefused({ outer, wrong }, "same side"), error);
  CheckTrue("two equal shells", isRefused({ outer, outer }, "equal volumes"), error);
  BoxShell open = outer;
  open.Faces = 5;
  CheckTrue("an open box", isRefused({ open }, "not shared by two faces"), error);
}

void CheckErrors()
{
  const VariantSolid box = MakeBoxOfSides();
  const VariantSolid torus = MakeTorusOfRadii();
  std::string error;
  vtkTrimmedNURBSModel* base = box.Shape->GetBase();
  sm::VariantShape::Make(nullptr, {}, error);
  CheckTrue("no model", error.find("no faces") != std::string::npos, error);
  sm::VariantShape::Make(base, { { torus.Shape->GetBase(), 1.0 } }, error);
  CheckTrue("another model", error.find("direction 0") == 0, error);
  sm::VariantShape::Make(base, { { base, 0.0 } }, error);
  CheckTrue("amount 0", error.find("amount") != std::string::npos, error);
  // A control point of the seam, and one of a pole, leave the others that coincide with them.
  for (const std::size_t point : { std::size_t{ 18 }, std::size_t{ 3 } })
  {
    const auto ball = MakeModel({ MakeBall({ 0.0, 0.0, 0.0 }, 1.0) }, { -1, 1, -1, 1, -1, 1 });
    auto face = std::make_shared<sm::Face>(*ball->GetFaces()[0]);
    face->Surface.ControlPoints[point][1] += 0.1;
    CheckTrue("a ball that opens",
      !sm::VariantShape::Make(ball, { { MakeModel({ face }, { -1, 1, -1, 1, -1, 1 }), 1.0 } }, error), error);
  }
  CheckLoopless();
  CheckBases();
  sm::VariantOptions options;
  options.Ranges = { 1.0 };
  CheckTrue("too few ranges", !sm::VariantPolynomial::Make(box.Shape, options, error), error);
  options.Ranges = { 1.0, 1.0, -1.0 };
  CheckTrue("a negative range", !sm::VariantPolynomial::Make(box.Shape, options, error), error);
  options.Ranges.clear();
  options.Tolerance = 0.0;
  CheckTrue("tolerance 0", !sm::VariantPolynomial::Make(box.Shape, options, error), error);
  CheckTrue("no shape", !sm::VariantPolynomial::Make(nullptr, {}, error), error);
  const auto polynomial = sm::VariantPolynomial::Make(box.Shape, {}, error);
  const double c[3] = { std::nan(""), 1.0, 0.0 };
  double values[10];
  double bounds[10];
  double gradients[30];
  double gradientBounds[30];
  polynomial->Evaluate(c, 1, values, bounds, gradients, gradientBounds);
  const auto areNaN = [](const double* from, int count)
  { return std::all_of(from, from + count, [](double x) { return std::isnan(x); }); };
  CheckTrue("NaN gives NaN",
    areNaN(values, 10) && areNaN(bounds, 10) && areNaN(gradients, 30) && areNaN(gradientBounds, 30));
}
}

int TestVariantPolynomial(int, char*[])
{
  // Closed forms in extended precision, poles as they are: the directions are exact to 4 roundings of double.
  for (const VariantSolid& solid : { MakeBoxOfSides(), MakePrism() })
  {
    CheckSolid(solid, 1e-18, 24);
  }
  // Weights and coordinates of arcs are rounded: cos(45 degrees) and its products, 8 roundings.
  for (const VariantSolid& solid : { MakeEllipsoid(true), MakeEllipsoid(false), MakeTorusOfRadii() })
  {
    CheckSolid(solid, 2e-15, 24);
  }
  // The truth rounds the poles of each variant, to 2^-53 of coordinates up to 2.
  CheckSolid(MakeBlock({ 2, 1, 3 }, false, 4), 2e-15, 24);
  CheckSolid(MakeBlock({ 2, 2, 2 }, true, 3), 2e-15, 8);
  CheckSolid(MakeBlock({ 3, 2, 2 }, true, 10), 2e-15, 4);
  CheckCoefficients();
  CheckProperties();
  CheckErrors();
  return Finish();
}
