#include "smPatchCurvature.h"

#include "smPatchParts.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Beyond the borders of a rational surface's domain a weight may vanish: bounds are immense then, not negative.
constexpr double LeastWeight = 1e-100;

/// How often a part is halved in both directions where its weights differ too much for a bound.
constexpr int MostHalvings = 5;
/// The same where weights are no products: the bound is too coarse before.
constexpr int LeastHalvings = 2;
/// Parts of a rational curve on which its second derivative is bounded.
constexpr int CurveParts = 4;

double GetLargestNorm(const PatchNet& net)
{
  double largest = 0.0;
  for (const Homogeneous& h : net.B)
  {
    largest = std::max(largest, Dot(h.data(), h.data()));
  }
  return std::sqrt(largest);
}

double GetLargestWeight(const PatchNet& net)
{
  double largest = 0.0;
  for (const Homogeneous& h : net.B)
  {
    largest = std::max(largest, std::abs(h[3]));
  }
  return largest;
}

/**
 * With c, d_u, d_v: position and derivatives in the middle, H = (P, w):
 *     w S_uu = (P_uu - w_uu c - 2 w_u d_u)             - w_uu (S - c) - 2 w_u (S_u - d_u)
 *     w S_uv = (P_uv - w_uv c - w_u d_v - w_v d_u)     - w_uv (S - c) - w_u (S_v - d_v) - w_v (S_u - d_u)
 * The brackets are polynomials, bounded by their coefficients; |S_u - d_u| <= (M_uu + M_uv) / 2 and so on on [0,1]^2. That is
 * M <= g + A M with A, g >= 0; any M with M >= g + A M and g > 0 bounds the true one, for then the spectral radius of A is below 1.
 */
bool BoundRational(const PatchNet& net, const PatchNet& u, const PatchNet& v, std::array<double, 3>& bound)
{
  const PatchNet second[3] = { Derive(u, 0), Derive(u, 1), Derive(v, 1) };
  const Homogeneous h = Evaluate(net, 0.5, 0.5);
  const Vector3 c = Project(h);
  const Vector3 middle[2] = { ProjectDerivative(Evaluate(u, 0.5, 0.5), c, h[3]),
    ProjectDerivative(Evaluate(v, 0.5, 0.5), c, h[3]) };
  double lightest = std::max(net.B[0][3], LeastWeight);
  for (const Homogeneous& b : net.B)
  {
    lightest = std::min(lightest, std::max(b[3], LeastWeight));
  }
  const double a[2] = { GetLargestWeight(u) / lightest, GetLargestWeight(v) / lightest };
  double g[3];
  double twice[3];
  for (int k = 0; k < 3; ++k)
  {
    PatchNet all = second[k];
    PatchNet first[2] = { u, v };
    const int p = k == 1 ? net.P : (k == 0 ? std::max(u.P, all.P) : net.P);
    const int q = k == 1 ? net.Q : (k == 2 ? std::max(v.Q, all.Q) : net.Q);
    Elevate(all, p, q);
    for (std::size_t i = 0; i < all.B.size(); ++i)
    {
      for (int x = 0; x < 3; ++x)
      {
        all.B[i][x] -= all.B[i][3] * c[x];
      }
    }
    // w_u with d_u for S_uu; w_u with d_v and w_v with d_u for S_uv.
    for (int d = 0; d < 2; ++d)
    {
      if ((k == 0 && d == 1) || (k == 2 && d == 0))
      {
        continue;
      }
      Elevate(first[d], p, q);
      const Vector3& with = k == 1 ? middle[1 - d] : middle[d];
      for (std::size_t i = 0; i < all.B.size(); ++i)
      {
        for (int x = 0; x < 3; ++x)
        {
          all.B[i][x] -= (k == 1 ? 1.0 : 2.0) * first[d].B[i][3] * with[x];
        }
      }
    }
    g[k] = GetLargestNorm(all) / lightest;
    twice[k] = GetLargestWeight(second[k]) / lightest;
  }
  const double far = 0.5 * (Norm(middle[0]) + Norm(middle[1]));
  const double least = 1e-14 * (Norm(middle[0]) + Norm(middle[1])) + 1e-300;
  std::array<double, 3> m{};
  for (int step = 0; step < 60; ++step)
  {
    const double r = far + 0.125 * (m[0] + 2.0 * m[1] + m[2]);
    const double ends[2] = { 0.5 * (m[0] + m[1]), 0.5 * (m[1] + m[2]) };
    const std::array<double, 3> next{ g[0] + twice[0] * r + 2.0 * a[0] * ends[0] + least,
      g[1] + twice[1] * r + a[0] * ends[1] + a[1] * ends[0] + least,
      g[2] + twice[2] * r + 2.0 * a[1] * ends[1] + least };
    if (next[0] <= m[0] && next[1] <= m[1] && next[2] <= m[2])
    {
      bound = m;
      return true;
    }
    for (int k = 0; k < 3; ++k)
    {
      m[k] = 1.02 * next[k];
    }
  }
  return false;
}

/// Second derivatives of a rational patch of any weights, coarse: |S_u| <= p (w_max / w_min)^2 max |S_i - S_j|.
std::array<double, 3> BoundCoarsely(const PatchNet& net, const PatchNet& u, const PatchNet& v)
{
  const Vector3 c = Project(net.B[0]);
  double size = 0.0;
  double lightest = std::max(net.B[0][3], LeastWeight);
  for (const Homogeneous& h : net.B)
  {
    size = std::max(size, Norm(Subtract(Project(h), c)));
    lightest = std::min(lightest, std::max(h[3], LeastWeight));
  }
  const double ratio = GetLargestWeight(net) / lightest;
  const double slope[2] = { 2.0 * net.P * ratio * ratio * size, 2.0 * net.Q * ratio * ratio * size };
  const double a[2] = { GetLargestWeight(u) / lightest, GetLargestWeight(v) / lightest };
  const PatchNet second[3] = { Derive(u, 0), Derive(u, 1), Derive(v, 1) };
  std::array<double, 3> bound;
  for (int k = 0; k < 3; ++k)
  {
    PatchNet moved = second[k];
    for (Homogeneous& h : moved.B)
    {
      for (int x = 0; x < 3; ++x)
      {
        h[x] -= h[3] * c[x];
      }
    }
    bound[k] = (GetLargestNorm(moved) + GetLargestWeight(moved) * size) / lightest;
  }
  bound[0] += 2.0 * a[0] * slope[0];
  bound[1] += a[0] * slope[1] + a[1] * slope[0];
  bound[2] += 2.0 * a[1] * slope[1];
  return bound;
}

/// True where the weights are products of a weight of the column and one of the row.
bool IsSeparable(const PatchNet& net)
{
  const double corner = net.At(0, 0)[3];
  for (int j = 1; j <= net.Q; ++j)
  {
    for (int i = 1; i <= net.P; ++i)
    {
      const double product = net.At(i, 0)[3] * net.At(0, j)[3];
      if (!(std::abs(net.At(i, j)[3] * corner - product) <= 1e-12 * product))
      {
        return false;
      }
    }
  }
  return true;
}

/// Bound of the second derivative of a rational curve on [0,1], as in BoundRational() with one direction; infinite where there is none.
double BoundCurve(const Homogeneous* b, int degree)
{
  const BernsteinPiece<4> curve{ b, degree };
  Homogeneous derivative;
  const Homogeneous h = curve.Evaluate(0.5, &derivative);
  const Vector3 c = Project(h);
  const Vector3 d = ProjectDerivative(derivative, c, h[3]);
  double lightest = std::max(b[degree][3], LeastWeight);
  double slope = 0.0;
  double bend = 0.0;
  for (int i = 0; i < degree; ++i)
  {
    lightest = std::min(lightest, std::max(b[i][3], LeastWeight));
    slope = std::max(slope, degree * std::abs(b[i + 1][3] - b[i][3]));
  }
  // P'' - w'' c - 2 w' d, of degree - 1: the second differences have one degree less.
  double largest = 0.0;
  for (int i = 0; i < degree; ++i)
  {
    Homogeneous second{};
    for (int side = 0; side < 2; ++side)
    {
      const int k = i - 1 + side;
      const double share =
        side == 0 ? i / std::max(degree - 1.0, 1.0) : 1.0 - i / std::max(degree - 1.0, 1.0);
      for (int x = 0; k >= 0 && k + 2 <= degree && x < 4; ++x)
      {
        second[x] += share * degree * (degree - 1.0) * (b[k + 2][x] - 2.0 * b[k + 1][x] + b[k][x]);
      }
    }
    const double w = degree * (b[i + 1][3] - b[i][3]);
    Vector3 g;
    for (int x = 0; x < 3; ++x)
    {
      g[x] = second[x] - second[3] * c[x] - 2.0 * w * d[x];
    }
    largest = std::max(largest, Norm(g));
  }
  for (int i = 0; i + 2 <= degree; ++i)
  {
    bend = std::max(bend, degree * (degree - 1.0) * std::abs(b[i + 2][3] - 2.0 * b[i + 1][3] + b[i][3]));
  }
  const double rest = 1.0 - slope / lightest - 0.125 * bend / lightest;
  return rest > 0.0 ? (largest + 0.5 * bend * Norm(d)) / lightest / rest : HUGE_VAL;
}

/// The mixed derivative is bounded on parts whose weights in one direction are in about this ratio at most, on no more than so many.
constexpr double PartRatio = 1.5;
constexpr int MostMixedParts = 16;

/// Largest ratio of the weights of a separable net in each direction.
std::array<double, 2> GetWeightRatios(const PatchNet& net)
{
  std::array<double, 2> ratios{};
  for (int d = 0; d < 2; ++d)
  {
    double least = HUGE_VAL;
    double most = 0.0;
    for (int i = 0; i <= (d == 0 ? net.P : net.Q); ++i)
    {
      const double w = (d == 0 ? net.At(i, 0) : net.At(0, i))[3];
      least = std::min(least, w);
      most = std::max(most, w);
    }
    ratios[d] = most / least;
  }
  return ratios;
}

/// |S_uv| <= p q (ratios of weights)^2 max |second difference of S_ij in both directions|, for separable weights.
double BoundMixed(const PatchNet& net)
{
  const std::array<double, 2> ratios = GetWeightRatios(net);
  const double ratio = ratios[0] * ratios[1];
  double largest = 0.0;
  for (int j = 0; j < net.Q; ++j)
  {
    for (int i = 0; i < net.P; ++i)
    {
      const Vector3 a = Subtract(Project(net.At(i + 1, j + 1)), Project(net.At(i, j + 1)));
      const Vector3 b = Subtract(Project(net.At(i + 1, j)), Project(net.At(i, j)));
      largest = std::max(largest, Norm(Subtract(a, b)));
    }
  }
  return net.P * net.Q * ratio * ratio * largest;
}

/**
 * With w_ij = a_i b_j the surface is sum R_i(u) R_j(v) S_ij with rational bases of one direction each. R_j(v) >= 0 sum to 1, so
 * |S_uu| is at most that of the curves whose points are S_ij of one j; and BoundMixed() holds, because |C'| <= p (w_max / w_min)^2
 * max |S_i+1 - S_i| for a rational curve. False where the weights differ too much.
 */
bool BoundSeparable(const PatchNet& net, std::array<double, 3>& bound)
{
  bound = {};
  for (int direction = 0; direction < 2; ++direction)
  {
    const int degree = direction == 0 ? net.P : net.Q;
    const int rows = direction == 0 ? net.Q : net.P;
    Homogeneous line[MaximumDegree + 1];
    for (int row = 0; row <= rows; ++row)
    {
      for (int part = 0; part < CurveParts; ++part)
      {
        for (int i = 0; i <= degree; ++i)
        {
          line[i] = direction == 0 ? net.At(i, row) : net.At(row, i);
        }
        RestrictBernstein(line, degree, 1, static_cast<double>(part) / CurveParts, (part + 1.0) / CurveParts);
        const double b = CurveParts * CurveParts * BoundCurve(line, degree);
        bound[2 * direction] = std::max(bound[2 * direction], b);
      }
    }
  }
  int parts[2];
  const std::array<double, 2> ratios = GetWeightRatios(net);
  for (int d = 0; d < 2; ++d)
  {
    if (!(ratios[d] >= 1.0 && std::isfinite(ratios[d])))
    {
      return false;
    }
    const double wanted = std::ceil(std::log(ratios[d]) / std::log(PartRatio));
    parts[d] = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(MostMixedParts)));
  }
  for (int part = 0; part < parts[0] * parts[1]; ++part)
  {
    const int at[2] = { part % parts[0], part / parts[0] };
    const PatchNet piece = Restrict(net, static_cast<double>(at[0]) / parts[0], (at[0] + 1.0) / parts[0],
      static_cast<double>(at[1]) / parts[1], (at[1] + 1.0) / parts[1]);
    bound[1] = std::max(bound[1], parts[0] * parts[1] * BoundMixed(piece));
  }
  return std::isfinite(bound[0] + bound[1] + bound[2]);
}

std::array<double, 3> BoundParts(const PatchNet& net, bool rational, int halvings)
{
  const PatchNet u = Derive(net, 0);
  const PatchNet v = Derive(net, 1);
  std::array<double, 3> bound{};
  if (!rational)
  {
    const double w = net.B[0][3];
    return { GetLargestNorm(Derive(u, 0)) / w, GetLargestNorm(Derive(u, 1)) / w,
      GetLargestNorm(Derive(v, 1)) / w };
  }
  if (IsSeparable(net))
  {
    if (BoundSeparable(net, bound))
    {
      return bound;
    }
  }
  else if (halvings <= MostHalvings - LeastHalvings && BoundRational(net, u, v, bound))
  {
    return bound;
  }
  if (halvings == 0)
  {
    return BoundCoarsely(net, u, v);
  }
  bound = {};
  for (int part = 0; part < 4; ++part)
  {
    const double s = 0.5 * (part % 2);
    const double r = 0.5 * (part / 2);
    const std::array<double, 3> b = BoundParts(Restrict(net, s, s + 0.5, r, r + 0.5), rational, halvings - 1);
    for (int k = 0; k < 3; ++k)
    {
      // Derivatives of the part are by half as long a unit.
      bound[k] = std::max(bound[k], 4.0 * b[k]);
    }
  }
  return bound;
}
}

std::array<double, 3> BoundSecondDerivatives(const PatchNet& net, bool rational)
{
  return BoundParts(net, rational, MostHalvings);
}
}
