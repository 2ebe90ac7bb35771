// The shaders' kernels compiled as C++: single panels, ribbons and caps against formulas, and against the
// same Gauss sums in extended precision, within the rounding that their rows state.
#include "smItemReference.h"
#include "smTesting.h"
#include "smUnitRoundoff.h"

#include <vtkMath.h>

#include <algorithm>
#include <random>

namespace
{
using namespace smtest;

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
    largest = std::max(largest,
      expected.Sizes[k] > 0.0L ? rounding / (sm::UnitRoundoff * static_cast<double>(expected.Sizes[k]))
                               : 0.0);
  }
  CheckRange(what + ": error over stated rounding", 0.0, GetErrorOverRounding(expected, actual), 1.0);
  // Positions of size up to 2, degrees up to 25 and the factors of Bounds.md: 8 (stretch / |Ss| + stretch /
  // |Sr|).
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
    sm::WorkItems items = MakeItems(face);
    const Evaluation panel(face, items[0], 7, 4);
    CheckSum("panel of degrees " + name, SumPanel(face, 7, 4), panel);
    CheckEqual("its evaluations", 28, panel.Result.Evaluations);
    CheckSum("ribbon of degrees " + name, SumRibbon(face, 6, 5), Evaluation(face, items[1], 6, 1));
    // The kernel for any degrees does the same operations as the one compiled for these.
    items[0].Degree[0] = items[0].Degree[1] = 0;
    CheckTrue("same bits by the kernel for any degrees", panel.Row == Evaluation(face, items[0], 7, 4).Row);
  }
}

/// Lanes of every width that this processor has, full and with one item less, against each item by itself:
/// same bits.
void CheckLanes()
{
  std::mt19937 random(29);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const int degrees[][2] = { { 1, 1 }, { 1, 2 }, { 2, 2 }, { 3, 3 }, { 2, 5 }, { 12, 25 } };
  CheckRange("items side by side", 2, sm::GetLaneCounts().back(), sm::MaxLanes);
  for (const int lanes : sm::GetLaneCounts())
  {
    for (const auto& degree : degrees)
    {
      for (int count = std::max(lanes - 1, 1); count <= lanes; ++count)
      {
        std::vector<sm::FacePanels> faces;
        sm::WorkItems items[3];
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
          const sm::WorkItems all = MakeItems(faces.back());
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

/// Rounding with heavy weights: at an end, in one column, falling off. Single items, for sums over many hide
/// what one lacks.
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
      const sm::WorkItems items = MakeItems(face);
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
  sm::WorkItems items = MakeItems(face);
  const Evaluation whole(face, items[0], 16, 4);
  const double area = 0.5 * vtkMath::Pi() * radius * height;
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
  sm::WorkItems quarters;
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
  const double limit = 64 * sm::UnitRoundoff * 60.0;
  const double flux = 20.0 * 2.0 * h + 30.0 * 2.0 * d;
  Check("ribbon: flux / 3", flux / 3.0, strip.GetValue(0), limit);
  Check("moment x", 11.0 * flux / 4.0, strip.GetValue(1), 11 * limit);
  Check("moment z", (30.0 + h / 2) * flux / 4.0, strip.GetValue(2), 30 * limit);
  Check("vector area y", 2 * h, strip.GetValue(6), limit);
  Check("vector area z", 2 * d, strip.GetValue(7), limit);
  Check("no area of a ribbon", 0.0, strip.GetValue(8), 0.0);
  Check("largest gap", 0.5, strip.Row[sm::RowLayout::MaxGap], limit);
  Check("squared gap", 2.0 * 0.25, strip.Row[sm::RowLayout::SquaredGap], limit);
  Check("gap area", 2.0 * 0.5, strip.Row[sm::RowLayout::GapArea], limit);
  CheckEqual("evaluations", 3, strip.Result.Evaluations);

  // Out of step with its edge by a twentieth: a gap is measured at its foot point.
  face.Ribbons[0].EdgeStart = 0.05;
  face.Ribbons[0].EdgeEnd = 1.05;
  const Evaluation late(face, MakeItems(face)[0], 3, 1);
  Check("largest gap out of step", 0.5, late.Row[sm::RowLayout::MaxGap], limit);
  Check("squared gap out of step", 0.5, late.Row[sm::RowLayout::SquaredGap], limit);

  face.Ribbons[0] = { 0, 0, 4, 1, 1, true, false, 0.0, 1.0, 0.0, 1.0, -1 };
  const Evaluation flipped(face, MakeItems(face)[0], 3, 1);
  CheckTrue(
    "flipped", flipped.GetValue(0) == -strip.GetValue(0) && flipped.GetValue(6) == -strip.GetValue(6));
  CheckTrue("no gap of a closing strip",
    flipped.Row[sm::RowLayout::MaxGap] == 0.0 && flipped.Row[sm::RowLayout::SquaredGap] == 0.0 &&
      flipped.Row[sm::RowLayout::GapArea] == 0.0);
  sm::WorkItems halves;
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
