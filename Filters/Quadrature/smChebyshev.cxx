#include "smChebyshev.h"

#include "smWideEvaluation.h"

#include <array>
#include <cmath>
#include <memory>
#include <mutex>

namespace sm
{
ChebyshevRule::ChebyshevRule(int n)
  : Size(n)
  , Nodes(n)
  , Values(n * n)
  , Transform(n * n)
{
  const double pi = 3.14159265358979323846;
  for (int i = 0; i < n; ++i)
  {
    this->Nodes[i] = std::cos((i + 0.5) * pi / n);
    for (int k = 0; k < n; ++k)
    {
      const double value = std::cos(k * (i + 0.5) * pi / n);
      this->Values[i * n + k] = value;
      this->Transform[k * n + i] = (k == 0 ? 1.0 : 2.0) / n * value;
    }
  }
  if (n > MaximumDegree + 1)
  {
    return;
  }
  // Coefficient k of B_j is the sum of the transform times its values at the nodes.
  std::vector<Wide> sums(n * n, 0.0L);
  Wide basis[MaximumDegree + 1];
  for (int i = 0; i < n; ++i)
  {
    const Wide angle = (i + 0.5L) * 3.141592653589793238462643L / n;
    FillWideBasis(n - 1, 0.5L + 0.5L * std::cos(angle), basis);
    for (int k = 0; k < n; ++k)
    {
      for (int j = 0; j < n; ++j)
      {
        sums[k * n + j] += (k == 0 ? 1.0L : 2.0L) / n * std::cos(k * angle) * basis[j];
      }
    }
  }
  this->FromBernstein.assign(sums.begin(), sums.end());
}

const ChebyshevRule& ChebyshevRule::Get(int n)
{
  static std::array<std::unique_ptr<const ChebyshevRule>, MaximumSize + 1> rules;
  static std::array<std::once_flag, MaximumSize + 1> made;
  std::call_once(made[n], [n]() { rules[n].reset(new ChebyshevRule(n)); });
  return *rules[n];
}

void DifferentiateChebyshev(const double* series, double* derivative, int count, int stride)
{
  // d_{k-1} = d_{k+1} + 2 k c_k, and the first one halved.
  derivative[(count - 1) * stride] = 0.0;
  double after = 0.0;
  double afterNext = 0.0;
  for (int k = count - 1; k > 0; --k)
  {
    const double d = afterNext + 2.0 * k * series[k * stride];
    derivative[(k - 1) * stride] = k == 1 ? 0.5 * d : d;
    afterNext = after;
    after = d;
  }
}

void Ellipse::GetMajorants(int count, std::vector<double>& majorants) const
{
  majorants.resize(count);
  double before = 1.0;
  double value = this->A;
  for (int k = 0; k < count; ++k)
  {
    majorants[k] = before;
    const double next = 2.0 * this->A * value - before;
    before = value;
    value = next;
  }
}
}
