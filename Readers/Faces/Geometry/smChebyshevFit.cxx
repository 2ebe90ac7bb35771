#include "smChebyshevFit.h"

#include <vector>

namespace sm
{
namespace
{
struct Tables
{
  FitSamples Nodes;
  /// cos(pi i k / FitOrder)
  double Cosine[FitOrder + 1][FitOrder + 1];
  /// Bernstein[d][k][i]: coefficient i of T_k(1 - 2x) in degree d.
  std::vector<std::vector<std::vector<long double>>> Bernstein;

  Tables()
  {
    const long double pi = std::acos(-1.0L);
    for (int i = 0; i <= FitOrder; ++i)
    {
      for (int k = 0; k <= FitOrder; ++k)
      {
        this->Cosine[i][k] = static_cast<double>(std::cos(pi * ((i * k) % (2 * FitOrder)) / FitOrder));
      }
      const long double half = std::sin(pi * i / (2 * FitOrder));
      this->Nodes[i] = static_cast<double>(half * half);
    }
    this->Nodes[0] = 0.0;
    this->Nodes[FitOrder / 2] = 0.5;
    this->Nodes[FitOrder] = 1.0;
    this->Bernstein.resize(FitOrder + 1);
    for (int d = 0; d <= FitOrder; ++d)
    {
      for (int k = 0; k <= d; ++k)
      {
        this->Bernstein[d].push_back(ElevatedChebyshev(k, d));
      }
    }
  }

  static long double Binomial(int n, int k)
  {
    long double b = 1.0L;
    for (int i = 1; i <= k; ++i)
    {
      b = b * (n - k + i) / i;
    }
    return b;
  }

  /// T_k(1-2x) = sum_j (-1)^j C(2k,2j)/C(k,j) B^k_j(x), raised to degree d one step at a time.
  static std::vector<long double> ElevatedChebyshev(int k, int d)
  {
    std::vector<long double> b(k + 1);
    for (int j = 0; j <= k; ++j)
    {
      b[j] = (j % 2 ? -1.0L : 1.0L) * Binomial(2 * k, 2 * j) / Binomial(k, j);
    }
    for (int degree = k; degree < d; ++degree)
    {
      std::vector<long double> raised(degree + 2);
      for (int j = 0; j <= degree + 1; ++j)
      {
        const long double share = static_cast<long double>(j) / (degree + 1);
        raised[j] = (j > 0 ? share * b[j - 1] : 0.0L) + (j <= degree ? (1.0L - share) * b[j] : 0.0L);
      }
      b = raised;
    }
    return b;
  }
};

const Tables& GetTables()
{
  static const Tables tables;
  return tables;
}
}

const FitSamples& GetFitNodes()
{
  return GetTables().Nodes;
}

void ComputeChebyshevCoefficients(const FitSamples& samples, FitSamples& coefficients)
{
  const Tables& tables = GetTables();
  for (int k = 0; k <= FitOrder; ++k)
  {
    double sum = 0.5 * (samples[0] + (k % 2 ? -samples[FitOrder] : samples[FitOrder]));
    for (int i = 1; i < FitOrder; ++i)
    {
      sum += tables.Cosine[i][k] * samples[i];
    }
    coefficients[k] = sum * (k == 0 || k == FitOrder ? 1.0 : 2.0) / FitOrder;
  }
}

void ConvertToBernstein(const FitSamples& chebyshev, int degree, double* bernstein)
{
  const auto& table = GetTables().Bernstein[degree];
  for (int i = 0; i <= degree; ++i)
  {
    long double sum = 0.0L;
    for (int k = 0; k <= degree; ++k)
    {
      sum += table[k][i] * chebyshev[k];
    }
    bernstein[i] = static_cast<double>(sum);
  }
}
}
