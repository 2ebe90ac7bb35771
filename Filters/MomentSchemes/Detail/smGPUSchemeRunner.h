/**
 * @file smGPUSchemeRunner.h
 * @brief Evaluates tiles of the paper's schemes by compute shaders
 */
#ifndef smGPUSchemeRunner_h
#define smGPUSchemeRunner_h

#include "smFiltersMomentSchemesModule.h"
#include "smProgressCallback.h"
#include "smSchemeRunner.h"

#include <memory>

class vtkComputeContext;

namespace sm
{
/**
 * Uploads every batch as a whole and dispatches it in portions of limited cost, each in its own scope of the
 * context. The rows of each tile are reduced over a fixed tree (sm::Reduction). The context must be READY.
 */
class SMFILTERSMOMENTSCHEMES_EXPORT GPUSchemeRunner : public SchemeRunner
{
public:
  explicit GPUSchemeRunner(vtkComputeContext* context);
  ~GPUSchemeRunner() override;

  /// Returns the largest size of a shader storage block, in bytes.
  std::size_t GetMaximumBytes() const override;
  /// Compiles the shaders and runs each once on an empty range.
  bool Prepare(const std::set<SchemeKernel>& kernels) override;
  bool Run(const SchemeBatch& batch, const Setup& setup, Results& results,
    const ContinueCallback& shouldContinue) override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
