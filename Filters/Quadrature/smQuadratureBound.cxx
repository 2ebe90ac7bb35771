#include "smQuadratureBound.h"

#include <cmath>
#include <limits>

namespace sm
{
EllipseRadius::EllipseRadius(double radius)
  : Value(radius)
{
  this->Powers[0] = 1.0;
  for (int n = 1; n <= MaxPoints; ++n)
  {
    this->Powers[n] = this->Powers[n - 1] / (radius * radius);
  }
}

void DirectionBound::Reset(const std::vector<double>& shares, int largest)
{
  this->Shares = shares;
  this->Largest = largest;
  this->Radii.clear();
  this->Factors.clear();
  this->Orders.clear();
  for (const double share : shares)
  {
    this->Orders.push_back(share > 0.0 && std::isfinite(share) ? largest + 1 : 1);
  }
  this->ExactOrders.assign(shares.size(), std::numeric_limits<int>::max());
}

bool DirectionBound::AddEllipse(const EllipseRadius& radius, const std::vector<double>& bounds)
{
  const double constant = 32.0 / 15.0 / (1.0 - radius.GetPower(1));
  bool may = false;
  this->Radii.push_back(&radius);
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    const double factor = constant * bounds[i];
    this->Factors.push_back(factor);
    int& order = this->Orders[i];
    if (order == 1)
    {
      continue;
    }
    // Infinite and NaN bounds never meet a share.
    const bool asFew = order > this->Largest || factor * radius.GetPower(order) <= this->Shares[i];
    while (order > 1 && factor * radius.GetPower(order - 1) <= this->Shares[i])
    {
      --order;
    }
    may = may || (asFew && order > 1);
  }
  return may;
}

bool DirectionBound::IsLastBest(int points) const
{
  const std::size_t count = this->Shares.size();
  const std::size_t last = this->Radii.size() - 1;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double error = this->Factors[last * count + i] * this->Radii[last]->GetPower(points);
    bool isBest = true;
    for (std::size_t k = 0; isBest && k < last; ++k)
    {
      isBest = error < this->Factors[k * count + i] * this->Radii[k]->GetPower(points);
    }
    if (isBest)
    {
      return true;
    }
  }
  return false;
}

void DirectionBound::SetExactOrder(std::size_t integrand, int order)
{
  this->ExactOrders[integrand] = std::min(this->ExactOrders[integrand], order);
}

double DirectionBound::GetError(std::size_t integrand, int order) const
{
  if (order >= this->ExactOrders[integrand])
  {
    return 0.0;
  }
  double minimum = std::numeric_limits<double>::infinity();
  const std::size_t count = this->Shares.size();
  for (std::size_t i = 0; i < this->Radii.size(); ++i)
  {
    minimum = std::min(minimum, this->Factors[i * count + integrand] * this->Radii[i]->GetPower(order));
  }
  return minimum;
}
}
