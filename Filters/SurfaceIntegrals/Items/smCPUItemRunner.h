/**
 * @file smCPUItemRunner.h
 * @brief Evaluates items on the CPU, by the shaders' own chunks of mathematics
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
 * Items run in parallel by vtkSMPTools, with whatever backend and number of threads the application chose; results are
 * the same bits for any. All faces are one group. An integrand of the user's own is GLSL text, which needs OpenGL:
 * GetObstacle() says so.
 */
class SMFILTERSSURFACEINTEGRALS_EXPORT CPUItemRunner : public ItemRunner
{
public:
  CPUItemRunner();
  ~CPUItemRunner() override;

  /// "CPU, N threads".
  static std::string GetDescription();

  std::string GetObstacle(const Integrand& integrand) const override;
  bool Acquire(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress) override;
  std::string GetFaceError(std::size_t face) const override;
  int GetGroup(std::size_t face) const override;
  std::size_t GetRowLimit() const override;
  bool BeginBatch(const std::vector<BatchFace>& faces) override;
  bool BeginRows(std::size_t rows) override;
  bool Run(const std::vector<WorkItem>& items, const std::vector<std::size_t>& active,
    std::vector<std::uint8_t>& unconverged, std::int64_t& evaluations,
    const ContinueCallback& shouldContinue) override;
  bool Sum(const std::vector<Segment>& segments, std::vector<double>& sums,
    std::vector<double>& largestGaps) override;
  void Release() override;

protected:
  void OnConfigure() override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
