#include "smSignChanges.h"

#include "smChebyshev.h"

#include <cmath>

namespace sm
{
namespace
{
constexpr int MaxHalvings = 44;

/// Evaluates a Chebyshev series by Clenshaw's algorithm.
double Sum(const std::vector<double>& series, double x)
{
  double next = 0.0;
  double afterNext = 0.0;
  for (std::size_t k = series.size(); k-- > 1;)
  {
    const double value = 2.0 * x * next - afterNext + series[k];
    afterNext = next;
    next = value;
  }
  return x * next - afterNext + series[0];
}

void Append(std::vector<SignedRange>& ranges, double start, double end, bool negative)
{
  if (!ranges.empty() && ranges.back().Negative == negative && ranges.back().End == start)
  {
    ranges.back().End = end;
  }
  else if (end > start)
  {
    ranges.push_back({ start, end, negative });
  }
}
}

void ExpandPolynomial(const std::function<double(double)>& evaluate, int degree, double start, double end,
  std::vector<double>& series)
{
  const ChebyshevRule& rule = ChebyshevRule::Get(degree + 1);
  series.assign(degree + 1, 0.0);
  for (int i = 0; i <= degree; ++i)
  {
    const double value = evaluate(start + (end - start) * 0.5 * (1.0 + rule.GetNode(i)));
    for (int k = 0; k <= degree; ++k)
    {
      series[k] += rule.GetTransform(k)[i] * value;
    }
  }
}

double GetLargest(const std::vector<double>& series)
{
  double sum = 0.0;
  for (const double coefficient : series)
  {
    sum += std::abs(coefficient);
  }
  return sum;
}

namespace
{
struct Search
{
  const std::function<double(double)>& Evaluate;
  int Degree;
  const std::function<bool(double, double, double, bool)>& IsSmall;
  std::vector<SignedRange>& Ranges;
  std::vector<double> Series{};

  void Run(double start, double end, int depth)
  {
    ExpandPolynomial(this->Evaluate, this->Degree, start, end, this->Series);
    const std::vector<double>& a = this->Series;
    const double largest = GetLargest(a);
    const double rest = largest - std::abs(a[0]);
    if (std::abs(a[0]) >= rest)
    {
      Append(this->Ranges, start, end, a[0] < 0.0);
      return;
    }
    // Bound of the other terms of the derivative, as |T_k'| <= k^2.
    double otherSlopes = 0.0;
    for (std::size_t k = 2; k < a.size(); ++k)
    {
      otherSlopes += static_cast<double>(k * k) * std::abs(a[k]);
    }
    if (a.size() > 1 && otherSlopes < std::abs(a[1]))
    {
      this->AppendMonotone(start, end);
      return;
    }
    if (this->IsSmall(start, end, largest, depth == MaxHalvings) || depth == MaxHalvings)
    {
      Append(this->Ranges, start, end, a[0] < 0.0);
      return;
    }
    const double middle = 0.5 * (start + end);
    this->Run(start, middle, depth + 1);
    this->Run(middle, end, depth + 1);
  }

  void AppendMonotone(double start, double end)
  {
    const bool rises = this->Series[1] > 0.0;
    const bool before = Sum(this->Series, -1.0) < 0.0;
    const bool after = Sum(this->Series, 1.0) < 0.0;
    if (before == after || before != rises)
    {
      Append(this->Ranges, start, end, before != after ? rises : before);
      return;
    }
    double low = -1.0;
    double high = 1.0;
    for (int step = 0; step < 60; ++step)
    {
      const double middle = 0.5 * (low + high);
      ((Sum(this->Series, middle) < 0.0) == before ? low : high) = middle;
    }
    const double root = start + (end - start) * 0.5 * (1.0 + low);
    Append(this->Ranges, start, root, before);
    Append(this->Ranges, root, end, after);
  }
};
}

void FindSignedRanges(const std::function<double(double)>& evaluate, int degree, double start, double end,
  const std::function<bool(double, double, double, bool)>& isSmall, std::vector<SignedRange>& ranges)
{
  Search{ evaluate, degree, isSmall, ranges }.Run(start, end, 0);
}
}
