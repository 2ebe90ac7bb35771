/**
 * @file smRatedFilter.h
 * @brief A filter whose engine can be given other rates of the machine, and rates by which a GPU pays
 */
#ifndef smRatedFilter_h
#define smRatedFilter_h

#include "smIntegralEngine.h"

namespace smtest
{
template <class Filter>
class RatedFilter : public Filter
{
public:
  static RatedFilter* New()
  {
    auto* filter = new RatedFilter;
    filter->InitializeObjectBase();
    return filter;
  }

  void SetRates(const sm::BackendRates& rates) { this->GetEngine().SetRates(rates); }
};

/// Rates of a slow processor next to a GPU that needs `seconds` for any run.
inline sm::BackendRates MakeGPURates(double seconds)
{
  sm::BackendRates rates;
  for (double& rate : rates.CPUEvaluationsPerSecond)
  {
    rate = 1e3;
  }
  rates.CPURunSeconds = 0.0;
  rates.ContextSeconds = seconds;
  rates.ProgramSeconds = rates.GPURunSeconds = 0.0;
  rates.UploadBytesPerSecond = rates.GPUEvaluationsPerSecond = 1e99;
  return rates;
}
}

#endif
