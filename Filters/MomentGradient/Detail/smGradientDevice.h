/**
 * @file smGradientDevice.h
 * @brief Integrals of patches for gradients by compute shaders
 */
#ifndef smGradientDevice_h
#define smGradientDevice_h

#include "smPatchGradient.h"

#include <memory>
#include <string>
#include <vector>

class vtkComputeContext;

namespace sm
{
/**
 * What is the same on a line of points, with all basis values in r, is made on the processor. Three shaders
 * follow for all patches of a batch, whatever their degrees: nets are reduced to curves at the lines; each
 * line is integrated for each polynomial in s; lines are added for each polynomial in r. So a point is
 * evaluated once for each polynomial in s, p + 1 times. The bounds are those of the processor: curves are
 * evaluated by powers of s and products with 1 - s, with at most 3 roundings a degree and 2, and roundings
 * of a sum are counted for any order.
 *
 * Not thread safe.
 */
class GradientDevice
{
public:
  explicit GradientDevice(vtkComputeContext* context);
  ~GradientDevice();

  /**
   * Computes ComputePatchSums() of all tasks. The first patches of the degrees in the first batch on a
   * context are compared with the processor's, within both bounds. False, with a sentence in GetError(),
   * where there is no usable context, a shader fails, or a result is wrong. A patch whose integrals are not
   * finite, or which is larger than a batch, is left to the processor.
   */
  bool Compute(const std::vector<PatchTask>& tasks, std::vector<PatchSums>& sums);

  const std::string& GetError() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
