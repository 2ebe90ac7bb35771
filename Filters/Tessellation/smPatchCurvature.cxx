#include "Detail/smPatchCurvature.h"

#include "Detail/smRationalBound.h"
#include "smBernstein.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// How often a part is halved where its weights differ too much for a bound, and where a bound is too coarse.
constexpr int MaxHalvings = 10;
constexpr int SharpHalvings = 4;
/// Bounds are not tried where weights change by more than this, relative to them.
constexpr double MaxSlope = 0.5;
/// Parts of a rational curve on which its second derivative is bounded.
constexpr int CurveParts = 4;

double GetMaxWeight(const BernsteinNet& net)
{
  double largest = 0.0;
  for (const Homogeneous& h : net.B)
  {
    largest = std::max(largest, std::abs(h[3]));
  }
  return largest;
}

/// Second difference in one direction, or mixed: `i` and `j` are those of the first point.
template <class Points>
double GetSecond(const Points& net, int k, int i, int j, int c)
{
  return k == 0 ? net.At(i + 2, j)[c] - 2.0 * net.At(i + 1, j)[c] + net.At(i, j)[c]
    : k == 2    ? net.At(i, j + 2)[c] - 2.0 * net.At(i, j + 1)[c] + net.At(i, j)[c]
                : net.At(i + 1, j + 1)[c] - net.At(i + 1, j)[c] - net.At(i, j + 1)[c] + net.At(i, j)[c];
}

/// Number of second differences in u and v of kind k: uu, uv, vv; and the factor that makes them derivatives.
struct SecondKind
{
  SecondKind(const BernsteinNet& net, int k)
    : Columns(std::max(net.P + 1 -
          (k == 0      ? 2
              : k == 1 ? 1
                       : 0),
        0))
    , Rows(std::max(net.Q + 1 -
          (k == 2      ? 2
              : k == 1 ? 1
                       : 0),
        0))
    , Factor(k == 0 ? net.P * (net.P - 1.0)
          : k == 1  ? net.P * net.Q
                    : net.Q * (net.Q - 1.0))
  {
  }
  int Columns;
  int Rows;
  double Factor;
};

CurvatureBounds BoundPolynomial(const BernsteinNet& net, const Vector3& normal)
{
  CurvatureBounds bound;
  for (int k = 0; k < 3; ++k)
  {
    const SecondKind kind(net, k);
    MaxVector largest(normal);
    for (int j = 0; j < kind.Rows; ++j)
    {
      for (int i = 0; i < kind.Columns; ++i)
      {
        const Vector3 second{ GetSecond(net, k, i, j, 0), GetSecond(net, k, i, j, 1),
          GetSecond(net, k, i, j, 2) };
        largest.Add(second);
      }
    }
    const double factor = kind.Factor / net.B[0][3];
    bound.Full[k] = factor * largest.GetLength();
    bound.Along[k] = factor * largest.GetComponent();
  }
  return bound;
}

/// Second derivatives of a rational patch of any weights, coarse: |S_u| <= p (w_max / w_min)^2 max |S_i -
/// S_j|.
CurvatureBounds BoundCoarsely(const BernsteinNet& net)
{
  const Vector3 center = Project(net.B[0]);
  double size = 0.0;
  double lightest = HUGE_VAL;
  BernsteinNet moved = net;
  for (Homogeneous& h : moved.B)
  {
    size = std::max(size, Norm(Subtract(Project(h), center)));
    lightest = std::min(lightest, std::max(h[3], MinWeight));
    for (int x = 0; x < 3; ++x)
    {
      h[x] -= h[3] * center[x];
    }
  }
  const double ratio = GetMaxWeight(net) / lightest;
  const double slope[2] = { 2.0 * net.P * ratio * ratio * size, 2.0 * net.Q * ratio * ratio * size };
  const double a[2] = { GetMaxWeight(Derive(net, 0)) / lightest, GetMaxWeight(Derive(net, 1)) / lightest };
  CurvatureBounds bound;
  for (int k = 0; k < 3; ++k)
  {
    const SecondKind kind(net, k);
    const Vector3 none{};
    MaxVector largest(none);
    double weight = 0.0;
    for (int j = 0; j < kind.Rows; ++j)
    {
      for (int i = 0; i < kind.Columns; ++i)
      {
        const Vector3 second{ GetSecond(moved, k, i, j, 0), GetSecond(moved, k, i, j, 1),
          GetSecond(moved, k, i, j, 2) };
        largest.Add(second);
        weight = std::max(weight, std::abs(GetSecond(moved, k, i, j, 3)));
      }
    }
    bound.Full[k] = kind.Factor * (largest.GetLength() + weight * size) / lightest;
  }
  bound.Full[0] += 2.0 * a[0] * slope[0];
  bound.Full[1] += a[0] * slope[1] + a[1] * slope[0];
  bound.Full[2] += 2.0 * a[1] * slope[1];
  bound.Along = bound.Full;
  return bound;
}

/// Returns true where the weights are products of a weight of the column and one of the row.
bool IsSeparable(const BernsteinNet& net)
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

/// Bounds of the second derivative of a rational curve on [0,1] and of its component along a unit vector, as
/// RationalBound with one direction; infinite where there are none.
std::array<double, 2> BoundCurve(const Homogeneous* b, int degree, const Vector3& normal)
{
  const BernsteinPiece<4> curve{ b, degree };
  Homogeneous derivative;
  const Homogeneous h = curve.Evaluate(0.5, &derivative);
  const Vector3 c = Project(h);
  const Vector3 d = ProjectDerivative(derivative, c, h[3]);
  double lightest = std::max(b[degree][3], MinWeight);
  double slope = 0.0;
  double bend = 0.0;
  for (int i = 0; i < degree; ++i)
  {
    lightest = std::min(lightest, std::max(b[i][3], MinWeight));
    slope = std::max(slope, degree * std::abs(b[i + 1][3] - b[i][3]));
  }
  // P'' - w'' c - 2 w' d, of degree - 1: the second differences have one degree less.
  MaxVector largest(normal);
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
    largest.Add(g);
  }
  for (int i = 0; i + 2 <= degree; ++i)
  {
    bend = std::max(bend, degree * (degree - 1.0) * std::abs(b[i + 2][3] - 2.0 * b[i + 1][3] + b[i][3]));
  }
  const double rest = 1.0 - slope / lightest - 0.125 * bend / lightest;
  if (!(rest > 0.0))
  {
    return { HUGE_VAL, HUGE_VAL };
  }
  return { (largest.GetLength() + 0.5 * bend * Norm(d)) / lightest / rest,
    (largest.GetComponent() + 0.5 * bend * std::abs(Dot(d, normal))) / lightest / rest };
}

/// The mixed derivative is bounded on parts whose weights in one direction are in about this ratio at most,
/// on no more than so many.
constexpr double PartRatio = 1.5;
constexpr int MaxMixedParts = 16;

/// Largest ratio of the weights of a separable net in each direction.
std::array<double, 2> GetWeightRatios(const BernsteinNet& net)
{
  std::array<double, 2> ratios{};
  for (int d = 0; d < 2; ++d)
  {
    double minimum = HUGE_VAL;
    double maximum = 0.0;
    for (int i = 0; i <= (d == 0 ? net.P : net.Q); ++i)
    {
      const double w = (d == 0 ? net.At(i, 0) : net.At(0, i))[3];
      minimum = std::min(minimum, w);
      maximum = std::max(maximum, w);
    }
    ratios[d] = maximum / minimum;
  }
  return ratios;
}

/// |S_uv| <= p q (ratios of weights)^2 max |second difference of S_ij in both directions|, for separable
/// weights; and so its component.
std::array<double, 2> BoundMixed(const BernsteinNet& net, const Vector3& normal)
{
  const std::array<double, 2> ratios = GetWeightRatios(net);
  const double ratio = ratios[0] * ratios[1];
  MaxVector largest(normal);
  for (int j = 0; j < net.Q; ++j)
  {
    for (int i = 0; i < net.P; ++i)
    {
      const Vector3 a = Subtract(Project(net.At(i + 1, j + 1)), Project(net.At(i, j + 1)));
      const Vector3 b = Subtract(Project(net.At(i + 1, j)), Project(net.At(i, j)));
      largest.Add(Subtract(a, b));
    }
  }
  const double factor = net.P * net.Q * ratio * ratio;
  return { factor * largest.GetLength(), factor * largest.GetComponent() };
}

/// Returns true where all weights along a line are equal and it has no second derivative.
bool IsStraight(const Homogeneous* line, int degree)
{
  return degree == 1 && line[0][3] == line[1][3];
}

/**
 * With w_ij = a_i b_j the surface is sum R_i(u) R_j(v) S_ij with rational bases of one direction each. R_j(v)
 * >= 0 sum to 1, so |S_uu| is at most that of the curves whose points are S_ij of one j; and BoundMixed()
 * holds, because |C'| <= p (w_max / w_min)^2 max |S_i+1 - S_i| for a rational curve. Curves are bounded in
 * `curveParts` parts. False where the weights differ too much.
 */
bool BoundSeparable(const BernsteinNet& net, const Vector3& normal, int curveParts, CurvatureBounds& bound)
{
  bound = {};
  const auto raise = [&bound](int k, double factor, const std::array<double, 2>& by)
  {
    bound.Full[k] = std::max(bound.Full[k], factor * by[0]);
    bound.Along[k] = std::max(bound.Along[k], factor * by[1]);
  };
  for (int direction = 0; direction < 2; ++direction)
  {
    const int degree = direction == 0 ? net.P : net.Q;
    const int rows = direction == 0 ? net.Q : net.P;
    Homogeneous whole[MaximumDegree + 1];
    Homogeneous line[MaximumDegree + 1];
    for (int row = 0; row <= rows; ++row)
    {
      for (int i = 0; i <= degree; ++i)
      {
        whole[i] = direction == 0 ? net.At(i, row) : net.At(row, i);
      }
      for (int part = 0; part < curveParts && !IsStraight(whole, degree); ++part)
      {
        std::copy(whole, whole + degree + 1, line);
        RestrictBernstein(line, degree, 1, static_cast<double>(part) / curveParts, (part + 1.0) / curveParts);
        raise(2 * direction, curveParts * curveParts, BoundCurve(line, degree, normal));
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
    parts[d] = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(MaxMixedParts)));
  }
  for (int part = 0; part < parts[0] * parts[1]; ++part)
  {
    const int at[2] = { part % parts[0], part / parts[0] };
    const BernsteinNet piece = Restrict(net, static_cast<double>(at[0]) / parts[0], (at[0] + 1.0) / parts[0],
      static_cast<double>(at[1]) / parts[1], (at[1] + 1.0) / parts[1]);
    raise(1, parts[0] * parts[1], BoundMixed(piece, normal));
  }
  return std::isfinite(bound.Full[0] + bound.Full[1] + bound.Full[2]);
}

/// Bounds of a rational net on parts of it.
class RationalParts
{
public:
  RationalParts(const Vector3& normal, const EnoughBound& enough)
    : Normal(normal)
    , Enough(enough)
  {
  }

  /// `density`: the length of the whole in units of the part.
  CurvatureBounds Run(const BernsteinNet& net, const std::array<double, 2>& density, int halvings)
  {
    CurvatureBounds bound;
    const bool isSeparable = IsSeparable(net);
    if (isSeparable && this->BoundProduct(net, density, bound))
    {
      return bound;
    }
    RationalBound rational(net, this->Normal);
    const std::array<double, 2>& slope = rational.GetSlope();
    CurvatureBounds reached;
    const bool isBounded =
      !isSeparable && std::max(slope[0], slope[1]) < MaxSlope && rational.Run(bound, reached);
    if (isBounded)
    {
      Refine(density, bound);
      Refine(density, reached);
      this->Reached.Raise(reached);
      if (halvings >= SharpHalvings || this->Enough.IsMet(bound.Full) || bound.IsSharp(this->Reached))
      {
        return bound;
      }
    }
    if (halvings == MaxHalvings)
    {
      bound = BoundCoarsely(net);
      Refine(density, bound);
      return bound;
    }
    const int direction = slope[0] > slope[1] ? 0 : 1;
    std::array<double, 2> finer = density;
    finer[direction] *= 2.0;
    CurvatureBounds largest;
    BernsteinNet parts[2] = { net, BernsteinNet() };
    SplitInMiddle(parts[0], direction, parts[1]);
    for (const BernsteinNet& part : parts)
    {
      largest.Raise(this->Run(part, finer, halvings + 1));
    }
    if (isBounded)
    {
      largest.Lower(bound);
    }
    return largest;
  }

private:
  static void Refine(const std::array<double, 2>& density, CurvatureBounds& bound)
  {
    bound.Refine(0, density[0]);
    bound.Refine(1, density[1]);
  }

  bool BoundProduct(
    const BernsteinNet& net, const std::array<double, 2>& density, CurvatureBounds& bound) const
  {
    for (const int parts : { 1, CurveParts })
    {
      const bool isBounded = BoundSeparable(net, this->Normal, parts, bound);
      Refine(density, bound);
      if (isBounded && (parts == CurveParts || this->Enough.IsMet(bound.Full)))
      {
        return true;
      }
    }
    return false;
  }

  const Vector3& Normal;
  const EnoughBound& Enough;
  /// About what the derivatives are somewhere.
  CurvatureBounds Reached;
};
}

CurvatureBounds BoundSecondDerivatives(
  const BernsteinNet& net, bool rational, const Vector3& normal, const EnoughBound& enough)
{
  return rational ? RationalParts(normal, enough).Run(net, { 1.0, 1.0 }, 0) : BoundPolynomial(net, normal);
}
}
