/**
 * @file smCPUItemRunner.h
 * @brief Evaluates items on the CPU, with the mathematics of the shaders
 */
#ifndef smCPUItemRunner_h
#define smCPUItemRunner_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "smItemRunner.h"
#include "smProgressCallback.h"

#include <memory>

namespace sm
{
/**
 * Evaluates items in parallel by vtkSMPTools, with the backend and the number of threads that the application
 * chose, and items of one shape side by side in the lanes of vector registers; results are bitwise the same
 * for any of these. All faces are one group. User integrands are GLSL text, which needs OpenGL; for these
 * GetObstacle() returns a reason.
 */
class SMFILTERSSURFACEINTEGRALS_EXPORT CPUItemRunner : public ItemRunner
{
public:
  CPUItemRunner();
  ~CPUItemRunner() override;

  /// Returns "CPU, N threads".
  static std::string GetDescription();

  /// Sets how many items are evaluated side by side, one of GetLaneCounts(); default: as many as the
  /// processor can. Results are bitwise the same for any number.
  void SetLaneCount(int lanes);

  std::string GetObstacle(const Integrand& integrand) const override;
  bool Acquire(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress) override;
  std::string GetFaceError(std::size_t face) const override;
  int GetGroup(std::size_t face) const override;
  std::size_t GetRowLimit() const override;
  bool BeginBatch(const std::vector<BatchFace>& faces) override;
  bool BeginRows(std::size_t rows) override;
  bool Run(const WorkItems& items, const ActiveItems& active, std::int64_t& evaluations,
    const ContinueCallback& shouldContinue) override;
  bool GetUnconverged(std::vector<std::uint8_t>& unconverged) override;
  bool AddUp(const std::vector<RowPart>& parts, FaceTotals& totals, std::vector<RowGaps>& gaps) override;
  void Release() override;

  /// Computes the sums of all columns over each segment [first, last) of rows, GetLayout().GetStride()
  /// doubles each, and the maximum of the column MaxGap. An empty segment has zeros. Sums are
  /// compensated; a NaN is preserved.
  using Segment = std::pair<unsigned int, unsigned int>;
  bool Sum(const std::vector<Segment>& segments, std::vector<double>& sums, std::vector<double>& largestGaps);

protected:
  void OnConfigure() override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
  int LaneCount;
};
}

#endif
