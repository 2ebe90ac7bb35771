// Polynomials in Bernstein form: binomial coefficients, values by both ways, parts and halves, and nets with
// their derivatives, against sums in extended precision.
#include "smBernstein.h"
#include "smBernsteinNet.h"
#include "smReferenceBernstein.h"
#include "smTesting.h"

#include <cmath>
#include <random>

namespace
{
using namespace smtest;

/// Roundings of 2 x 25 steps, each a few units in the last place of the largest coefficient, which is 1.
constexpr double Limit = 1e-13;

double GetNumber(std::mt19937& random)
{
  return 2.0 * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max())) - 1.0;
}

void CheckBasis()
{
  double worst = 0.0;
  bool areSums = true;
  for (int degree = 0; degree <= sm::MaximumDegree; ++degree)
  {
    double sum = 0.0;
    for (int i = 0; i <= degree; ++i)
    {
      sum += sm::Binomials[degree][i];
    }
    areSums = areSums && sum == std::ldexp(1.0, degree);
    for (const double x : { 0.0, 0.125, 0.4, 0.97, 1.0 })
    {
      double values[2][sm::MaximumDegree + 1];
      sm::FillBernsteinBasis(degree, x, values[0]);
      sm::EvaluateBasis(x, degree, values[1]);
      for (int i = 0; i <= degree; ++i)
      {
        const auto expected = static_cast<double>(Bernstein<long double>(degree, i, x));
        worst = std::max({ worst, std::abs(values[0][i] - expected), std::abs(values[1][i] - expected) });
      }
    }
  }
  CheckTrue("the coefficients of a degree add up to a power of two", areSums);
  CheckRange("values of Bernstein polynomials", 0.0, worst, Limit, "roundings of 25 steps");
}

template <std::size_t Dimension>
long double Sum(const std::array<double, Dimension>* b, int degree, int stride, std::size_t c, long double x)
{
  long double sum = 0.0L;
  for (int i = 0; i <= degree; ++i)
  {
    sum += Bernstein<long double>(degree, i, x) * b[i * stride][c];
  }
  return sum;
}

void CheckParts()
{
  std::mt19937 random(3);
  double worst = 0.0;
  bool areHalves = true;
  for (int degree = 0; degree <= 12; ++degree)
  {
    std::array<double, 2> whole[13];
    for (auto& point : whole)
    {
      point = { GetNumber(random), GetNumber(random) };
    }
    for (const auto& [low, high] :
      { std::pair(0.0, 1.0), std::pair(0.25, 0.75), std::pair(0.0, 0.1), std::pair(0.6, 1.0) })
    {
      std::array<double, 2> part[13];
      std::copy(std::begin(whole), std::end(whole), part);
      sm::RestrictBernstein(part, degree, 1, low, high);
      for (const double x : { 0.0, 0.3, 1.0 })
      {
        const long double there = low + static_cast<long double>(high - low) * x;
        worst = std::max(
          worst, static_cast<double>(std::abs(Sum(part, degree, 1, 1, x) - Sum(whole, degree, 1, 1, there))));
      }
    }
    std::array<double, 2> left[13];
    std::array<double, 2> right[13];
    std::copy(std::begin(whole), std::end(whole), left);
    std::copy(std::begin(whole), std::end(whole), right);
    sm::HalveBernstein(left, right, degree, 1);
    areHalves =
      areHalves && left[0] == whole[0] && right[degree] == whole[degree] && left[degree] == right[0];
    worst = std::max(
      worst, static_cast<double>(std::abs(Sum(left, degree, 1, 0, 0.5L) - Sum(whole, degree, 1, 0, 0.25L))));
    worst = std::max(
      worst, static_cast<double>(std::abs(Sum(right, degree, 1, 0, 0.5L) - Sum(whole, degree, 1, 0, 0.75L))));
  }
  CheckTrue("halves end where the polynomial does, and meet", areHalves);
  CheckRange("parts and halves are the same polynomial", 0.0, worst, Limit, "roundings of 24 steps");
}

/// The value of a net's coordinate.
long double Sum(const sm::BernsteinNet& net, std::size_t c, long double s, long double r)
{
  long double sum = 0.0L;
  for (int j = 0; j <= net.Q; ++j)
  {
    sum += Bernstein(net.Q, j, r) * Sum(&net.At(0, j), net.P, 1, c, s);
  }
  return sum;
}

void CheckNets()
{
  std::mt19937 random(5);
  double worst = 0.0;
  double slopes = 0.0;
  for (const auto& [p, q] : { std::pair(1, 1), std::pair(3, 2), std::pair(0, 4), std::pair(5, 5) })
  {
    sm::BernsteinNet net;
    net.Resize(p, q);
    for (sm::Homogeneous& point : net.B)
    {
      point = { GetNumber(random), GetNumber(random), GetNumber(random), 1.5 + 0.5 * GetNumber(random) };
    }
    const sm::BernsteinNet part = sm::Restrict(net, 0.25, 0.5, 0.5, 1.0);
    worst =
      std::max(worst, static_cast<double>(std::abs(Sum(part, 2, 0.5L, 0.5L) - Sum(net, 2, 0.375L, 0.75L))));
    for (int direction = 0; direction < 2; ++direction)
    {
      sm::BernsteinNet low = net;
      sm::BernsteinNet high;
      sm::SplitInMiddle(low, direction, high);
      const long double s = direction == 0 ? 0.25L : 0.5L;
      worst =
        std::max(worst, static_cast<double>(std::abs(Sum(low, 3, 0.5L, 0.5L) - Sum(net, 3, s, 0.75L - s))));
      // The quotient of central differences has an error of h^2 times the third derivative.
      const long double h = 1e-5L;
      const long double ds = direction == 0 ? h : 0.0L;
      const long double dr = h - ds;
      const sm::BernsteinNet derived = sm::Derive(net, direction);
      const long double slope =
        (Sum(net, 0, 0.3L + ds, 0.6L + dr) - Sum(net, 0, 0.3L - ds, 0.6L - dr)) / (2.0L * h);
      slopes = std::max(slopes, static_cast<double>(std::abs(Sum(derived, 0, 0.3L, 0.6L) - slope)));
    }
    const sm::NetMiddle middle = sm::EvaluateMiddle(net);
    const long double weight = Sum(net, 3, 0.5L, 0.5L);
    worst =
      std::max(worst, static_cast<double>(std::abs(Sum(net, 1, 0.5L, 0.5L) / weight - middle.Position[1])));
  }
  CheckRange("parts, halves and middles of nets", 0.0, worst, Limit, "roundings of 20 steps");
  CheckRange("derivatives of nets", 0.0, slopes, 1e-7, "h^2 times a third derivative below 1e3");
}
}

int TestBernstein(int, char*[])
{
  CheckBasis();
  CheckParts();
  CheckNets();
  return Finish();
}
