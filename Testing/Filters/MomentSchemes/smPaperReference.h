/**
 * @file smPaperReference.h
 * @brief A whole scheme of the paper on the CPU, straight from its equations: the truth for smSubPatches and
 * the GPU
 *
 * "Accurate Moment Computation Using the GPU" (SPM 2010). Only NURBSSurface::Evaluate of the library is
 * called; second derivatives come from the Cox-de Boor recursion, planes are integrated along the borders of
 * their polygons, points are classified one by one. Plain sums: good for values to about 1e-13 of the largest
 * term.
 */
#ifndef smPaperReference_h
#define smPaperReference_h

#include "smFace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace smtest
{
using PaperPoint = std::array<double, 2>;
using PaperPolygons = std::vector<std::vector<PaperPoint>>;
/// V X Y Z XX YY ZZ XY YZ XZ NX NY NZ area.
using PaperIntegrals = std::array<double, 14>;

/// K of the sub-patch [u0,u1] x [v0,v1] of a surface.
using PaperDeviation =
  std::function<double(const sm::NURBSSurface& surface, double u0, double u1, double v0, double v1)>;

struct PaperOptions
{
  /// n: 1, 2 or 3 Gauss points a sub-patch and direction.
  int Points = 2;
  /// k.
  int Factor = 2;
  int TextureFactor = 4;
  /// Empty: the largest of samples, see SampleDeviation.
  PaperDeviation Deviation;
};

struct PaperResult
{
  PaperIntegrals Integrals{};
  /// Eq. 36 over the sub-patches wholly in the face, and over all that have a texel in it.
  double Estimate = 0.0;
  double EstimateWithBoundary = 0.0;
  long long SubPatches = 0;
};

/// Eq. 32, 33, 35 on [-1, 1].
inline std::vector<PaperPoint> GetPaperRule(int points)
{
  const double third = std::sqrt(1.0 / 3.0);
  const double fifth = std::sqrt(3.0 / 5.0);
  return points == 1 ? std::vector<PaperPoint>{ { 0.0, 2.0 } }
    : points == 2
    ? std::vector<PaperPoint>{ { -third, 1.0 }, { third, 1.0 } }
    : std::vector<PaperPoint>{ { -fifth, 5.0 / 9.0 }, { 0.0, 8.0 / 9.0 }, { fifth, 5.0 / 9.0 } };
}

/// The integrands of Eq. 16-28, vector area and area at a point with normal n.
inline PaperIntegrals EvaluatePaperIntegrands(const double (&s)[3], const double (&n)[3])
{
  const double x = s[0], y = s[1], z = s[2], nz = n[2];
  return { z * nz, x * z * nz, y * z * nz, z * z / 2.0 * nz, x * x * z * nz, y * y * z * nz,
    z * z * z / 3.0 * nz, x * y * z * nz, y * z * z / 2.0 * nz, x * z * z / 2.0 * nz, n[0], n[1], nz,
    std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) };
}

/// Integrands at (u,v) by Eq. 11, with the face's outward normal.
inline PaperIntegrals EvaluatePaperIntegrands(const sm::Face& face, double u, double v)
{
  double s[3];
  double a[3];
  double b[3];
  face.Surface.Evaluate(u, v, s, a, b);
  const double sign = face.Reversed ? -1.0 : 1.0;
  const double n[3] = { sign * (a[1] * b[2] - a[2] * b[1]), sign * (a[2] * b[0] - a[0] * b[2]),
    sign * (a[0] * b[1] - a[1] * b[0]) };
  return EvaluatePaperIntegrands(s, n);
}

/// Every trim piece at `chords` + 1 equidistant parameters, in loop direction.
inline PaperPolygons SamplePolygons(const sm::Face& face, int chords)
{
  PaperPolygons polygons;
  for (const sm::Loop& loop : face.Loops)
  {
    std::vector<PaperPoint> polygon;
    for (const sm::Coedge& coedge : loop.Coedges)
    {
      const int count = coedge.Curve.GetNumberOfPieces() * chords;
      for (int i = 0; i <= count; ++i)
      {
        const int at = coedge.Reversed ? count - i : i;
        const int piece = std::min(at / chords, coedge.Curve.GetNumberOfPieces() - 1);
        polygon.push_back(
          coedge.Curve.GetPiece(piece).Evaluate(static_cast<double>(at - piece * chords) / chords));
      }
    }
    polygons.push_back(polygon);
  }
  return polygons;
}

/// How often the polygons run around a point: crossings of the ray to the right, upward ones positive.
inline int GetWindingNumber(const PaperPolygons& polygons, double u, double v)
{
  int winding = 0;
  for (const std::vector<PaperPoint>& polygon : polygons)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const PaperPoint& a = polygon[i];
      const PaperPoint& b = polygon[(i + 1) % polygon.size()];
      if ((a[1] <= v) != (b[1] <= v))
      {
        const double side = (b[0] - a[0]) * (v - a[1]) - (u - a[0]) * (b[1] - a[1]);
        const bool upward = b[1] > a[1];
        winding += upward && side > 0.0 ? 1 : !upward && side < 0.0 ? -1 : 0;
      }
    }
  }
  return winding;
}

/// Section 5.4: the part of the sub-patch's texel centres that the face holds.
inline double GetPaperFraction(
  const PaperPolygons& polygons, double u0, double u1, double v0, double v1, int textureFactor)
{
  int inside = 0;
  for (int j = 0; j < textureFactor; ++j)
  {
    for (int i = 0; i < textureFactor; ++i)
    {
      const double u = u0 + (u1 - u0) * (i + 0.5) / textureFactor;
      const double v = v0 + (v1 - v0) * (j + 0.5) / textureFactor;
      inside += GetWindingNumber(polygons, u, v) != 0 ? 1 : 0;
    }
  }
  return static_cast<double>(inside) / (textureFactor * textureFactor);
}

/// Value, first and second derivative.
using PaperJet = std::array<double, 3>;

/// The basis functions N_(k-p) .. N_k on knot interval k at u, as polynomials: u may be the interval's end.
/// Cox-de Boor: N_i,d = (u - t_i) / (t_i+d - t_i) N_i,d-1 + (t_i+d+1 - u) / (t_i+d+1 - t_i+1) N_i+1,d-1,
/// differentiated twice.
inline std::vector<PaperJet> EvaluatePaperBasis(const std::vector<double>& t, int p, int k, double u)
{
  // basis[i] is N_(k-p+i).
  std::vector<PaperJet> basis(p + 2, PaperJet{});
  basis[p] = { 1.0, 0.0, 0.0 };
  const auto add = [](PaperJet& to, const PaperJet& n, double factor, double slope)
  {
    to[0] += factor * n[0];
    to[1] += factor * n[1] + slope * n[0];
    to[2] += factor * n[2] + 2.0 * slope * n[1];
  };
  for (int d = 1; d <= p; ++d)
  {
    std::vector<PaperJet> next(p + 2, PaperJet{});
    for (int i = p - d; i <= p; ++i)
    {
      const int m = k - p + i;
      if (i > p - d)
      {
        add(next[i], basis[i], (u - t[m]) / (t[m + d] - t[m]), 1.0 / (t[m + d] - t[m]));
      }
      if (i < p)
      {
        add(next[i], basis[i + 1], (t[m + d + 1] - u) / (t[m + d + 1] - t[m + 1]),
          -1.0 / (t[m + d + 1] - t[m + 1]));
      }
    }
    basis = next;
  }
  basis.pop_back();
  return basis;
}

/// The knot interval that holds u.
inline int FindPaperSpan(const sm::NURBSSurface& surface, int direction, double u)
{
  int k = surface.Degree[direction];
  const int last = surface.NumberOfControlPoints[direction] - 1;
  while (k < last && !(u < surface.Knots[direction][k + 1]))
  {
    ++k;
  }
  return k;
}

/// Largest |coordinate| of S_uu, S_uv, S_vv at (u,v) on the knot intervals ku, kv; Eq. 8 and the quotient
/// rule.
inline std::array<double, 3> EvaluatePaperSecondDerivatives(
  const sm::NURBSSurface& surface, int ku, int kv, double u, double v)
{
  const int p = surface.Degree[0];
  const int q = surface.Degree[1];
  const std::vector<PaperJet> nu = EvaluatePaperBasis(surface.Knots[0], p, ku, u);
  const std::vector<PaperJet> nv = EvaluatePaperBasis(surface.Knots[1], q, kv, v);
  double h[3][3][4] = {};
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      const std::array<double, 4>& point = surface.ControlPoints[(ku - p + i) +
        static_cast<std::size_t>(kv - q + j) * surface.NumberOfControlPoints[0]];
      for (int a = 0; a < 3; ++a)
      {
        for (int b = 0; a + b < 3; ++b)
        {
          for (int c = 0; c < 4; ++c)
          {
            h[a][b][c] += nu[i][a] * nv[j][b] * point[c];
          }
        }
      }
    }
  }
  std::array<double, 3> largest{};
  const double w = h[0][0][3];
  for (int c = 0; c < 3; ++c)
  {
    const double x = h[0][0][c] / w;
    const double xu = (h[1][0][c] - x * h[1][0][3]) / w;
    const double xv = (h[0][1][c] - x * h[0][1][3]) / w;
    const double second[3] = { (h[2][0][c] - 2.0 * xu * h[1][0][3] - x * h[2][0][3]) / w,
      (h[1][1][c] - xu * h[0][1][3] - xv * h[1][0][3] - x * h[1][1][3]) / w,
      (h[0][2][c] - 2.0 * xv * h[0][1][3] - x * h[0][2][3]) / w };
    for (int i = 0; i < 3; ++i)
    {
      largest[i] = std::max(largest[i], std::abs(second[i]));
    }
  }
  return largest;
}

/// Eq. 1-4 with the largest of samples x samples points of the sub-patch, corners included; 0: max(3, degree)
/// in each direction.
inline double SampleDeviation(
  const sm::NURBSSurface& surface, double u0, double u1, double v0, double v1, int samples = 0)
{
  const int ku = FindPaperSpan(surface, 0, 0.5 * (u0 + u1));
  const int kv = FindPaperSpan(surface, 1, 0.5 * (v0 + v1));
  const int columns = samples > 0 ? samples : std::max(3, surface.Degree[0]);
  const int rows = samples > 0 ? samples : std::max(3, surface.Degree[1]);
  double k[3] = {};
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const std::array<double, 3> d = EvaluatePaperSecondDerivatives(
        surface, ku, kv, u0 + (u1 - u0) * i / (columns - 1), v0 + (v1 - v0) * j / (rows - 1));
      for (int c = 0; c < 3; ++c)
      {
        k[c] = std::max(k[c], d[c]);
      }
    }
  }
  // Derivatives by (u - u0) / (u1 - u0): the unit domain with n = m = 1, or that of the knot interval with n
  // = m = k.
  const double width = u1 - u0;
  const double height = v1 - v0;
  return (k[0] * width * width + 2.0 * k[1] * width * height + k[2] * height * height) / 8.0;
}

/// A curved face, by Eq. 31 on every sub-patch weighed by its fraction (section 5.4), and Eq. 36.
inline PaperResult IntegrateCurved(
  const sm::Face& face, const PaperPolygons& polygons, const PaperOptions& options)
{
  PaperResult result;
  const std::vector<PaperPoint> rule = GetPaperRule(options.Points);
  const std::vector<double> breaks[2] = { face.Surface.GetSpanBreaks(0), face.Surface.GetSpanBreaks(1) };
  const auto border = [&breaks, &options](int direction, std::size_t i)
  {
    const std::size_t span = std::min(i / options.Factor, breaks[direction].size() - 2);
    const double start = breaks[direction][span];
    return start + (breaks[direction][span + 1] - start) * (i - span * options.Factor) / options.Factor;
  };
  const std::size_t columns = (breaks[0].size() - 1) * options.Factor;
  const std::size_t rows = (breaks[1].size() - 1) * options.Factor;
  for (std::size_t index = 0; index < columns * rows; ++index, ++result.SubPatches)
  {
    const double u0 = border(0, index % columns), u1 = border(0, index % columns + 1);
    const double v0 = border(1, index / columns), v1 = border(1, index / columns + 1);
    const double fraction =
      face.Loops.empty() ? 1.0 : GetPaperFraction(polygons, u0, u1, v0, v1, options.TextureFactor);
    PaperIntegrals integrals{};
    double projected = 0.0;
    for (const PaperPoint& b : rule)
    {
      for (const PaperPoint& a : rule)
      {
        const double weight = (u1 - u0) / 2.0 * (v1 - v0) / 2.0 * a[1] * b[1];
        const PaperIntegrals at = EvaluatePaperIntegrands(
          face, (u1 - u0) / 2.0 * a[0] + (u1 + u0) / 2.0, (v1 - v0) / 2.0 * b[0] + (v1 + v0) / 2.0);
        for (std::size_t c = 0; c < at.size(); ++c)
        {
          integrals[c] += weight * at[c];
        }
        projected += weight * std::abs(at[12]);
      }
    }
    for (std::size_t c = 0; c < integrals.size(); ++c)
    {
      result.Integrals[c] += fraction * integrals[c];
    }
    const double k = options.Deviation ? options.Deviation(face.Surface, u0, u1, v0, v1)
                                       : SampleDeviation(face.Surface, u0, u1, v0, v1);
    result.Estimate += fraction == 1.0 ? 2.0 * k * projected : 0.0;
    result.EstimateWithBoundary += fraction > 0.0 ? 2.0 * k * projected : 0.0;
  }
  return result;
}

/// A planar face bounded by polygons, by Green's theorem: the integral of f du dv is that of F dv along the
/// border, with F the integral of f du from the domain's start. f is a cubic, so 2 and 3 Gauss points are
/// exact.
inline PaperIntegrals IntegratePlane(const sm::Face& face, const PaperPolygons& polygons)
{
  PaperIntegrals integrals{};
  const double start = face.Surface.GetDomainStart(0);
  for (const std::vector<PaperPoint>& polygon : polygons)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const PaperPoint& a = polygon[i];
      const PaperPoint& b = polygon[(i + 1) % polygon.size()];
      for (const PaperPoint& along : GetPaperRule(3))
      {
        const double u = (b[0] - a[0]) / 2.0 * along[0] + (b[0] + a[0]) / 2.0;
        const double v = (b[1] - a[1]) / 2.0 * along[0] + (b[1] + a[1]) / 2.0;
        for (const PaperPoint& across : GetPaperRule(2))
        {
          const double weight = (b[1] - a[1]) / 2.0 * along[1] * (u - start) / 2.0 * across[1];
          const PaperIntegrals at =
            EvaluatePaperIntegrands(face, (u - start) / 2.0 * across[0] + (u + start) / 2.0, v);
          for (std::size_t c = 0; c < at.size(); ++c)
          {
            integrals[c] += weight * at[c];
          }
        }
      }
    }
  }
  return integrals;
}
}

#endif
