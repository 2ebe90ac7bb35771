#include "Detail/smVariantKernels.h"

#include <cstdint>

namespace sm
{
// Each is compiled for a processor of its own: registers of 2, 4 and 8 doubles.
void EvaluateForms2(
  const VariantForms& forms, const double* c, std::size_t count, double* values, double* scratch);
#ifdef SM_WIDE_LANES
void EvaluateForms4(
  const VariantForms& forms, const double* c, std::size_t count, double* values, double* scratch);
void EvaluateForms8(
  const VariantForms& forms, const double* c, std::size_t count, double* values, double* scratch);
#endif

namespace
{
constexpr std::size_t Alignment = 64;

/// Returns the first aligned number of a vector that has room for `size` of them.
double* Align(std::vector<double>& values, std::size_t size)
{
  values.resize(size + Alignment / sizeof(double));
  const auto address = reinterpret_cast<std::uintptr_t>(values.data());
  return values.data() + (Alignment - address % Alignment) % Alignment / sizeof(double);
}
}

int GetVariantLanes()
{
#ifdef SM_WIDE_LANES
  static const int lanes = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") ? 16
    : __builtin_cpu_supports("avx2")                                                               ? 8
                                                                                                   : 4;
  return lanes;
#else
  return 4;
#endif
}

void EvaluateForms(
  const VariantForms& forms, const double* c, std::size_t count, double* values, std::vector<double>& scratch)
{
  const std::size_t lanes = GetVariantLanes();
  std::size_t monomials = 0;
  for (int degree = 1; degree <= forms.MaximumDegree; ++degree)
  {
    monomials += forms.Counts[static_cast<std::size_t>(degree) * (forms.Variables + 1) + forms.Variables];
  }
  const std::size_t results = forms.TotalColumns * lanes;
  double* const aligned = Align(scratch, results + monomials * lanes);
#ifdef SM_WIDE_LANES
  const auto evaluate = lanes == 16 ? EvaluateForms8 : lanes == 8 ? EvaluateForms4 : EvaluateForms2;
#else
  const auto evaluate = EvaluateForms2;
#endif
  evaluate(forms, c, count, aligned, aligned + results);
  for (std::size_t i = 0; i < results; ++i)
  {
    values[i] = aligned[i];
  }
}
}
