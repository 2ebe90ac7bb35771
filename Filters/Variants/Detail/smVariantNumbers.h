/**
 * @file smVariantNumbers.h
 * @brief The numbers c of variants on their way to a device
 */
#ifndef smVariantNumbers_h
#define smVariantNumbers_h

#include "smFiltersVariantsModule.h"

#include "smComputeBuffer.h"

#include <cstddef>
#include <cstdint>

namespace sm
{
/// The largest |c|, whose powers are far from an overflow.
constexpr double MaximumNumber = 1e30;
/// Returns true if all numbers are finite, and at most MaximumNumber.
bool IsInRange(const double* c, std::size_t directions);

/// The number of variants above which UploadVariables() fails as without memory, for tests of what guards
/// against that; none by default. Not thread safe.
SMFILTERSVARIANTS_EXPORT std::size_t& GetFailingBatch();

/// Copies c[count][directions] to the device, [direction][variant]. Variants that are not in the range are 0.
bool UploadVariables(ComputeBuffer& to, const double* c, std::size_t count, std::size_t directions);

// Invocations of a work group, as in the shaders.
constexpr unsigned int VariantsOfGroup = 32;
// Variants of a batch on a GPU, and bytes of its largest buffer: a GPU's memory is shared with others.
constexpr std::size_t DeviceBatch = 131072;
constexpr std::size_t MaximumBufferBytes = std::size_t{ 256 } << 20;
// Multiply-adds of a dispatch on a GPU: less than 0.2 s where it makes 50 billion of doubles a second, far
// from the 2 s after which watchdogs end a program.
constexpr std::uint64_t DeviceWork = 10000000000;
// Continues the name of a driver whose rounding the bounds do not count.
constexpr const char* SubnormalsProblem = " takes numbers below 2.3e-308 for 0";
// Mesa's llvmpipe ends all loops of an invocation, without an error, after 65,535 iterations together.
constexpr std::size_t SoftwareSteps = 60000;
}

#endif
