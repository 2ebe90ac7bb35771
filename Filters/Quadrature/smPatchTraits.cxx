#include "smPatchTraits.h"

#include "smChebyshev.h"
#include "smPatchMajorants.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sm
{
namespace
{
// A row of control points this close together, relative to the patch, is taken for one point, and a length this close to a polynomial for a
// polynomial. Both differences are of the size of rounding.
constexpr double CollapsedSize = 1e-15;
constexpr double LengthTolerance = 3e-15; // times the degrees, whose rounding adds up

/// Doubles of a sample: D, m~ (3) and |m~|.
constexpr int SampleSize = 5;

/// Lebesgue's constant of n Chebyshev nodes: a polynomial of degree n - 1 is at most that many times its largest value at them.
double GetLebesgueConstant(int n)
{
  return 1.0 + 2.0 / M_PI * std::log(static_cast<double>(n));
}

/// Index of a control point of an edge: s = 0, s = 1, r = 0, r = 1.
int GetEdgePoint(int edge, int i, int p, int q)
{
  return edge < 2 ? (edge == 1 ? p : 0) + i * (p + 1) : (edge == 3 ? (p + 1) * q : 0) + i;
}

Vector3 GetPosition(const std::array<double, 4>& point)
{
  return { point[0] / point[3], point[1] / point[3], point[2] / point[3] };
}

double GetSize(const std::array<double, 4>* points, int count)
{
  double size = 0.0;
  for (int i = 0; i < count; ++i)
  {
    size = std::max(size, Norm(points[i].data()) / points[i][3]);
  }
  return size;
}

/// All control points of an edge are within `distance` of its first.
bool IsCollapsed(const std::array<double, 4>* points, int p, int q, int edge, double distance)
{
  const Vector3 first = GetPosition(points[GetEdgePoint(edge, 0, p, q)]);
  for (int i = 1; i <= (edge < 2 ? q : p); ++i)
  {
    if (!(Norm(Subtract(GetPosition(points[GetEdgePoint(edge, i, p, q)]), first)) <= distance))
    {
      return false;
    }
  }
  return true;
}

/// Returns false if |m~| is not a polynomial: its interpolation differs from it at a point between the nodes by more than `getAllowed`
/// returns for this point.
template <class GetAllowed>
bool MayBePolynomialLength(const double* samples, int countS, int countR, const GetAllowed& getAllowed)
{
  // A point that is no node of any small rule.
  const double at[2] = { 0.3141, -0.2718 };
  std::vector<double> weights[2];
  for (int d = 0; d < 2; ++d)
  {
    const int n = d == 0 ? countS : countR;
    const ChebyshevRule& rule = ChebyshevRule::Get(n);
    weights[d].assign(n, 0.0);
    double before = 1.0;
    double value = at[d];
    for (int k = 0; k < n; ++k)
    {
      for (int i = 0; i < n; ++i)
      {
        weights[d][i] += before * rule.GetTransform(k)[i];
      }
      const double next = 2.0 * at[d] * value - before;
      before = value;
      value = next;
    }
  }
  double sum[SampleSize] = {};
  for (int b = 0; b < countR; ++b)
  {
    for (int a = 0; a < countS; ++a)
    {
      for (int c = 1; c < SampleSize; ++c)
      {
        sum[c] += weights[0][a] * weights[1][b] * samples[SampleSize * (a + countS * b) + c];
      }
    }
  }
  // The factor 4 leaves room for the rounding of this interpolation.
  return std::abs(Norm(sum + 1) - sum[4]) <= 4.0 * getAllowed(at[0], at[1]);
}
}

void CollapseEdges(std::vector<std::array<double, 4>>& points, int p, int q, double size)
{
  const std::vector<std::array<double, 4>> before = points;
  const double distance = size * GetSize(points.data(), static_cast<int>(points.size()));
  for (int edge = 0; edge < 4; ++edge)
  {
    if (!IsCollapsed(before.data(), p, q, edge, distance))
    {
      continue;
    }
    const int last = edge < 2 ? q : p;
    const Vector3 first = GetPosition(points[GetEdgePoint(edge, 0, p, q)]);
    Vector3 pole = first;
    for (int i = 1; i <= last; ++i)
    {
      const Vector3 offset = Subtract(GetPosition(points[GetEdgePoint(edge, i, p, q)]), first);
      for (int c = 0; c < 3; ++c)
      {
        pole[c] += offset[c] / (last + 1);
      }
    }
    for (int i = 0; i <= last; ++i)
    {
      std::array<double, 4>& point = points[GetEdgePoint(edge, i, p, q)];
      point = { pole[0] * point[3], pole[1] * point[3], pole[2] * point[3], point[3] };
    }
  }
}

PatchTraits FindPatchTraits(const std::array<double, 4>* points, int p, int q)
{
  PatchTraits traits;
  const int count = (p + 1) * (q + 1);
  for (int i = 0; i < count; ++i)
  {
    traits.Polynomial = traits.Polynomial && points[i][3] == points[0][3];
  }
  for (int edge = 0; edge < 4; ++edge)
  {
    traits.Collapsed[edge] = IsCollapsed(points, p, q, edge, CollapsedSize * GetSize(points, count));
  }
  return traits;
}

void PatchMajorants::ExpandPatch(const std::array<double, 4>* points, int p, int q, PatchTraits& traits,
  const ParameterBox& box, const Vector3& origin)
{
  this->ExpandSamples(points, p, q, traits, box, origin);
  const int countS = 3 * p - 1;
  const int countR = 3 * q - 1;
  const double tolerance = LengthTolerance * (p + q);
  const double* longest = nullptr;
  const double largest = this->FindLongestSample(longest);
  double acrossBound = 0.0;
  const double across = this->MeasureAcross(longest, acrossBound);
  if (across <= tolerance * largest)
  {
    traits.ConstantDirection = true;
    // Across the mean direction of a box on which |m~| varies by less than 2 it is at most three times as much as across the
    // longest sample's.
    traits.SquareDeviation = 9.0 * acrossBound * acrossBound;
  }
  const bool mayBePolynomial = !traits.ConstantDirection &&
    MayBePolynomialLength(this->Samples.data(), countS, countR,
      [&](double x, double y) { return tolerance * largest * this->EvaluateCube(x, y); });
  if (mayBePolynomial)
  {
    this->Transform<Components>(countS, countR);
    traits.PolynomialLength =
      this->MeasureLengthDeviation(tolerance * largest, largest, traits.SquareDeviation);
  }
  else
  {
    this->Transform<Components - 1>(countS, countR);
  }
  this->Traits = traits;
  this->MakeTables(countS, countR);
}

double PatchMajorants::EvaluateCube(double x, double y) const
{
  // T_k(x) T_l(y) by their recurrences.
  double w = 0.0;
  double tl[2] = { 1.0, y };
  for (int l = 0; l <= this->Q; ++l)
  {
    double tk[2] = { 1.0, x };
    for (int k = 0; k <= this->P; ++k)
    {
      w += tl[0] * tk[0] * this->Series[0][4 * (k + (this->P + 1) * l) + 3];
      const double next = 2.0 * x * tk[1] - tk[0];
      tk[0] = tk[1];
      tk[1] = next;
    }
    const double next = 2.0 * y * tl[1] - tl[0];
    tl[0] = tl[1];
    tl[1] = next;
  }
  return w * w * w;
}

template <class Visit>
void PatchMajorants::VisitSamples(const Visit& visit) const
{
  const int countS = 3 * this->P - 1;
  const int countR = 3 * this->Q - 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(countS) * countR; ++i)
  {
    const double w = this->Weights[i];
    visit(this->Samples.data() + Components * i, w * w * w);
  }
}

double PatchMajorants::FindLongestSample(const double*& longest) const
{
  double largest = 0.0;
  longest = this->Samples.data();
  this->VisitSamples(
    [&](const double* sample, double cube)
    {
      if (sample[4] / cube > largest)
      {
        largest = sample[4] / cube;
        longest = sample;
      }
    });
  return largest;
}

double PatchMajorants::MeasureAcross(const double* longest, double& bound) const
{
  double across = 0.0;
  bound = 0.0;
  this->VisitSamples(
    [&](const double* sample, double cube)
    {
      const Vector3 product = Cross(sample + 1, longest + 1);
      const double length = Norm(product.data()) / longest[4];
      across = std::max(across, length / cube);
      bound = std::max(bound, length);
    });
  // The root of 3 is for the three components of a vector.
  bound *= std::sqrt(3.0) * GetLebesgueConstant(3 * this->P - 1) * GetLebesgueConstant(3 * this->Q - 1);
  return across;
}

bool PatchMajorants::MeasureLengthDeviation(double allowed, double largest, double& square) const
{
  const int countS = 3 * this->P - 1;
  const int countR = 3 * this->Q - 1;
  // h^2 - m~.m~ has the degrees 2 (countS - 1) and 2 (countR - 1): values at as many nodes and one more bound it.
  const ChebyshevRule& checkS = ChebyshevRule::Get(2 * countS - 1);
  const ChebyshevRule& checkR = ChebyshevRule::Get(2 * countR - 1);
  double largestSquare = 0.0;
  std::vector<double> line(static_cast<std::size_t>(Components) * countR);
  std::vector<double> weights(this->Q + 1);
  for (int a = 0; a < checkS.GetSize(); ++a)
  {
    std::fill(line.begin(), line.end(), 0.0);
    for (int l = 0; l < countR; ++l)
    {
      for (int k = 0; k < countS; ++k)
      {
        const double* from = this->Samples.data() + Components * (k + static_cast<std::size_t>(countS) * l);
        for (int c = 1; c < Components; ++c)
        {
          line[Components * l + c] += checkS.GetValues(a)[k] * from[c];
        }
      }
    }
    for (int l = 0; l <= this->Q; ++l)
    {
      weights[l] = 0.0;
      for (int k = 0; k <= this->P; ++k)
      {
        weights[l] += checkS.GetValues(a)[k] * this->Series[0][4 * (k + (this->P + 1) * l) + 3];
      }
    }
    for (int b = 0; b < checkR.GetSize(); ++b)
    {
      const double w = std::inner_product(weights.begin(), weights.end(), checkR.GetValues(b), 0.0);
      double value[Components] = {};
      for (int l = 0; l < countR; ++l)
      {
        for (int c = 1; c < Components; ++c)
        {
          value[c] += checkR.GetValues(b)[l] * line[Components * l + c];
        }
      }
      const double cube = w * w * w;
      const double length = Norm(value + 1);
      const double difference = std::abs(length - value[4]) / cube;
      // Where the length is small, the difference of squares is no good measure of the difference of lengths.
      if (!(difference <= allowed && length > 1e-3 * largest * cube))
      {
        return false;
      }
      largestSquare = std::max(largestSquare, difference * cube * (length + std::abs(value[4])));
    }
  }
  square = largestSquare * GetLebesgueConstant(checkS.GetSize()) * GetLebesgueConstant(checkR.GetSize());
  return true;
}
}
