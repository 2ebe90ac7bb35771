// Code of EvaluateForms for registers of SM_VARIANT_BYTES bytes. Nothing here but plain loops may be inlined
// from elsewhere: other files are compiled for other processors.
#include "Detail/smVariantKernels.h"

namespace
{
constexpr int PackSize = SM_VARIANT_BYTES / 8;
using Pack = double __attribute__((vector_size(SM_VARIANT_BYTES)));
constexpr int Packs = 2;
constexpr int Lanes = PackSize * Packs;

/// Monomials of the degree before, times each variable: those with a last variable `a` lie one after another.
void MultiplyUp(const sm::VariantForms& forms, int degree, const Pack* variables, const Pack* from, Pack* to)
{
  const std::size_t* counts = forms.Counts + static_cast<std::size_t>(degree - 1) * (forms.Variables + 1);
  for (int a = 0; a < forms.Variables; ++a)
  {
    const std::size_t size = counts[a + 1];
    for (std::size_t m = 0; m < size; ++m)
    {
      for (int p = 0; p < Packs; ++p)
      {
        to[Packs * m + p] = from[Packs * m + p] * variables[Packs * a + p];
      }
    }
    to += Packs * size;
  }
}

void SumColumns(const sm::VariantMatrix& matrix, const Pack* monomials, Pack* values)
{
  for (std::size_t block = 0; block < matrix.Columns / 4; ++block)
  {
    const double* entries = matrix.Entries + block * 4 * matrix.Rows;
    Pack total[4 * Packs] = {};
    for (std::size_t begin = 0; begin < matrix.Rows; begin += 64)
    {
      const std::size_t end = begin + 64 < matrix.Rows ? begin + 64 : matrix.Rows;
      Pack a0 = {}, a1 = {}, b0 = {}, b1 = {}, c0 = {}, c1 = {}, d0 = {}, d1 = {};
      for (std::size_t row = begin; row < end; ++row)
      {
        const double* e = entries + 4 * row;
        const Pack x = monomials[Packs * row];
        const Pack y = monomials[Packs * row + 1];
        a0 += e[0] * x;
        a1 += e[0] * y;
        b0 += e[1] * x;
        b1 += e[1] * y;
        c0 += e[2] * x;
        c1 += e[2] * y;
        d0 += e[3] * x;
        d1 += e[3] * y;
      }
      const Pack part[4 * Packs] = { a0, a1, b0, b1, c0, c1, d0, d1 };
      for (int k = 0; k < 4 * Packs; ++k)
      {
        total[k] += part[k];
      }
    }
    for (int k = 0; k < 4 * Packs; ++k)
    {
      *values++ = total[k];
    }
  }
}

void EvaluateInLanes(
  const sm::VariantForms& forms, const double* c, std::size_t count, double* values, double* scratch)
{
  Pack* const variables = reinterpret_cast<Pack*>(scratch);
  const int others = forms.Variables - 1;
  double* const numbers = scratch;
  for (int a = 0; a < forms.Variables; ++a)
  {
    for (int lane = 0; lane < Lanes; ++lane)
    {
      numbers[a * Lanes + lane] = a == 0         ? 1.0
        : static_cast<std::size_t>(lane) < count ? c[static_cast<std::size_t>(lane) * others + (a - 1)]
                                                 : 0.0;
    }
  }
  Pack* monomials = variables;
  const Pack* before = variables;
  Pack* next = variables + static_cast<std::size_t>(Packs) * forms.Variables;
  for (int degree = 1; degree <= forms.MaximumDegree; ++degree)
  {
    if (degree > 1)
    {
      monomials = next;
      MultiplyUp(forms, degree, variables, before, monomials);
      before = monomials;
      const std::size_t rows =
        forms.Counts[static_cast<std::size_t>(degree) * (forms.Variables + 1) + forms.Variables];
      next = monomials + Packs * rows;
    }
    double* to = values;
    for (std::size_t k = 0; k < forms.MatrixCount; ++k)
    {
      if (forms.Matrices[k].Degree == degree)
      {
        SumColumns(forms.Matrices[k], monomials, reinterpret_cast<Pack*>(to));
      }
      to += forms.Matrices[k].Columns * Lanes;
    }
  }
}
}
