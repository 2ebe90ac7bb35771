#define SM_VARIANT_BYTES 16
#include "Detail/smVariantPointsCode.h"

namespace sm
{
void AddPoints2(const PointsView& face, const double* c, std::size_t directions, std::size_t count,
  double* sums, double* carries, double* scratch)
{
  AddInLanes(face, c, directions, count, sums, carries, scratch);
}
}
