/**
 * @file smPatchIntegrator.h
 * @brief Chooses where integrals of patches for gradients are computed
 */
#ifndef smPatchIntegrator_h
#define smPatchIntegrator_h

#include "smGradientDevice.h"
#include "smMomentGradient.h"
#include "smProgressCallback.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

namespace sm
{
/// Not thread safe.
class PatchIntegrator
{
public:
  /// `context`: null for one of its own, which is made when it is needed.
  explicit PatchIntegrator(BackendChoice backend = BackendChoice::CPU, vtkComputeContext* context = nullptr);

  /// Computes the integrals of all tasks, by OpenGL or on all threads. Returns false if stopped.
  bool Compute(
    const std::vector<PatchTask>& tasks, std::vector<PatchSums>& sums, const ProgressCallback& progress);

  /// OpenGL if it computed something, and did not fail later.
  BackendChoice GetUsed() const { return this->IsUsed ? BackendChoice::OpenGL : BackendChoice::CPU; }
  /// Why the processor, where OpenGL was asked for or tried.
  const std::string& GetReason() const { return this->Reason; }
  /// Seconds of all calls of Compute().
  double GetSeconds() const { return this->Seconds; }

private:
  bool WantsDevice(const std::vector<PatchTask>& tasks);
  bool ComputeOnDevice(const std::vector<PatchTask>& tasks, std::vector<PatchSums>& sums);

  BackendChoice Backend;
  vtkSmartPointer<vtkComputeContext> Context;
  std::unique_ptr<GradientDevice> Device;
  bool HasFailed = false;
  bool IsUsed = false;
  std::string Reason;
  double Seconds = 0.0;
};
}

#endif
