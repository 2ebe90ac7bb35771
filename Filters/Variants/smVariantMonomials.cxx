#include "Detail/smVariantMonomials.h"

namespace sm
{
VariantMonomials::VariantMonomials(int variables)
  : Variables(variables)
{
  this->Counts[0].assign(variables + 1, 1);
  for (int d = 1; d <= MaximumFormDegree; ++d)
  {
    this->Counts[d].assign(variables + 1, 0);
    for (int n = 1; n <= variables; ++n)
    {
      this->Counts[d][n] = this->Counts[d][n - 1] + this->Counts[d - 1][n];
    }
  }
  for (int d = 0; d < MaximumFormDegree; ++d)
  {
    this->Products[d].resize(this->GetCount(d) * variables);
    for (std::size_t m = 0; m < this->GetCount(d); ++m)
    {
      const std::array<int, MaximumFormDegree> factors = this->GetFactors(d, m);
      for (int a = 0; a < variables; ++a)
      {
        // The variable is inserted in its place: those behind it move by one.
        std::size_t index = 0;
        int place = 1;
        bool isInserted = false;
        for (int i = 0; i <= d; ++i)
        {
          const bool isNext = !isInserted && (i == d || factors[i] > a);
          if (isNext)
          {
            index += this->Counts[place++][a];
            isInserted = true;
          }
          if (i < d)
          {
            index += this->Counts[place++][factors[i]];
          }
        }
        this->Products[d][m * variables + a] = static_cast<std::uint32_t>(index);
      }
    }
  }
}

std::array<int, MaximumFormDegree> VariantMonomials::GetFactors(int degree, std::size_t monomial) const
{
  std::array<int, MaximumFormDegree> factors{};
  for (int d = degree; d > 0; --d)
  {
    int a = this->Variables - 1;
    while (this->Counts[d][a] > monomial)
    {
      --a;
    }
    factors[d - 1] = a;
    monomial -= this->Counts[d][a];
  }
  return factors;
}
}
