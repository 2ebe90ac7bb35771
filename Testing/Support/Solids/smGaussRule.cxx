#include "smGaussRule.h"

#include <cmath>

namespace smtest
{
GaussRule MakeGaussRule(int count)
{
  GaussRule rule;
  for (int k = 0; k < count; ++k)
  {
    Real x = std::cos(Pi * (k + 0.75L) / (count + 0.5L));
    Real derivative = 0;
    for (int iteration = 0; iteration < 100; ++iteration)
    {
      Real previous = 1;
      Real value = x;
      for (int n = 2; n <= count; ++n)
      {
        const Real next = ((2 * n - 1) * x * value - (n - 1) * previous) / n;
        previous = value;
        value = next;
      }
      derivative = count * (x * value - previous) / (x * x - 1);
      const Real step = value / derivative;
      x -= step;
      if (std::fabs(step) < 1e-19L)
      {
        break;
      }
    }
    rule.Nodes.push_back((1 + x) / 2);
    rule.Weights.push_back(1 / ((1 - x * x) * derivative * derivative));
  }
  return rule;
}
}
