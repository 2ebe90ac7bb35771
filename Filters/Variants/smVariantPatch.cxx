#include "Detail/smVariantPatch.h"

#include "smBernstein.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Differences of neighbours of a net in one direction, times the degree.
void TakeSteps(const double* net, const int degree[2], int direction, double* steps)
{
  const int row = degree[0] + 1;
  const int stride = direction == 0 ? 1 : row;
  for (int j = 0; j <= degree[1] - direction; ++j)
  {
    for (int i = 0; i <= degree[0] - (1 - direction); ++i)
    {
      *steps++ = degree[direction] * (net[i + row * j + stride] - net[i + row * j]);
    }
  }
}

double GetLargest(const double* values, int count)
{
  double largest = 0.0;
  for (int i = 0; i < count; ++i)
  {
    largest = std::max(largest, std::abs(values[i]));
  }
  return largest;
}

double SumProducts(const double* a, const double* b, int count)
{
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    sum += a[i] * b[i];
  }
  return sum;
}
}

void VariantPatch::AddVariable(const Patch& patch, const std::array<double, 4>* points,
  const std::array<double, 3>& center, double centerError)
{
  if (this->Centers.empty())
  {
    this->Degree[0] = patch.Degree[0];
    this->Degree[1] = patch.Degree[1];
    this->Variables = 0;
    for (int i = 0; i < this->GetNumberOfPoints(); ++i)
    {
      this->Weights.push_back(points[i][3]);
    }
  }
  ++this->Variables;
  this->Centers.push_back(center);
  this->Moved.push_back({});
  for (int c = 0; c < 3; ++c)
  {
    this->Moved.back()[c] = patch.Displacement[c] + centerError;
    for (int i = 0; i < this->GetNumberOfPoints(); ++i)
    {
      this->Points.push_back(points[i][c]);
    }
  }
}

void VariantPatch::Finish()
{
  const int count = this->GetNumberOfPoints();
  const int nets = 3 * this->Variables;
  this->StepsS.resize(static_cast<std::size_t>(nets) * this->GetNumberOfStepsS());
  this->StepsR.resize(static_cast<std::size_t>(nets) * this->GetNumberOfStepsR());
  for (int n = 0; n < nets; ++n)
  {
    const double* net = this->Points.data() + static_cast<std::ptrdiff_t>(n) * count;
    TakeSteps(
      net, this->Degree, 0, this->StepsS.data() + static_cast<std::ptrdiff_t>(n) * this->GetNumberOfStepsS());
    TakeSteps(
      net, this->Degree, 1, this->StepsR.data() + static_cast<std::ptrdiff_t>(n) * this->GetNumberOfStepsR());
  }
  this->WeightStepsS.resize(this->GetNumberOfStepsS());
  this->WeightStepsR.resize(this->GetNumberOfStepsR());
  TakeSteps(this->Weights.data(), this->Degree, 0, this->WeightStepsS.data());
  TakeSteps(this->Weights.data(), this->Degree, 1, this->WeightStepsR.data());
  this->IsPolynomial = std::all_of(
    this->Weights.begin(), this->Weights.end(), [this](double w) { return w == this->Weights.front(); });
}

void VariantPatch::FillBasis(double s, double r, PatchBasis& basis) const
{
  const int p = this->Degree[0];
  const int q = this->Degree[1];
  double of[4][MaximumDegree + 1];
  FillBernsteinBasis(p, s, of[0]);
  FillBernsteinBasis(p - 1, s, of[1]);
  FillBernsteinBasis(q, r, of[2]);
  FillBernsteinBasis(q - 1, r, of[3]);
  const auto fill = [](const double* a, int m, const double* b, int n, std::vector<double>& products)
  {
    products.resize(static_cast<std::size_t>(m) * n);
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < m; ++i)
      {
        products[static_cast<std::size_t>(j) * m + i] = a[i] * b[j];
      }
    }
  };
  fill(of[0], p + 1, of[2], q + 1, basis.Position);
  fill(of[1], p, of[2], q + 1, basis.First);
  fill(of[0], p + 1, of[3], q, basis.Second);
  const double w = SumProducts(basis.Position.data(), this->Weights.data(), this->GetNumberOfPoints());
  basis.TurnS = 0.0;
  basis.TurnR = 0.0;
  if (!this->IsPolynomial)
  {
    basis.TurnS = -SumProducts(basis.First.data(), this->WeightStepsS.data(), this->GetNumberOfStepsS()) / w;
    basis.TurnR = -SumProducts(basis.Second.data(), this->WeightStepsR.data(), this->GetNumberOfStepsR()) / w;
  }
  for (std::vector<double>* values : { &basis.Position, &basis.First, &basis.Second })
  {
    for (double& value : *values)
    {
      value /= w;
    }
  }
}

void VariantPatch::Sample(
  const PatchBasis& basis, double* position, double* first, double* second, bool isLocal) const
{
  const int count = this->GetNumberOfPoints();
  const int stepsS = this->GetNumberOfStepsS();
  const int stepsR = this->GetNumberOfStepsR();
  for (int a = 0; a < this->Variables; ++a)
  {
    for (int c = 0; c < 3; ++c)
    {
      const std::ptrdiff_t net = 3 * static_cast<std::ptrdiff_t>(a) + c;
      const int to = c * this->Variables + a;
      const double local = SumProducts(basis.Position.data(), this->Points.data() + net * count, count);
      position[to] = isLocal ? local : this->Centers[a][c] + local;
      first[to] =
        SumProducts(basis.First.data(), this->StepsS.data() + net * stepsS, stepsS) + basis.TurnS * local;
      second[to] =
        SumProducts(basis.Second.data(), this->StepsR.data() + net * stepsR, stepsR) + basis.TurnR * local;
    }
  }
}

/**
 * Inside [0,1]^2 Bernstein polynomials are positive with sum 1, outside by d their absolute values sum to
 * (1 + 2d)^degree at most. With W_low the smallest weight there,
 *
 *     |x| <= max|H| / W_low,   |x_s| <= (max|H_s| + |x| max|w_s|) / W_low,
 *
 * where H_s, w_s are the steps of the nets times the degree. Every sum has fewer than
 * n = (p + 1) (q + 1) + 4 (p + q) + 10 roundings of each term, and a quotient as many of its parts together,
 * so that 4 n unit roundoffs of these bounds bound the rounding (Higham, Accuracy and Stability of Numerical
 * Algorithms, 3.1).
 */
TangentForms<ErrorBound> BoundSamples(const VariantPatch& patch, const double outside[2], bool withCenter)
{
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  const double growth = std::pow(1.0 + 2.0 * outside[0], p) * std::pow(1.0 + 2.0 * outside[1], q);
  const double roundings = 4.0 * ((p + 1.0) * (q + 1.0) + 4.0 * (p + q) + 10.0) * UnitRoundoff;
  const auto [lightest, heaviest] = std::minmax_element(patch.Weights.begin(), patch.Weights.end());
  // sum B_i w_i with sum B_i = 1: what is negative takes (growth - 1) / 2 of the heaviest at most.
  const double low = *lightest - 0.5 * (growth - 1.0) * (*heaviest - *lightest);
  const double turn[2] = { growth * GetLargest(patch.WeightStepsS.data(), patch.GetNumberOfStepsS()),
    growth * GetLargest(patch.WeightStepsR.data(), patch.GetNumberOfStepsR()) };
  TangentForms<ErrorBound> forms(patch.Variables);
  for (int a = 0; a < patch.Variables; ++a)
  {
    for (int c = 0; c < 3; ++c)
    {
      const std::ptrdiff_t net = 3 * static_cast<std::ptrdiff_t>(a) + c;
      const auto largest = [&](const std::vector<double>& values, int count)
      { return growth * GetLargest(values.data() + net * count, count); };
      const double infinity = std::numeric_limits<double>::infinity();
      const double divisor = low > 0.0 ? low : 0.0;
      const double local =
        divisor > 0.0 ? largest(patch.Points, patch.GetNumberOfPoints()) / divisor : infinity;
      const double moved = growth * patch.Moved[a][c];
      const double center = withCenter ? std::abs(patch.Centers[a][c]) : 0.0;
      forms.Position[c][a] = { center + local, roundings * local + 2.0 * UnitRoundoff * center + moved };
      const double steps[2] = { largest(patch.StepsS, patch.GetNumberOfStepsS()),
        largest(patch.StepsR, patch.GetNumberOfStepsR()) };
      for (int d = 0; d < 2; ++d)
      {
        const double size = divisor > 0.0 ? (steps[d] + local * turn[d]) / divisor : infinity;
        // Control points of the homogeneous net move by the heaviest weight times the displacement.
        const double slope = divisor > 0.0
          ? (2.0 * patch.Degree[d] * growth * *heaviest + turn[d]) * moved * *heaviest / (divisor * divisor)
          : infinity;
        (d == 0 ? forms.First : forms.Second)[c][a] = { size, roundings * size + slope };
      }
    }
  }
  return forms;
}

VariantSeries::VariantSeries(const VariantPatch& patch)
  : Patch_(patch)
  , Count{ patch.Degree[0] + 1, patch.Degree[1] + 1 }
{
  for (int n = 0; n < 3 * patch.Variables; ++n)
  {
    this->Tables.push_back(
      this->Expand(patch.Points.data() + static_cast<std::ptrdiff_t>(n) * patch.GetNumberOfPoints()));
  }
  this->Weight = this->Expand(patch.Weights.data());
}

VariantSeries::Table VariantSeries::Expand(const double* net) const
{
  const int m = this->Count[0];
  const int n = this->Count[1];
  const std::size_t size = static_cast<std::size_t>(m) * n;
  Table table;
  std::vector<double> rows(size, 0.0);
  const ChebyshevRule& ruleS = ChebyshevRule::Get(m);
  const ChebyshevRule& ruleR = ChebyshevRule::Get(n);
  for (int j = 0; j < n; ++j)
  {
    for (int k = 0; k < m; ++k)
    {
      rows[static_cast<std::size_t>(j) * m + k] =
        SumProducts(ruleS.GetFromBernstein(k), net + static_cast<std::ptrdiff_t>(j) * m, m);
    }
  }
  table.Value.assign(size, 0.0);
  table.First.assign(size, 0.0);
  table.Second.assign(size, 0.0);
  for (int l = 0; l < n; ++l)
  {
    const double* row = ruleR.GetFromBernstein(l);
    for (int k = 0; k < m; ++k)
    {
      for (int j = 0; j < n; ++j)
      {
        table.Value[static_cast<std::size_t>(l) * m + k] +=
          row[j] * rows[static_cast<std::size_t>(j) * m + k];
      }
    }
  }
  // Derivatives by s and r, which run over [0,1] where the series have [-1,1].
  for (int l = 0; l < n; ++l)
  {
    DifferentiateChebyshev(table.Value.data() + static_cast<std::ptrdiff_t>(l) * m,
      table.First.data() + static_cast<std::ptrdiff_t>(l) * m, m, 1);
  }
  for (int k = 0; k < m; ++k)
  {
    DifferentiateChebyshev(table.Value.data() + k, table.Second.data() + k, n, m);
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    table.First[i] *= 2.0;
    table.Second[i] *= 2.0;
  }
  // |T_k| <= 1, so a coefficient is at most twice the largest value in each direction, and the transforms'
  // rows are no larger; 8 (m + n) roundings, and those of the transforms.
  table.Noise = 64.0 * (m + n) * UnitRoundoff * GetLargest(net, static_cast<int>(size));
  return table;
}

bool VariantSeries::Bound(
  const Ellipse& s, const Ellipse& r, bool withCenter, TangentForms<double>& forms) const
{
  const int m = this->Count[0];
  const int n = this->Count[1];
  std::vector<double> ofS;
  std::vector<double> ofR;
  s.GetMajorants(m, ofS);
  r.GetMajorants(n, ofR);
  double all = 0.0;
  for (const double x : ofS)
  {
    for (const double y : ofR)
    {
      all += x * y;
    }
  }
  const auto sum = [&](const std::vector<double>& values, double noise)
  {
    double total = 0.0;
    for (int l = 0; l < n; ++l)
    {
      for (int k = 0; k < m; ++k)
      {
        total += std::abs(values[static_cast<std::size_t>(l) * m + k]) * ofS[k] * ofR[l];
      }
    }
    return 1.000001 * (total + noise * all);
  };
  const Table& w = this->Weight;
  const double first = std::abs(w.Value[0]);
  const bool isRational = !this->Patch_.IsPolynomial;
  const double low = isRational ? 2.0 * first - sum(w.Value, w.Noise) : first * (1.0 - 1e-9);
  if (!(low > 0.0))
  {
    return false;
  }
  // A derivative is at most 2 k^2 times as large as its series, and so is its rounding.
  const double slopes[2] = { 2.0 * m * m, 2.0 * n * n };
  const double turn[2] = { isRational ? sum(w.First, slopes[0] * w.Noise) : 0.0,
    isRational ? sum(w.Second, slopes[1] * w.Noise) : 0.0 };
  forms = TangentForms<double>(this->Patch_.Variables);
  for (int a = 0; a < this->Patch_.Variables; ++a)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Table& table = this->Tables[3 * static_cast<std::size_t>(a) + c];
      const double local = sum(table.Value, table.Noise) / low;
      forms.Position[c][a] = local + (withCenter ? std::abs(this->Patch_.Centers[a][c]) : 0.0);
      forms.First[c][a] = (sum(table.First, slopes[0] * table.Noise) + local * turn[0]) / low;
      forms.Second[c][a] = (sum(table.Second, slopes[1] * table.Noise) + local * turn[1]) / low;
    }
  }
  return true;
}
}
