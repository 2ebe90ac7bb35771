// Every rule over every monomial it claims, and the first one it does not.
#include "smGaussLegendre.h"
#include "smTesting.h"

#include <algorithm>

int main()
{
  std::vector<double> nodes;
  std::vector<double> weights;
  for (int n = 1; n <= sm::MaximumRuleSize; ++n)
  {
    sm::ComputeGaussLegendre(n, nodes, weights);
    double worst = 0.0;
    for (int degree = 0; degree <= 2 * n; ++degree)
    {
      double sum = 0.0;
      for (int i = 0; i < n; ++i)
      {
        sum += weights[i] * std::pow(nodes[i], degree);
      }
      const double error = std::abs(sum - 1.0 / (degree + 1));
      if (degree < 2 * n)
      {
        worst = std::max(worst, error);
      }
      else if (n <= 10)
      {
        // The error term on [0,1] is (n!)^4 / ((2n+1) ((2n)!)^2) for x^(2n), whose 2n-th derivative is (2n)!.
        long double expected = 1.0L / (2 * n + 1);
        for (int k = 1; k <= n; ++k)
        {
          expected *= static_cast<long double>(k) * k / (static_cast<long double>(n + k) * (n + k));
        }
        smtest::Check("rule of " + std::to_string(n) + ", degree 2n", static_cast<double>(expected), error,
          4e-16, "rounding of a sum of n terms below 1");
      }
    }
    smtest::Check("rule of " + std::to_string(n) + ", degrees below 2n", 0.0, worst, 5e-16,
      "rounding of a sum of n terms below 1");
    smtest::CheckTrue("weights positive, nodes inside and increasing",
      *std::min_element(weights.begin(), weights.end()) > 0.0 && nodes.front() > 0.0 && nodes.back() < 1.0 &&
        std::is_sorted(nodes.begin(), nodes.end()));
  }
  return smtest::Finish();
}
