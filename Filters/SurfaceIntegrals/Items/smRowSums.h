/**
 * @file smRowSums.h
 * @brief Sums of the columns of a table of rows, as the GPU's reduction forms them
 */
#ifndef smRowSums_h
#define smRowSums_h

#include "smFiltersSurfaceIntegralsModule.h"
#include <cstddef>
#include <vector>

namespace sm
{
/// sums[0 .. stride): sums of all columns over `count` rows of `stride` doubles, in order, with the errors of all additions carried
/// to the end, as sm::Reduction (Ogita, Rump, Oishi 2005, algorithm 4.4). An overflow is infinite, a NaN stays. `errors` is
/// scratch space.
SMFILTERSSURFACEINTEGRALS_EXPORT void SumRows(
  const double* rows, std::size_t count, int stride, std::vector<double>& errors, double* sums);
}

#endif
