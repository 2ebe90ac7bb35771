#define SM_LANES 2
#include "smItemLanesCode.h"

unsigned int sm::IntegrateLanes2(const ItemLanes& items)
{
  return IntegrateAnyDegree(items);
}
