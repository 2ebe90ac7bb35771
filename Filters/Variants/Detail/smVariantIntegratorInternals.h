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
/// Returns the smallest seconds of three calls of `evaluate`, for each of n variants; NaN if a call returns
/// false.
template <typename Evaluate>
double MeasureVariants(std::size_t n, const Evaluate& evaluate)
{
  double seconds = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    if (!evaluate())
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
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
  /// Errors of all faces.
  std::size_t Terms = 0;
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
  /// Errors are moved from the chains, or copied where these are needed again.
  void AddFaces(std::vector<VariantFaceChain>& chains, bool isNeededAgain);
  void EvaluatePoints(const double* c, std::size_t n, double* values, double* bounds) const;
  bool EvaluateOnDevice(const double* c, std::size_t n, double* values, double* bounds);
  bool EvaluateFormsOnDevice(const double* c, std::size_t n, double* values, double* gradients);
  template <typename AnyDevice>
  bool Prepare(std::unique_ptr<AnyDevice>& device, std::string (Internals::*findDifference)());
  bool StartContext(const VariantSettings& settings, double onAll);
  std::vector<double> MakeSamples() const;
  std::string FindDeviceDifference();
  std::string FindFormDifference();
  void LeaveDevice(std::unique_ptr<VariantDevice>& device, std::string reason);
  void LeaveDevice(std::unique_ptr<VariantFormDevice>& device, std::string reason);
  double MeasurePoints() const;
  bool MakePoints(
    const VariantSettings& settings, const VariantChainOptions& options, double& seconds, std::string& error);
  template <typename AnyDevice, typename Work>
  double MeasureDevice(const VariantSettings& settings, std::unique_ptr<AnyDevice>& device, const char* what,
    double onAll, std::size_t n, const Work& evaluate);
  /// Return the seconds of a variant by OpenGL, or `onAll`, those on all threads of the CPU.
  double ChooseDevice(const VariantSettings& settings, DevicePoints points, double onAll);
  double ChooseFormDevice(const VariantSettings& settings,
    const std::shared_ptr<const VariantPolynomial>& polynomial, double onAll);
  bool TryPolynomial(
    const VariantSettings& settings, const VariantOptions& options, double ofPoints, std::string& error);
};
}

#endif
