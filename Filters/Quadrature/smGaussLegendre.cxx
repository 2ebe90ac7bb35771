#include "smGaussLegendre.h"

#include <cmath>

namespace sm
{
void ComputeGaussLegendre(int n, std::vector<double>& nodes, std::vector<double>& weights)
{
  nodes.assign(n, 0.0);
  weights.assign(n, 0.0);
  const long double pi = std::acos(-1.0L);
  // The other half are the mirror images.
  for (int i = 0; i < (n + 1) / 2; ++i)
  {
    long double x = -std::cos(pi * (i + 0.75L) / (n + 0.5L));
    long double derivative = 1.0L;
    for (int iteration = 0; iteration < 20; ++iteration)
    {
      long double before = 1.0L;
      long double p = x;
      for (int k = 2; k <= n; ++k)
      {
        const long double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      derivative = n * (before - x * p) / (1.0L - x * x);
      const long double step = p / derivative;
      x -= step;
      if (std::abs(step) < 1e-20L)
      {
        break;
      }
    }
    nodes[n - 1 - i] = static_cast<double>((1.0L - x) / 2.0L);
    nodes[i] = static_cast<double>((1.0L + x) / 2.0L);
    weights[i] = weights[n - 1 - i] = static_cast<double>(1.0L / ((1.0L - x * x) * derivative * derivative));
  }
}

const std::vector<double>& GetRuleTable()
{
  static const std::vector<double> known = []()
  {
    std::vector<double> table;
    std::vector<double> nodes;
    std::vector<double> weights;
    for (int n = 1; n <= MaximumRuleSize; ++n)
    {
      ComputeGaussLegendre(n, nodes, weights);
      for (int i = 0; i < n; ++i)
      {
        table.push_back(nodes[i]);
        table.push_back(weights[i]);
      }
    }
    return table;
  }();
  return known;
}
}
