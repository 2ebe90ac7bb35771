#include "smQuadratureBound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr int NotExact = std::numeric_limits<int>::max();

double IntegerPower(double base, int exponent)
{
  double power = 1.0;
  for (; exponent > 0; exponent /= 2, base *= base)
  {
    power *= exponent % 2 ? base : 1.0;
  }
  return power;
}
}

DirectionBound::DirectionBound(std::size_t integrands)
{
  this->Reset(integrands);
}

void DirectionBound::Reset(std::size_t integrands)
{
  this->Classes = integrands;
  this->Radii.clear();
  this->Factors.clear();
  this->FactorLogarithms.clear();
  this->ExactOrders.assign(integrands, NotExact);
}

void DirectionBound::AddEllipse(double radius, const std::vector<double>& bounds)
{
  this->Radii.push_back({ radius, std::log(radius) });
  const double factor = 32.0 / 15.0 / (1.0 - 1.0 / (radius * radius));
  for (std::size_t i = 0; i < this->Classes; ++i)
  {
    this->Factors.push_back(factor * bounds[i]);
    this->FactorLogarithms.push_back(std::log(this->Factors.back()));
  }
}

void DirectionBound::SetExactOrder(std::size_t integrand, int order)
{
  this->ExactOrders[integrand] = std::min(this->ExactOrders[integrand], order);
}

void DirectionBound::SetExactOrder(int order)
{
  for (std::size_t i = 0; i < this->Classes; ++i)
  {
    this->SetExactOrder(i, order);
  }
}

double DirectionBound::GetError(std::size_t integrand, int order) const
{
  if (order >= this->ExactOrders[integrand])
  {
    return 0.0;
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->Radii.size(); ++i)
  {
    least = std::min(
      least, this->Factors[i * this->Classes + integrand] / IntegerPower(this->Radii[i].Value, 2 * order));
  }
  return least;
}

int DirectionBound::GetOrder(
  std::size_t radius, std::size_t integrand, double share, double logarithm, int largest) const
{
  const std::size_t at = radius * this->Classes + integrand;
  if (this->Factors[at] <= share)
  {
    return 1;
  }
  const double points = (this->FactorLogarithms[at] - logarithm) / (2.0 * this->Radii[radius].Logarithm);
  // Infinite or not a number: not below.
  return points < largest ? std::max(1, static_cast<int>(std::ceil(points))) : largest + 1;
}

int DirectionBound::FindOrder(std::size_t integrand, double share, int largest) const
{
  int least = std::min(this->ExactOrders[integrand], largest + 1);
  const double logarithm = std::log(share);
  for (std::size_t i = 0; i < this->Radii.size() && least > 1; ++i)
  {
    least = std::min(least, this->GetOrder(i, integrand, share, logarithm, largest));
  }
  return least;
}

int DirectionBound::FindLastOrder(std::size_t integrand, double share, int largest) const
{
  return this->GetOrder(this->Radii.size() - 1, integrand, share, std::log(share), largest);
}
}
