/**
 * @file smGPUItemRunner.h
 * @brief Evaluates items by compute shaders
 */
#ifndef smGPUItemRunner_h
#define smGPUItemRunner_h

#include "smItemRunner.h"
#include "smProgressCallback.h"

#include <memory>

class vtkComputeContext;

namespace sm
{
/**
 * Keeps faces resident (ResidentFaces); a group is a page of them. Work is dispatched in portions of limited cost, each in a
 * scope of the context of its own, so that abort is heard, no driver's watchdog fires, and whoever watches the
 * progress may render elsewhere between them. The context must be READY.
 */
class GPUItemRunner : public ItemRunner
{
public:
  explicit GPUItemRunner(vtkComputeContext* context);
  ~GPUItemRunner() override;

  /// What the compiler says of an expression of the user's.
  std::string GetObstacle(const Integrand& integrand) const override;
  bool Acquire(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress) override;
  std::string GetFaceError(std::size_t face) const override;
  int GetGroup(std::size_t face) const override;
  /// Rows, and work records, fit into a storage block each.
  std::size_t GetRowLimit() const override;
  bool BeginBatch(const std::vector<BatchFace>& faces) override;
  bool BeginRows(std::size_t rows) override;
  bool Run(const std::vector<WorkItem>& items, const std::vector<std::size_t>& active,
    std::vector<std::uint8_t>& unconverged, std::int64_t& evaluations,
    const ContinueCallback& shouldContinue) override;
  bool Sum(const std::vector<Segment>& segments, std::vector<double>& sums,
    std::vector<double>& largestGaps) override;
  void Release() override;
  void FreeMemory() override;

protected:
  void OnConfigure() override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
