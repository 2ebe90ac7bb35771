#include "smVariantIntegrator.h"

#include "Detail/smVariantDevice.h"
#include "Detail/smVariantErrors.h"
#include "Detail/smVariantKernels.h"
#include "Detail/smVariantPointsWriter.h"
#include "Detail/smVariantScales.h"
#include "Detail/smVariantSums.h"
#include "smFormat.h"
#include "smParallelFor.h"
#include "smUnitRoundoff.h"

#include "vtkComputeContext.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>

namespace sm
{
namespace
{
// Below this time of the CPU, in seconds, starting a context and building shaders does not pay.
constexpr double DevicePays = 1.0;

double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string FormatMicroseconds(double seconds)
{
  return FormatDigits(1e6 * seconds, 4) + " us";
}

/// Returns the smallest seconds of three calls of `evaluate`, for each of n variants.
template <typename Evaluate>
double Measure(std::size_t n, const Evaluate& evaluate)
{
  double seconds = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i)
  {
    const double start = Now();
    evaluate();
    seconds = std::min(seconds, Now() - start);
  }
  return seconds / static_cast<double>(n);
}
}

struct VariantIntegrator::Internals
{
  std::shared_ptr<const VariantShape> Shape;
  std::shared_ptr<const VariantPolynomial> Polynomial;
  std::array<double, 3> Reference{};
  std::vector<double> Ranges;
  std::vector<PointsFace> Faces;
  std::vector<PointsErrors> Errors;
  /// Of the faces that nothing moves.
  std::array<double, NumberOfMoments> Constant{};
  std::array<double, NumberOfMoments> ConstantBound{};
  std::vector<VariantGap> Gaps;
  std::int64_t Samples = 0;
  /// Protects the device and the reason.
  std::mutex Mutex;
  /// Null: the CPU.
  std::unique_ptr<VariantDevice> Device;
  std::string Reason;

  std::size_t GetDirections() const { return static_cast<std::size_t>(this->Shape->GetNumberOfDirections()); }
  void AddReason(const std::string& text) { this->Reason += (this->Reason.empty() ? "" : ", ") + text; }
  void AddFaces(std::vector<VariantFaceChain>& chains, DevicePointsWriter* writer);
  void EvaluatePoints(const double* c, std::size_t n, double* values, double* bounds) const;
  bool EvaluateOnDevice(const double* c, std::size_t n, double* values, double* bounds);
  bool PrepareDevice();
  std::string FindDeviceDifference();
  void LeaveDevice(std::string reason);
  double MeasurePoints() const;
  double MeasureDevice();
  bool MakePoints(
    const VariantSettings& settings, const VariantChainOptions& options, double& seconds, std::string& error);
  double ChooseDevice(const VariantSettings& settings, DevicePoints points, double onProcessor);
  bool TryPolynomial(
    const VariantSettings& settings, const VariantOptions& options, double ofPoints, std::string& error);
};

void VariantIntegrator::Internals::AddFaces(std::vector<VariantFaceChain>& chains, DevicePointsWriter* writer)
{
  const VariantMonomials one(1);
  VariantTotals totals(one);
  const VariantMap map(one, {}, one);
  for (VariantFaceChain& chain : chains)
  {
    if (writer)
    {
      writer->AddFace(chain);
    }
    PointsErrors errors{ chain.Directions, std::move(chain.Errors) };
    if (!chain.Directions.empty())
    {
      this->Samples += CountSamples(chain);
      this->Faces.push_back(WritePoints(chain));
      this->Errors.push_back(std::move(errors));
      continue;
    }
    VariantSums sums(one, map, totals);
    VisitSamples(chain, [&sums](const VariantSample& sample) { sums.Add(sample); });
    sums.Flush();
    AddErrors(errors, { 1.0 }, this->ConstantBound);
  }
  for (int m = 0; m < NumberOfMoments; ++m)
  {
    this->Constant[m] = totals.Get(m, 0);
  }
}

void VariantIntegrator::Internals::EvaluatePoints(
  const double* c, std::size_t n, double* values, double* bounds) const
{
  const std::size_t lanes = GetVariantLanes();
  const std::size_t directions = this->GetDirections();
  ParallelFor((n + lanes - 1) / lanes, 8,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<double> sums(NumberOfMoments * lanes);
      std::vector<double> carries(sums.size());
      std::vector<double> scratch;
      std::vector<double> sizes;
      for (std::size_t batch = begin; batch < end; ++batch)
      {
        const std::size_t first = batch * lanes;
        const std::size_t count = std::min(lanes, n - first);
        for (std::size_t i = 0; i < sums.size(); ++i)
        {
          sums[i] = this->Constant[i / lanes];
          carries[i] = 0.0;
        }
        for (const PointsFace& face : this->Faces)
        {
          AddPoints(face, c + first * directions, directions, count, sums.data(), carries.data(), scratch);
        }
        for (std::size_t lane = 0; lane < count; ++lane)
        {
          for (int m = 0; m < NumberOfMoments; ++m)
          {
            values[(first + lane) * NumberOfMoments + m] = sums[m * lanes + lane] + carries[m * lanes + lane];
          }
          if (!bounds)
          {
            continue;
          }
          std::array<double, NumberOfMoments> total = this->ConstantBound;
          AddErrors(this->Errors, c + (first + lane) * directions, sizes, total);
          for (int m = 0; m < NumberOfMoments; ++m)
          {
            const double value = values[(first + lane) * NumberOfMoments + m];
            const double bound = PointsRounding * total[m] +
              4.0 * UnitRoundoff * (std::abs(value) + std::abs(this->Constant[m]));
            bounds[(first + lane) * NumberOfMoments + m] =
              std::isfinite(bound) ? bound : std::numeric_limits<double>::quiet_NaN();
          }
        }
      }
    });
}

double VariantIntegrator::Internals::MeasurePoints() const
{
  const std::size_t n = 4 * static_cast<std::size_t>(GetVariantLanes());
  const std::vector<double> c(n * this->GetDirections(), 0.0);
  std::vector<double> values(n * NumberOfMoments);
  return Measure(n, [&]() { this->EvaluatePoints(c.data(), n, values.data(), nullptr); });
}

double VariantIntegrator::Internals::MeasureDevice()
{
  const std::size_t n = this->Device->GetContext()->IsSoftware() ? 64 : 65536;
  const std::vector<double> c(n * this->GetDirections(), 0.0);
  std::vector<double> values(n * NumberOfMoments);
  return Measure(n, [&]() { this->Device->Evaluate(c.data(), n, values.data(), nullptr); });
}

void VariantIntegrator::Internals::LeaveDevice(std::string reason)
{
  this->Device = nullptr;
  this->AddReason("no OpenGL, the CPU evaluates: " + reason);
}

/// Starts the context, and compares the device with the CPU, as a driver may compile an operation that the
/// start-up probe tests rightly there and wrongly elsewhere.
bool VariantIntegrator::Internals::PrepareDevice()
{
  if (!this->Device->Prepare())
  {
    this->LeaveDevice(this->Device->GetError());
    return false;
  }
  const std::string difference = this->FindDeviceDifference();
  if (!difference.empty())
  {
    this->LeaveDevice(this->Device->GetContext()->GetRenderer() + " " + difference);
    return false;
  }
  return true;
}

/// Returns a sentence about the first moment or bound of three variants in which device and CPU differ by
/// more than both bounds; empty if they do not.
std::string VariantIntegrator::Internals::FindDeviceDifference()
{
  constexpr std::size_t n = 3;
  const std::size_t directions = this->GetDirections();
  std::vector<double> c(n * directions, 0.0);
  for (std::size_t k = 0; k < directions; ++k)
  {
    c[directions + k] = 0.61 * this->Ranges[k];
    c[2 * directions + k] = (k % 3 == 0 ? 1.0 : -0.83) * this->Ranges[k] / static_cast<double>(1 + k % 5);
  }
  std::array<std::array<double, n * NumberOfMoments>, 2> values{};
  std::array<std::array<double, n * NumberOfMoments>, 2> bounds{};
  this->EvaluatePoints(c.data(), n, values[0].data(), bounds[0].data());
  if (!this->Device->Evaluate(c.data(), n, values[1].data(), bounds[1].data()))
  {
    return this->Device->GetError();
  }
  const DevicePoints& points = this->Device->GetPoints();
  std::vector<double> sizes;
  for (std::size_t i = 0; i < n; ++i)
  {
    std::array<double, NumberOfMoments> expected = points.ConstantBound;
    AddErrors(points.Errors, c.data() + i * directions, sizes, expected);
    for (std::size_t m = 0; m < NumberOfMoments; ++m)
    {
      const double value = values[1][i * NumberOfMoments + m];
      const double right = values[0][i * NumberOfMoments + m];
      const double bound = bounds[1][i * NumberOfMoments + m];
      const double known =
        expected[m] + 4.0 * UnitRoundoff * (std::abs(value) + std::abs(points.Constant[m]));
      const bool isBound = points.HasBounds ? std::abs(bound - known) <= 1e-9 * known : std::isnan(bound);
      // Where no bound is known, half of the digits.
      const double allowed =
        points.HasBounds ? bound + bounds[0][i * NumberOfMoments + m] : 1e-8 * std::abs(right);
      if (!isBound || !(std::abs(value - right) <= allowed))
      {
        return "computes a variant wrong: moment " + std::to_string(m) + " is " + FormatDigits(value, 17) +
          " for " + FormatDigits(right, 17) + ", and its bound " + FormatDigits(bound, 5) + " for " +
          FormatDigits(known, 5);
      }
    }
  }
  return "";
}

bool VariantIntegrator::Internals::EvaluateOnDevice(
  const double* c, std::size_t n, double* values, double* bounds)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->Device || (!this->Device->IsReady() && !this->PrepareDevice()))
  {
    return false;
  }
  if (!this->Device->Evaluate(c, n, values, bounds))
  {
    this->LeaveDevice(this->Device->GetError());
    return false;
  }
  const std::size_t directions = this->GetDirections();
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!VariantDevice::IsInRange(c + i * directions, directions))
    {
      this->EvaluatePoints(
        c + i * directions, 1, values + i * NumberOfMoments, bounds ? bounds + i * NumberOfMoments : nullptr);
    }
  }
  return true;
}

/// Returns the seconds of a variant at frozen points, by OpenGL or on the CPU.
double VariantIntegrator::Internals::ChooseDevice(
  const VariantSettings& settings, DevicePoints points, double onProcessor)
{
  const double threads = std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  const bool isForced = settings.Backend == VariantBackend::OpenGL;
  const double onAll = onProcessor / threads;
  if (!isForced && onAll * static_cast<double>(settings.Expected) < DevicePays)
  {
    return onProcessor;
  }
  vtkSmartPointer<vtkComputeContext> context = settings.Context;
  if (!context)
  {
    context = vtkSmartPointer<vtkComputeContext>::New();
  }
  if (!isForced && !context->StartOnGPU())
  {
    this->AddReason("no GPU");
    return onProcessor;
  }
  this->Device = std::make_unique<VariantDevice>(context, std::move(points), this->GetDirections());
  if (!this->PrepareDevice())
  {
    return onProcessor;
  }
  const double seconds = this->MeasureDevice();
  this->AddReason(FormatMicroseconds(seconds) + " there by OpenGL on " + context->GetRenderer());
  if (!isForced && seconds >= onAll)
  {
    this->Device = nullptr;
    return onProcessor;
  }
  return seconds;
}

bool VariantIntegrator::Internals::MakePoints(
  const VariantSettings& settings, const VariantChainOptions& options, double& seconds, std::string& error)
{
  std::vector<VariantFaceChain> chains;
  if (!MakeChains(*this->Shape, options, GetPartOf(settings.Progress, 0.0, 0.5), chains, error))
  {
    return false;
  }
  this->Gaps = FindGaps(chains, this->Shape->GetNumberOfDirections());
  DevicePointsWriter writer;
  const bool isForDevice = settings.Backend != VariantBackend::CPU;
  this->AddFaces(chains, isForDevice ? &writer : nullptr);
  seconds = this->MeasurePoints();
  this->Reason =
    "a variant takes " + FormatMicroseconds(seconds) + " at frozen points on a thread of the CPU";
  if (isForDevice)
  {
    seconds = this->ChooseDevice(settings, writer.Finish(), seconds);
  }
  return true;
}

bool VariantIntegrator::Internals::TryPolynomial(
  const VariantSettings& settings, const VariantOptions& options, double ofPoints, std::string& error)
{
  const bool isOnly = settings.Method == VariantMethod::Polynomial;
  const auto polynomial = VariantPolynomial::Make(
    this->Shape, options, error, GetPartOf(settings.Progress, isOnly ? 0.0 : 0.5, 1.0));
  if (!polynomial)
  {
    return false;
  }
  const std::size_t n = 16 * static_cast<std::size_t>(GetVariantLanes());
  const std::vector<double> c(n * this->GetDirections(), 0.0);
  std::vector<double> values(n * NumberOfMoments);
  const double seconds = Measure(n, [&]() { polynomial->Evaluate(c.data(), n, values.data()); });
  this->AddReason((this->Reason.empty() ? "a variant takes " : "") + FormatMicroseconds(seconds) +
    " as a polynomial, which took " + FormatDigits(polynomial->GetSeconds(), 4) + " s to make");
  if (isOnly || seconds < ofPoints)
  {
    this->Polynomial = polynomial;
    this->Gaps = polynomial->GetGaps();
    this->Samples = 0;
    this->Faces.clear();
    this->Errors.clear();
    this->Device = nullptr;
  }
  return true;
}

VariantIntegrator::VariantIntegrator(std::unique_ptr<Internals> implementation)
  : Implementation(std::move(implementation))
{
}

VariantIntegrator::~VariantIntegrator() = default;

std::shared_ptr<const VariantIntegrator> VariantIntegrator::Make(
  const std::shared_ptr<const VariantShape>& shape, const VariantOptions& options, std::string& error,
  const VariantSettings& settings)
try
{
  const VariantMethod method = settings.Method;
  error = !shape ? "there is no shape: make one first" : FindProblem(options, shape->GetNumberOfDirections());
  if (error.empty() && method == VariantMethod::Polynomial &&
    shape->GetNumberOfDirections() > VariantPolynomial::MaximumDirections)
  {
    error = "more than " + std::to_string(VariantPolynomial::MaximumDirections) +
      " directions are too many for polynomials: use frozen points";
  }
  if (!error.empty())
  {
    return nullptr;
  }
  auto internals = std::make_unique<Internals>();
  internals->Shape = shape;
  const VariantChainOptions chainOptions = MakeChainOptions(*shape, options);
  internals->Ranges = chainOptions.Ranges;
  for (int c = 0; c < 3; ++c)
  {
    internals->Reference[c] = chainOptions.Reference[c] + shape->GetBase()->GetOrigin()[c];
  }
  double ofPoints = 0.0;
  if (method != VariantMethod::Polynomial && !internals->MakePoints(settings, chainOptions, ofPoints, error))
  {
    return nullptr;
  }
  const bool isTried = method == VariantMethod::Polynomial ||
    (method == VariantMethod::Automatic &&
      shape->GetNumberOfDirections() <= VariantPolynomial::MaximumDirections &&
      // Below the time that a small polynomial takes there is nothing to gain.
      ofPoints * static_cast<double>(settings.Expected) > 0.01);
  if (isTried && !internals->TryPolynomial(settings, options, ofPoints, error))
  {
    return nullptr;
  }
  if (internals->Polynomial && settings.Backend == VariantBackend::OpenGL)
  {
    internals->AddReason("polynomials are evaluated on the CPU");
  }
  return std::shared_ptr<const VariantIntegrator>(new VariantIntegrator(std::move(internals)));
}
catch (...)
{
  error = ExplainFailure(std::current_exception());
  return nullptr;
}

VariantMethod VariantIntegrator::GetMethod() const
{
  return this->Implementation->Polynomial ? VariantMethod::Polynomial : VariantMethod::Points;
}

VariantBackend VariantIntegrator::GetBackend() const
{
  const std::lock_guard<std::mutex> lock(this->Implementation->Mutex);
  return this->Implementation->Device ? VariantBackend::OpenGL : VariantBackend::CPU;
}

std::string VariantIntegrator::GetReason() const
{
  const std::lock_guard<std::mutex> lock(this->Implementation->Mutex);
  return this->Implementation->Reason;
}

int VariantIntegrator::GetNumberOfDirections() const
{
  return this->Implementation->Shape->GetNumberOfDirections();
}

const std::array<double, 3>& VariantIntegrator::GetReference() const
{
  return this->Implementation->Reference;
}

const std::vector<VariantGap>& VariantIntegrator::GetGaps() const
{
  return this->Implementation->Gaps;
}

const VariantPolynomial* VariantIntegrator::GetPolynomial() const
{
  return this->Implementation->Polynomial.get();
}

std::int64_t VariantIntegrator::GetNumberOfSamples() const
{
  return this->Implementation->Samples;
}

void VariantIntegrator::Evaluate(const double* c, std::size_t n, double* values, double* bounds) const
{
  if (this->Implementation->Polynomial)
  {
    this->Implementation->Polynomial->Evaluate(c, n, values, bounds);
    return;
  }
  if (!this->Implementation->EvaluateOnDevice(c, n, values, bounds))
  {
    this->Implementation->EvaluatePoints(c, n, values, bounds);
  }
  HideNotFinite(c, static_cast<std::size_t>(this->GetNumberOfDirections()), n,
    { { values, NumberOfValues }, { bounds, NumberOfValues } });
}
}
