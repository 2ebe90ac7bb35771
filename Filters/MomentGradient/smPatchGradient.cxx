#include "Detail/smPatchGradient.h"

#include "smBernstein.h"
#include "smGaussLegendre.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
using Wide = long double;

/// The parameters of a patch on a piece of a trim curve, and their derivatives by the piece's parameter.
struct TrimPoint
{
  double S, R, SlopeR;
};

/// Evaluates a trim piece by de Casteljau's scheme in wider numbers: what remains of its rounding is that of
/// the result.
TrimPoint EvaluateTrim(const double* coefficients, int degree, const Patch& patch, double t)
{
  Wide points[MaximumDegree + 1][2];
  for (int i = 0; i <= degree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      points[i][d] = (static_cast<Wide>(coefficients[2 * i + d]) - patch.Start[d]) / patch.Width[d];
    }
  }
  Wide slope = 0;
  const Wide x = t;
  for (int level = degree; level > 0; --level)
  {
    slope = level == 1 ? degree * (points[1][1] - points[0][1]) : slope;
    for (int i = 0; i < level; ++i)
    {
      for (int d = 0; d < 2; ++d)
      {
        points[i][d] = (1 - x) * points[i][d] + x * points[i + 1][d];
      }
    }
  }
  return { static_cast<double>(points[0][0]), static_cast<double>(points[0][1]), static_cast<double>(slope) };
}

/// Bernstein polynomials of a degree at x, and their derivatives from those of one degree less.
struct Basis
{
  double Values[MaximumDegree + 1];
  double Slopes[MaximumDegree + 1];

  Basis(int degree, double x)
  {
    double lower[MaximumDegree + 1];
    FillBernsteinBasis(degree, x, this->Values);
    FillBernsteinBasis(degree - 1, x, lower);
    for (int i = 0; i <= degree; ++i)
    {
      this->Slopes[i] = degree * ((i > 0 ? lower[i - 1] : 0.0) - (i < degree ? lower[i] : 0.0));
    }
  }
};

/// Adds `factor` times `count` numbers.
inline void AddMultiple(double factor, const double* from, int count, double* to)
{
  for (int k = 0; k < count; ++k)
  {
    to[k] += factor * from[k];
  }
}
}

double BoundBasis(const FacePanels& panels, const Panel& panel)
{
  const Patch& patch = panels.Patches[panel.Patch];
  std::array<double, 2> points[MaximumDegree + 1];
  for (int i = 0; i <= panel.TrimDegree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      points[i][d] = (panels.Coefficients[panel.Trim + 2 * i + d] - patch.Start[d]) / patch.Width[d];
    }
  }
  if (panel.TrimDegree > 0 && panel.End > panel.Start)
  {
    RestrictBernstein<2>(points, panel.TrimDegree, 1, panel.Start, panel.End);
  }
  double growth = 1.0;
  for (int d = 0; d < 2; ++d)
  {
    double beyond = 0.0;
    for (int i = 0; i <= panel.TrimDegree; ++i)
    {
      beyond = std::max({ beyond, -points[i][d], points[i][d] - 1.0 });
    }
    growth *= std::pow(1.0 + 2.0 * beyond, patch.Degree[d]);
  }
  return growth;
}

struct PatchGradient::Line
{
  /// The sign of the coverage, and of the outward normal.
  double Coverage;
  double Side;
  /// s at the trim curve.
  double EdgeS;
  /// BoundBasis() of the panel.
  double Growth;
  /// Rounding of the trim curve in units of u of the patch's width, as in smPanel.glsl.
  double TrimRounding;
};

void PatchGradient::Compute(const FacePanels& panels, std::uint32_t patch, const PatchPlan& plan,
  const std::array<double, 3>& shift, const std::array<double, 3>& moved)
{
  this->Panels = &panels;
  this->Source = &panels.Patches[patch];
  this->Points = panels.Points.data() + this->Source->FirstPoint;
  std::copy_n(this->Source->Degree, 2, this->Degree);
  const int p = this->Degree[0];
  const int q = this->Degree[1];
  for (int c = 0; c < 3; ++c)
  {
    this->Origin[c] = this->Source->Center[c] + shift[c];
  }
  // A net that is off by d has differences (w_i+1 d_i+1 - w_i d_i), and with Radius d in StretchOf() its
  // derivatives are at most 2 p d times the ratio of neighbours' weights.
  this->Moved = std::hypot(moved[0] + this->Source->Displacement[0], moved[1] + this->Source->Displacement[1],
    moved[2] + this->Source->Displacement[2]);
  const double ratio = std::max(1.0, this->Source->WeightRatio);
  for (int d = 0; d < 2; ++d)
  {
    this->Slope[d] = 2.0 * this->Degree[d] * ratio * this->Moved;
  }
  this->Sums.assign(channel::Count * static_cast<std::size_t>(p + 1) * (q + 1), 0.0);
  this->LineSums.resize(channel::Count * static_cast<std::size_t>(p + 1));
  this->LineSlopes.resize(4 * static_cast<std::size_t>(p + 1));
  this->Row.resize(p + 1);
  this->RowS.resize(p + 1);
  this->RowR.resize(p + 1);
  this->Evaluations = 0;
  this->Growth = 1.0;
  this->AreaNoise[0] = this->AreaNoise[1] = 0.0;
  // A polynomial has at most 3 roundings a degree and a sum over the net one for each term: 4 (p + q) and a
  // few more for a numerator, and as many for the weight that it is divided by. Differences, quotients and
  // products of a tangent are the rest. All polynomials and weights are positive, so that these are relative
  // errors.
  this->Roundings = 8.0 * (p + q) + 24.0;
  std::size_t lines = 0;
  int longest = 1;
  for (const PlannedItem& item : plan.Items)
  {
    const int factor = item.Compared ? 2 : 1;
    lines += static_cast<std::size_t>(factor) * item.Along;
    longest = std::max(longest, factor * item.Across);
  }
  this->Additions = static_cast<double>(lines) + longest;
  for (const PlannedItem& item : plan.Items)
  {
    this->AddItem(item);
  }
}

void PatchGradient::AddItem(const PlannedItem& item)
{
  const Panel& panel = this->Panels->Panels[item.Index];
  const double* trim = this->Panels->Coefficients.data() + panel.Trim;
  const std::vector<double>& rules = GetRuleTable();
  const int factor = item.Compared ? 2 : 1;
  const int along = std::min(factor * item.Along, MaximumRuleSize);
  const int across = std::min(factor * item.Across, MaximumRuleSize);
  const double* ruleT = rules.data() + along * (along - 1);
  const double* ruleX = rules.data() + across * (across - 1);
  const double width = panel.End - panel.Start;
  const double start = panel.Start + width * item.Start;
  const double tWidth = width * (item.End - item.Start);
  const double xiWidth = item.XiEnd - item.XiStart;
  const int p = this->Degree[0];
  const int q = this->Degree[1];
  // Coefficients far from the patch round its parameters by more, in units of its width.
  double reach = 1.0;
  for (int i = 0; i <= panel.TrimDegree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      reach = std::max(reach, std::abs(trim[2 * i + d]) / this->Source->Width[d]);
    }
  }
  const double growth = BoundBasis(*this->Panels, panel);
  this->Growth = std::max(this->Growth, growth);
  for (int a = 0; a < along; ++a)
  {
    const TrimPoint at = EvaluateTrim(trim, panel.TrimDegree, *this->Source, start + tWidth * ruleT[2 * a]);
    const Line line{ panel.Negative ? -1.0 : 1.0, panel.FlipNormal ? -1.0 : 1.0, at.S, growth, 3.0 * reach };
    const Basis inR(q, at.R);
    for (int i = 0; i <= p; ++i)
    {
      this->Row[i] = this->RowS[i] = this->RowR[i] = {};
    }
    double lower[MaximumDegree + 1];
    FillBernsteinBasis(q - 1, at.R, lower);
    for (int j = 0; j <= q; ++j)
    {
      const std::array<double, 4>* net = this->Points + static_cast<std::ptrdiff_t>(j) * (p + 1);
      for (int i = 0; i <= p; ++i)
      {
        for (int c = 0; c < 4; ++c)
        {
          this->Row[i][c] += inR.Values[j] * net[i][c];
          // Differences come first: the rounding of a derivative is relative to them.
          this->RowR[i][c] += j < q ? q * (lower[j] * (net[i + p + 1][c] - net[i][c])) : 0.0;
          this->RowS[i][c] += i < p ? p * (inR.Values[j] * (net[i + 1][c] - net[i][c])) : 0.0;
        }
      }
    }
    std::fill(this->LineSums.begin(), this->LineSums.end(), 0.0);
    std::fill(this->LineSlopes.begin(), this->LineSlopes.end(), 0.0);
    const double weightT = ruleT[2 * a + 1] * tWidth * at.SlopeR * xiWidth;
    for (int b = 0; b < across; ++b)
    {
      this->AddPoint(line, (item.XiStart + xiWidth * ruleX[2 * b]) * at.S, weightT * ruleX[2 * b + 1]);
    }
    // The line's sums meet the polynomials in r.
    for (int j = 0; j <= q; ++j)
    {
      for (int i = 0; i <= p; ++i)
      {
        double* sums = this->Sums.data() + channel::Count * (i + (p + 1) * static_cast<std::size_t>(j));
        const double* from = this->LineSums.data() + channel::Count * static_cast<std::size_t>(i);
        AddMultiple(inR.Values[j], from, channel::Noise, sums);
        AddMultiple(std::abs(inR.Values[j]), from + channel::Noise, channel::Count - channel::Noise,
          sums + channel::Noise);
        AddMultiple(
          inR.Slopes[j], this->LineSlopes.data() + 4 * static_cast<std::size_t>(i), 4, sums + channel::Area);
      }
    }
  }
  this->Evaluations += static_cast<std::int64_t>(along) * across;
}

void PatchGradient::AddPoint(const Line& line, double s, double weight)
{
  const int p = this->Degree[0];
  const Basis inS(p, s);
  double lower[MaximumDegree + 1];
  FillBernsteinBasis(p - 1, s, lower);
  double h[4] = {};
  double hs[4] = {};
  double hr[4] = {};
  for (int i = 0; i <= p; ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      h[c] += inS.Values[i] * this->Row[i][c];
      hr[c] += inS.Values[i] * this->RowR[i][c];
      hs[c] += i < p ? lower[i] * this->RowS[i][c] : 0.0;
    }
  }
  const double inverse = 1.0 / h[3];
  Vector3 x;
  Vector3 ss;
  Vector3 sr;
  for (int c = 0; c < 3; ++c)
  {
    const double offset = h[c] * inverse;
    ss[c] = (hs[c] - hs[3] * offset) * inverse;
    sr[c] = (hr[c] - hr[3] * offset) * inverse;
    x[c] = this->Origin[c] + offset;
  }
  const Vector3 n = Cross(ss, sr);
  const double length = Norm(n);
  const double g[NumberOfMoments] = { 1.0, x[0], x[1], x[2], x[0] * x[0], x[1] * x[1], x[2] * x[2],
    x[0] * x[1], x[1] * x[2], x[0] * x[2] };
  const double flux = Dot(x, n);

  double values[channel::Count];
  const double coverage = line.Coverage * weight * line.EdgeS * inverse;
  const double signedWeight = line.Side * coverage;
  for (int k = 0; k < NumberOfMoments; ++k)
  {
    const double factor = signedWeight * g[k];
    for (int c = 0; c < 3; ++c)
    {
      values[3 * k + c] = factor * n[c];
    }
    values[channel::Flux + k] = factor * flux;
  }

  // Roundings relative to u, see Documentation/Gradients.md: of tangents, K times the largest steps of the
  // net; of a product of few factors and of its sum, relative to it; of the trim curve, which moves the
  // border; and what the net itself is off. The last one is divided by u, as all are multiplied by it.
  const double lengthS = Norm(ss);
  const double lengthR = Norm(sr);
  const double stretchS = std::max(this->Source->Stretch[0], lengthS);
  const double stretchR = std::max(this->Source->Stretch[1], lengthR);
  const double size = Norm(x);
  const double off = this->Moved / UnitRoundoff;
  const double offS = this->Slope[0] / UnitRoundoff;
  const double offR = this->Slope[1] / UnitRoundoff;
  const double absolute = std::abs(weight) * inverse;
  const double edge = std::abs(line.EdgeS);
  const double ofNormal = edge *
      ((this->Roundings + 4.0) * (stretchS * lengthR + lengthS * stretchR) +
        (this->Roundings + this->Additions + 24.0) * length + offS * lengthR + offR * lengthS) +
    line.TrimRounding * stretchS * stretchR;
  const double ofPosition =
    edge * length * ((this->Roundings + 2.0) * this->Source->Radius + 2.0 * size + off);
  double power = 1.0;
  double lowerPower = 0.0;
  for (int m = 0; m < 4; ++m)
  {
    values[channel::Noise + m] =
      absolute * line.Growth * line.Growth * (power * ofNormal + m * lowerPower * ofPosition);
    lowerPower = power;
    power *= size;
  }

  // Area: the normal's direction is off by at most 2 and by twice its relative error.
  Vector3 e{};
  for (int c = 0; c < 3 && length > 0.0; ++c)
  {
    e[c] = n[c] / length;
  }
  const Vector3 a = Cross(sr, e);
  const Vector3 b = Cross(e, ss);
  double alongA[4];
  double alongB[4];
  for (int c = 0; c < 3; ++c)
  {
    const double common = -(hs[3] * a[c] + hr[3] * b[c]) * inverse;
    values[channel::Area + c] = common;
    alongA[c] = a[c];
    alongB[c] = b[c];
  }
  alongA[3] = Dot(x, a);
  alongB[3] = Dot(x, b);
  values[channel::Area + 3] = -(hs[3] * alongA[3] + hr[3] * alongB[3]) * inverse + 2.0 * length;
  for (int c = 0; c < 4; ++c)
  {
    values[channel::Area + c] *= coverage;
    alongA[c] *= coverage;
    alongB[c] *= coverage;
  }
  // The sums of |R_s| and of |R_r| over all control points; K roundings of each and of the tangents, and the
  // normal's direction, off by twice its relative error but by no more than 2.
  const double slopeS = (2.0 * p + std::abs(hs[3]) * inverse) * inverse;
  const double slopeR = (2.0 * this->Degree[1] + std::abs(hr[3]) * inverse) * inverse;
  const double few = this->Roundings + this->Additions + 24.0;
  const double offNormal = (this->Roundings + 4.0) * (stretchS * lengthR + lengthS * stretchR) +
    4.0 * length + offS * lengthR + offR * lengthS;
  const double offDirection = std::min(2.0 / UnitRoundoff, 2.0 * offNormal / length);
  const double steps = slopeS * stretchR + slopeR * stretchS;
  const double ofArea = edge *
      (few * steps + (slopeS * lengthR + slopeR * lengthS) * offDirection + slopeS * offR + slopeR * offS) +
    line.TrimRounding * steps;
  const double scale = std::abs(weight) * line.Growth * line.Growth;
  this->AreaNoise[0] += scale * ofArea;
  this->AreaNoise[1] += scale *
    (size * ofArea +
      edge *
        ((slopeS * lengthR + slopeR * lengthS) *
            ((this->Roundings + 2.0) * this->Source->Radius + 2.0 * size + off) +
          2.0 * inverse * (offNormal + few * length)) +
      2.0 * inverse * line.TrimRounding * stretchS * stretchR);

  for (int i = 0; i <= p; ++i)
  {
    double* sums = this->LineSums.data() + channel::Count * static_cast<std::size_t>(i);
    AddMultiple(inS.Values[i], values, channel::Noise, sums);
    AddMultiple(std::abs(inS.Values[i]), values + channel::Noise, channel::Count - channel::Noise,
      sums + channel::Noise);
    AddMultiple(inS.Slopes[i], alongA, 4, sums + channel::Area);
    AddMultiple(inS.Values[i], alongB, 4, this->LineSlopes.data() + 4 * static_cast<std::size_t>(i));
  }
}
}
