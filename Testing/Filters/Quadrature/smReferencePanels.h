/**
 * @file smReferencePanels.h
 * @brief Panels and ribbons integrated in a wider precision, by formulas of their own: the truth for plans of
 * orders
 */
#ifndef smReferencePanels_h
#define smReferencePanels_h

#include "smExactMoments.h"
#include "smGaussRule.h"
#include "smQuadraturePlan.h"
#include "smReferenceBernstein.h"

#include <array>
#include <cmath>
#include <vector>

namespace smtest
{
inline const std::vector<sm::BoundClass> Classes = { { sm::BoundClass::VolumeMoment, 0 },
  { sm::BoundClass::VolumeMoment, 1 }, { sm::BoundClass::VolumeMoment, 2 }, { sm::BoundClass::VectorArea, 0 },
  { sm::BoundClass::AreaMoment, 0 } };
// One integrand of each class.
constexpr int Count = 5;
using Values = std::array<Real, Count>;

#ifdef __SIZEOF_FLOAT128__
/// Used for errors as small as the rounding of 80-bit long double. On other platforms long double is not
/// wider than double, or is quadruple itself.
__extension__ using Quad = __float128;
#else
using Quad = long double;
#endif

/// The Gauss-Legendre rule of n points on [0,1] in extended precision.
inline const GaussRule& GetRule(int n)
{
  static std::vector<GaussRule> rules(100);
  GaussRule& rule = rules[n];
  if (rule.Nodes.empty())
  {
    rule = MakeGaussRule(n);
  }
  return rule;
}

/// All Bernstein polynomials of degree n <= 63 at x, by raising the degree, and their derivatives.
template <class Real>
struct Basis
{
  Basis(int n, Real x)
  {
    this->Values[0] = 1;
    this->Slopes[0] = 0;
    for (int degree = 1; degree <= n; ++degree)
    {
      this->Slopes[degree] = degree * this->Values[degree - 1];
      this->Values[degree] = x * this->Values[degree - 1];
      for (int i = degree - 1; i > 0; --i)
      {
        this->Slopes[i] = degree * (this->Values[i - 1] - this->Values[i]);
        this->Values[i] = (1 - x) * this->Values[i] + x * this->Values[i - 1];
      }
      this->Slopes[0] = -degree * this->Values[0];
      this->Values[0] *= 1 - x;
    }
  }
  std::array<Real, 64> Values, Slopes;
};

template <class Real>
std::array<Real, 3> Cross(const std::array<Real, 3>& a, const std::array<Real, 3>& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

template <class Real>
Real Dot(const std::array<Real, 3>& a, const std::array<Real, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
class ReferencePanelsOf
{
public:
  using Vector = std::array<Real, 3>;
  using Values = std::array<Real, Count>;

  explicit ReferencePanelsOf(const sm::FacePanels& panels)
    : Panels(panels)
  {
  }

  /// A whole cap. Three points in either direction are exact for these integrands.
  static Values IntegrateCap(const sm::Cap& cap)
  {
    Vector sides[2];
    for (int d = 0; d < 3; ++d)
    {
      sides[0][d] = static_cast<Real>(cap.From[d]) - cap.Apex[d];
      sides[1][d] = static_cast<Real>(cap.To[d]) - cap.Apex[d];
    }
    const Vector normal = Cross(sides[0], sides[1]);
    const GaussRule& rule = GetRule(5);
    Values values{};
    for (int i = 0; i < 5; ++i)
    {
      for (int j = 0; j < 5; ++j)
      {
        const Real l = rule.Nodes[i];
        const Real t = rule.Nodes[j];
        Vector x;
        for (int d = 0; d < 3; ++d)
        {
          x[d] = cap.Apex[d] + l * ((1 - t) * sides[0][d] + t * sides[1][d]);
        }
        Add(values, rule.Weights[i] * rule.Weights[j] * l, x, normal, false);
      }
    }
    return values;
  }

  /// A part of the item by a rule of `along` times `across` points.
  Values Integrate(const sm::PlannedItem& item, int along, int across) const
  {
    return item.Kind == sm::ItemKind::Panel ? this->IntegratePanel(item, along, across)
                                            : this->IntegrateRibbon(item, along);
  }

  /// Integrates the item by many points on six parts of it.
  Values IntegrateFinely(const sm::PlannedItem& item) const
  {
    Values sum{};
    for (int a = 0; a < 3; ++a)
    {
      for (int b = 0; b < (item.Kind == sm::ItemKind::Panel ? 2 : 1); ++b)
      {
        sm::PlannedItem part = item;
        part.Start = item.Start + (item.End - item.Start) * a / 3;
        part.End = a == 2 ? item.End : item.Start + (item.End - item.Start) * (a + 1) / 3;
        if (item.Kind == sm::ItemKind::Panel)
        {
          const double middle = 0.5 * (item.XiStart + item.XiEnd);
          part.XiStart = b == 0 ? item.XiStart : middle;
          part.XiEnd = b == 0 ? middle : item.XiEnd;
        }
        const Values values = this->Integrate(part, 36, 36);
        for (int k = 0; k < Count; ++k)
        {
          sum[k] += values[k];
        }
      }
    }
    return sum;
  }

  /// The control points of a patch's curve at one r, and their derivatives by r.
  struct Row
  {
    std::array<std::array<Real, 4>, 64> Points, Slopes;
  };

  Row MakeRow(std::uint32_t index, Real r) const
  {
    const sm::Patch& patch = this->Panels.Patches[index];
    const int p = patch.Degree[0];
    const Basis across(patch.Degree[1], r);
    Row row;
    for (int i = 0; i <= p; ++i)
    {
      row.Points[i] = {};
      row.Slopes[i] = {};
      for (int j = 0; j <= patch.Degree[1]; ++j)
      {
        for (int c = 0; c < 4; ++c)
        {
          const Real value = this->Panels.Points[patch.FirstPoint + i + (p + 1) * j][c];
          row.Points[i][c] += across.Values[j] * value;
          row.Slopes[i][c] += across.Slopes[j] * value;
        }
      }
    }
    return row;
  }

  void EvaluateRow(const sm::Patch& patch, const Row& row, Real s, Vector& x, Vector& ds, Vector& dr) const
  {
    const Basis along(patch.Degree[0], s);
    Real h[3][4] = {};
    for (int i = 0; i <= patch.Degree[0]; ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        h[0][c] += along.Values[i] * row.Points[i][c];
        h[1][c] += along.Slopes[i] * row.Points[i][c];
        h[2][c] += along.Values[i] * row.Slopes[i][c];
      }
    }
    for (int c = 0; c < 3; ++c)
    {
      x[c] = h[0][c] / h[0][3];
      ds[c] = (h[1][c] - h[1][3] * x[c]) / h[0][3];
      dr[c] = (h[2][c] - h[2][3] * x[c]) / h[0][3];
      x[c] += patch.Center[c];
    }
  }

  void EvaluatePatch(std::uint32_t index, Real s, Real r, Vector& x, Vector& ds, Vector& dr) const
  {
    this->EvaluateRow(this->Panels.Patches[index], this->MakeRow(index, r), s, x, ds, dr);
  }

  /// In the parameters of the patch.
  void EvaluateTrim(
    const sm::Patch& patch, std::uint32_t first, int degree, Real t, Real point[2], Real slope[2]) const
  {
    for (int d = 0; d < 2; ++d)
    {
      point[d] = slope[d] = 0;
      for (int i = 0; i <= degree; ++i)
      {
        const Real c =
          (static_cast<Real>(this->Panels.Coefficients[first + 2 * i + d]) - patch.Start[d]) / patch.Width[d];
        point[d] += Bernstein(degree, i, t) * c;
        slope[d] += BernsteinSlope(degree, i, t) * c;
      }
    }
  }

  static void Add(Values& values, Real weight, const Vector& x, const Vector& n, bool withArea)
  {
    const Real flux = Dot(x, n);
    values[0] += weight * flux / 3;
    values[1] += weight * flux * x[1] / 4;
    values[2] += weight * flux * x[0] * x[2] / 5;
    values[3] += weight * n[2];
    values[4] += withArea ? weight * std::sqrt(static_cast<smtest::Real>(Dot(n, n))) : 0;
  }

private:
  Values IntegratePanel(const sm::PlannedItem& item, int along, int across) const
  {
    const sm::Panel& panel = this->Panels.Panels[item.Index];
    const sm::Patch& patch = this->Panels.Patches[panel.Patch];
    const Real width = panel.End - panel.Start;
    const Real t0 = panel.Start + width * item.Start;
    const Real t1 = panel.Start + width * item.End;
    const Real xi0 = item.XiStart;
    const Real xi1 = item.XiEnd;
    Values values{};
    const GaussRule& ruleT = GetRule(along);
    const GaussRule& ruleX = GetRule(across);
    for (int i = 0; i < along; ++i)
    {
      Real point[2];
      Real slope[2];
      this->EvaluateTrim(patch, panel.Trim, panel.TrimDegree, t0 + (t1 - t0) * ruleT.Nodes[i], point, slope);
      const Row row = this->MakeRow(panel.Patch, point[1]);
      for (int j = 0; j < across; ++j)
      {
        Vector x;
        Vector ds;
        Vector dr;
        this->EvaluateRow(patch, row, (xi0 + (xi1 - xi0) * ruleX.Nodes[j]) * point[0], x, ds, dr);
        Add(values, ruleT.Weights[i] * ruleX.Weights[j] * (t1 - t0) * (xi1 - xi0) * point[0] * slope[1], x,
          Cross(ds, dr), true);
      }
    }
    return values;
  }

  Values IntegrateRibbon(const sm::PlannedItem& item, int along) const
  {
    const sm::Ribbon& ribbon = this->Panels.Ribbons[item.Index];
    const sm::Patch& patch = this->Panels.Patches[ribbon.Patch];
    const Real fraction0 = item.Start;
    const Real fraction1 = item.End;
    const Real trimWidth = ribbon.End - ribbon.Start;
    const Real edgeWidth = ribbon.EdgeEnd - ribbon.EdgeStart;
    Values values{};
    const GaussRule& ruleT = GetRule(along);
    const GaussRule& ruleL = GetRule(5);
    for (int i = 0; i < along; ++i)
    {
      const Real t = fraction0 + (fraction1 - fraction0) * ruleT.Nodes[i];
      const Real e = ribbon.EdgeStart + edgeWidth * t;
      Real point[2];
      Real slope[2];
      this->EvaluateTrim(patch, ribbon.Trim, ribbon.TrimDegree, ribbon.Start + trimWidth * t, point, slope);
      Vector a;
      Vector ds;
      Vector dr;
      this->EvaluatePatch(ribbon.Patch, point[0], point[1], a, ds, dr);
      Vector c{};
      Vector dc{};
      for (int k = 0; k <= ribbon.EdgeDegree; ++k)
      {
        for (int d = 0; d < 3; ++d)
        {
          const double value = this->Panels.Coefficients[ribbon.Edge + 3 * k + d];
          c[d] += Bernstein(ribbon.EdgeDegree, k, e) * value;
          dc[d] += BernsteinSlope(ribbon.EdgeDegree, k, e) * value;
        }
      }
      for (int j = 0; j < 5; ++j)
      {
        const Real l = ruleL.Nodes[j];
        Vector x;
        Vector along3;
        Vector width;
        for (int d = 0; d < 3; ++d)
        {
          x[d] = (1 - l) * a[d] + l * c[d];
          along3[d] = (1 - l) * trimWidth * (slope[0] * ds[d] + slope[1] * dr[d]) + l * edgeWidth * dc[d];
          width[d] = c[d] - a[d];
        }
        Add(values, ruleT.Weights[i] * ruleL.Weights[j] * (fraction1 - fraction0), x, Cross(width, along3),
          false);
      }
    }
    return values;
  }

  const sm::FacePanels& Panels;
};

using ReferencePanels = ReferencePanelsOf<Real>;
}

#endif
