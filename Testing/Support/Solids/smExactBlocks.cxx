#include "smExactBlocks.h"

#include "smBlockShape.h"

#include <Geom_OffsetSurface.hxx>

#include <cmath>
#include <random>
#include <stdexcept>

namespace smtest
{
namespace
{
/// Multiples of 1/64 in [-1, 1], the same on every machine.
class Noise
{
public:
  double Get() { return static_cast<double>(this->Engine() % 129) / 64.0 - 1.0; }

private:
  std::mt19937 Engine{ 2010 };
};

/// 64ths are exact in a double and in 17 digits.
double Rounded(double x)
{
  return std::round(64.0 * x) / 64.0;
}

/// The integrals of a block are compared with what is known of them in closed form: a slip stops the build.
void Confirm(const std::string& what, Real integrated, Real known)
{
  // The poles of rational arcs are rounded to doubles.
  if (!(std::fabs(integrated - known) <= 1e-15L * std::fabs(known)))
  {
    throw std::runtime_error(what + ": the integrals of a block and the closed form disagree");
  }
}

ExactSolid MakeBlockSolid(const RationalBlock& block)
{
  return MakeExactSolid(MakeBlockShape(block), IntegrateBlock(block), false);
}

/// Volume and its first moment in x are sums over the poles: B_i has the integral 1 / (p + 1) and u B_i that
/// of (i + 1) / ((p + 1) (p + 2)).
void ConfirmGraph(const RationalBlock& block, const ExactMoments& moments)
{
  const int p = block.Degree[0];
  const int q = block.Degree[1];
  const Real cell = 3 * p * 4 * q / static_cast<Real>((p + 1) * (q + 1));
  Real volume = 0;
  Real first = 0;
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      const Real height =
        static_cast<Real>(block.Poles[block.GetIndex(i, j, 1)][2]) - block.Poles[block.GetIndex(i, j, 0)][2];
      volume += cell * height;
      first += cell * height * 3 * p * (i + 1) / (p + 2);
    }
  }
  Confirm("graph, volume", moments.Volume, volume);
  Confirm("graph, x", moments.Center[0], first / volume);
}

/// A polynomial graph of degrees (p, q) over [0, 3p] x [0, 4q], on a floor that is a polynomial too.
ExactSolid MakeGraph(int p, int q)
{
  Noise noise;
  const RationalBlock block = MakeBlock({ p, q, 1 },
    [&](double u, double v, double w)
    {
      const double height = w > 0 ? 2.0 + 8.0 * noise.Get() : -24.0 + 2.0 * noise.Get();
      return std::array<double, 3>{ std::round(3.0 * p * u), std::round(4.0 * q * v), height };
    });
  const ExactSolid solid = MakeBlockSolid(block);
  ConfirmGraph(block, solid.Moments);
  return solid;
}

/// All three coordinates of all three degrees: a bent brick with rough faces.
RationalBlock MakeBentBlock(const std::array<int, 3>& degree)
{
  Noise noise;
  return MakeBlock(degree,
    [&](double u, double v, double w)
    {
      // A fifth of the lattice's spacing leaves the order of neighbours alone.
      const double x = 36 * u + 12 * w * (1 - w) - 5 * v * v + 7.2 / degree[0] * noise.Get();
      const double y = 20 * v + 9 * u * (1 - u) * (1 + w) + 4 / degree[1] * noise.Get();
      const double z = 28 * w - 6 * u * v + 5 * u * u + 5.6 / degree[2] * noise.Get();
      return std::array<double, 3>{ Rounded(x), Rounded(y), Rounded(z) };
    });
}

/// A polynomial solid written with weights; its moments come from the polynomials.
ExactSolid MakeReparametrized(const RationalBlock& polynomial, const std::array<double, 3>& factor)
{
  ExactSolid solid =
    MakeExactSolid(MakeBlockShape(Reparametrized(polynomial, factor)), IntegrateBlock(polynomial), false);
  solid.VolumeComparable = factor[0] < 10;
  return solid;
}

/// u and v change places: the Jacobian is negative, every outward face has the other orientation.
RationalBlock Swapped(const RationalBlock& block)
{
  RationalBlock swapped;
  swapped.Degree = { block.Degree[1], block.Degree[0], block.Degree[2] };
  for (int k = 0; k <= swapped.Degree[2]; ++k)
  {
    for (int j = 0; j <= swapped.Degree[1]; ++j)
    {
      for (int i = 0; i <= swapped.Degree[0]; ++i)
      {
        swapped.Poles.push_back(block.Poles[block.GetIndex(j, i, k)]);
      }
    }
  }
  return swapped;
}

ExactSolid MakeRationalBlock()
{
  RationalBlock block = MakeBentBlock({ 2, 3, 1 });
  Noise noise;
  for (std::size_t i = 0; i < block.Poles.size(); ++i)
  {
    block.Weights.push_back(1.75 + 1.25 * noise.Get());
  }
  return MakeBlockSolid(block);
}

/// Bernstein coefficients of degree n of a polynomial in powers.
std::vector<Real> ToBernstein(const std::vector<Real>& powers, int n)
{
  std::vector<Real> result;
  for (int i = 0; i <= n; ++i)
  {
    Real sum = 0;
    // C(i, k) / C(n, k).
    Real ratio = 1;
    for (int k = 0; k <= i && k < static_cast<int>(powers.size()); ++k)
    {
      sum += ratio * powers[k];
      ratio *= static_cast<Real>(i - k) / (n - k);
    }
    result.push_back(sum);
  }
  return result;
}

/// Integral over [0,1] of u^j / (1 + 5u)^k, k > j + 1, a rational number: with t = 1 + 5u a sum of powers of
/// t.
Real IntegrateQuotient(int j, int k)
{
  Real sum = 0;
  Real binomial = 1;
  for (int m = 0; m <= j; ++m)
  {
    const int power = m - k + 1;
    const Real sign = (j - m) % 2 ? -1 : 1;
    sum += sign * binomial * (std::pow(6.0L, power) - 1) / power;
    binomial = binomial * (j - m) / (m + 1);
  }
  return sum / std::pow(5.0L, j + 1);
}

/// Between z = -4 and z = 48 g(v) / (1 + 5u)^4, g = 1 + 2v - 2v^2, over [0,30] x [0,20]: weights from 1 to
/// 6^4, and moments that are rational numbers.
ExactSolid MakeRationalGraph()
{
  const Real a = 30;
  const Real b = 20;
  const Real height = 48;
  const Real floor = 4;
  const std::vector<Real> fourth{ 1, 20, 150, 500, 625 };
  const std::vector<Real> w = ToBernstein(fourth, 5);
  const std::vector<Real> xw = ToBernstein({ 0, a * 1, a * 20, a * 150, a * 500, a * 625 }, 5);
  const std::vector<Real> g = ToBernstein({ 1, 2, -2 }, 2);
  RationalBlock block;
  block.Degree = { 5, 2, 1 };
  for (int k = 0; k <= 1; ++k)
  {
    for (int j = 0; j <= 2; ++j)
    {
      for (int i = 0; i <= 5; ++i)
      {
        block.Poles.push_back({ static_cast<double>(xw[i] / w[i]), static_cast<double>(b * j / 2),
          static_cast<double>(k ? height * g[j] / w[i] : -floor) });
        block.Weights.push_back(static_cast<double>(w[i]));
      }
    }
  }
  ExactSolid solid = MakeBlockSolid(block);
  solid.VolumeComparable = false;
  // Integrals of g^n v^j.
  const Real g1 = 4.0L / 3;
  const Real g1v = 2.0L / 3;
  const Real g2 = 1 + 4.0L * (1.0L / 6) + 4 * (1.0L / 30);
  const Real volume = a * b * (height * g1 * IntegrateQuotient(0, 4) + floor);
  const Real x = a * a * b * (height * g1 * IntegrateQuotient(1, 4) + floor / 2);
  const Real y = a * b * b * (height * g1v * IntegrateQuotient(0, 4) + floor / 2);
  const Real z = a * b * (height * height * g2 * IntegrateQuotient(0, 8) - floor * floor) / 2;
  const Real xx = a * a * a * b * (height * g1 * IntegrateQuotient(2, 4) + floor / 3);
  const Matrix second = solid.Moments.GetSecondMoments();
  Confirm("rational graph, volume", solid.Moments.Volume, volume);
  Confirm("rational graph, x", solid.Moments.Center[0], x / volume);
  Confirm("rational graph, y", solid.Moments.Center[1], y / volume);
  Confirm("rational graph, z", solid.Moments.Center[2], z / volume);
  Confirm("rational graph, xx", second[0][0], xx);
  return solid;
}

/// The strip between c(t) = 24 (t - t^3 / 3, t^2), a curve of speed 24 (1 + t^2), and its offset by 4, which
/// is rational: n = (-2t, 1 - t^2) / (1 + t^2). Extruded to z = 15. The file gives the outer face as an
/// offset surface.
ExactSolid MakeOffsetStrip()
{
  const Real size = 24;
  const Real distance = 4;
  const Real height = 15;
  const std::vector<Real> w = ToBernstein({ 1, 0, 1 }, 5);
  RationalBlock block;
  // The three parameters are z, t, and the distance from the curve towards its offset.
  block.Degree = { 1, 5, 1 };
  for (int k = 0; k <= 1; ++k)
  {
    const Real d = k * distance;
    const std::vector<Real> xw = ToBernstein({ 0, size - 2 * d, 0, size * 2 / 3, 0, -size / 3 }, 5);
    const std::vector<Real> yw = ToBernstein({ d, 0, size - d, 0, size }, 5);
    for (int j = 0; j <= 5; ++j)
    {
      for (int i = 0; i <= 1; ++i)
      {
        block.Poles.push_back({ static_cast<double>(xw[j] / w[j]), static_cast<double>(yw[j] / w[j]),
          static_cast<double>(i * height) });
        block.Weights.push_back(static_cast<double>(w[j]));
      }
    }
  }
  // The curve has length 32 and turns by a right angle.
  const Real section = distance * size * 4 / 3 - distance * distance * Pi / 4;
  const Real length = size * 8 / 3 - distance * Pi / 2;
  const ExactMoments moments = IntegrateBlock(block);
  Confirm("offset strip, volume", moments.Volume, section * height);
  Confirm("offset strip, area", moments.Area, 2 * section + (length + 2 * distance) * height);

  // The curve as it is, a cubic: an offset surface needs its basis smooth and is fitted by the reader.
  RationalBlock basis;
  basis.Degree = { 1, 3, 1 };
  for (int k = 0; k <= 1; ++k)
  {
    for (const auto& p : { std::array<double, 2>{ 0, 0 }, { 8, 0 }, { 16, 8 }, { 16, 24 } })
    {
      basis.Poles.push_back({ p[0], p[1], 0 });
      basis.Poles.push_back({ p[0], p[1], static_cast<double>(height) });
    }
  }
  std::array<Handle(Geom_Surface), 6> replaced;
  replaced[2 * 2 + 1] = new Geom_OffsetSurface(MakeBlockPatch(basis, 2, 0), static_cast<double>(distance));
  return MakeExactSolid(MakeBlockShape(block, replaced), moments, false);
}

/// Poles and weights (x, y, w) of a circular arc of radius 1.
std::array<std::array<Real, 3>, 3> MakeArc(Real low, Real high)
{
  const Real middle = (low + high) / 2;
  const Real c = std::cos((high - low) / 2);
  return { { { std::cos(low), std::sin(low), 1 }, { std::cos(middle) / c, std::sin(middle) / c, c },
    { std::cos(high), std::sin(high), 1 } } };
}

/// A part of a spherical shell of radii 10 and 13. The file gives the outer face as the offset of a rational
/// B-spline.
ExactSolid MakeOffsetSphere()
{
  const Real inner = 10;
  const Real outer = 13;
  const Real low = -Pi / 6;
  const Real high = Pi / 5;
  const Real width = Pi / 2;
  const auto longitude = MakeArc(0, width);
  const auto latitude = MakeArc(low, high);
  RationalBlock block;
  block.Degree = { 2, 2, 1 };
  for (const Real radius : { inner, outer })
  {
    for (const auto& q : latitude)
    {
      for (const auto& p : longitude)
      {
        block.Poles.push_back({ static_cast<double>(radius * q[0] * p[0]),
          static_cast<double>(radius * q[0] * p[1]), static_cast<double>(radius * q[1]) });
        block.Weights.push_back(static_cast<double>(p[2] * q[2]));
      }
    }
  }
  const Real angle = width * (std::sin(high) - std::sin(low));
  const Real ring = (outer * outer - inner * inner) / 2;
  const ExactMoments moments = IntegrateBlock(block);
  Confirm(
    "offset sphere, volume", moments.Volume, (outer * outer * outer - inner * inner * inner) / 3 * angle);
  Confirm("offset sphere, area", moments.Area,
    (outer * outer + inner * inner) * angle + 2 * ring * (high - low) +
      ring * width * (std::cos(low) + std::cos(high)));
  std::array<Handle(Geom_Surface), 6> replaced;
  replaced[2 * 2 + 1] =
    new Geom_OffsetSurface(MakeBlockPatch(block, 2, 0), static_cast<double>(outer - inner));
  return MakeExactSolid(MakeBlockShape(block, replaced), moments, false);
}
}

const std::vector<NamedSolid>& GetExactBlocks()
{
  static const std::vector<NamedSolid> blocks = {
    { "graph_3_7", [] { return MakeGraph(3, 7); } },
    { "graph_9_9", [] { return MakeGraph(9, 9); } },
    // Near the largest degree there is, 25, where OCCT's own check becomes unreliable.
    { "graph_20_2", [] { return MakeGraph(20, 2); } },
    { "block_4_3_2",
      [] {
        return MakeBlockSolid(MakeBentBlock({ 4, 3, 2 }));
      } },
    { "block_9_2_5",
      [] {
        return MakeBlockSolid(MakeBentBlock({ 9, 2, 5 }));
      } },
    // Weights 1, 10, 100, 1000.
    { "moebius_1000",
      [] {
        return MakeReparametrized(MakeBentBlock({ 3, 2, 2 }), { 10, 1, 1 });
      } },
    // Weights from 1 to 2^10 on one face.
    { "moebius_left",
      [] {
        return MakeReparametrized(Swapped(MakeBentBlock({ 6, 4, 1 })), { 2, 2, 2 });
      } },
    { "rational_block", MakeRationalBlock },
    { "rational_graph", MakeRationalGraph },
    { "offset_strip", MakeOffsetStrip },
    { "offset_sphere", MakeOffsetSphere },
  };
  return blocks;
}
}
