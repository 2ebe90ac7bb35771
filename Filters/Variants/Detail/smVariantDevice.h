/**
 * @file smVariantDevice.h
 * @brief Evaluates variants at frozen points by compute shaders
 */
#ifndef smVariantDevice_h
#define smVariantDevice_h

#include "smVariantDevicePoints.h"

#include <cstddef>
#include <memory>
#include <string>

class vtkComputeContext;

namespace sm
{
/**
 * One invocation has a variant. Only c is uploaded, nets are made on the device, and only results are read
 * back, after all dispatches of a batch. Batches fit the context's largest storage block; a dispatch has
 * some 1e10 multiply-adds on a GPU, or takes some 50 ms on a software renderer. The bits of a variant do not
 * depend on the others of the call.
 *
 * What bounds rely on: the shaders add, subtract and multiply doubles, which GLSL (4.30, 4.7.1) rounds
 * correctly, in any order, fused or not; every count of roundings holds for all of these. Quotients, roots
 * and basis values are the CPU's. GLSL leaves the rounding mode open and allows subnormal numbers to be 0:
 * the start-up probe of the context (smProbe.h) proves to the last bit that sums and products are rounded to
 * the nearest and subnormal numbers stay.
 *
 * Not thread safe.
 */
class VariantDevice
{
public:
  VariantDevice(vtkComputeContext* context, DevicePoints points, std::size_t directions);
  ~VariantDevice();

  const DevicePoints& GetPoints() const;
  vtkComputeContext* GetContext() const;

  /// True if buffers and programs are there, in the context's present generation.
  bool IsReady() const;
  /// Starts the context, uploads the samples and builds the programs.
  bool Prepare();

  /**
   * Evaluates n variants, c[n][directions]: values[n][10], and if it is not null bounds[n][10]. A variant
   * with a number that is not finite, or above MaximumNumber (smVariantNumbers.h), is evaluated for c = 0:
   * its results have no meaning.
   */
  bool Evaluate(const double* c, std::size_t n, double* values, double* bounds);

  /// Why the last call failed.
  const std::string& GetError() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
