#define SM_LANES 8
#include "smItemLanesCode.h"

unsigned int sm::IntegrateLanes8(const ItemLanes& items)
{
  return IntegrateAnyDegree(items);
}
