#define SM_LANES 1
#include "smItemLanesCode.h"

unsigned int sm::IntegrateLanes1(const ItemLanes& items)
{
  return IntegrateAnyDegree(items);
}
