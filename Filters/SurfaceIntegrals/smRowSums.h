/**
 * @file smRowSums.h
 * @brief Sums of the columns of a table of rows, computed as by the GPU's reduction
 */
#ifndef smRowSums_h
#define smRowSums_h

#include "smFiltersSurfaceIntegralsModule.h"

#include <cstddef>

namespace sm
{
/// Computes sums[0 .. stride), the sums of all columns over `count` rows of `stride` doubles, in order. As in
/// sm::Reduction, the errors of all additions are accumulated and added at the end (Ogita, Rump, Oishi 2005,
/// algorithm 4.4). An overflow results in infinity, and a NaN is preserved. Columns are added side by side in
/// vector registers, which changes no bit.
SMFILTERSSURFACEINTEGRALS_EXPORT void SumRows(
  const double* rows, std::size_t count, int stride, double* sums);
}

#endif
