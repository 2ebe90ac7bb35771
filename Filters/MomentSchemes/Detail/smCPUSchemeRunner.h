/**
 * @file smCPUSchemeRunner.h
 * @brief Evaluates tiles of the paper's schemes on the CPU, with the mathematics of the shaders
 */
#ifndef smCPUSchemeRunner_h
#define smCPUSchemeRunner_h

#include "smFiltersMomentSchemesModule.h"
#include "smProgressCallback.h"
#include "smSchemeRunner.h"

namespace sm
{
/// Evaluates tiles in parallel by vtkSMPTools, with the backend and the number of threads that the
/// application chose.
class SMFILTERSMOMENTSCHEMES_EXPORT CPUSchemeRunner : public SchemeRunner
{
public:
  bool Run(const SchemeBatch& batch, const Setup& setup, Results& results,
    const ContinueCallback& shouldContinue) override;
};
}

#endif
