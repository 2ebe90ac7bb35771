// Variants at frozen points by compute shaders: against closed forms and the CPU, for any number of variants,
// with bits that repeat; and what happens without a context, with a wrong one, or with one that ends.
#include "Detail/smVariantNumbers.h"
#include "smShaderFault.h"
#include "smSubnormals.h"
#include "smTesting.h"
#include "smVariantIntegrator.h"
#include "smVariantSolids.h"
#include "vtkComputeContext.h"

#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace
{
using namespace smtest;
using Integrator = std::shared_ptr<const sm::VariantIntegrator>;

struct Results
{
  std::vector<double> Values, Bounds;
};

Integrator MakePoints(const VariantSolid& solid, sm::BackendChoice backend, vtkComputeContext* context)
{
  sm::VariantOptions options;
  options.Ranges = solid.Ranges;
  sm::VariantSettings settings(sm::VariantMethod::Points, backend);
  settings.Context = context;
  std::string error;
  Integrator variants = sm::VariantIntegrator::Make(solid.Shape, options, error, settings);
  CheckTrue(solid.Name + " is made", variants != nullptr, error);
  return variants;
}

std::vector<double> MakeNumbers(const VariantSolid& solid, std::size_t count, double share)
{
  std::mt19937 random(23);
  std::vector<double> c(count * solid.Ranges.size());
  for (std::size_t i = 0; i < c.size(); ++i)
  {
    c[i] = share * solid.Ranges[i % solid.Ranges.size()] *
      std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  }
  return c;
}

Results Evaluate(const sm::VariantIntegrator& variants, const double* c, std::size_t count)
{
  Results results{ std::vector<double>(10 * count), std::vector<double>(10 * count) };
  variants.Evaluate(c, count, results.Values.data(), results.Bounds.data());
  return results;
}

/// All bits, also those of NaN.
bool AreSame(const double* a, const double* b, std::size_t count)
{
  return std::memcmp(a, b, count * sizeof(double)) == 0;
}

/// `poles`: the rounding of the truth's poles, see TestVariantPolynomial. `truths` variants are compared with
/// the closed form.
void CheckSolid(
  const VariantSolid& solid, vtkComputeContext* context, double poles, double share, std::size_t truths = 8)
{
  constexpr std::size_t count = 37;
  const Integrator device = MakePoints(solid, sm::BackendChoice::OpenGL, context);
  const Integrator cpu = MakePoints(solid, sm::BackendChoice::CPU, nullptr);
  if (!device || !cpu)
  {
    return;
  }
  CheckTrue(solid.Name + ": OpenGL evaluates", device->GetBackend() == sm::BackendChoice::OpenGL,
    device->GetReason());
  const std::vector<double> c = MakeNumbers(solid, count, share);
  const std::size_t k = solid.Ranges.size();
  context->ResetCounters();
  const Results own = Evaluate(*device, c.data(), count);
  CheckTrue(solid.Name + ": shaders ran", context->GetNumberOfDispatches() > 0);
  const Results known = Evaluate(*cpu, c.data(), count);
  double volume = 0.0;
  for (std::size_t t = 0; t < count; ++t)
  {
    volume = std::max(volume, std::abs(known.Values[10 * t]));
  }
  long long outside = 0;
  double widest = 0.0;
  double worst = 0.0;
  double wider = 0.0;
  for (std::size_t t = 0; t < count; ++t)
  {
    const Numbers at(
      c.begin() + static_cast<std::ptrdiff_t>(t * k), c.begin() + static_cast<std::ptrdiff_t>((t + 1) * k));
    const TenMoments truth = t < truths ? About(solid.Truth(at), device->GetReference()) : TenMoments{};
    for (std::size_t q = 0; q < 10; ++q)
    {
      const std::size_t i = 10 * t + q;
      const double size = std::pow(volume, q == 0 ? 1.0 : q < 4 ? 4.0 / 3.0 : 5.0 / 3.0);
      const double apart = std::abs(own.Values[i] - known.Values[i]);
      outside += apart <= own.Bounds[i] + known.Bounds[i] ? 0 : 1;
      if (t < truths)
      {
        const auto difference = static_cast<double>(std::abs(own.Values[i] - truth[q]));
        outside += difference <= own.Bounds[i] + poles * size ? 0 : 1;
        worst = std::max(worst, difference / own.Bounds[i]);
      }
      widest = std::max(widest, own.Bounds[i] / size);
      wider = std::max(wider, own.Bounds[i] / known.Bounds[i]);
    }
  }
  std::printf("     bounds up to %.1e of the size, up to %.2g times the CPU's; error / bound up to %.1e\n",
    widest, wider, worst);
  CheckEqual(solid.Name + ": outside the bounds", 0LL, outside);
  CheckRange(solid.Name + ": widest bound", 0.0, widest, 1e-10, "some ten thousand roundings");
  // An error of the derivatives counts 2 degree times that of the points.
  CheckRange(solid.Name + ": its ratio to the CPU's", 0.5, wider, 2.1, "measured; Variants.md");
  const Results again = Evaluate(*device, c.data(), count);
  CheckTrue(solid.Name + ": the same bits twice",
    AreSame(own.Values.data(), again.Values.data(), own.Values.size()) &&
      AreSame(own.Bounds.data(), again.Bounds.data(), own.Bounds.size()));
}

/// Polynomials: values, bounds and gradients, with and without gradients, against the CPU's and closed forms.
void CheckForms(const VariantSolid& solid, vtkComputeContext* context, double poles, std::size_t truths = 4)
{
  constexpr std::size_t count = 37;
  const std::size_t k = solid.Ranges.size();
  sm::VariantOptions options;
  options.Ranges = solid.Ranges;
  sm::VariantSettings settings(sm::VariantMethod::Polynomial, sm::BackendChoice::OpenGL);
  settings.Context = context;
  std::string error;
  const Integrator device = sm::VariantIntegrator::Make(solid.Shape, options, error, settings);
  if (!CheckTrue(solid.Name + ": polynomials by OpenGL",
        device && device->GetPolynomial() && device->GetBackend() == sm::BackendChoice::OpenGL,
        device ? device->GetReason() : error))
  {
    return;
  }
  const std::vector<double> c = MakeNumbers(solid, count, 1.2);
  std::vector<double> values[3], bounds[3], gradients[2], gradientBounds[2];
  for (int i = 0; i < 3; ++i)
  {
    values[i].resize(10 * count);
    bounds[i].resize(10 * count);
  }
  for (int i = 0; i < 2; ++i)
  {
    gradients[i].resize(10 * count * k);
    gradientBounds[i].resize(10 * count * k);
  }
  context->ResetCounters();
  device->Evaluate(c.data(), count, values[0].data(), bounds[0].data());
  CheckTrue(solid.Name + ": shaders of polynomials ran", context->GetNumberOfDispatches() > 0);
  device->Evaluate(
    c.data(), count, values[1].data(), bounds[1].data(), gradients[0].data(), gradientBounds[0].data());
  device->GetPolynomial()->Evaluate(
    c.data(), count, values[2].data(), bounds[2].data(), gradients[1].data(), gradientBounds[1].data());
  long long outside = 0;
  for (std::size_t i = 0; i < 10 * count; ++i)
  {
    for (int which = 0; which < 2; ++which)
    {
      outside += std::abs(values[which][i] - values[2][i]) <= 2.0 * bounds[2][i] ? 0 : 1;
    }
    const std::size_t t = i / 10;
    if (t < truths)
    {
      const Numbers at(
        c.begin() + static_cast<std::ptrdiff_t>(t * k), c.begin() + static_cast<std::ptrdiff_t>((t + 1) * k));
      const TenMoments truth = About(solid.Truth(at), device->GetReference());
      const double size = std::pow(static_cast<double>(std::abs(truth[0])),
        i % 10 == 0    ? 1.0
          : i % 10 < 4 ? 4.0 / 3.0
                       : 5.0 / 3.0);
      outside +=
        static_cast<double>(std::abs(values[0][i] - truth[i % 10])) <= bounds[0][i] + poles * size ? 0 : 1;
    }
  }
  CheckEqual(solid.Name + ": polynomials outside the bounds", 0LL, outside);
  CheckTrue(solid.Name + ": the CPU's bounds",
    AreSame(bounds[0].data(), bounds[2].data(), 10 * count) &&
      AreSame(gradientBounds[0].data(), gradientBounds[1].data(), 10 * count * k));
  outside = 0;
  for (std::size_t i = 0; i < 10 * count * k; ++i)
  {
    outside += std::abs(gradients[0][i] - gradients[1][i]) <= 2.0 * gradientBounds[1][i] ? 0 : 1;
  }
  CheckEqual(solid.Name + ": gradients outside the bounds", 0LL, outside);
  std::vector<double> again(10 * count);
  device->Evaluate(c.data(), count, again.data());
  CheckTrue(
    solid.Name + ": the same bits of polynomials twice", AreSame(again.data(), values[0].data(), 10 * count));
  device->Evaluate(c.data() + 7 * k, 1, again.data());
  CheckTrue(
    solid.Name + ": the bits of a polynomial alone", AreSame(again.data(), values[0].data() + 70, 10));
}

/// A cube about the origin, one plane of which has weights that fall to `weight`: its first moments vanish.
std::shared_ptr<const sm::VariantShape> MakeWeightedCube(double weight)
{
  const auto make = [weight](double x)
  {
    BoxBody body;
    body.Add({ { -1.0, -1.0, -1.0 }, { 1.0 + x, 1.0, 1.0 } });
    vtkSmartPointer<vtkTrimmedNURBSModel> model = body.Make()->GetModel();
    std::vector<sm::FacePointer> faces = model->GetFaces();
    auto face = std::make_shared<sm::Face>(*faces[0]);
    face->Id = sm::NewId();
    const int* count = face->Surface.NumberOfControlPoints;
    for (int i = 0; i < count[0]; ++i)
    {
      for (double& number : face->Surface.ControlPoints[i])
      {
        number *= weight;
      }
    }
    faces[0] = face;
    model->SetFaces(faces);
    return model;
  };
  return MakeShape(make(0.0), { { make(0.25), 0.25 } });
}

/// Where a bound is infinite, moments that vanish by symmetry are compared with the scale of the others.
void CheckWithoutBounds(vtkComputeContext* context)
{
  const std::shared_ptr<const sm::VariantShape> shape = MakeWeightedCube(1e-40);
  for (const sm::VariantMethod method : { sm::VariantMethod::Points, sm::VariantMethod::Polynomial })
  {
    sm::VariantSettings settings(method, sm::BackendChoice::OpenGL);
    settings.Context = context;
    std::string error;
    const Integrator device = sm::VariantIntegrator::Make(shape, {}, error, settings);
    if (!CheckTrue("a cube without bounds", device != nullptr, error))
    {
      continue;
    }
    const double c = 0.0;
    const Results own = Evaluate(*device, &c, 1);
    CheckTrue("it has no bounds", std::isnan(own.Bounds[0]));
    CheckRange("a moment that vanishes", -1e-14, own.Values[2], 1e-14, "roundings");
    CheckTrue("OpenGL evaluates it", device->GetBackend() == sm::BackendChoice::OpenGL, device->GetReason());
  }
}

void CheckFormFallback()
{
  const VariantSolid solid = MakeBoxOfSides();
  vtkNew<vtkComputeContext> none;
  none->SetSource(vtkComputeContext::WINDOW);
  sm::VariantSettings settings(sm::VariantMethod::Polynomial, sm::BackendChoice::OpenGL);
  settings.Context = none;
  std::string error;
  const Integrator variants = sm::VariantIntegrator::Make(solid.Shape, {}, error, settings);
  CheckTrue("polynomials without a context",
    variants && variants->GetBackend() == sm::BackendChoice::CPU &&
      variants->GetReason().find("no OpenGL") != std::string::npos,
    variants ? variants->GetReason() : error);
  // Points have no gradients.
  const Integrator points = MakePoints(solid, sm::BackendChoice::CPU, nullptr);
  std::vector<double> values(10);
  std::vector<double> gradients(30, 1.0);
  points->Evaluate(std::vector<double>(3, 0.1).data(), 1, values.data(), nullptr, gradients.data());
  CheckTrue("gradients at points are NaN",
    std::all_of(gradients.begin(), gradients.end(), [](double x) { return std::isnan(x); }));
}

void CheckBatches(vtkComputeContext* context)
{
  const VariantSolid solid = MakeBoxOfSides();
  const Integrator device = MakePoints(solid, sm::BackendChoice::OpenGL, context);
  constexpr std::size_t total = 10000;
  const std::vector<double> c = MakeNumbers(solid, total, 1.0);
  const Results all = Evaluate(*device, c.data(), total);
  for (const std::size_t count :
    { std::size_t{ 1 }, std::size_t{ 63 }, std::size_t{ 64 }, std::size_t{ 65 } })
  {
    // From the end, so that a variant has another place in its batch.
    const std::size_t first = total - count;
    const Results some = Evaluate(*device, c.data() + 3 * first, count);
    CheckTrue("bits in a batch of " + std::to_string(count),
      AreSame(some.Values.data(), all.Values.data() + 10 * first, 10 * count) &&
        AreSame(some.Bounds.data(), all.Bounds.data() + 10 * first, 10 * count));
  }
  long long outside = 0;
  for (std::size_t i = 0; i < total; ++i)
  {
    const double volume = (1.0 + c[3 * i]) * (1.0 + c[3 * i + 1]) * (1.0 + c[3 * i + 2]);
    // The product of the sides is rounded.
    outside += std::abs(all.Values[10 * i] - volume) <= all.Bounds[10 * i] + 1e-15 * volume ? 0 : 1;
  }
  CheckEqual("volumes of 10,000 boxes outside their bounds", 0LL, outside);
  std::vector<double> alone(10 * 64);
  device->Evaluate(c.data(), 64, alone.data());
  CheckTrue("bits without bounds", AreSame(alone.data(), all.Values.data(), alone.size()));
  device->Evaluate(nullptr, 0, nullptr);
}

void CheckNotFinite(vtkComputeContext* context)
{
  const VariantSolid solid = MakeEllipsoid(false);
  const Integrator device = MakePoints(solid, sm::BackendChoice::OpenGL, context);
  const Integrator cpu = MakePoints(solid, sm::BackendChoice::CPU, nullptr);
  std::vector<double> c = MakeNumbers(solid, 40, 1.0);
  const Results before = Evaluate(*device, c.data(), 40);
  c[3 * 7 + 1] = std::numeric_limits<double>::quiet_NaN();
  c[3 * 20] = -std::numeric_limits<double>::infinity();
  c[3 * 33 + 2] = 1e40;
  const Results own = Evaluate(*device, c.data(), 40);
  const Results known = Evaluate(*cpu, c.data(), 40);
  bool areOthersSame = true;
  for (std::size_t i = 0; i < 40; ++i)
  {
    const bool isChanged = i == 7 || i == 20 || i == 33;
    areOthersSame = areOthersSame &&
      (isChanged ||
        (AreSame(own.Values.data() + 10 * i, before.Values.data() + 10 * i, 10) &&
          AreSame(own.Bounds.data() + 10 * i, before.Bounds.data() + 10 * i, 10)));
  }
  CheckTrue("the bits of the others", areOthersSame);
  for (const std::size_t i : { std::size_t{ 7 }, std::size_t{ 20 } })
  {
    const auto isNaN = [](double x) { return std::isnan(x); };
    CheckTrue("NaN of variant " + std::to_string(i),
      std::all_of(own.Values.begin() + 10 * i, own.Values.begin() + 10 * i + 10, isNaN) &&
        std::all_of(own.Bounds.begin() + 10 * i, own.Bounds.begin() + 10 * i + 10, isNaN));
  }
  CheckTrue("a number near the end of the range is the CPU's",
    AreSame(own.Values.data() + 330, known.Values.data() + 330, 10) &&
      AreSame(own.Bounds.data() + 330, known.Bounds.data() + 330, 10));
}

void CheckFallback(const std::string& what, const Integrator& variants, const std::string& reason)
{
  const VariantSolid solid = MakeTorusOfRadii();
  CheckTrue(what + ": the CPU evaluates", variants && variants->GetBackend() == sm::BackendChoice::CPU);
  CheckTrue(what + ": the reason", variants && variants->GetReason().find(reason) != std::string::npos,
    variants ? variants->GetReason() : "");
  const Integrator cpu = MakePoints(solid, sm::BackendChoice::CPU, nullptr);
  const std::vector<double> c = MakeNumbers(solid, 3, 1.0);
  const Results own = Evaluate(*variants, c.data(), 3);
  const Results known = Evaluate(*cpu, c.data(), 3);
  CheckTrue(what + ": the CPU's bits",
    AreSame(own.Values.data(), known.Values.data(), 30) &&
      AreSame(own.Bounds.data(), known.Bounds.data(), 30));
}

void CheckFallbacks()
{
  const VariantSolid solid = MakeTorusOfRadii();
  vtkNew<vtkComputeContext> none;
  none->SetSource(vtkComputeContext::WINDOW);
  CheckFallback("no context", MakePoints(solid, sm::BackendChoice::OpenGL, none), "no OpenGL");
  vtkNew<vtkComputeContext> old;
  old->SetSource(vtkComputeContext::EGL);
  old->SetMaximumVersion(4, 2);
  CheckFallback("an old driver", MakePoints(solid, sm::BackendChoice::OpenGL, old), "4.3");
  vtkNew<vtkComputeContext> context;
  sm::GetFaultyShaders().insert("smVariantPanelsCS");
  CheckFallback("a shader whose arrays are floats", MakePoints(solid, sm::BackendChoice::OpenGL, context),
    "computes a variant wrong");
  sm::GetFaultyShaders().clear();
  // A shader that is wrong only after the context ended.
  const Integrator lost = MakePoints(solid, sm::BackendChoice::OpenGL, context);
  CheckTrue("it is right again", lost->GetBackend() == sm::BackendChoice::OpenGL, lost->GetReason());
  context->Stop();
  sm::GetFaultyShaders().insert("smVariantPanelsCS");
  std::vector<double> values(10);
  lost->Evaluate(std::vector<double>(2, 0.1).data(), 1, values.data());
  sm::GetFaultyShaders().clear();
  CheckFallback("a wrong shader in a new context", lost, "computes a variant wrong");
}

/// A device that compares three variants rightly, and has no memory for the batch that is timed.
void CheckNoMemory(vtkComputeContext* context)
{
  const VariantSolid solid = MakeTorusOfRadii();
  sm::GetFailingBatch() = 3;
  CheckFallback("no memory", MakePoints(solid, sm::BackendChoice::OpenGL, context), "does not fit");
  sm::VariantSettings settings(sm::VariantMethod::Polynomial, sm::BackendChoice::OpenGL);
  settings.Context = context;
  std::string error;
  const Integrator forms = sm::VariantIntegrator::Make(solid.Shape, {}, error, settings);
  sm::GetFailingBatch() = std::numeric_limits<std::size_t>::max();
  CheckTrue("no memory for polynomials",
    forms && forms->GetBackend() == sm::BackendChoice::CPU &&
      forms->GetReason().find("no OpenGL for polynomials") != std::string::npos,
    forms ? forms->GetReason() : error);
}

/// Polynomials that fail leave points on the device.
void CheckOneFails(vtkComputeContext* context)
{
  sm::VariantSettings settings(sm::VariantMethod::Automatic, sm::BackendChoice::OpenGL);
  settings.Context = context;
  settings.Expected = 1000000000;
  std::string error;
  // Timed are at points 64 or 65,536 variants, and twice or more as polynomials.
  sm::GetFailingBatch() = context->IsSoftware() ? 64 : 65536;
  const Integrator variants = sm::VariantIntegrator::Make(MakeTorusOfRadii().Shape, {}, error, settings);
  sm::GetFailingBatch() = std::numeric_limits<std::size_t>::max();
  if (!CheckTrue("memory for points only", variants != nullptr, error))
  {
    return;
  }
  const std::string reason = variants->GetReason();
  const bool arePoints = variants->GetMethod() == sm::VariantMethod::Points;
  CheckTrue("polynomials are left, not points",
    reason.find("no OpenGL for polynomials") != std::string::npos &&
      reason.find("there by OpenGL") != std::string::npos &&
      arePoints == (variants->GetBackend() == sm::BackendChoice::OpenGL),
    reason);
}

/// Automatic takes a GPU alone, and only where the CPU needs more than a second.
void CheckAutomatic(vtkComputeContext* context)
{
  const VariantSolid solid = MakeTorusOfRadii();
  for (const std::int64_t expected : { std::int64_t{ 1 }, std::int64_t{ 1000000000 } })
  {
    sm::VariantSettings settings(sm::VariantMethod::Points, sm::BackendChoice::Automatic);
    settings.Expected = expected;
    vtkNew<vtkComputeContext> own;
    settings.Context = own;
    std::string error;
    const Integrator variants = sm::VariantIntegrator::Make(solid.Shape, {}, error, settings);
    CheckTrue("automatic for " + std::to_string(expected) + " is made", variants != nullptr, error);
    const std::string reason = variants->GetReason();
    const bool isOpenGL = variants->GetBackend() == sm::BackendChoice::OpenGL;
    if (expected == 1)
    {
      CheckTrue("a variant needs no context", !isOpenGL && own->GetStatus() == vtkComputeContext::NOT_STARTED,
        reason);
      continue;
    }
    CheckTrue("a software renderer is not taken", !isOpenGL || !context->IsSoftware(), reason);
    CheckTrue("what was found is in the reason",
      reason.find(context->IsSoftware() ? "no GPU" : "OpenGL on") != std::string::npos, reason);
  }
}

void CheckLostContext()
{
  const VariantSolid solid = MakeBlock({ 2, 2, 2 }, true, 3);
  vtkNew<vtkComputeContext> context;
  const Integrator device = MakePoints(solid, sm::BackendChoice::OpenGL, context);
  const std::vector<double> c = MakeNumbers(solid, 5, 1.0);
  const Results before = Evaluate(*device, c.data(), 5);
  context->Stop();
  const Results after = Evaluate(*device, c.data(), 5);
  CheckTrue(
    "OpenGL in a new context", device->GetBackend() == sm::BackendChoice::OpenGL, device->GetReason());
  CheckTrue("bits in a new context",
    AreSame(before.Values.data(), after.Values.data(), 50) &&
      AreSame(before.Bounds.data(), after.Bounds.data(), 50));
}

void CheckProgress()
{
  const VariantSolid solid = MakeBoxOfSides();
  for (const sm::VariantMethod method : { sm::VariantMethod::Points, sm::VariantMethod::Polynomial })
  {
    std::vector<double> seen;
    sm::VariantSettings settings(method, sm::BackendChoice::CPU);
    settings.Progress = [&seen](double fraction)
    {
      seen.push_back(fraction);
      return true;
    };
    std::string error;
    CheckTrue(
      "with progress", sm::VariantIntegrator::Make(solid.Shape, {}, error, settings) != nullptr, error);
    CheckTrue("progress grows in [0, 1]",
      !seen.empty() && std::is_sorted(seen.begin(), seen.end()) && seen.front() >= 0.0 && seen.back() <= 1.0);
    // Stopped at each of the calls.
    for (std::size_t last = 0; last < seen.size(); ++last)
    {
      std::size_t calls = 0;
      settings.Progress = [&](double) { return calls++ < last; };
      CheckTrue("stopped", sm::VariantIntegrator::Make(solid.Shape, {}, error, settings) == nullptr, error);
      CheckTrue("stopped: the reason", error.find("stopped") != std::string::npos, error);
    }
  }
}
}

int TestVariantDevice(int, char*[])
{
  vtkNew<vtkComputeContext> context;
  if (context->Start() != vtkComputeContext::READY)
  {
    std::printf("SKIP %s\n", context->GetReason().c_str());
    return Skipped;
  }
  if (FlushesSubnormals())
  {
    return Skipped;
  }
  for (const VariantSolid& solid : { MakeBoxOfSides(), MakePrism() })
  {
    CheckSolid(solid, context, 1e-17, 1.0);
  }
  // 8 roundings of the arcs' weights and points.
  for (const VariantSolid& solid : { MakeEllipsoid(true), MakeEllipsoid(false), MakeTorusOfRadii() })
  {
    CheckSolid(solid, context, 2e-15, 1.0);
  }
  CheckSolid(MakeBlock({ 2, 1, 3 }, false, 4), context, 2e-15, 1.0);
  CheckSolid(MakeBlock({ 3, 3, 2 }, true, 10), context, 2e-15, 1.0);
  // Beyond the ranges that the orders are for.
  CheckSolid(MakeBlock({ 2, 2, 2 }, true, 3), context, 2e-15, 1.5);
  // Nets in a buffer; and more directions than polynomials have.
  CheckSolid(MakeBlock({ 4, 2, 5 }, true, 1), context, 2e-15, 1.0, 4);
  CheckSolid(MakeBlock({ 2, 3, 1 }, false, 40), context, 2e-15, 1.0, 4);
  CheckForms(MakeEllipsoid(true), context, 2e-15);
  CheckForms(MakePrism(), context, 1e-17);
  CheckForms(MakeBlock({ 3, 3, 2 }, true, 10), context, 2e-15);
  // More monomials than loops of llvmpipe may have.
  CheckForms(MakeBlock({ 1, 1, 1 }, false, 20), context, 2e-15);
  CheckWithoutBounds(context);
  CheckFormFallback();
  CheckBatches(context);
  CheckNotFinite(context);
  CheckFallbacks();
  CheckNoMemory(context);
  CheckOneFails(context);
  CheckAutomatic(context);
  CheckLostContext();
  CheckProgress();
  return Finish();
}
