#include "smRowLayout.h"

#include <algorithm>

namespace sm
{
RowLayout::RowLayout(const std::vector<Integrand>& integrands)
  : Integrands(static_cast<int>(integrands.size()))
{
  for (int k = 0; k < this->Integrands; ++k)
  {
    auto found = std::find_if(this->Magnitudes.begin(), this->Magnitudes.end(),
      [&](int other) { return integrands[other].Magnitude == integrands[k].Magnitude; });
    if (found == this->Magnitudes.end())
    {
      found = this->Magnitudes.insert(found, k);
    }
    this->RoundingOf.push_back(static_cast<int>(found - this->Magnitudes.begin()));
  }
}
}
