#include "smSplineBasis.h"

#include <algorithm>
#include <cmath>

namespace sm
{
SplineBasis SplineBasis::MakeFromFlat(int degree, const std::vector<double>& flat)
{
  SplineBasis basis;
  basis.Degree = degree;
  for (const double knot : flat)
  {
    if (basis.Knots.empty() || knot != basis.Knots.back())
    {
      basis.Knots.push_back(knot);
      basis.Multiplicities.push_back(0);
    }
    ++basis.Multiplicities.back();
  }
  return basis;
}

std::string SplineBasis::Complete()
{
  const std::size_t size = this->Knots.size();
  if (this->Degree < 1 || this->Degree > MaximumDegree)
  {
    return "its degree is not between 1 and " + std::to_string(MaximumDegree);
  }
  if (size < 2 || this->Multiplicities.size() != size)
  {
    return "it has not as many multiplicities as knots, or fewer than two";
  }
  int sum = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const bool isBorder = i == 0 || i + 1 == size;
    const int largest = this->Periodic ? this->Degree : this->Degree + (isBorder ? 1 : 0);
    if (!std::isfinite(this->Knots[i]) || (i > 0 && !(this->Knots[i] > this->Knots[i - 1])))
    {
      return "its knots do not increase";
    }
    if (this->Multiplicities[i] < 1 || this->Multiplicities[i] > largest)
    {
      return "one of its knots has a multiplicity that its degree does not allow";
    }
    sum += this->Multiplicities[i];
  }
  if (this->Periodic)
  {
    if (this->Multiplicities.front() != this->Multiplicities.back())
    {
      return "its first and last knot have different multiplicities";
    }
    this->Count = sum - this->Multiplicities.back();
    this->StartKnot = 0;
    this->EndKnot = size - 1;
  }
  else
  {
    this->Count = sum - this->Degree - 1;
    int before = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
      before += this->Multiplicities[i];
      this->StartKnot = before <= this->Degree ? i + 1 : this->StartKnot;
      this->EndKnot = before <= this->Count ? i + 1 : this->EndKnot;
    }
    if (this->Count < this->Degree + 1 || this->EndKnot <= this->StartKnot)
    {
      return "it has fewer control points than its degree needs";
    }
  }
  this->Flat = this->Flatten(this->GetStart(), this->GetEnd());
  return {};
}

void SplineBasis::Evaluate(double t, int order, Values& values) const
{
  const FlatKnots& flat = this->Flat;
  const int p = this->Degree;
  if (this->Periodic)
  {
    const double period = this->GetEnd() - this->GetStart();
    t -= std::floor((t - this->GetStart()) / period) * period;
  }
  int span = flat.FindSpan(t);
  while (span > p && flat.Knots[span] == flat.Knots[span + 1])
  {
    --span;
  }
  // Column k of the triangle has the basis functions of degree k; the last ones are combined to derivatives.
  double triangle[MaximumDegree + 1][MaximumDegree + 1];
  triangle[0][0] = 1.0;
  for (int k = 1; k <= p; ++k)
  {
    const double* knots = flat.Knots.data() + span + 1;
    double carried = 0.0;
    for (int j = 0; j < k; ++j)
    {
      const double low = knots[j - k];
      const double x = (t - low) / (knots[j] - low);
      triangle[k][j] = carried + (1.0 - x) * triangle[k - 1][j];
      carried = x * triangle[k - 1][j];
    }
    triangle[k][k] = carried;
  }
  for (int r = 0; r <= order; ++r)
  {
    double* now = values.N[r];
    if (r > p)
    {
      std::fill_n(now, p + 1, 0.0);
      continue;
    }
    // Derivatives of the functions of degree p - r, raised r times.
    std::copy_n(triangle[p - r], p - r + 1, now);
    for (int k = p - r + 1; k <= p; ++k)
    {
      const double* knots = flat.Knots.data() + span + 1;
      double carried = 0.0;
      for (int j = 0; j < k; ++j)
      {
        const double slope = k * now[j] / (knots[j] - knots[j - k]);
        now[j] = carried - slope;
        carried = slope;
      }
      now[k] = carried;
    }
  }
  for (int j = 0; j <= p; ++j)
  {
    values.Poles[j] = flat.Poles[span - p + j];
  }
}
}
