#include "smPatchMajorants.h"

#include "Detail/smIntegerPower.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Scratch of the calling thread: several may evaluate the series of a patch at once.
struct MajorantScratch
{
  std::vector<double> S;
  std::vector<double> R;

  static MajorantScratch& Get()
  {
    static thread_local MajorantScratch scratch;
    return scratch;
  }
};
}

void PatchMajorants::Table::Resize(int countS, int countR)
{
  this->CountS = countS;
  this->CountR = countR;
  this->Entries.assign(static_cast<std::size_t>(countS) * countR, 0.0);
}

double PatchMajorants::Table::Sum(const std::vector<double>& s, const std::vector<double>& r) const
{
  double sum = 0.0;
  const double* entry = this->Entries.data();
  for (int l = 0; l < this->CountR; ++l)
  {
    double line = 0.0;
    for (int k = 0; k < this->CountS; ++k)
    {
      line += s[k] * *entry++;
    }
    sum += r[l] * line;
  }
  return sum;
}

PatchMajorants::ProductEntry PatchMajorants::SumProducts(
  const std::vector<double>& s, const std::vector<double>& r) const
{
  ProductEntry sum{};
  const ProductEntry* entry = this->Products.data();
  for (int l = 0; l < this->CountR; ++l)
  {
    ProductEntry line{};
    for (int k = 0; k < this->CountS; ++k, ++entry)
    {
      for (int c = 0; c < 4; ++c)
      {
        line[c] += s[k] * (*entry)[c];
      }
    }
    for (int c = 0; c < 4; ++c)
    {
      sum[c] += r[l] * line[c];
    }
  }
  return sum;
}

double PatchMajorants::GetFactorMajorant(const Ellipse& s, const Ellipse& r) const
{
  double factor = 1.0;
  const double axes[2] = { s.GetHalfAxis(), r.GetHalfAxis() };
  for (int edge = 0; edge < 4; ++edge)
  {
    if (this->Traits.Collapsed[edge])
    {
      const int d = edge / 2;
      const double end = edge % 2;
      factor *= std::abs(this->Box.Middle[d] - end) + this->Box.Half[d] * axes[d];
    }
  }
  return factor;
}

double PatchMajorants::GetSpread(const Ellipse& ellipse, int d) const
{
  // A point of the ellipse around [a,b] has |z - a| + |z - b| <= (b - a) A.
  const double half = this->Box.Half[d];
  const double outside = std::abs(this->Box.Middle[d] - half) + std::abs(1.0 - this->Box.Middle[d] - half);
  return std::max(1.0, 2.0 * half * ellipse.GetHalfAxis() + outside);
}

double PatchMajorants::GetBasisMajorant(const Ellipse& s, const Ellipse& r) const
{
  // The sum of |B_i(z)| over i is (|z| + |1 - z|)^p, and no B-spline that is continued by the patch is
  // larger, being a mean of the B_i.
  return IntegerPower(this->GetSpread(s, 0), this->P) * IntegerPower(this->GetSpread(r, 1), this->Q);
}

PatchMajorants::Slopes PatchMajorants::GetSlopes(const Ellipse& s, const Ellipse& r, double weight) const
{
  // Derivatives are sums of differences: p (B_(i-1) - B_i) of degree p - 1, and p (P_(i+1) - P_i).
  const double basis = this->GetBasisMajorant(s, r);
  const double spread[2] = { this->GetSpread(s, 0), this->GetSpread(r, 1) };
  const int degree[2] = { this->P, this->Q };
  const double position = this->NetRadius * basis / weight;
  Slopes slopes;
  for (int d = 0; d < 2; ++d)
  {
    const double lower = basis / spread[d];
    const double ofWeight = this->WeightSteps[d] * lower / weight;
    slopes.OfBasis[d] = (2.0 * degree[d] * lower + ofWeight * basis) / weight;
    slopes.OfSurface[d] = this->NetSteps[d] * lower / weight + ofWeight * position;
  }
  return slopes;
}

PatchMajorants::Slopes PatchMajorants::GetSlopes() const
{
  const Ellipse real = Ellipse::FromRadius(1.0);
  const double weight = this->GetMinWeight();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return weight > 0.0 ? this->GetSlopes(real, real, weight)
                      : Slopes{ { infinite, infinite }, { infinite, infinite } };
}

double PatchMajorants::GetMinLength() const
{
  // |m~| >= m~ . e, and h >= MinimumLength.
  const double weight = this->GetMinWeight();
  const double heaviest = 2.0 * this->FirstWeight - weight;
  double minimum = this->Positive && weight > 0.0
    ? this->MinimumLength * (1.0 - this->GetDirectionDeviation()) / (heaviest * heaviest * heaviest)
    : 0.0;
  for (int edge = 0; edge < 4; ++edge)
  {
    minimum *= this->Traits.Collapsed[edge] ? std::max(0.0, this->Box.GetDistance(edge)) : 1.0;
  }
  return std::max(0.0, minimum);
}

void PatchMajorants::GetDropped(const std::vector<BoundClass>& classes, std::vector<double>& dropped) const
{
  const Ellipse real = Ellipse::FromRadius(1.0);
  const double weight = this->GetMinWeight();
  const double cube = weight * weight * weight;
  const double factor = this->GetFactorMajorant(real, real);
  const double reach = this->GetReach();
  if (!(weight > 0.0))
  {
    const bool isAny =
      std::any_of(this->Dropped.begin(), this->Dropped.end(), [](double sum) { return sum > 0.0; });
    dropped.assign(classes.size(), isAny ? std::numeric_limits<double>::infinity() : 0.0);
    return;
  }
  dropped.resize(classes.size());
  for (std::size_t i = 0; i < classes.size(); ++i)
  {
    const double power = IntegerPower(reach, classes[i].Degree);
    const double length = this->Dropped[this->IsPolynomialLength() && this->Traits.PolynomialLength ? 2 : 1];
    const double basis = classes[i].HasBasis() ? this->GetBasisMajorant(real, real) / weight : 1.0;
    dropped[i] = classes[i].Kind == BoundClass::FluxBasis ? basis * this->Dropped[0] * power / cube
      : classes[i].Kind == BoundClass::NormalBasis        ? basis * factor * this->Dropped[1] * power / cube
      : classes[i].Kind == BoundClass::VolumeMoment
      ? this->Dropped[0] * power / ((3 + classes[i].Degree) * cube)
      : classes[i].Kind == BoundClass::HeightMoment
      ? factor * this->Dropped[1] * power * reach / cube
      : factor * (classes[i].Kind == BoundClass::VectorArea ? this->Dropped[1] : length * power) / cube;
  }
}

bool PatchMajorants::IsPolynomialLength() const
{
  // h^2 = m~ . m~ says |m~| = |h|: without a change of sign it is h.
  return (this->Traits.PolynomialLength || this->Traits.ConstantDirection) && this->Positive;
}

bool PatchMajorants::HasLength() const
{
  return this->IsPolynomialLength() || this->Nonzero;
}

double PatchMajorants::GetKink(int direction) const
{
  double kink = 0.0;
  for (int side = 0; side < 2; ++side)
  {
    if (this->Traits.Collapsed[2 * direction + side])
    {
      const double middle = this->Box.Middle[direction];
      const double half = this->Box.Half[direction];
      const double outside = side == 0 ? half - middle : middle + half - 1.0;
      kink += outside > 0.0 ? 2.0 * outside / (std::abs(middle - side) + half) : 0.0;
    }
  }
  return kink;
}

bool PatchMajorants::Evaluate(const Ellipse& s, const Ellipse& r, const std::vector<BoundClass>& classes,
  std::vector<double>& bounds) const
{
  auto& [inS, inR] = MajorantScratch::Get();
  s.GetMajorants(std::max(this->P + 1, 3 * this->P - 1), inS);
  r.GetMajorants(std::max(this->Q + 1, 3 * this->Q - 1), inR);
  const auto sum = [&inS = inS, &inR = inR](const Table& table) { return table.Sum(inS, inR); };
  // A bound so close to a pole of the integrand is useless, and above 1e-9 rounding cannot change the sign.
  const double weight = this->FirstWeight - (this->Traits.Polynomial ? 0.0 : sum(this->Weight));
  if (!(weight > 1e-9 * this->FirstWeight))
  {
    return false;
  }
  const double cube = weight * weight * weight;
  const double reach = this->CenterDistance + sum(this->Position) / weight;
  const double factor = this->GetFactorMajorant(s, r);
  const ProductEntry products = this->SumProducts(inS, inR);
  const double numerator = products[Numerator];
  const double normal = factor * products[Normal];
  const bool isReal = s.GetHalfAxis() == 1.0 && r.GetHalfAxis() == 1.0;
  double length = std::numeric_limits<double>::infinity();
  const double along = this->FirstLength + products[Along];
  // A lower bound of |m~|, or of |(m~.m~)^(1/2)|; not positive where there is none.
  double shortest = 0.0;
  if (this->IsPolynomialLength())
  {
    length = factor * along;
    shortest = this->FirstLength - products[Along];
  }
  else
  {
    // m~.m~ = (|m~_00| + a)^2 + b.b with |a| <= D1, |b.b| <= D2^2: the root is analytic where D1 + D2 <
    // |m~_00|.
    const double across = products[Across];
    if (along - this->FirstLength + across < 0.999999 * this->FirstLength)
    {
      length = factor * std::hypot(along, across);
      const double shortestAlong = this->FirstLength - products[Along];
      shortest = std::sqrt((shortestAlong - across) * (shortestAlong + across));
    }
    else if (isReal)
    {
      // For real parameters the length need not be analytic.
      length = normal;
    }
  }
  bounds.resize(classes.size());
  for (std::size_t i = 0; i < classes.size(); ++i)
  {
    const double power = IntegerPower(reach, classes[i].Degree);
    switch (classes[i].Kind)
    {
      case BoundClass::VolumeMoment:
        bounds[i] = numerator * power / ((3 + classes[i].Degree) * cube);
        break;
      case BoundClass::VectorArea:
        bounds[i] = normal / cube;
        break;
      case BoundClass::HeightMoment:
        // |z| <= |x|, |n_z| <= |n|, for complex vectors, too.
        bounds[i] = normal * power * reach / cube;
        break;
      case BoundClass::NormalBasis:
        bounds[i] = this->GetBasisMajorant(s, r) * normal * power / (cube * weight);
        break;
      case BoundClass::FluxBasis:
        bounds[i] = this->GetBasisMajorant(s, r) * numerator * power / (cube * weight);
        break;
      case BoundClass::AreaBasis:
        // |e| <= |m~| / |(m~.m~)^(1/2)|, the modulus of a product of complex vectors at most that of theirs.
        // For real parameters |e| is 1, also where it jumps.
        bounds[i] = shortest > 1e-6 * this->FirstLength || isReal
          ? (shortest > 1e-6 * this->FirstLength ? products[Normal] / shortest : 1.0) *
              this->GetSlopes(s, r, weight).GetArea() * power +
            (classes[i].Degree > 0 ? 2.0 * this->GetBasisMajorant(s, r) / weight * length / cube : 0.0)
          : std::numeric_limits<double>::infinity();
        break;
      default:
        bounds[i] = length * power / cube;
        break;
    }
  }
  return true;
}

double PatchMajorants::GetMinWeight() const
{
  double sum = 0.0;
  for (const double entry : this->Weight.Entries)
  {
    sum += entry;
  }
  return std::max(0.0, this->FirstWeight - sum);
}

bool PatchMajorants::HasEvenWeight() const
{
  return this->GetMinWeight() > 0.1 * this->FirstWeight;
}

double PatchMajorants::GetReach() const
{
  double sum = 0.0;
  for (const double entry : this->Position.Entries)
  {
    sum += entry;
  }
  const double weight = this->GetMinWeight();
  return weight > 0.0 ? this->CenterDistance + sum / weight : std::numeric_limits<double>::infinity();
}

double PatchMajorants::GetLengthDeviation() const
{
  if (!this->IsPolynomialLength() || this->Traits.SquareDeviation == 0.0)
  {
    return 0.0;
  }
  // ||m~| - h| (|m~| + h) is the deviation of the squares. With a constant direction h is m~.e, e taken on
  // the box.
  const Ellipse real = Ellipse::FromRadius(1.0);
  const double weight = this->GetMinWeight();
  return this->Traits.SquareDeviation / this->MinimumLength * this->GetFactorMajorant(real, real) /
    (weight * weight * weight);
}

double PatchMajorants::GetDirectionDeviation() const
{
  return this->IsPolynomialLength() && this->Traits.SquareDeviation > 0.0
    ? this->Traits.SquareDeviation / (this->MinimumLength * this->MinimumLength)
    : 0.0;
}

void PatchMajorants::EvaluatePosition(
  const Ellipse& s, const Ellipse& r, double& position, double& weight) const
{
  auto& [inS, inR] = MajorantScratch::Get();
  s.GetMajorants(this->P + 1, inS);
  r.GetMajorants(this->Q + 1, inR);
  weight = this->FirstWeight + this->Weight.Sum(inS, inR);
  position = this->CenterOffset * weight + this->Position.Sum(inS, inR);
}

int PatchMajorants::GetVaryingDirection() const
{
  double inS = 0.0;
  double inR = 0.0;
  const auto add = [&](int countS, int countR, double scale, const auto& get)
  {
    for (int l = 0; l < countR; ++l)
    {
      for (int k = l == 0 ? 1 : 0; k < countS; ++k)
      {
        const double entry = get(k + static_cast<std::size_t>(countS) * l);
        inS += k > 0 ? entry / scale : 0.0;
        inR += l > 0 ? entry / scale : 0.0;
      }
    }
  };
  add(this->Weight.CountS, this->Weight.CountR, this->FirstWeight,
    [this](std::size_t i) { return this->Weight.Entries[i]; });
  if (this->FirstLength > 0.0)
  {
    for (const Product which : { Along, this->Traits.PolynomialLength ? Normal : Across })
    {
      add(this->CountS, this->CountR, this->FirstLength,
        [this, which](std::size_t i) { return this->Products[i][which]; });
    }
  }
  return inS >= inR ? 0 : 1;
}
}
