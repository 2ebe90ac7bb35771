#include "Detail/smGapSeries.h"

#include "Detail/smIntegerPower.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace sm
{
namespace
{
constexpr double GapRadii[] = { 1.6, 2.5, 4.2, 9.0, 30.0 };
// Numbers of sampling nodes: up to which a search for fewer nodes costs more than it saves; the minimum of a
// search; the maximum.
constexpr int AffordableNodes = 16;
constexpr int FewNodes = 10;
constexpr int MaxNodes = 128;
// Largest bilinear term of a parallelogram's patch, relative to the differences of its corners: rounding,
// which is computed in double.
constexpr double MaxCorner = 1e-6;
// Smallest degree from which raising the lower of two degrees saves time.
constexpr int MinRaised = 4;
// Gaps wider than this, relative to the patch, are transformed in extended precision. For narrower ones
// double suffices, because its rounding is relative to the small gap.
constexpr double WideGap = 1e-6;

template <class Real>
constexpr double GetRoundoff()
{
  return std::is_same<Real, double>::value ? UnitRoundoff : WideRoundoff;
}

/// Roundings of a sum of Bernstein polynomials at start + (end - start) t, relative to its largest
/// coefficient: 2n + 2 of the polynomials (smWideEvaluation.h), n + 1 of products and sums, 3 of the
/// coefficients, 3 of the parameter, which count 2n times, and 4 to raise the degree to n by one.
double GetCurveRoundings(int degree, int raised, double start, double end)
{
  return 3.0 * raised + (start == 0.0 && end == 1.0 ? 0.0 : 6.0) * degree + 6.0 + 4.0 * (raised - degree);
}

/// Roundings of the n coefficients of ExpandBernstein(), likewise: its scheme rounds 6 times a degree; the
/// entries of the transform, whose absolute values add up to at most 2 in a row, are within 8 n roundings;
/// products and sums round n + 1 times.
double GetSeriesRoundings(int n)
{
  return 30.0 * n * n;
}

bool ShareInterval(const Ribbon& ribbon)
{
  return ribbon.Start == ribbon.EdgeStart && ribbon.End == ribbon.EdgeEnd;
}

/// Returns true if one basis for both curves of a ribbon costs less than one for each.
bool MayRaiseDegree(const Ribbon& ribbon)
{
  return ShareInterval(ribbon) &&
    (ribbon.TrimDegree == ribbon.EdgeDegree || std::min(ribbon.TrimDegree, ribbon.EdgeDegree) >= MinRaised);
}

/// The bases of a curve piece at the nodes of a rule on a part of it.
class PieceBases
{
public:
  PieceBases(int degree, int nodes, bool isWhole)
    : Degree(degree)
    , Table(isWhole ? GetWideBases(degree, nodes) : nullptr)
  {
  }
  /// The basis at node i, which is x on the piece.
  const Wide* Get(int i, Wide x)
  {
    if (this->Table)
    {
      return this->Table + i * (this->Degree + 1);
    }
    FillWideBasis(this->Degree, x, this->Basis);
    return this->Basis;
  }

private:
  const int Degree;
  const Wide* const Table;
  Wide Basis[MaximumDegree + 1];
};

bool IsPolynomial(const std::array<double, 4>* points, int count)
{
  return std::all_of(
    points, points + count, [points](const std::array<double, 4>& p) { return p[3] == points[0][3]; });
}
}

const std::array<double, 4>* GapSeries::GetPoints(const Ribbon& ribbon) const
{
  return this->Panels.Points.data() + this->Panels.Patches[ribbon.Patch].FirstPoint;
}

template <class Real>
void GapSeries::ExpandEdge(const Ribbon& ribbon, double start, double end)
{
  const Real width = static_cast<Real>(ribbon.EdgeEnd) - ribbon.EdgeStart;
  const int n = ribbon.EdgeDegree + 1;
  const double* coefficients = this->Panels.Coefficients.data() + ribbon.Edge;
  Real edge[3 * (MaximumDegree + 1)];
  Real series[3 * (MaximumDegree + 1)];
  std::copy_n(coefficients, 3 * n, edge);
  ExpandBernstein<Real>(
    edge, 3, ribbon.EdgeDegree, ribbon.EdgeStart + width * start, ribbon.EdgeStart + width * end, series);
  this->Curve.resize(n);
  double largest = 0.0;
  for (int k = 0; k < n; ++k)
  {
    std::copy_n(series + 3 * k, 3, this->Curve[k].begin());
    largest = std::max(largest, Norm(coefficients + 3 * k));
  }
  this->CurveNoise = std::sqrt(3.0) * GetRoundoff<Real>() * GetSeriesRoundings(n) * largest;
  double center[3];
  for (int c = 0; c < 3; ++c)
  {
    center[c] = this->Curve[0][c] + this->Shift[c];
  }
  this->CurveDistance = Norm(center);
}

template <class Real>
void GapSeries::TransformSamples(
  const std::vector<std::array<Wide, 4>>& samples, double largest, double largestWeight)
{
  const int nodes = static_cast<int>(samples.size());
  const ChebyshevRule& rule = ChebyshevRule::Get(nodes);
  static thread_local std::vector<std::array<Real, 4>> values;
  values.resize(nodes);
  for (int i = 0; i < nodes; ++i)
  {
    std::copy_n(samples[i].begin(), 4, values[i].begin());
  }
  this->Gap.resize(nodes);
  SeriesNoise dropped;
  for (int k = 0; k < nodes; ++k)
  {
    const Real* row = rule.GetTransform<Real>(k);
    Real sum[4] = {};
    for (int i = 0; i < nodes; ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        sum[c] += row[i] * values[i][c];
      }
    }
    std::copy_n(sum, 4, this->Gap[k].begin());
    double& weight = this->Gap[k][3];
    if (k > 0 && std::abs(weight) <= 16.0 * UnitRoundoff * this->Gap[0][3])
    {
      dropped.Add(k, std::abs(weight));
      weight = 0.0;
    }
  }
  // Coefficients are sums of n terms; the values of a row add up to 2 at most.
  const double roundings = GetRoundoff<Real>() * 2.0 * nodes * (nodes + 6.0);
  this->Noise = std::sqrt(3.0) * roundings * largest;
  this->WeightNoise = SeriesNoise::OfPolynomial(roundings * largestWeight, nodes - 1);
  this->WeightNoise.Add(dropped);
}

bool GapSeries::ExpandOnPlane(const Ribbon& ribbon, double start, double end)
{
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const std::array<double, 4>* p = this->GetPoints(ribbon);
  if (patch.Degree[0] != 1 || patch.Degree[1] != 1 || !IsPolynomial(p, 4) || !ShareInterval(ribbon))
  {
    return false;
  }
  // P = P00 + s (P10 - P00) + r (P01 - P00) + s r d: d is the rounding of the corners.
  const double w = p[0][3];
  Wide along[2][3];
  double tangent[2][3];
  double d[3];
  for (int c = 0; c < 3; ++c)
  {
    along[0][c] = static_cast<Wide>(p[1][c]) - p[0][c];
    along[1][c] = static_cast<Wide>(p[2][c]) - p[0][c];
    d[c] = static_cast<double>(static_cast<Wide>(p[3][c]) - p[1][c] - along[1][c]);
    tangent[0][c] = static_cast<double>(along[0][c]) / w;
    tangent[1][c] = static_cast<double>(along[1][c]) / w;
  }
  const double corner = Norm(d);
  if (!(corner <= MaxCorner * w * std::min(Norm(tangent[0]), Norm(tangent[1]))))
  {
    return false;
  }
  const WideCurves curves(this->Panels, ribbon, true);
  const int degree = curves.TrimDegree;
  const Wide(&local)[MaximumDegree + 1][2] = curves.Trim;
  double size = 0.0;
  double largest = 0.0;
  double farthest = 1.0;
  double gap[MaximumDegree + 1][3];
  for (int c = 0; c < 3; ++c)
  {
    for (int i = 0; i <= degree; ++i)
    {
      const Wide curve = curves.Edge[i][c] * w;
      const Wide moved[2] = { local[i][0] * along[0][c], local[i][1] * along[1][c] };
      gap[i][c] = static_cast<double>(curve - (p[0][c] + moved[0] + moved[1]));
      size = std::max({ size, static_cast<double>(std::abs(curve)), static_cast<double>(std::abs(moved[0])),
        static_cast<double>(std::abs(moved[1])), std::abs(p[0][c]) });
      largest = std::max(largest, std::abs(gap[i][c]));
      farthest = std::max(farthest, static_cast<double>(std::abs(local[i][0]) + std::abs(local[i][1])));
    }
  }
  if (largest > WideGap * patch.Radius * w)
  {
    return false;
  }
  double series[MaximumDegree + 1][3];
  const double width = ribbon.End - ribbon.Start;
  ExpandBernstein<double>(
    &gap[0][0], 3, degree, ribbon.Start + width * start, ribbon.Start + width * end, &series[0][0]);

  const int trim = corner > 0.0 ? this->Trim.GetDegree() : 0;
  const int count = std::max(degree, 2 * trim) + 1;
  this->Gap.assign(count, {});
  for (int k = 0; k <= degree; ++k)
  {
    std::copy_n(series[k], 3, this->Gap[k].begin());
  }
  this->Gap[0][3] = w;
  // The product of two series: T_k T_l = (T_(k+l) + T_|k-l|) / 2.
  const std::vector<double>& s = this->Trim.GetSeries(0);
  const std::vector<double>& r = this->Trim.GetSeries(1);
  for (int k = 0; corner > 0.0 && k <= trim; ++k)
  {
    for (int l = 0; l <= trim; ++l)
    {
      for (const int to : { k + l, std::abs(k - l) })
      {
        for (int c = 0; c < 3; ++c)
        {
          this->Gap[to][c] -= 0.5 * s[k] * r[l] * d[c];
        }
      }
    }
  }
  this->Rough = false;
  this->Tail = 0.0;
  this->WeightNoise = {};
  // Roundings of every coordinate: 20 of the terms and their sum, 4 in each of three terms to raise the
  // degree by one. The series of the gap and of the trim are doubles: the gap is small, and the trim enters
  // only through d.
  const int raised = std::abs(ribbon.TrimDegree - ribbon.EdgeDegree);
  this->Noise = std::sqrt(3.0) *
    (WideRoundoff * (20.0 + 12.0 * raised) * size +
      UnitRoundoff *
        (GetSeriesRoundings(degree + 1) * largest +
          2.0 * GetSeriesRoundings(trim + 1) * farthest * farthest * corner));

  for (int k = 0; k < 2; ++k)
  {
    this->Stretch[k] = Norm(tangent[k]) + farthest * corner / w;
    this->TrimSlope[k] = this->Trim.GetMaxSlope(Ellipse::FromRadius(1.0), k);
  }
  this->NormalLength = Norm(Cross(tangent[0], tangent[1]).data()) +
    farthest * corner / w * (this->Stretch[0] + this->Stretch[1]);
  return true;
}

int GapSeries::ChooseNodes(const Ribbon& ribbon)
{
  // U has the degree of P(c(t)) plus that of C, where w is not constant.
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const std::array<double, 4>* points = this->GetPoints(ribbon);
  const bool polynomial = IsPolynomial(points, (patch.Degree[0] + 1) * (patch.Degree[1] + 1));
  const int inS = this->Trim.GetLow(0) == this->Trim.GetHigh(0) ? 0 : patch.Degree[0];
  const int inR = this->Trim.GetLow(1) == this->Trim.GetHigh(1) ? 0 : patch.Degree[1];
  const int ofPoint = (inS + inR) * this->Trim.GetDegree();
  const int exact =
    (polynomial ? std::max<int>(ofPoint, ribbon.EdgeDegree) : ofPoint + ribbon.EdgeDegree) + 1;
  this->GapDegree = exact - 1;
  double& tail = this->Tail;
  tail = 0.0;
  this->Rough = false;
  if (exact <= AffordableNodes)
  {
    return exact;
  }
  // Interpolation in n nodes errs by at most 4 M rho^(1-n) / (rho - 1) for a function with modulus below M in
  // the ellipse.
  PatchTraits traits;
  traits.Polynomial = false;
  const ParameterBox box = this->Trim.GetBox(1.0, 1.0);
  this->Crude.ExpandWithoutNormal(points, patch.Degree[0], patch.Degree[1], traits, box);
  double size;
  double realWeight;
  const Ellipse real = Ellipse::FromRadius(1.0);
  this->Crude.EvaluatePosition(real, real, size, realWeight);
  const double wanted = 0.01 * UnitRoundoff * (this->CurveDistance * realWeight + size);
  int nodes = std::min(exact, MaxNodes);
  tail = exact <= MaxNodes ? 0.0 : std::numeric_limits<double>::infinity();
  for (const double radius : GapRadii)
  {
    const Ellipse t = Ellipse::FromRadius(radius);
    double position;
    double weight;
    this->Crude.EvaluatePosition(
      this->Trim.Map(t, 0, box, 1.0, 1.0), this->Trim.Map(t, 1, box, 1.0, 1.0), position, weight);
    t.GetMajorants(static_cast<int>(this->Curve.size()), this->Powers);
    const double offset[3] = { this->Curve[0][0] - patch.Center[0], this->Curve[0][1] - patch.Center[1],
      this->Curve[0][2] - patch.Center[2] };
    double curve = Norm(offset);
    for (std::size_t k = 1; k < this->Curve.size(); ++k)
    {
      curve += Norm(this->Curve[k].data()) * this->Powers[k];
    }
    const double largest = curve * weight + position;
    const double factor = 4.0 * radius * largest / (radius - 1.0);
    const double count = std::ceil(std::log(std::max(factor / wanted, 1.0)) / std::log(radius)) + 1.0;
    const double mostly = factor * std::pow(radius, -MaxNodes);
    if (count < nodes)
    {
      nodes = std::max(FewNodes, static_cast<int>(count));
      tail = wanted;
    }
    else if (nodes == MaxNodes && mostly < tail)
    {
      tail = mostly;
    }
  }
  this->Rough = !(tail <= 100.0 * wanted);
  return nodes;
}

void GapSeries::Sample(const Ribbon& ribbon, double start, double end, int nodes)
{
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const ChebyshevRule& rule = ChebyshevRule::Get(nodes);
  const bool together = MayRaiseDegree(ribbon);
  const WideCurves curves(this->Panels, ribbon, together);
  const WidePatch net(this->GetPoints(ribbon), patch.Degree[0], patch.Degree[1],
    curves.Constant[0] ? &curves.Trim[0][0] : nullptr, curves.Constant[1] ? &curves.Trim[0][1] : nullptr);
  static thread_local std::vector<std::array<Wide, 4>> samples;
  samples.resize(nodes);
  const bool onPatch = this->BoundTangents(patch);
  double largest = 0.0;
  double weight = 0.0;
  const Wide width = static_cast<Wide>(ribbon.End) - ribbon.Start;
  const Wide edgeWidth = static_cast<Wide>(ribbon.EdgeEnd) - ribbon.EdgeStart;
  const bool isWhole = start == 0.0 && end == 1.0;
  PieceBases trimBases(curves.TrimDegree, nodes, isWhole && ribbon.Start == 0.0 && ribbon.End == 1.0);
  PieceBases edgeBases(curves.EdgeDegree, nodes, isWhole && ribbon.EdgeStart == 0.0 && ribbon.EdgeEnd == 1.0);
  for (int i = 0; i < nodes; ++i)
  {
    const Wide t = start + (static_cast<Wide>(end) - start) * 0.5L * (1.0L + rule.GetWideNode(i));
    const Wide* basis = trimBases.Get(i, ribbon.Start + width * t);
    Wide at[2];
    SumBasis<2>(basis, curves.Trim, curves.TrimDegree, at);
    Wide h[4];
    net.Evaluate(at[0], at[1], h);
    Wide edge[3];
    SumBasis<3>(together ? basis : edgeBases.Get(i, ribbon.EdgeStart + edgeWidth * t), curves.Edge,
      curves.EdgeDegree, edge);
    for (int c = 0; c < 3; ++c)
    {
      samples[i][c] = edge[c] * h[3] - h[c];
      largest = std::max(largest, static_cast<double>(std::abs(samples[i][c])));
    }
    samples[i][3] = h[3];
    weight = std::max(weight, static_cast<double>(h[3]));
    if (!onPatch)
    {
      this->SampleTangents(ribbon, { static_cast<double>(at[0]), static_cast<double>(at[1]) });
    }
  }
  if (largest > WideGap * weight * patch.Radius)
  {
    this->TransformSamples<Wide>(samples, largest, weight);
    this->ExpandEdge<Wide>(ribbon, start, end);
  }
  else
  {
    this->TransformSamples<double>(samples, largest, weight);
  }
  // The series interpolates rounded samples; between the nodes their rounding is multiplied by at most
  // Lebesgue's constant.
  this->Noise += this->GetSampleNoise(ribbon, weight) * (1.0 + std::log(static_cast<double>(nodes)));
}

double GapSeries::GetSampleNoise(const Ribbon& ribbon, double weight) const
{
  // P is a sum of the control points times 2p + 2 and 2q + 2 roundings of the polynomials, and p + q + 2 of
  // sums and products; their absolute values add up to the radius times the weight. An error d of the trim
  // point in s changes U by w |Ss| d, up to a rounding of the gap. C's coefficients and those of the trim
  // piece count over the whole piece, which may be longer than the ribbon, and leave the patch.
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const std::array<double, 4>* points = this->GetPoints(ribbon);
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  double growth = 1.0;
  double local[2] = { 0.0, 0.0 };
  const double* trim = this->Panels.Coefficients.data() + ribbon.Trim;
  for (int d = 0; d < 2; ++d)
  {
    const double beyond = std::max({ 0.0, -this->Trim.GetLow(d), this->Trim.GetHigh(d) - 1.0 });
    growth *= IntegerPower(1.0 + 2.0 * beyond, patch.Degree[d]);
    for (int i = 0; i <= ribbon.TrimDegree; ++i)
    {
      local[d] = std::max(local[d], std::abs((trim[2 * i + d] - patch.Start[d]) / patch.Width[d]));
    }
  }
  for (int i = 0; growth > 1.0 && i < (p + 1) * (q + 1); ++i)
  {
    // Beyond the patch the Bernstein polynomials have both signs.
    weight = std::max(weight, growth * points[i][3]);
  }
  double edge = 0.0;
  const double* coefficients = this->Panels.Coefficients.data() + ribbon.Edge;
  for (int i = 0; i <= ribbon.EdgeDegree; ++i)
  {
    const double offset[3] = { coefficients[3 * i] - patch.Center[0],
      coefficients[3 * i + 1] - patch.Center[1], coefficients[3 * i + 2] - patch.Center[2] };
    edge = std::max(edge, Norm(offset));
  }
  const bool together = MayRaiseDegree(ribbon);
  const int raised = std::max(ribbon.TrimDegree, ribbon.EdgeDegree);
  const int trimRaised = together ? raised : ribbon.TrimDegree;
  const int edgeRaised = together ? raised : ribbon.EdgeDegree;
  return WideRoundoff * weight *
    (3.0 * (p + q + 3) * (patch.Radius + edge) +
      GetCurveRoundings(ribbon.EdgeDegree, edgeRaised, ribbon.EdgeStart, ribbon.EdgeEnd) * edge +
      GetCurveRoundings(ribbon.TrimDegree, trimRaised, ribbon.Start, ribbon.End) *
        (local[0] * this->Stretch[0] + local[1] * this->Stretch[1]));
}

void GapSeries::Expand(const Ribbon& ribbon, double start, double end)
{
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const double width = ribbon.End - ribbon.Start;
  this->Trim.Expand(this->Panels.Coefficients.data() + ribbon.Trim, ribbon.TrimDegree, patch,
    ribbon.Start + width * start, ribbon.Start + width * end);
  this->ExpandEdge<double>(ribbon, start, end);
  if (!this->ExpandOnPlane(ribbon, start, end))
  {
    const int nodes = this->ChooseNodes(ribbon);
    this->Sample(ribbon, start, end, nodes);
  }
  this->Summarize();
}
}
