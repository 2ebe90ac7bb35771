/**
 * @file smVariantIntegratorInternals.h
 * @brief What a VariantIntegrator has, on the CPU and on a device
 */
#ifndef smVariantIntegratorInternals_h
#define smVariantIntegratorInternals_h

#include "smVariantDevice.h"
#include "smVariantErrors.h"
#include "smVariantFormDevice.h"
#include "smVariantIntegrator.h"
#include "smVariantPoints.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <mutex>

namespace sm
{
/// Returns the smallest seconds of three calls of `evaluate`, for each of n variants.
template <typename Evaluate>
double MeasureVariants(std::size_t n, const Evaluate& evaluate)
{
  double seconds = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    evaluate();
    seconds =
      std::min(seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return seconds / static_cast<double>(n);
}

/// "12.3 us".
std::string FormatMicroseconds(double seconds);

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
  /// Protects the devices and the reason.
  std::mutex Mutex;
  vtkSmartPointer<vtkComputeContext> Context;
  /// Of points and polynomials; null: the CPU.
  std::unique_ptr<VariantDevice> Device;
  std::unique_ptr<VariantFormDevice> FormDevice;
  std::string Reason;

  std::size_t GetDirections() const { return static_cast<std::size_t>(this->Shape->GetNumberOfDirections()); }
  void AddReason(const std::string& text) { this->Reason += (this->Reason.empty() ? "" : ", ") + text; }
  void AddFaces(std::vector<VariantFaceChain>& chains, DevicePointsWriter* writer);
  void EvaluatePoints(const double* c, std::size_t n, double* values, double* bounds) const;
  bool EvaluateOnDevice(const double* c, std::size_t n, double* values, double* bounds);
  bool EvaluateFormsOnDevice(const double* c, std::size_t n, double* values, double* gradients);
  template <typename AnyDevice>
  bool Prepare(std::unique_ptr<AnyDevice>& device, std::string (Internals::*findDifference)());
  bool StartContext(const VariantSettings& settings, double onProcessor);
  std::vector<double> MakeSamples() const;
  std::string FindDeviceDifference();
  std::string FindFormDifference();
  void LeaveDevice(std::string reason);
  double MeasurePoints() const;
  bool MakePoints(
    const VariantSettings& settings, const VariantChainOptions& options, double& seconds, std::string& error);
  double ChooseDevice(const VariantSettings& settings, DevicePoints points, double onProcessor);
  double ChooseFormDevice(const VariantSettings& settings,
    const std::shared_ptr<const VariantPolynomial>& polynomial, double onProcessor);
  bool TryPolynomial(
    const VariantSettings& settings, const VariantOptions& options, double ofPoints, std::string& error);
};
}

#endif
