#include "smRowSums.h"

#include "smItemKernels.h"
#include "smItemLanes.h"

namespace sm
{
void SumRows(const double* rows, std::size_t count, int stride, double* sums)
{
  static const int lanes = GetLaneCounts().back();
  switch (lanes)
  {
#ifdef SM_WIDE_LANES
    case 8:
      return SumRowsLanes8(rows, count, stride, sums);
    case 4:
      return SumRowsLanes4(rows, count, stride, sums);
#endif
    default:
      return SumRowsLanes2(rows, count, stride, sums);
  }
}
}
