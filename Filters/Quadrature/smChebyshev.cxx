#include "smChebyshev.h"

#include "Detail/smWideEvaluation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>

namespace sm
{
ChebyshevRule::ChebyshevRule(int n)
  : Size(n)
  , Nodes(n)
  , WideNodes(n)
  , Values(n * n)
{
  // cos(m pi / 2n) for all m; the cosine of k times a rounded angle would be wrong by many u for high degrees
  // k.
  std::vector<Wide> cosines(n + 1);
  std::vector<Wide>& transform = std::get<std::vector<Wide>>(this->Transform);
  transform.resize(n * n);
  for (int m = 0; m < n; ++m)
  {
    cosines[m] = std::cos(m * 1.570796326794896619231322L / n);
  }
  const auto getCosine = [&cosines, n](int m)
  {
    m %= 4 * n;
    m = std::min(m, 4 * n - m);
    return m <= n ? cosines[m] : -cosines[2 * n - m];
  };
  for (int i = 0; i < n; ++i)
  {
    this->WideNodes[i] = getCosine(2 * i + 1);
    this->Nodes[i] = static_cast<double>(this->WideNodes[i]);
    for (int k = 0; k < n; ++k)
    {
      const Wide value = getCosine(k * (2 * i + 1));
      this->Values[i * n + k] = static_cast<double>(value);
      transform[k * n + i] = (k == 0 ? 1.0L : 2.0L) / n * value;
    }
  }
  std::get<std::vector<double>>(this->Transform).assign(transform.begin(), transform.end());
  if (n > MaximumDegree + 1)
  {
    return;
  }
  // Coefficient k of B_j is the sum of the transform times its values at the nodes.
  std::vector<Wide>& fromBernstein = std::get<std::vector<Wide>>(this->FromBernstein);
  fromBernstein.resize(n * n);
  Wide basis[MaximumDegree + 1];
  for (int i = 0; i < n; ++i)
  {
    FillWideBasis(n - 1, 0.5L + 0.5L * this->WideNodes[i], basis);
    for (int k = 0; k < n; ++k)
    {
      for (int j = 0; j < n; ++j)
      {
        fromBernstein[k * n + j] += transform[k * n + i] * basis[j];
      }
    }
  }
  std::get<std::vector<double>>(this->FromBernstein).assign(fromBernstein.begin(), fromBernstein.end());
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
