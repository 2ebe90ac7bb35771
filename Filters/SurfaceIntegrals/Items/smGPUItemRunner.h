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
 * Keeps faces resident (ResidentFaces); a group is a page of them. Work is dispatched in portions of limited
 * cost, each in its own scope of the context, so that a run can be aborted between them, the driver's
 * watchdog does not interrupt it, and a progress observer may render in another window. Nothing is read back
 * before AddUp(): rows stay on the GPU. The context must be READY.
 */
class GPUItemRunner : public ItemRunner
{
public:
  explicit GPUItemRunner(vtkComputeContext* context);
  ~GPUItemRunner() override;

  /// Returns the compiler's message if the expression of a user integrand does not compile.
  std::string GetObstacle(const Integrand& integrand) const override;
  bool Acquire(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress) override;
  std::string GetFaceError(std::size_t face) const override;
  int GetGroup(std::size_t face) const override;
  /// Returns the number of rows for which the rows and the work records fit into a storage block each.
  std::size_t GetRowLimit() const override;
  bool IsProved(const WorkItem& item) const override;
  void SetProved(const WorkItem& item) override;
  void ForgetProofs() override;
  bool BeginBatch(const std::vector<BatchFace>& faces) override;
  bool BeginRows(std::size_t rows) override;
  bool Run(const WorkItems& items, const ActiveItems& active, std::int64_t& evaluations,
    const ContinueCallback& shouldContinue) override;
  bool GetUnconverged(std::vector<std::uint8_t>& unconverged) override;
  bool AddUp(const std::vector<RowPart>& parts, FaceTotals& totals, std::vector<RowGaps>& gaps) override;
  void Release() override;

protected:
  void OnConfigure() override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
