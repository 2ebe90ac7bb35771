#include "smBernstein.h"

namespace sm
{
void FillBernsteinBasis(int degree, double x, double* basis)
{
  basis[0] = 1.0;
  for (int k = 1; k <= degree; ++k)
  {
    double carried = 0.0;
    for (int j = 0; j < k; ++j)
    {
      const double term = basis[j];
      basis[j] = carried + (1.0 - x) * term;
      carried = x * term;
    }
    basis[k] = carried;
  }
}
}
