#define SM_LANES 2
#include "smItemLanesCode.h"

unsigned int sm::IntegrateLanes2(const ItemLanes& items)
{
  return IntegrateAnyDegree(items);
}

void sm::SumRowsLanes2(const double* rows, std::size_t count, int stride, double* sums)
{
  SumRowsInLanes(rows, count, stride, sums);
}

void sm::InterleaveLanes2(const double* const* from, std::size_t size, double* to)
{
  InterleaveInLanes(from, size, to);
}
