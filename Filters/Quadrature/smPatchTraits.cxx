#include "Detail/smPatchTraits.h"

#include "Detail/smWideEvaluation.h"
#include "smChebyshev.h"
#include "smPatchMajorants.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// A row of control points this close together, relative to the patch, is taken for one point, and a length
// this close to a polynomial for a polynomial. Both differences are of the size of rounding.
constexpr double CollapsedSize = 1e-15;
constexpr double LengthTolerance = 3e-15; // times the degrees, whose rounding adds up

/// Doubles of a sample: D, m~ (3) and |m~|.
constexpr int SampleSize = 5;

/// Lebesgue's constant of n Chebyshev nodes: a polynomial of degree n - 1 is at most that many times its
/// largest value at them.
double GetLebesgueConstant(int n)
{
  return 1.0 + 2.0 / M_PI * std::log(static_cast<double>(n));
}

/// Index of a control point of an edge: s = 0, s = 1, r = 0, r = 1.
int GetEdgePoint(int edge, int i, int p, int q)
{
  return edge < 2 ? (edge == 1 ? p : 0) + i * (p + 1) : (edge == 3 ? (p + 1) * q : 0) + i;
}

/// Largest control points, and largest differences of neighbours times the degree, of the homogeneous net in
/// s and in r: a bound of P, P_s and P_r, and of w, w_s and w_r.
struct NetSize
{
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Weight[3] = { 0.0, 0.0, 0.0 };

  NetSize(const std::array<double, 4>* points, int p, int q)
  {
    for (int i = 0; i < (p + 1) * (q + 1); ++i)
    {
      this->Add(0, 1.0, points[i], {});
      if (i % (p + 1) < p)
      {
        this->Add(1, p, points[i + 1], points[i]);
      }
      if (i / (p + 1) < q)
      {
        this->Add(2, q, points[i + p + 1], points[i]);
      }
    }
  }

  /// A bound of every term of m = w Ps x Pr + ws Pr x P + wr P x Ps.
  double GetNumerator() const
  {
    const double* x = this->Position;
    const double* w = this->Weight;
    return w[0] * x[1] * x[2] + w[1] * x[2] * x[0] + w[2] * x[0] * x[1];
  }

private:
  void Add(int which, double degree, const std::array<double, 4>& a, const std::array<double, 4>& b)
  {
    this->Position[which] =
      std::max(this->Position[which], degree * std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    this->Weight[which] = std::max(this->Weight[which], degree * std::abs(a[3] - b[3]));
  }
};

/**
 * Roundings of a sample of m in units of its terms. In double: a Chebyshev coefficient of P, w or their
 * derivatives has at most 4 (5 (p + q) + 14) roundings of the net, as rows of the conversion and of the
 * transform sum up to 2 each, their value 4 (p + 1) (q + 1) times that and the p + q + 4 of its evaluation,
 * and a term of m three such factors.
 */
double GetSampleRoundings(int p, int q)
{
  return 12.0 * (p + 1) * (q + 1) * (6.0 * (p + q) + 20.0);
}

/// The same from control points in extended precision: 2 n + 2 for a basis of degree n, one for each point,
/// three factors and their sums.
double GetWideRoundings(int p, int q)
{
  return 3.0 * (2.0 * (p + q) + 4.0 + (p + 1) * (q + 1)) + 16.0;
}

/// A patch at r = constant: points, steps in s from each to the next, and differences in r of its Bezier
/// curve in s, as in smPatch.glsl.
struct WideRow
{
  Wide Points[3][MaximumDegree + 1][4] = {};

  WideRow(const std::array<double, 4>* points, int p, int q, Wide r)
  {
    Wide basis[2][MaximumDegree + 1];
    FillWideBasis(q, r, basis[0]);
    FillWideBasis(q - 1, r, basis[1]);
    for (int j = 0; j <= q; ++j)
    {
      for (int i = 0; i <= p; ++i)
      {
        const std::array<double, 4>* at = points + i + j * (p + 1);
        for (int c = 0; c < 4; ++c)
        {
          this->Points[0][i][c] += basis[0][j] * at[0][c];
          this->Points[1][i][c] += i < p ? basis[0][j] * (static_cast<Wide>(at[1][c]) - at[0][c]) : 0;
          this->Points[2][i][c] += j < q ? basis[1][j] * (static_cast<Wide>(at[p + 1][c]) - at[0][c]) : 0;
        }
      }
    }
  }
};

/// m = w Ps x Pr + ws Pr x P + wr P x Ps at a point of a row, where the bases of degrees p and p - 1 have
/// these values.
void EvaluateNormal(const WideRow& row, int p, int q, const Wide* basis, const Wide* lower, Wide m[3])
{
  Wide h[3][4];
  SumBasis(basis, row.Points[0], p, h[0]);
  SumBasis(lower, row.Points[1], p - 1, h[1]);
  SumBasis(basis, row.Points[2], p, h[2]);
  const auto cross = [&h](int a, int b, int c)
  {
    const int d = (c + 1) % 3;
    const int e = (c + 2) % 3;
    return h[a][d] * h[b][e] - h[a][e] * h[b][d];
  };
  for (int c = 0; c < 3; ++c)
  {
    // P_s is p times the sum of steps, P_r q times that of differences.
    m[c] = (h[0][3] * cross(1, 2, c) + h[1][3] * cross(2, 0, c) + h[2][3] * cross(0, 1, c)) * (p * q);
  }
}

/// T_0 .. T_{n-1} at every node of a rule, one node after another.
std::vector<Wide> MakeChebyshevTable(int n, const ChebyshevRule& rule)
{
  std::vector<Wide> table(static_cast<std::size_t>(n) * rule.GetSize());
  for (int i = 0; i < rule.GetSize(); ++i)
  {
    Wide* values = table.data() + static_cast<std::size_t>(n) * i;
    const Wide x = rule.GetWideNode(i);
    for (int k = 0; k < n; ++k)
    {
      values[k] = k == 0 ? 1 : k == 1 ? x : 2 * x * values[k - 1] - values[k - 2];
    }
  }
  return table;
}

/// Sum of values[k] times the vector at series + 4 k. Local sums stay in registers.
std::array<Wide, 4> SumSeries(const Wide* values, const Wide* series, int count)
{
  Wide x = 0;
  Wide y = 0;
  Wide z = 0;
  Wide w = 0;
  for (int k = 0; k < count; ++k, series += 4)
  {
    const Wide value = values[k];
    x += value * series[0];
    y += value * series[1];
    z += value * series[2];
    w += value * series[3];
  }
  return { x, y, z, w };
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

/// Returns false if |m~| is not a polynomial: its interpolation differs from it at a point between the nodes
/// by more than `getAllowed` returns for this point.
template <class GetAllowed>
bool MayBePolynomialLength(const double* samples, int countS, int countR, const GetAllowed& getAllowed)
{
  // A point that is not a node of any small rule.
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
  const ParameterBox& box, const Vector3& origin, bool withForm)
{
  this->ExpandSamples(points, p, q, traits, box, origin);
  const int countS = 3 * p - 1;
  const int countR = 3 * q - 1;
  const double tolerance = LengthTolerance * (p + q);
  const double* longest = nullptr;
  const double largest = this->FindLongestSample(longest);
  double acrossBound = 0.0;
  const double across = this->MeasureAcross(points, longest, acrossBound);
  if (across <= tolerance * largest)
  {
    traits.ConstantDirection = true;
    // Across the mean direction of a box on which |m~| varies by less than 2 it is at most three times as
    // much as across the longest sample's.
    traits.SquareDeviation = 9.0 * acrossBound * acrossBound;
  }
  const bool mayBePolynomial = withForm && !traits.ConstantDirection &&
    MayBePolynomialLength(this->Samples.data(), countS, countR,
      [&](double x, double y) { return tolerance * largest * this->EvaluateCube(x, y); });
  if (mayBePolynomial)
  {
    this->Transform<Components>(countS, countR);
    traits.PolynomialLength =
      this->MeasureLengthDeviation(points, tolerance * largest, largest, traits.SquareDeviation);
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

double PatchMajorants::GetMinimumFactor() const
{
  double minimum = 1.0;
  for (int a = 0; a < 3 * this->P - 1; ++a)
  {
    const double s = this->Box.Middle[0] + this->Box.Half[0] * ChebyshevRule::Get(3 * this->P - 1).GetNode(a);
    for (int b = 0; b < 3 * this->Q - 1; ++b)
    {
      const double r =
        this->Box.Middle[1] + this->Box.Half[1] * ChebyshevRule::Get(3 * this->Q - 1).GetNode(b);
      minimum = std::min(minimum, this->GetFactor(s, r));
    }
  }
  return minimum;
}

double PatchMajorants::MeasureAcross(
  const std::array<double, 4>* points, const double* longest, double& bound) const
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
  // This bounds what the rounding of the samples hides; it counts squared.
  bound += GetSampleRoundings(this->P, this->Q) * UnitRoundoff *
    NetSize(points, this->P, this->Q).GetNumerator() / this->GetMinimumFactor();
  // The root of 3 is for the three components of a vector.
  bound *= std::sqrt(3.0) * GetLebesgueConstant(3 * this->P - 1) * GetLebesgueConstant(3 * this->Q - 1);
  return across;
}

std::vector<Wide> PatchMajorants::ExpandWideNormal(const std::array<double, 4>* points) const
{
  const ChebyshevRule& ruleS = ChebyshevRule::Get(3 * this->P - 1);
  const ChebyshevRule& ruleR = ChebyshevRule::Get(3 * this->Q - 1);
  const int countS = ruleS.GetSize();
  const int countR = ruleR.GetSize();
  std::vector<Wide> series(4 * static_cast<std::size_t>(countS) * countR);
  // Transforms in s of the rows so far, a vector of them for each k.
  std::vector<Wide> lines(series.size());
  std::vector<Wide> samples(4 * static_cast<std::size_t>(countS));
  std::vector<std::array<Wide, MaximumDegree + 1>> bases(2 * static_cast<std::size_t>(countS));
  for (int a = 0; a < countS; ++a)
  {
    const Wide s = this->Box.Middle[0] + this->Box.Half[0] * ruleS.GetWideNode(a);
    FillWideBasis(this->P, s, bases[2 * a].data());
    FillWideBasis(this->P - 1, s, bases[2 * a + 1].data());
  }
  for (int b = 0; b < countR; ++b)
  {
    const Wide r = this->Box.Middle[1] + this->Box.Half[1] * ruleR.GetWideNode(b);
    const WideRow row(points, this->P, this->Q, r);
    for (int a = 0; a < countS; ++a)
    {
      const Wide s = this->Box.Middle[0] + this->Box.Half[0] * ruleS.GetWideNode(a);
      Wide m[4];
      EvaluateNormal(row, this->P, this->Q, bases[2 * a].data(), bases[2 * a + 1].data(), m);
      m[3] = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
      const Wide factor = this->GetFactor(s, r);
      for (int c = 0; c < 4; ++c)
      {
        samples[4 * a + c] = m[c] / factor;
      }
    }
    for (int k = 0; k < countS; ++k)
    {
      const std::array<Wide, 4> sum = SumSeries(ruleS.GetTransform<Wide>(k), samples.data(), countS);
      std::copy(sum.begin(), sum.end(), &lines[4 * (b + static_cast<std::size_t>(countR) * k)]);
    }
  }
  for (int l = 0; l < countR; ++l)
  {
    for (int k = 0; k < countS; ++k)
    {
      const std::array<Wide, 4> sum =
        SumSeries(ruleR.GetTransform<Wide>(l), &lines[4 * static_cast<std::size_t>(countR) * k], countR);
      std::copy(sum.begin(), sum.end(), &series[4 * (k + static_cast<std::size_t>(countS) * l)]);
    }
  }
  return series;
}

bool PatchMajorants::MeasureLengthDeviation(
  const std::array<double, 4>* points, double allowed, double largest, double& square) const
{
  const int countS = 3 * this->P - 1;
  const int countR = 3 * this->Q - 1;
  // h^2 - m~.m~ has the degrees 2 (countS - 1) and 2 (countR - 1): values at as many nodes and one more bound
  // it.
  const ChebyshevRule& checkS = ChebyshevRule::Get(2 * countS - 1);
  const ChebyshevRule& checkR = ChebyshevRule::Get(2 * countR - 1);
  const std::vector<Wide> series = this->ExpandWideNormal(points);
  Wide sum = 0;
  for (const Wide coefficient : series)
  {
    sum += std::abs(coefficient);
  }
  // Samples of m~ through the interpolation, and the evaluation of series, where T_k by its recurrence has at
  // most k^2 roundings.
  const double hidden = WideRoundoff *
    (GetLebesgueConstant(countS) * GetLebesgueConstant(countR) * GetWideRoundings(this->P, this->Q) *
        NetSize(points, this->P, this->Q).GetNumerator() / this->GetMinimumFactor() +
      static_cast<double>(sum) * (countS * (countS + 5.0) + countR * (countR + 5.0)));
  const std::vector<Wide> valuesS = MakeChebyshevTable(countS, checkS);
  const std::vector<Wide> valuesR = MakeChebyshevTable(countR, checkR);
  std::vector<Wide> line(4 * static_cast<std::size_t>(countR));
  double largestSquare = 0.0;
  for (int a = 0; a < checkS.GetSize(); ++a)
  {
    for (int l = 0; l < countR; ++l)
    {
      const std::array<Wide, 4> vector = SumSeries(&valuesS[static_cast<std::size_t>(countS) * a],
        &series[4 * static_cast<std::size_t>(countS) * l], countS);
      std::copy(vector.begin(), vector.end(), &line[4 * static_cast<std::size_t>(l)]);
    }
    for (int b = 0; b < checkR.GetSize(); ++b)
    {
      const std::array<Wide, 4> value =
        SumSeries(&valuesR[static_cast<std::size_t>(countR) * b], line.data(), countR);
      const Wide length = std::sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
      const double cube = this->EvaluateCube(checkS.GetNode(a), checkR.GetNode(b));
      const double difference = static_cast<double>(std::abs(length - value[3]));
      // Where the length is small, the difference of squares is not a good measure of the difference of
      // lengths.
      if (!(difference <= allowed * cube && length > 1e-3 * largest * cube))
      {
        return false;
      }
      largestSquare = std::max(largestSquare,
        (difference + 2.0 * hidden) * (static_cast<double>(length + std::abs(value[3])) + 2.0 * hidden));
    }
  }
  square = largestSquare * GetLebesgueConstant(checkS.GetSize()) * GetLebesgueConstant(checkR.GetSize());
  return true;
}
}
