/**
 * @file smVariantSums.h
 * @brief Adds the flux of samples as forms in the variables
 */
#ifndef smVariantSums_h
#define smVariantSums_h

#include "smVariantChain.h"

#include <array>
#include <vector>

namespace sm
{
/// Sums of forms with compensation.
class VariantTotals
{
public:
  explicit VariantTotals(const VariantMonomials& monomials);
  void Add(int moment, std::size_t monomial, double value)
  {
    double& sum = this->Sums[moment][monomial];
    const double next = sum + value;
    // Neumaier's compensation.
    const double left = std::abs(sum) >= std::abs(value) ? (sum - next) + value : (value - next) + sum;
    this->Carries[moment][monomial] += left;
    sum = next;
  }
  double Get(int moment, std::size_t monomial) const
  {
    return this->Sums[moment][monomial] + this->Carries[moment][monomial];
  }

private:
  MomentForms<double> Sums;
  MomentForms<double> Carries;
};

/// Indices of a face's monomials among those of the body, by degree.
class VariantMap
{
public:
  VariantMap(const VariantMonomials& face, const std::vector<int>& directions, const VariantMonomials& body);
  std::size_t Get(int degree, std::size_t monomial) const { return this->Indices[degree - 3][monomial]; }

private:
  std::array<std::vector<std::size_t>, 3> Indices;
};

/// Adds samples of a face, at most 64 before the sums go to the totals, so that no sum has more roundings
/// than smVariantOrders.cxx counts.
class VariantSums
{
public:
  VariantSums(const VariantMonomials& monomials, const VariantMap& map, VariantTotals& totals);
  void Add(const VariantSample& sample);
  void Flush();

private:
  const VariantMonomials& Monomials;
  const VariantMap& Map;
  VariantTotals& Totals;
  int Count = 0;
  std::array<std::vector<double>, 3> Normal;
  std::vector<double> Cubic;
  std::array<std::vector<double>, 3> Quartic;
  std::vector<double> Volume;
  std::array<std::vector<double>, 3> First;
  /// Second moments, [variable][monomial of degree 4]: products with the last coordinate are sorted when they
  /// go to the totals.
  std::array<std::vector<double>, 6> Second;
};
}

#endif
