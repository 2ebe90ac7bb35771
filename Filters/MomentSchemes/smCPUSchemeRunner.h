/**
 * @file smCPUSchemeRunner.h
 * @brief Evaluates tiles of the paper's schemes on the CPU, by the shaders' own chunks of mathematics
 */
#ifndef smCPUSchemeRunner_h
#define smCPUSchemeRunner_h

#include "smFiltersMomentSchemesModule.h"
#include "smProgressCallback.h"
#include "smSchemeRunner.h"

namespace sm
{
/// In parallel by vtkSMPTools, with whatever backend and number of threads the application chose.
class SMFILTERSMOMENTSCHEMES_EXPORT CPUSchemeRunner : public SchemeRunner
{
public:
  bool Run(const SchemeBatch& batch, const Setup& setup, Results& results,
    const ContinueCallback& shouldContinue) override;
};
}

#endif
