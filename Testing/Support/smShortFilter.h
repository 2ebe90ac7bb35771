/**
 * @file smShortFilter.h
 * @brief Filters whose RequestData is short of memory, for programs that test it
 *
 * Include it in one source file of a program, as smFailingMemory.h.
 */
#ifndef smShortFilter_h
#define smShortFilter_h

#include "smFailingMemory.h"
#include "smTestPipeline.h"

#include <vtkSurfaceIntegralGPU.h>

#if __has_include(<vtkBuoyancy.h>)
#include <vtkBuoyancy.h>
#define HAS_BUOYANCY
#endif

#include <algorithm>
#include <fstream>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace smtest
{
/// Shortage of memory in a run.
struct Shortage
{
  /// Number of the allocation that fails; 0: none.
  long Failing = 0;
  /// Bytes of address space above what is in use when the run starts; negative: no limit.
  long Headroom = -1;
  /// The number of allocations of the run until it writes its outputs.
  long Allocations = 0;
  bool HasEscaped = false;

  void Begin() const
  {
    if (this->Headroom >= 0)
    {
      malloc_trim(0);
      long pages = 0;
      std::ifstream("/proc/self/statm") >> pages;
      SetLimit(static_cast<rlim_t>(pages * sysconf(_SC_PAGESIZE) + this->Headroom));
    }
    failingMemory.Begin(this->Failing);
  }
  void End()
  {
    this->Allocations = failingMemory.End();
    if (this->Headroom >= 0)
    {
      SetLimit(RLIM_INFINITY);
    }
  }

private:
  static void SetLimit(rlim_t bytes)
  {
    struct rlimit limit = {};
    getrlimit(RLIMIT_AS, &limit);
    limit.rlim_cur = std::min(bytes, limit.rlim_max);
    setrlimit(RLIMIT_AS, &limit);
  }
};

/// A filter with a shortage of memory in RequestData alone: the pipeline around it is VTK's.
template <class Filter>
class ShortFilter : public Filter
{
public:
  static ShortFilter* New()
  {
    auto* filter = new ShortFilter;
    filter->InitializeObjectBase();
    return filter;
  }
  Shortage Memory;

protected:
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override
  {
    int result = 0;
    this->Memory.HasEscaped = false;
    this->Memory.Begin();
    try
    {
      result = this->Filter::RequestData(request, input, output);
    }
    catch (...)
    {
      this->Memory.HasEscaped = true;
    }
    this->Memory.End();
    return result;
  }
  /// VTK's containers do not survive an operator new that fails in them.
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies,
    const vtkSurfaceIntegralBase::Outputs& outputs) const override
  {
    failingMemory.End();
    this->Filter::WriteOutputs(bodies, outputs);
  }
  void ShareBlocks(vtkInformation* request, vtkInformationVector* output, int port) override
  {
    failingMemory.End();
    this->Filter::ShareBlocks(request, output, port);
  }
};

inline void SetUp(vtkMassPropertiesBase*) {}

inline void SetUp(vtkSurfaceIntegralGPU* filter)
{
  filter->AddVolumeMoment("volume", 0, 0, 0);
  filter->AddAreaMoment("area", 0, 0, 0);
}

#ifdef HAS_BUOYANCY
inline void SetUp(vtkBuoyancy* filter)
{
  filter->SetNormal(0.3, -0.5, 0.8);
}
#endif
}

#endif
