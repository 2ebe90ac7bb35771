// Every rule over every monomial it claims, and over products of Legendre polynomials: these distinguish
// degree 2n - 1 from 2n at every n, where monomials look alike to rounding.
#include "smGaussLegendre.h"
#include "smTesting.h"

#include <algorithm>

namespace
{
/// P_0 to P_n on [0,1] at every node: values[k][i].
std::vector<std::vector<double>> EvaluateLegendre(int n, const std::vector<double>& nodes)
{
  std::vector<std::vector<double>> values(n + 1, std::vector<double>(nodes.size(), 1.0));
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const double x = 2.0 * nodes[i] - 1.0;
    for (int k = 1; k <= n; ++k)
    {
      const double before = k > 1 ? values[k - 2][i] : 0.0;
      values[k][i] = ((2 * k - 1) * x * values[k - 1][i] - (k - 1) * before) / k;
    }
  }
  return values;
}

/// Integrals of P_j P_k are 1 / (2j + 1) for j = k, else 0. The rule has them to j + k = 2n - 1; of P_n P_n
/// it sees nothing, for its nodes are the zeros of P_n.
void CheckLegendre(int n, const std::vector<double>& nodes, const std::vector<double>& weights)
{
  const std::vector<std::vector<double>> values = EvaluateLegendre(n, nodes);
  double worst = 0.0;
  double beyond = 0.0;
  for (int j = 0; j <= n; ++j)
  {
    for (int k = j; k <= n; ++k)
    {
      double sum = 0.0;
      for (int i = 0; i < n; ++i)
      {
        sum += weights[i] * values[j][i] * values[k][i];
      }
      if (j + k < 2 * n)
      {
        worst = std::max(worst, std::abs(sum - (j == k ? 1.0 / (2 * j + 1) : 0.0)));
      }
      else
      {
        beyond = sum;
      }
    }
  }
  const std::string name = "rule of " + std::to_string(n);
  // The recurrence rounds a few times a level, P' is at most k^2.
  smtest::Check(
    name + ", Legendre products below 2n", 0.0, worst, 2e-16 * (4 + n), "rounding of the recurrence");
  smtest::Check(name + ", P_n P_n", 0.0, beyond, 1e-15 * n * n, "a degree too many: not 1 / (2n + 1)");
}
}

int TestGaussLegendre(int, char*[])
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
    CheckLegendre(n, nodes, weights);
    smtest::CheckTrue("weights positive, nodes inside and increasing",
      *std::min_element(weights.begin(), weights.end()) > 0.0 && nodes.front() > 0.0 && nodes.back() < 1.0 &&
        std::is_sorted(nodes.begin(), nodes.end()));
  }
  return smtest::Finish();
}
