#define SM_LANES 4
#include "smItemLanesCode.h"

unsigned int sm::IntegrateLanes4(const ItemLanes& items)
{
  return IntegrateAnyDegree(items);
}
