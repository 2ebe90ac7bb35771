/**
 * @file smProbe.h
 * @brief Test that a driver computes what the shaders rely on; not installed
 */
#ifndef smProbe_h
#define smProbe_h

#include "smRenderingComputeModule.h"

#include <string>
#include <vector>

class vtkComputeContext;

namespace sm
{
/// What a driver makes of a construct of GLSL.
struct ProbeResult
{
  /// In the words of a sentence: "a square root".
  std::string Construct;
  /// False for constructs that no shader uses, because some driver gets them wrong.
  bool IsUsed = true;
  bool IsRight = false;
  /// True for subnormal numbers where the driver takes them for 0.
  bool IsFlushed = false;
  /// Largest relative error of 32 results; infinite if a program could not be built or run, or if a NaN was
  /// lost.
  double Error = 0.0;
};

/// Tests the constructs that shaders use, by one dispatch in the context, which must be READY. On failure
/// `complaint` continues a sentence that starts with the driver's name, and names the constructs that are
/// wrong. GLSL lets a driver take subnormal numbers for 0: then it succeeds, and `isFlushed` is true. Not
/// counted as a dispatch.
SMRENDERINGCOMPUTE_EXPORT bool ProbeConstructs(
  vtkComputeContext* context, bool& isFlushed, std::string& complaint);

/// Returns a row for each construct, used or not. The context must be READY.
SMRENDERINGCOMPUTE_EXPORT std::vector<ProbeResult> ProbeAllConstructs(vtkComputeContext* context);
}

#endif
