#define SM_LANES 4
#include "smItemLanesCode.h"

unsigned int sm::IntegrateLanes4(const ItemLanes& items)
{
  return IntegrateAnyDegree(items);
}

void sm::SumRowsLanes4(const double* rows, std::size_t count, int stride, double* sums)
{
  SumRowsInLanes(rows, count, stride, sums);
}

void sm::InterleaveLanes4(const double* const* from, std::size_t size, double* to)
{
  InterleaveInLanes(from, size, to);
}
