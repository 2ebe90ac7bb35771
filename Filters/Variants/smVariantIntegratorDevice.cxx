#include "Detail/smVariantIntegratorInternals.h"
#include "Detail/smVariantNumbers.h"
#include "smFormat.h"
#include "smUnitRoundoff.h"

#include <cmath>

namespace sm
{
namespace
{
// Below this time of the CPU, in seconds, starting a context and building shaders does not pay.
constexpr double DevicePays = 1.0;
// Variants that device and CPU compare.
constexpr std::size_t ComparedVariants = 3;

/// Where no bound is known, half of the digits count, or 10 of the `scale`, as a number may vanish by
/// symmetry.
bool AreClose(double value, double right, double bound, double scale)
{
  const double apart = std::abs(value - right);
  return apart <= (std::isnan(bound) ? std::max(1e-8 * std::abs(right), 1e-10 * scale) : bound);
}

/// Returns scales of the moments of some variants: the largest volume V and the largest second moment S, and
/// the root of V S, which no first moment exceeds.
std::array<double, NumberOfMoments> FindScales(const double* values, std::size_t n)
{
  double volume = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; i < n * NumberOfMoments; ++i)
  {
    const std::size_t m = i % NumberOfMoments;
    volume = m == 0 ? std::max(volume, std::abs(values[i])) : volume;
    second = m > 3 ? std::max(second, std::abs(values[i])) : second;
  }
  std::array<double, NumberOfMoments> scales;
  scales.fill(second);
  scales[0] = volume;
  std::fill_n(scales.begin() + 1, 3, std::sqrt(volume) * std::sqrt(second));
  return scales;
}

std::string DescribeDifference(std::size_t moment, double value, double right)
{
  return "computes a variant wrong: moment " + std::to_string(moment) + " is " + FormatDigits(value, 17) +
    " for " + FormatDigits(right, 17);
}
}

// Reasons are copies, as errors are the device's.
void VariantIntegrator::Internals::LeaveDevice(std::unique_ptr<VariantDevice>& device, std::string reason)
{
  device = nullptr;
  this->AddReason("no OpenGL at frozen points, the CPU evaluates these: " + reason);
}

void VariantIntegrator::Internals::LeaveDevice(std::unique_ptr<VariantFormDevice>& device, std::string reason)
{
  device = nullptr;
  this->AddReason("no OpenGL for polynomials, the CPU evaluates these: " + reason);
}

/// Starts the context, and compares the device with the CPU, as a driver may compile an operation that the
/// start-up probe tests rightly there and wrongly elsewhere.
template <typename AnyDevice>
bool VariantIntegrator::Internals::Prepare(
  std::unique_ptr<AnyDevice>& device, std::string (Internals::*findDifference)())
{
  if (!device->Prepare())
  {
    this->LeaveDevice(device, device->GetError());
    return false;
  }
  const std::string difference = (this->*findDifference)();
  if (!difference.empty())
  {
    this->LeaveDevice(device, device->GetContext()->GetRenderer() + " " + difference);
    return false;
  }
  return true;
}

/// c of the variants that are compared: the base, and two in the ranges.
std::vector<double> VariantIntegrator::Internals::MakeSamples() const
{
  const std::size_t directions = this->GetDirections();
  std::vector<double> c(ComparedVariants * directions, 0.0);
  for (std::size_t k = 0; k < directions; ++k)
  {
    c[directions + k] = 0.61 * this->Ranges[k];
    c[2 * directions + k] = (k % 3 == 0 ? 1.0 : -0.83) * this->Ranges[k] / static_cast<double>(1 + k % 5);
  }
  return c;
}

/// Returns a sentence about the first moment or bound of three variants in which device and CPU differ by
/// more than both bounds; empty if they do not.
std::string VariantIntegrator::Internals::FindDeviceDifference()
{
  constexpr std::size_t n = ComparedVariants;
  const std::size_t directions = this->GetDirections();
  const std::vector<double> c = this->MakeSamples();
  std::array<std::array<double, n * NumberOfMoments>, 2> values{};
  std::array<std::array<double, n * NumberOfMoments>, 2> bounds{};
  this->EvaluatePoints(c.data(), n, values[0].data(), bounds[0].data());
  if (!this->Device->Evaluate(c.data(), n, values[1].data(), bounds[1].data()))
  {
    return this->Device->GetError();
  }
  const DevicePoints& points = this->Device->GetPoints();
  const std::array<double, NumberOfMoments> scales = FindScales(values[0].data(), n);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < n; ++i)
  {
    std::array<double, NumberOfMoments> expected = points.ConstantBound;
    AddErrors(points.Errors, c.data() + i * directions, sizes, expected);
    for (std::size_t m = 0; m < NumberOfMoments; ++m)
    {
      const std::size_t at = i * NumberOfMoments + m;
      const double bound = bounds[1][at];
      const double known = GetSumRounding(points.Terms) * expected[m] +
        4.0 * UnitRoundoff * (std::abs(values[1][at]) + std::abs(points.Constant[m]));
      const bool isBound = points.HasBounds && std::isfinite(known) ? std::abs(bound - known) <= 1e-9 * known
                                                                    : std::isnan(bound);
      if (!isBound || !AreClose(values[1][at], values[0][at], bound + bounds[0][at], scales[m]))
      {
        return DescribeDifference(m, values[1][at], values[0][at]) + ", and its bound " +
          FormatDigits(bound, 5) + " for " + FormatDigits(known, 5);
      }
    }
  }
  return "";
}

/// The same for polynomials, whose bounds are the CPU's, and for their gradients.
std::string VariantIntegrator::Internals::FindFormDifference()
{
  constexpr std::size_t n = ComparedVariants;
  const std::size_t all = n * NumberOfMoments;
  const std::size_t directions = this->GetDirections();
  const std::vector<double> c = this->MakeSamples();
  std::vector<double> values[2] = { std::vector<double>(all), std::vector<double>(all) };
  std::vector<double> bounds(all);
  std::vector<double> gradients[2] = { std::vector<double>(all * directions),
    std::vector<double>(all * directions) };
  std::vector<double> gradientBounds(all * directions);
  for (const bool hasGradients : { false, true })
  {
    this->Polynomial->Evaluate(c.data(), n, values[0].data(), bounds.data(),
      hasGradients ? gradients[0].data() : nullptr, gradientBounds.data());
    if (!this->FormDevice->Evaluate(
          c.data(), n, values[1].data(), hasGradients ? gradients[1].data() : nullptr))
    {
      return this->FormDevice->GetError();
    }
    const std::array<double, NumberOfMoments> scales = FindScales(values[0].data(), n);
    for (std::size_t i = 0; i < all; ++i)
    {
      if (!AreClose(values[1][i], values[0][i], 2.0 * bounds[i], scales[i % NumberOfMoments]))
      {
        return DescribeDifference(i % NumberOfMoments, values[1][i], values[0][i]);
      }
    }
    for (std::size_t i = 0; hasGradients && i < all * directions; ++i)
    {
      const std::size_t m = i / directions % NumberOfMoments;
      const double scale = scales[m] / this->Ranges[i % directions];
      if (!AreClose(gradients[1][i], gradients[0][i], 2.0 * gradientBounds[i], scale))
      {
        return DescribeDifference(m, gradients[1][i], gradients[0][i]) + ", as a derivative";
      }
    }
  }
  return "";
}

bool VariantIntegrator::Internals::EvaluateOnDevice(
  const double* c, std::size_t n, double* values, double* bounds)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->Device ||
    (!this->Device->IsReady() && !this->Prepare(this->Device, &Internals::FindDeviceDifference)))
  {
    return false;
  }
  if (!this->Device->Evaluate(c, n, values, bounds))
  {
    this->LeaveDevice(this->Device, this->Device->GetError());
    return false;
  }
  const std::size_t directions = this->GetDirections();
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!IsInRange(c + i * directions, directions))
    {
      this->EvaluatePoints(
        c + i * directions, 1, values + i * NumberOfMoments, bounds ? bounds + i * NumberOfMoments : nullptr);
    }
  }
  return true;
}

bool VariantIntegrator::Internals::EvaluateFormsOnDevice(
  const double* c, std::size_t n, double* values, double* gradients)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->FormDevice ||
    (!this->FormDevice->IsReady() && !this->Prepare(this->FormDevice, &Internals::FindFormDifference)))
  {
    return false;
  }
  if (!this->FormDevice->Evaluate(c, n, values, gradients))
  {
    this->LeaveDevice(this->FormDevice, this->FormDevice->GetError());
    return false;
  }
  const std::size_t directions = this->GetDirections();
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!IsInRange(c + i * directions, directions))
    {
      this->Polynomial->Evaluate(c + i * directions, 1, values + i * NumberOfMoments, nullptr,
        gradients ? gradients + i * NumberOfMoments * directions : nullptr);
    }
  }
  return true;
}

/// Returns false, with the reason, where OpenGL is not wanted, does not pay, or has no GPU.
bool VariantIntegrator::Internals::StartContext(const VariantSettings& settings, double onAll)
{
  const bool isForced = settings.Backend == BackendChoice::OpenGL;
  if (settings.Backend == BackendChoice::CPU ||
    (!isForced && onAll * static_cast<double>(settings.Expected) < DevicePays))
  {
    return false;
  }
  if (!this->Context)
  {
    this->Context = settings.Context;
    if (!this->Context)
    {
      this->Context = vtkSmartPointer<vtkComputeContext>::New();
    }
    if (!isForced && !this->Context->StartOnGPU())
    {
      // A machine without a GPU is nothing to report; a GPU that cannot be used is.
      this->AddReason(this->Context->GetStatus() <= vtkComputeContext::NO_CONTEXT
          ? "no GPU"
          : "no usable GPU: " + this->Context->GetReason());
    }
  }
  return isForced || this->Context->StartOnGPU();
}

/// Returns the seconds of a variant by `evaluate(c, values)` of a device, or leaves the device and returns
/// `onAll` where it fails, or is slower though it is not forced.
template <typename AnyDevice, typename Work>
double VariantIntegrator::Internals::MeasureDevice(const VariantSettings& settings,
  std::unique_ptr<AnyDevice>& device, const char* what, double onAll, std::size_t n, const Work& evaluate)
{
  const std::vector<double> c(n * this->GetDirections(), 0.0);
  std::vector<double> values(n * NumberOfMoments);
  const double seconds = MeasureVariants(n, [&]() { return evaluate(c.data(), values.data()); });
  if (std::isnan(seconds))
  {
    this->LeaveDevice(device, device->GetError());
    return onAll;
  }
  this->AddReason(FormatMicroseconds(seconds) + what + this->Context->GetRenderer());
  if (settings.Backend != BackendChoice::OpenGL && seconds >= onAll)
  {
    device = nullptr;
    return onAll;
  }
  return seconds;
}

double VariantIntegrator::Internals::ChooseDevice(
  const VariantSettings& settings, DevicePoints points, double onAll)
{
  this->Device = std::make_unique<VariantDevice>(this->Context, std::move(points), this->GetDirections());
  if (!this->Prepare(this->Device, &Internals::FindDeviceDifference))
  {
    return onAll;
  }
  const std::size_t n = this->Context->IsSoftware() ? 64 : 65536;
  return this->MeasureDevice(settings, this->Device, " there by OpenGL on ", onAll, n,
    [&](const double* c, double* values) { return this->Device->Evaluate(c, n, values, nullptr); });
}

/// The same as a polynomial, which becomes that of the integrator.
double VariantIntegrator::Internals::ChooseFormDevice(
  const VariantSettings& settings, const std::shared_ptr<const VariantPolynomial>& polynomial, double onAll)
{
  this->Polynomial = polynomial;
  if (!this->StartContext(settings, onAll))
  {
    return onAll;
  }
  this->FormDevice = std::make_unique<VariantFormDevice>(this->Context, polynomial);
  if (!this->Prepare(this->FormDevice, &Internals::FindFormDifference))
  {
    return onAll;
  }
  const std::size_t n = this->Context->IsSoftware() ? 1024 : 131072;
  return this->MeasureDevice(settings, this->FormDevice, " as one by OpenGL on ", onAll, n,
    [&](const double* c, double* values) { return this->FormDevice->Evaluate(c, n, values, nullptr); });
}
}
