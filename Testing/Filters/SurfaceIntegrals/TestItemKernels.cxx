// The shaders' kernels compiled as C++: single panels, ribbons and caps against formulas, and against the same
// Gauss sums in extended precision, within the rounding that their rows state.
#include "Items/smBatchParameters.h"
#include "Items/smItemKernels.h"
#include "smGaussLegendre.h"
#include "smTesting.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <random>

namespace
{
using namespace smtest;
using Real = long double;
using Vector = std::array<Real, 3>;

constexpr double Unit = sm::UnitRoundoff;
constexpr double Pi = 3.14159265358979323846;

Vector operator+(const Vector& a, const Vector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}
Vector operator*(Real f, const Vector& a)
{
  return { f * a[0], f * a[1], f * a[2] };
}
Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
Real Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Real Bernstein(int n, int i, Real x)
{
  Real value = i < 0 || i > n ? 0.0L : 1.0L;
  for (int k = 1; k <= i && i <= n; ++k)
  {
    value *= static_cast<Real>(n - i + k) / k;
  }
  for (int k = 0; k < n && i >= 0 && i <= n; ++k)
  {
    value *= k < i ? x : 1.0L - x;
  }
  return value;
}
Real BernsteinSlope(int n, int i, Real x)
{
  return n == 0 ? 0.0L
                : n * ((i > 0 ? Bernstein(n - 1, i - 1, x) : 0.0L) - (i < n ? Bernstein(n - 1, i, x) : 0.0L));
}

/// A polynomial piece of `size` coordinates and its derivative.
void EvaluatePiece(const double* c, int size, int degree, Real x, Real* point, Real* slope)
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

void EvaluatePatch(const sm::FacePanels& face, Real s, Real r, Vector& x, Vector& xs, Vector& xr)
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

std::vector<sm::Integrand> MakeIntegrands()
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
Real EvaluateIntegrand(const sm::Integrand& f, const Vector& x, const Vector& n)
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

  Batch(const std::vector<sm::FacePanels>& faces, std::vector<sm::WorkItem> items, int along, int across,
    int lanes, const std::vector<Placement>& placements = {})
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

std::vector<sm::WorkItem> MakeItems(const sm::FacePanels& panels)
{
  sm::CutFace face;
  face.Panels = panels;
  if (!panels.Patches.empty())
  {
    face.Degree[0] = panels.Patches[0].Degree[0];
    face.Degree[1] = panels.Patches[0].Degree[1];
  }
  std::vector<sm::WorkItem> items;
  sm::AddItems(face, 0, items);
  return items;
}

/// Weights that differ by up to a factor `heavy` in one of five ways.
double MakeWeight(int kind, double heavy, int i, int p, std::mt19937& random)
{
  const bool isHeavy[] = { false, i == 0, i == p, i == (p + 1) / 2, false };
  const double common = 1.0 + 0.3 * std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  return kind == 4 ? std::pow(heavy, 1.0 - static_cast<double>(i) / p)
                   : common * (isHeavy[kind] ? heavy : 1.0);
}

/// As in smFacePanels.cxx: the largest step of the net.
void SetStretch(sm::FacePanels& face)
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
sm::FacePanels MakeRandomFace(int p, int q, std::mt19937& random, int kind = 0, double heavy = 1.0)
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

Sum SumPanel(const sm::FacePanels& face, int along, int across)
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

Sum SumRibbon(const sm::FacePanels& face, int along, int across)
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

double GetErrorOverRounding(const Sum& expected, const Evaluation& actual)
{
  double worst = 0.0;
  for (std::size_t k = 0; k < expected.Values.size(); ++k)
  {
    const auto error =
      static_cast<double>(std::abs(expected.Values[k] - static_cast<Real>(actual.GetValue(k))));
    worst = std::max(worst, error > 0.0 ? error / actual.GetRounding(static_cast<int>(k)) : 0.0);
  }
  return worst;
}

/// Within the stated rounding, which is no more than it need be.
void CheckSum(const std::string& what, const Sum& expected, const Evaluation& actual)
{
  double largest = 0.0;
  for (std::size_t k = 0; k < expected.Values.size(); ++k)
  {
    const double rounding = actual.GetRounding(static_cast<int>(k));
    largest = std::max(
      largest, expected.Sizes[k] > 0.0L ? rounding / (Unit * static_cast<double>(expected.Sizes[k])) : 0.0);
  }
  CheckRange(what + ": error over stated rounding", 0.0, GetErrorOverRounding(expected, actual), 1.0);
  // Positions of size up to 2, degrees up to 25 and the factors of Bounds.md: 8 (stretch / |Ss| + stretch / |Sr|).
  CheckRange(what + ": stated rounding over u", 1.0, largest, 4e3);
}

void CheckRandomItems()
{
  std::mt19937 random(5);
  const int degrees[][2] = { { 1, 1 }, { 1, 2 }, { 2, 2 }, { 3, 3 }, { 1, 3 }, { 2, 5 }, { 7, 9 },
    { 12, 25 } };
  for (const auto& degree : degrees)
  {
    const std::string name = std::to_string(degree[0]) + "," + std::to_string(degree[1]);
    const sm::FacePanels face = MakeRandomFace(degree[0], degree[1], random);
    std::vector<sm::WorkItem> items = MakeItems(face);
    const Evaluation panel(face, items[0], 7, 4);
    CheckSum("panel of degrees " + name, SumPanel(face, 7, 4), panel);
    CheckEqual("its evaluations", 28, panel.Result.Evaluations);
    CheckSum("ribbon of degrees " + name, SumRibbon(face, 6, 5), Evaluation(face, items[1], 6, 1));
    // The kernel for any degrees does the same operations as the one compiled for these.
    items[0].Degree[0] = items[0].Degree[1] = 0;
    CheckTrue("same bits by the kernel for any degrees", panel.Row == Evaluation(face, items[0], 7, 4).Row);
  }
}

/// Lanes of every width that this processor has, full and with one item less, against each item by itself: same bits.
void CheckLanes()
{
  std::mt19937 random(29);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const int degrees[][2] = { { 1, 1 }, { 1, 2 }, { 2, 2 }, { 3, 3 }, { 2, 5 }, { 12, 25 } };
  CheckRange("items side by side", 2, sm::GetLaneCounts().back(), sm::MostLanes);
  for (const int lanes : sm::GetLaneCounts())
  {
    for (const auto& degree : degrees)
    {
      for (int count = std::max(lanes - 1, 1); count <= lanes; ++count)
      {
        std::vector<sm::FacePanels> faces;
        std::vector<sm::WorkItem> items[3];
        std::vector<Placement> placements(count);
        for (int i = 0; i < count; ++i)
        {
          faces.push_back(MakeRandomFace(degree[0], degree[1], random, i % 4, 10.0));
          sm::Cap cap{ {}, {}, {}, true };
          for (std::array<double, 3>* point : { &cap.Apex, &cap.From, &cap.To })
          {
            std::generate(point->begin(), point->end(), [&]() { return uniform(random); });
          }
          faces.back().Caps.push_back(cap);
          const std::vector<sm::WorkItem> all = MakeItems(faces.back());
          for (int kind = 0; kind < 3; ++kind)
          {
            items[kind].push_back(all[kind]);
          }
          std::generate(placements[i].begin(), placements[i].end(), [&]() { return uniform(random); });
        }
        for (int kind = 0; kind < 3; ++kind)
        {
          const Batch together(
            faces, items[kind], 7, 4, lanes, kind == 1 ? placements : std::vector<Placement>{});
          std::vector<double> rows;
          for (int i = 0; i < count; ++i)
          {
            const Evaluation single(faces[i], items[kind][i], 7, 4, kind == 1 ? &placements[i] : nullptr);
            rows.insert(rows.end(), single.Row.begin(), single.Row.end());
          }
          CheckTrue("same bits in " + std::to_string(lanes) + " lanes, kind " + std::to_string(kind) +
              ", degrees " + std::to_string(degree[0]) + "," + std::to_string(degree[1]) + ", " +
              std::to_string(count) + " items",
            together.Rows == rows);
        }
      }
    }
  }
}

/// Rounding with heavy weights: at an end, in one column, falling off. Single items, for sums over many hide what one lacks.
void CheckHeavyWeights()
{
  std::mt19937 random(17);
  const int degrees[][2] = { { 2, 1 }, { 2, 2 }, { 3, 3 }, { 4, 4 }, { 7, 3 } };
  for (const double heavy : { 10.0, 1e2, 1e3, 1e4 })
  {
    double worst[2] = { 0.0, 0.0 };
    for (int trial = 0; trial < 200; ++trial)
    {
      const auto& degree = degrees[trial % 5];
      const sm::FacePanels face = MakeRandomFace(degree[0], degree[1], random, 1 + trial % 4, heavy);
      const std::vector<sm::WorkItem> items = MakeItems(face);
      worst[0] =
        std::max(worst[0], GetErrorOverRounding(SumPanel(face, 20, 20), Evaluation(face, items[0], 20, 20)));
      worst[1] =
        std::max(worst[1], GetErrorOverRounding(SumRibbon(face, 20, 5), Evaluation(face, items[1], 20, 1)));
    }
    const std::string name = "weights up to " + std::to_string(static_cast<int>(heavy));
    CheckRange(
      "panels with " + name + ": error over stated rounding", 0.0, worst[0], 0.5, "(no more than half)");
    CheckRange(
      "ribbons with " + name + ": error over stated rounding", 0.0, worst[1], 0.5, "(no more than half)");
  }
}

/// A quarter of a cylinder of radius 2, height 3 about the z axis through (5, 0, 0).
void CheckCylinder()
{
  const double w = std::sqrt(0.5);
  const double radius = 2.0;
  const double height = 3.0;
  sm::FacePanels face;
  face.Patches.push_back({ { 5.0, 0.0, 0.0 }, std::hypot(2 * radius, height), { 0.0, 0.0 }, { 1.0, 1.0 }, 0,
    { 1, 2 }, { height, 4 * radius }, {}, {}, 1.0 });
  for (const auto& [x, y, weight] : { std::array<double, 3>{ 1, 0, 1 }, { 1, 1, w }, { 0, 1, 1 } })
  {
    for (const double z : { height, 0.0 })
    {
      face.Points.push_back({ weight * radius * x, weight * radius * y, weight * z, weight });
    }
  }
  // The right edge s = 1: the whole patch.
  face.Coefficients = { 1.0, 0.0, 1.0, 1.0 };
  face.Panels.push_back({ 0, 0, 1, sm::PanelShape::General, false, false, 0.0, 1.0 });
  std::vector<sm::WorkItem> items = MakeItems(face);
  const Evaluation whole(face, items[0], 16, 4);
  const double area = 0.5 * Pi * radius * height;
  const double limit = 1e-14 * area * 5.0;
  Check("quarter cylinder: area", area, whole.GetValue(8), limit, "16 points, rho 4.6");
  Check("vector area x", -radius * height, -std::abs(whole.GetValue(5)), limit);
  Check("vector area y", -radius * height, -std::abs(whole.GetValue(6)), limit);
  Check("vector area z", 0.0, whole.GetValue(7), limit);
  const double sign = whole.GetValue(5) > 0.0 ? 1.0 : -1.0;
  // x.n = radius + 5 nx on the cylinder.
  Check("flux / 3", sign * (radius * area + 5.0 * radius * height) / 3.0, whole.GetValue(0), limit);
  // Moment x z of the area: z averages height / 2; x = 5 + radius cos.
  Check(
    "area moment x z", (5.0 * area + radius * radius * height) * height / 2.0, whole.GetValue(9), 10 * limit);

  for (const bool negative : { false, true })
  {
    face.Panels[0].Negative = negative;
    face.Panels[0].FlipNormal = !negative;
    const Evaluation changed(face, MakeItems(face)[0], 16, 4);
    CheckTrue(negative ? "negative coverage changes all signs" : "a flipped normal changes the flux's sign",
      changed.GetValue(0) == -whole.GetValue(0) &&
        changed.GetValue(8) == (negative ? -1 : 1) * whole.GetValue(8));
  }
  std::vector<sm::WorkItem> quarters;
  sm::BisectItem(items[0], 2, quarters);
  CheckEqual("quarters", 4, static_cast<long long>(quarters.size()));
  double sum[2] = { 0.0, 0.0 };
  for (const sm::WorkItem& quarter : quarters)
  {
    const Evaluation part(face, quarter, 12, 4);
    sum[0] += part.GetValue(0);
    sum[1] += part.GetValue(9);
  }
  Check("flux of the quarters", whole.GetValue(0), sum[0], limit);
  Check("moment of the quarters", whole.GetValue(9), sum[1], 10 * limit);
}

/// From the border y = 0 of a rectangle 2 x 3 at (10, 20, 30) to the line (., 20 - d, 30 + h): a flat strip.
void CheckRibbonFormulas()
{
  const double d = 0.3;
  const double h = 0.4;
  sm::FacePanels face;
  face.Patches.push_back({ { 10.0, 20.0, 30.0 }, std::hypot(2.0, 3.0), { 0.0, 0.0 }, { 1.0, 1.0 }, 0,
    { 1, 1 }, { 2.0, 3.0 }, {}, {}, 1.0 });
  face.Points = { { 0, 0, 0, 1 }, { 2, 0, 0, 1 }, { 0, 3, 0, 1 }, { 2, 3, 0, 1 } };
  face.Coefficients = { 0, 0, 1, 0, 10, 20 - d, 30 + h, 12, 20 - d, 30 + h };
  face.Ribbons.push_back({ 0, 0, 4, 1, 1, false, true, 0.0, 1.0, 0.0, 1.0, -1 });
  const Evaluation strip(face, MakeItems(face)[0], 3, 1);
  // X_l x X_t = (0, -d, h) x (2, 0, 0) = (0, 2 h, 2 d); the strip's middle is (11, 20 - d/2, 30 + h/2).
  const double limit = 64 * Unit * 60.0;
  const double flux = 20.0 * 2.0 * h + 30.0 * 2.0 * d;
  Check("ribbon: flux / 3", flux / 3.0, strip.GetValue(0), limit);
  Check("moment x", 11.0 * flux / 4.0, strip.GetValue(1), 11 * limit);
  Check("moment z", (30.0 + h / 2) * flux / 4.0, strip.GetValue(2), 30 * limit);
  Check("vector area y", 2 * h, strip.GetValue(6), limit);
  Check("vector area z", 2 * d, strip.GetValue(7), limit);
  Check("no area of a ribbon", 0.0, strip.GetValue(8), 0.0);
  Check("largest gap", 0.5, strip.Row[sm::RowLayout::LargestGap], limit);
  Check("squared gap", 2.0 * 0.25, strip.Row[sm::RowLayout::SquaredGap], limit);
  Check("gap area", 2.0 * 0.5, strip.Row[sm::RowLayout::GapArea], limit);
  CheckEqual("evaluations", 3, strip.Result.Evaluations);

  // Out of step with its edge by a twentieth: a gap is measured at its foot point.
  face.Ribbons[0].EdgeStart = 0.05;
  face.Ribbons[0].EdgeEnd = 1.05;
  const Evaluation late(face, MakeItems(face)[0], 3, 1);
  Check("largest gap out of step", 0.5, late.Row[sm::RowLayout::LargestGap], limit);
  Check("squared gap out of step", 0.5, late.Row[sm::RowLayout::SquaredGap], limit);

  face.Ribbons[0] = { 0, 0, 4, 1, 1, true, false, 0.0, 1.0, 0.0, 1.0, -1 };
  const Evaluation flipped(face, MakeItems(face)[0], 3, 1);
  CheckTrue(
    "flipped", flipped.GetValue(0) == -strip.GetValue(0) && flipped.GetValue(6) == -strip.GetValue(6));
  CheckTrue("no gap of a closing strip",
    flipped.Row[sm::RowLayout::LargestGap] == 0.0 && flipped.Row[sm::RowLayout::SquaredGap] == 0.0 &&
      flipped.Row[sm::RowLayout::GapArea] == 0.0);
  std::vector<sm::WorkItem> halves;
  sm::BisectItem(MakeItems(face)[0], 1, halves);
  CheckEqual("halves", 2, static_cast<long long>(halves.size()));
  Check("flux of the halves", flipped.GetValue(0),
    Evaluation(face, halves[0], 3, 1).GetValue(0) + Evaluation(face, halves[1], 3, 1).GetValue(0), limit);
}

/// The tetrahedron over the origin that a cap spans, by its vertices.
void CheckCapFormulas()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  // A rotation by 90 degrees about z, and a translation.
  const std::array<double, 12> placement = { 0, -1, 0, 3, 1, 0, 0, 5, 0, 0, 1, -2 };
  for (int i = 0; i < 4; ++i)
  {
    std::array<double, 3> corners[3];
    for (auto& corner : corners)
    {
      std::generate(corner.begin(), corner.end(), [&]() { return 4.0 + uniform(random); });
    }
    const bool isPlaced = i % 2 == 1;
    const bool isFlipped = i >= 2;
    sm::FacePanels face;
    face.Caps.push_back({ { 9, 9, 9 }, { 9, 9, 9 }, { 9, 9, 9 }, false });
    face.Caps.push_back({ corners[0], corners[1], corners[2], isFlipped });
    const Evaluation cap(face, MakeItems(face)[1], 5, 5, isPlaced ? &placement : nullptr);
    Vector v[3];
    for (int k = 0; k < 3; ++k)
    {
      const std::array<double, 3>& c = corners[k];
      v[k] = isPlaced ? Vector{ 3.0L - c[1], 5.0L + c[0], c[2] - 2.0L } : Vector{ c[0], c[1], c[2] };
    }
    const Real sign = isFlipped ? -1.0L : 1.0L;
    const Real volume = sign * Dot(v[0], Cross(v[1], v[2])) / 6.0L;
    const Vector sum = v[0] + v[1] + v[2];
    const Vector normal = 0.5L * sign * Cross(v[1] + -1.0L * v[0], v[2] + -1.0L * v[0]);
    Real xy = sum[0] * sum[1];
    Real yy = sum[1] * sum[1];
    for (const Vector& a : v)
    {
      xy += a[0] * a[1];
      yy += a[1] * a[1];
    }
    const Real expected[8] = { volume, volume * sum[0] / 4.0L, volume * sum[2] / 4.0L, volume * yy / 20.0L,
      volume * xy / 20.0L, normal[0], normal[1], normal[2] };
    const std::string name =
      std::string("cap") + (isFlipped ? ", flipped" : "") + (isPlaced ? ", placed: " : ": ");
    for (int k = 0; k < 8; ++k)
    {
      Check(name + MakeIntegrands()[k].Name, static_cast<double>(expected[k]), cap.GetValue(k),
        cap.GetRounding(k), "the rounding it states");
    }
    CheckEqual("points of caps do not count", 0, cap.Result.Evaluations);
  }
}
}

int TestItemKernels(int, char*[])
{
  CheckRandomItems();
  CheckLanes();
  CheckHeavyWeights();
  CheckCylinder();
  CheckRibbonFormulas();
  CheckCapFormulas();
  return Finish();
}
