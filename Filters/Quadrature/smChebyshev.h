/**
 * @file smChebyshev.h
 * @brief Chebyshev series on [-1,1]: nodes, transforms, and majorants of a series on an ellipse
 */
#ifndef smChebyshev_h
#define smChebyshev_h

#include "smFiltersQuadratureModule.h"
#include <tuple>
#include <vector>

namespace sm
{
/// n Chebyshev nodes cos((i + 1/2) pi / n), the values of T_0 .. T_{n-1} there, and the transform that takes
/// samples at the nodes to the coefficients of the interpolating series: exact for polynomials of degree
/// below n.
class SMFILTERSQUADRATURE_EXPORT ChebyshevRule
{
public:
  /// Largest n.
  static constexpr int MaximumSize = 160;

  /// The rule of n nodes, 1 <= n <= MaximumSize. Thread safe.
  static const ChebyshevRule& Get(int n);

  int GetSize() const { return this->Size; }
  double GetNode(int i) const { return this->Nodes[i]; }
  long double GetWideNode(int i) const { return this->WideNodes[i]; }
  /// T_0 .. T_{n-1} at node i.
  const double* GetValues(int i) const { return this->Values.data() + i * this->Size; }
  /// Row k: coefficient k is the sum of row[i] times sample i. In doubles or in extended precision.
  template <class Real = double>
  const Real* GetTransform(int k) const
  {
    return std::get<std::vector<Real>>(this->Transform).data() + k * this->Size;
  }
  /// Row k: coefficient k is the sum of row[i] times the Bernstein coefficient i, of degree n - 1 on [0,1]. n
  /// <= 26.
  template <class Real = double>
  const Real* GetFromBernstein(int k) const
  {
    return std::get<std::vector<Real>>(this->FromBernstein).data() + k * this->Size;
  }

private:
  explicit ChebyshevRule(int n);

  int Size;
  std::vector<double> Nodes;
  std::vector<long double> WideNodes;
  std::vector<double> Values;
  std::tuple<std::vector<double>, std::vector<long double>> Transform;
  std::tuple<std::vector<double>, std::vector<long double>> FromBernstein;
};

/// The Chebyshev series on [start,end], mapped to [-1,1], of a polynomial on [0,1] in Bernstein form. Both
/// have degree + 1 coefficients of `size` numbers each. 0 <= start < end <= 1.
template <class Real>
void ExpandBernstein(const Real* coefficients, int size, int degree, Real start, Real end, Real* series)
{
  // De Casteljau's scheme restricts the polynomial to [0, end], then to [start, end].
  static thread_local std::vector<Real> part;
  const int count = size * (degree + 1);
  part.assign(coefficients, coefficients + count);
  for (int level = 1; end != Real(1) && level <= degree; ++level)
  {
    for (int e = count - 1; e >= size * level; --e)
    {
      part[e] = (Real(1) - end) * part[e - size] + end * part[e];
    }
  }
  const Real x = end != Real(0) ? start / end : Real(0);
  for (int level = degree; x != Real(0) && level > 0; --level)
  {
    for (int e = 0; e < size * level; ++e)
    {
      part[e] = (Real(1) - x) * part[e] + x * part[e + size];
    }
  }
  const ChebyshevRule& rule = ChebyshevRule::Get(degree + 1);
  for (int k = 0; k <= degree; ++k)
  {
    const Real* row = rule.GetFromBernstein<Real>(k);
    for (int d = 0; d < size; ++d)
    {
      Real sum = 0;
      for (int i = 0; i <= degree; ++i)
      {
        sum += row[i] * part[size * i + d];
      }
      series[size * k + d] = sum;
    }
  }
}

/// Coefficients of the derivative of a series of `count` coefficients that lie `stride` doubles apart; the
/// last one is 0.
SMFILTERSQUADRATURE_EXPORT void DifferentiateChebyshev(
  const double* series, double* derivative, int count, int stride);

/// An ellipse with foci -1 and 1: the points with |z - 1| + |z + 1| <= 2 A, A = (rho + 1/rho) / 2. On it
/// |T_k| <= T_k(A).
class SMFILTERSQUADRATURE_EXPORT Ellipse
{
public:
  /// From the sum of half axes, rho >= 1; or from A >= 1.
  static Ellipse FromRadius(double rho) { return Ellipse(0.5 * (rho + 1.0 / rho)); }
  static Ellipse FromHalfAxis(double a) { return Ellipse(a > 1.0 ? a : 1.0); }

  double GetHalfAxis() const { return this->A; }
  /// T_0(A) .. T_{count-1}(A).
  void GetMajorants(int count, std::vector<double>& majorants) const;

private:
  explicit Ellipse(double a)
    : A(a)
  {
  }
  double A;
};
}

#endif
