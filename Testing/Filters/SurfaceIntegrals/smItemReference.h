/**
 * @file smItemReference.h
 * @brief Random faces of one panel and one ribbon, and the Gauss sums of their items in extended precision
 */
#ifndef smItemReference_h
#define smItemReference_h

#include "Items/smBatchParameters.h"
#include "Items/smItemKernels.h"
#include "smGaussLegendre.h"
#include "smReferenceBernstein.h"

#include <algorithm>
#include <random>

namespace smtest
{
using Real = long double;
using Vector = std::array<Real, 3>;

inline Vector operator+(const Vector& a, const Vector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}
inline Vector operator*(Real f, const Vector& a)
{
  return { f * a[0], f * a[1], f * a[2] };
}
inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
inline Real Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A polynomial piece of `size` coordinates and its derivative.
inline void EvaluatePiece(const double* c, int size, int degree, Real x, Real* point, Real* slope)
{
  std::fill_n(point, size, 0.0L);
  std::fill_n(slope, size, 0.0L);
  for (int i = 0; i <= degree; ++i)
  {
    const Real value = Bernstein(degree, i, x);
    const Real derivative = BernsteinSlope(degree, i, x);
    for (int d = 0; d < size; ++d)
    {
      point[d] += value * c[size * i + d];
      slope[d] += derivative * c[size * i + d];
    }
  }
}

inline void EvaluatePatch(const sm::FacePanels& face, Real s, Real r, Vector& x, Vector& xs, Vector& xr)
{
  const sm::Patch& patch = face.Patches[0];
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  Real h[3][4] = {};
  for (int i = 0; i <= p; ++i)
  {
    const Real basis = Bernstein(p, i, s);
    const Real slope = BernsteinSlope(p, i, s);
    for (int j = 0; j <= q; ++j)
    {
      const Real products[3] = { basis * Bernstein(q, j, r), slope * Bernstein(q, j, r),
        basis * BernsteinSlope(q, j, r) };
      for (int d = 0; d < 4; ++d)
      {
        const Real c = face.Points[patch.FirstPoint + i + j * (p + 1)][d];
        for (int k = 0; k < 3; ++k)
        {
          h[k][d] += products[k] * c;
        }
      }
    }
  }
  for (int d = 0; d < 3; ++d)
  {
    const Real offset = h[0][d] / h[0][3];
    x[d] = patch.Center[d] + offset;
    xs[d] = (h[1][d] - h[1][3] * offset) / h[0][3];
    xr[d] = (h[2][d] - h[2][3] * offset) / h[0][3];
  }
}

inline std::vector<sm::Integrand> MakeIntegrands()
{
  using sm::Integrand;
  return { Integrand::VolumeMoment("V", 0, 0, 0), Integrand::VolumeMoment("x", 1, 0, 0),
    Integrand::VolumeMoment("z", 0, 0, 1), Integrand::VolumeMoment("yy", 0, 2, 0),
    Integrand::VolumeMoment("xy", 1, 1, 0), Integrand::VectorArea("Nx", 0), Integrand::VectorArea("Ny", 1),
    Integrand::VectorArea("Nz", 2), Integrand::AreaMoment("A", 0, 0, 0),
    Integrand::AreaMoment("Axz", 1, 0, 1), Integrand::VolumeMoment("xyz", 1, 1, 1),
    Integrand::VolumeMoment("xxxzz", 3, 0, 2) };
}

/// Weight times integrand at a sample.
inline Real EvaluateIntegrand(const sm::Integrand& f, const Vector& x, const Vector& n)
{
  Real monomial = 1.0L;
  for (int d = 0; d < 3; ++d)
  {
    for (int i = 0; i < f.Powers[d]; ++i)
    {
      monomial *= x[d];
    }
  }
  switch (f.Form)
  {
    case sm::Integrand::Kind::VolumeMoment:
      return Dot(x, n) * monomial / (3 + f.Degree);
    case sm::Integrand::Kind::AreaMoment:
      return std::sqrt(Dot(n, n)) * monomial;
    default:
      return f.Powers[0] * n[0] + f.Powers[1] * n[1] + f.Powers[2] * n[2];
  }
}

using Placement = std::array<double, 12>;

/// Items of one shape evaluated side by side, each of a face of its own, with whatever orders.
struct Batch
{
  sm::ItemRunner::Setup Setup;
  sm::RowLayout Layout;
  std::vector<double> Rows;
  std::vector<sm::KernelResult> Results;

  Batch(const std::vector<sm::FacePanels>& faces, sm::WorkItems items, int along, int across, int lanes,
    const std::vector<Placement>& placements = {})
    : Results(items.size())
  {
    this->Setup.Integrands = MakeIntegrands();
    this->Setup.StripPoints = 5;
    this->Setup.UsePlacements = !placements.empty();
    this->Layout = sm::RowLayout(this->Setup.Integrands);
    this->Rows.assign(items.size() * this->Layout.GetStride(), 0.0);
    std::vector<sm::ItemRunner::BatchFace> slots;
    std::vector<sm::KernelItem> kernelItems;
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      slots.push_back({ i, std::vector<double>(this->Setup.Integrands.size(), 0.0),
        placements.empty() ? Placement{} : placements[i] });
      sm::SetItemOrders(items[i], { along, across, true, true }, false);
      items[i].Work.Item[2] = items[i].Work.Item[3] = static_cast<std::uint32_t>(i);
      kernelItems.push_back({ &faces[i], &items[i] });
    }
    const sm::BatchParameters parameters(slots, this->Setup.UsePlacements);
    const sm::SampleFormulas formulas(this->Setup.Integrands, this->Layout);
    const sm::KernelData data = { &this->Setup, &this->Layout, &formulas, parameters.Values.data(),
      parameters.ToleranceOffset, parameters.PlacementOffset, this->Rows.data() };
    sm::KernelScratch scratch(this->Layout);
    sm::EvaluateItems(
      data, kernelItems.data(), static_cast<int>(items.size()), lanes, scratch, this->Results.data());
  }
};

/// One item by itself.
struct Evaluation
{
  sm::RowLayout Layout;
  std::vector<double> Row;
  sm::KernelResult Result;

  Evaluation(const sm::FacePanels& face, const sm::WorkItem& item, int along, int across,
    const Placement* placement = nullptr)
  {
    const Batch batch({ face }, { item }, along, across, 1,
      placement ? std::vector<Placement>{ *placement } : std::vector<Placement>{});
    this->Layout = batch.Layout;
    this->Row = batch.Rows;
    this->Result = batch.Results[0];
  }
  double GetValue(int k) const { return this->Row[this->Layout.GetValue(k)]; }
  double GetRounding(int k) const { return this->Row[this->Layout.GetRounding(k)]; }
};

inline sm::WorkItems MakeItems(const sm::FacePanels& panels)
{
  sm::CutFace face;
  face.Panels = panels;
  if (!panels.Patches.empty())
  {
    face.Degree[0] = panels.Patches[0].Degree[0];
    face.Degree[1] = panels.Patches[0].Degree[1];
  }
  sm::WorkItems items;
  sm::AddItems(face, 0, items);
  return items;
}

/// Weights that differ by up to a factor `heavy` in one of five ways.
inline double MakeWeight(int kind, double heavy, int i, int p, std::mt19937& random)
{
  const bool isHeavy[] = { false, i == 0, i == p, i == (p + 1) / 2, false };
  const double common = 1.0 + 0.3 * std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  return kind == 4 ? std::pow(heavy, 1.0 - static_cast<double>(i) / p)
                   : common * (isHeavy[kind] ? heavy : 1.0);
}

/// As in smFacePanels.cxx: the largest step of the net.
inline void SetStretch(sm::FacePanels& face)
{
  sm::Patch& patch = face.Patches[0];
  const int row = patch.Degree[0] + 1;
  for (int direction = 0; direction < 2; ++direction)
  {
    for (int j = 0; j <= patch.Degree[1] - direction; ++j)
    {
      for (int i = 0; i <= patch.Degree[0] - (1 - direction); ++i)
      {
        const std::array<double, 4>& a = face.Points[patch.FirstPoint + i + row * j];
        const std::array<double, 4>& b =
          face.Points[patch.FirstPoint + i + row * j + (direction == 0 ? 1 : row)];
        const double step = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        patch.Stretch[direction] = std::max(patch.Stretch[direction],
          patch.Degree[direction] * (step + std::abs(b[3] - a[3]) * patch.Radius) / std::min(a[3], b[3]));
      }
    }
  }
}

/// A patch of random points and weights, a trim piece near its diagonal, an edge piece near the trim's image.
inline sm::FacePanels MakeRandomFace(int p, int q, std::mt19937& random, int kind = 0, double heavy = 1.0)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  sm::FacePanels face;
  face.Patches.push_back(
    { { 0.3, -0.2, 0.7 }, 0.0, { 2.0, -1.0 }, { 3.0, 0.5 }, 1, { p, q }, {}, {}, {}, 1.0 });
  face.Points.push_back({ 0.0, 0.0, 0.0, 0.0 });
  double& radius = face.Patches[0].Radius;
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      const double w = MakeWeight(kind, heavy, i, p, random);
      const double x[3] = { 2.0 * i / p - 1.0 + 0.2 * uniform(random),
        2.0 * j / q - 1.0 + 0.2 * uniform(random), 0.5 * uniform(random) };
      face.Points.push_back({ w * x[0], w * x[1], w * x[2], w });
      radius = std::max(radius, std::hypot(x[0], x[1], x[2]));
    }
  }
  SetStretch(face);
  const int degree = 3;
  face.Coefficients.push_back(0.0);
  for (int i = 0; i <= degree; ++i)
  {
    face.Coefficients.push_back(2.0 + 3.0 * (0.2 + 0.6 * i / degree + 0.1 * uniform(random)));
    face.Coefficients.push_back(-1.0 + 0.5 * (0.1 + 0.8 * i / degree + 0.1 * uniform(random)));
  }
  face.Panels.push_back({ 0, 1, degree, sm::PanelShape::General, false, false, 0.125, 0.875 });
  const auto edge = static_cast<std::uint32_t>(face.Coefficients.size());
  for (int i = 0; i <= 4; ++i)
  {
    for (int d = 0; d < 3; ++d)
    {
      face.Coefficients.push_back((d < 2 ? 0.4 * i - 0.8 : 0.5) + 0.2 * uniform(random));
    }
  }
  face.Ribbons.push_back({ 0, 1, edge, degree, 4, false, true, 0.125, 0.875, 0.25, 0.75, 0 });
  return face;
}

struct Sum
{
  std::vector<Real> Values = std::vector<Real>(MakeIntegrands().size(), 0.0L);
  std::vector<Real> Sizes = Values;
  void Add(Real weight, const Vector& x, const Vector& n, bool chainOnly)
  {
    static const std::vector<sm::Integrand> integrands = MakeIntegrands();
    for (std::size_t k = 0; k < integrands.size(); ++k)
    {
      if (!chainOnly || integrands[k].ClosedChain)
      {
        const Real value = weight * EvaluateIntegrand(integrands[k], x, n);
        this->Values[k] += value;
        this->Sizes[k] += std::sqrt(Dot(n, n)) * std::abs(weight);
      }
    }
  }
};

/// The rule that the kernels use, in double precision.
struct Rule
{
  explicit Rule(int points) { sm::ComputeGaussLegendre(points, this->Nodes, this->Weights); }
  std::vector<double> Nodes;
  std::vector<double> Weights;
};

inline Sum SumPanel(const sm::FacePanels& face, int along, int across)
{
  const sm::Patch& patch = face.Patches[0];
  const sm::Panel& panel = face.Panels[0];
  const Rule ruleT(along);
  const Rule ruleX(across);
  Sum sum;
  for (int i = 0; i < along; ++i)
  {
    Real uv[2];
    Real duv[2];
    const Real width = static_cast<Real>(panel.End) - panel.Start;
    EvaluatePiece(
      &face.Coefficients[panel.Trim], 2, panel.TrimDegree, panel.Start + width * ruleT.Nodes[i], uv, duv);
    const Real edge = (uv[0] - patch.Start[0]) / patch.Width[0];
    const Real r = (uv[1] - patch.Start[1]) / patch.Width[1];
    for (int j = 0; j < across; ++j)
    {
      Vector x;
      Vector xs;
      Vector xr;
      EvaluatePatch(face, ruleX.Nodes[j] * edge, r, x, xs, xr);
      sum.Add(static_cast<Real>(ruleT.Weights[i]) * ruleX.Weights[j] * width * duv[1] / patch.Width[1] * edge,
        x, Cross(xs, xr), false);
    }
  }
  return sum;
}

inline Sum SumRibbon(const sm::FacePanels& face, int along, int across)
{
  const sm::Patch& patch = face.Patches[0];
  const sm::Ribbon& ribbon = face.Ribbons[0];
  const Rule ruleT(along);
  const Rule ruleL(across);
  Sum sum;
  for (int i = 0; i < along; ++i)
  {
    Real uv[2];
    Real duv[2];
    const Real width = static_cast<Real>(ribbon.End) - ribbon.Start;
    EvaluatePiece(
      &face.Coefficients[ribbon.Trim], 2, ribbon.TrimDegree, ribbon.Start + width * ruleT.Nodes[i], uv, duv);
    Vector a;
    Vector as;
    Vector ar;
    EvaluatePatch(
      face, (uv[0] - patch.Start[0]) / patch.Width[0], (uv[1] - patch.Start[1]) / patch.Width[1], a, as, ar);
    const Vector da = width * (duv[0] / patch.Width[0] * as + duv[1] / patch.Width[1] * ar);
    const Real edgeWidth = static_cast<Real>(ribbon.EdgeEnd) - ribbon.EdgeStart;
    Vector c;
    Vector dc;
    EvaluatePiece(&face.Coefficients[ribbon.Edge], 3, ribbon.EdgeDegree,
      ribbon.EdgeStart + edgeWidth * ruleT.Nodes[i], c.data(), dc.data());
    for (int j = 0; j < across; ++j)
    {
      const Vector x = (1.0L - ruleL.Nodes[j]) * a + static_cast<Real>(ruleL.Nodes[j]) * c;
      const Vector xt = (1.0L - ruleL.Nodes[j]) * da + (ruleL.Nodes[j] * edgeWidth) * dc;
      sum.Add(static_cast<Real>(ruleT.Weights[i]) * ruleL.Weights[j], x, Cross(c + -1.0L * a, xt), true);
    }
  }
  return sum;
}
}

#endif
