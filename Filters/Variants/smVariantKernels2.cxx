#define SM_VARIANT_BYTES 16
#include "Detail/smVariantKernelsCode.h"

namespace sm
{
void EvaluateForms2(
  const VariantForms& forms, const double* c, std::size_t count, double* values, double* scratch)
{
  EvaluateInLanes(forms, c, count, values, scratch);
}
}
