#define SM_LANES 8
#include "smItemLanesCode.h"

unsigned int sm::IntegrateLanes8(const ItemLanes& items)
{
  return IntegrateAnyDegree(items);
}

void sm::SumRowsLanes8(const double* rows, std::size_t count, int stride, double* sums)
{
  SumRowsInLanes(rows, count, stride, sums);
}

void sm::InterleaveLanes8(const double* const* from, std::size_t size, double* to)
{
  InterleaveInLanes(from, size, to);
}
