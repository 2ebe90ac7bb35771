#define SM_VARIANT_BYTES 64
#include "Detail/smVariantKernelsCode.h"

namespace sm
{
void EvaluateForms8(
  const VariantForms& forms, const double* c, std::size_t count, double* values, double* scratch)
{
  EvaluateInLanes(forms, c, count, values, scratch);
}
}
