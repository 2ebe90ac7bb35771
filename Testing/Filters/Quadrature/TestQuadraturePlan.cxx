// The plan of a face's orders: the rules it chooses, run in extended precision, err by no more than the
// bounds it states, on random patches, trims and ribbons; and the bounds are within the tolerance.
#include "smReferencePanels.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace smtest;

/// A face of one patch with one panel and one ribbon.
struct Case
{
  sm::Face Face;
  sm::FacePanels Panels;
};

using Random = std::mt19937_64;

double Uniform(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A patch over about [0,1]^2 of a size 1, a trim piece from bottom to top, an edge curve at a distance `gap`
/// from it. `plane`: an oblique parallelogram. The control points of a pole are `spread` apart.
Case MakeCase(Random& random, double bend, double weights, bool pole, double gap, double slant,
  bool plane = false, double spread = 0.0)
{
  Case made;
  const int p = plane ? 1 : std::uniform_int_distribution<int>(1, 5)(random);
  const int q = plane ? 1 : std::uniform_int_distribution<int>(1, 5)(random);
  sm::Patch patch{};
  patch.Degree[0] = p;
  patch.Degree[1] = q;
  patch.Width[0] = patch.Width[1] = 1.0;
  patch.FirstPoint = 0;
  for (double& c : patch.Center)
  {
    c = Uniform(random, -2.0, 2.0);
  }
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      const double w = std::pow(weights, Uniform(random, 0.0, 1.0));
      double x = static_cast<double>(i) / p - 0.5 + bend * Uniform(random, -0.5, 0.5) / p;
      double y = static_cast<double>(j) / q - 0.5 + bend * Uniform(random, -0.5, 0.5) / q;
      double z = bend * Uniform(random, -0.5, 0.5);
      if (pole && j == 0)
      {
        x = 0.1 + spread * std::cos(7.0 * i);
        y = -0.6 + spread * std::sin(7.0 * i);
        z = 0.2;
      }
      if (plane)
      {
        z = 0.7 * x + 0.3 * y;
        x = 0.9 * x - 0.4 * y;
      }
      made.Panels.Points.push_back({ w * x, w * y, w * z, w });
    }
  }
  sm::MeasurePatch(made.Panels.Points.data(), patch);
  made.Panels.Patches.push_back(patch);
  const int degree = std::uniform_int_distribution<int>(1, 5)(random);
  const int edgeDegree = std::uniform_int_distribution<int>(0, 4)(random);
  const double r0 = Uniform(random, 0.0, 0.5);
  const double r1 = Uniform(random, 0.5, 1.0);
  const double s0 = Uniform(random, 0.2, 1.0);
  for (int i = 0; i <= degree; ++i)
  {
    made.Panels.Coefficients.push_back(std::clamp(s0 + slant * Uniform(random, -0.7, 0.7), 0.0, 1.0));
    made.Panels.Coefficients.push_back(r0 + (r1 - r0) * i / degree);
  }
  const auto edge = static_cast<std::uint32_t>(made.Panels.Coefficients.size());
  made.Panels.Panels.push_back(
    { 0, 0, static_cast<std::uint8_t>(degree), sm::PanelShape::General, false, false, 0.0, 1.0 });
  made.Panels.Ribbons.push_back({ 0, 0, edge, static_cast<std::uint8_t>(degree),
    static_cast<std::uint8_t>(edgeDegree), false, false, 0.0, 1.0, 0.0, 1.0, -1 });
  for (int i = 0; i <= edgeDegree; ++i)
  {
    // Some polynomial near the boundary.
    Real point[2];
    Real slope[2];
    const ReferencePanels reference(made.Panels);
    reference.EvaluateTrim(
      patch, 0, degree, edgeDegree == 0 ? 0.5L : static_cast<Real>(i) / edgeDegree, point, slope);
    Vector x;
    Vector ds;
    Vector dr;
    reference.EvaluatePatch(0, point[0], point[1], x, ds, dr);
    for (int d = 0; d < 3; ++d)
    {
      made.Panels.Coefficients.push_back(static_cast<double>(x[d]) + gap * Uniform(random, -1.0, 1.0));
    }
  }
  return made;
}

struct Score
{
  int Exceeded = 0;
  int Estimated = 0;
  int Above = 0;
  double MaxRatio = 0.0;
  std::int64_t Points = 0;
};

void Run(const Case& made, double weights, double tolerance, const std::string& label, Score& score)
{
  sm::PlanRequest request;
  request.Classes = Classes;
  request.Tolerances.assign(Count, tolerance);
  const sm::FacePlan plan = sm::PlanFace(made.Face, made.Panels, request);
  Values sum{};
  Values exact{};
  const ReferencePanels reference(made.Panels);
  for (const sm::PlannedItem& item : plan.Items)
  {
    const int factor = item.Compared ? 2 : 1;
    const Values rule = reference.Integrate(item, factor * item.Along, factor * item.Across);
    const Values fine = reference.IntegrateFinely(item);
    for (int k = 0; k < Count; ++k)
    {
      sum[k] += rule[k];
      exact[k] += fine[k];
    }
  }
  score.Estimated += plan.Estimated ? 1 : 0;
  score.Points += plan.Evaluations;
  for (int k = 0; k < Count; ++k)
  {
    // The area of compared panels has no bound here.
    if (plan.Estimated && Classes[k].Kind == sm::BoundClass::AreaMoment)
    {
      continue;
    }
    const double error = static_cast<double>(std::abs(sum[k] - exact[k]));
    const double bound = plan.QuadratureBound[k];
    // Some thousand terms of order 1 in extended precision.
    const double rounding = 1e-17;
    score.MaxRatio = std::max(score.MaxRatio, error / (bound + rounding));
    if (!(error <= bound + rounding))
    {
      ++score.Exceeded;
      std::printf("%s, class %d: error %.3e, bound %.3e\n", label.c_str(), k, error, bound);
    }
    // The rounding of a wide gap's series is added to the bound, whatever the tolerance.
    if (!(bound <= tolerance + 1e-15 + 1e-12 * weights))
    {
      ++score.Above;
      std::printf("%s, class %d: bound %.3e, tolerance %.3e\n", label.c_str(), k, bound, tolerance);
    }
  }
}

void RunFamily(double weights, double bend, bool pole, double tolerance, int count, bool plane = false)
{
  char label[100];
  std::snprintf(label, sizeof(label), "weights 1:%g, bend %g%s, tolerance %g", weights, bend,
    pole      ? ", pole"
      : plane ? ", plane"
              : "",
    tolerance);
  Score score;
  for (int seed = 1; seed <= count; ++seed)
  {
    Random random(static_cast<unsigned int>(seed));
    const double gap = std::pow(10.0, -Uniform(random, 0.5, 12.0));
    const Case made = MakeCase(random, bend, weights, pole, gap, seed % 3 == 0 ? 0.0 : 0.5, plane);
    Run(made, weights, tolerance, std::string(label) + ", seed " + std::to_string(seed), score);
  }
  std::printf("%s: %d estimated, largest error/bound %.2g, %.0f points a case\n", label, score.Estimated,
    score.MaxRatio, static_cast<double>(score.Points) / count);
  CheckTrue(std::string(label) + ": no bound exceeded", score.Exceeded == 0);
  CheckTrue(std::string(label) + ": bounds within the tolerance", score.Above == 0);
  CheckTrue(std::string(label) + ": bounds say something", score.MaxRatio > 1e-9);
}

/// On a plane an edge that is the image of the trim curve leaves no ribbon: its gap is known to be rounding.
void CheckNarrowRibbons(int count)
{
  int kept = 0;
  for (int seed = 1; seed <= count; ++seed)
  {
    Random random(static_cast<unsigned int>(seed));
    Case made = MakeCase(random, 0.0, 1.0, false, 0.0, 0.5, true);
    sm::Ribbon& ribbon = made.Panels.Ribbons[0];
    const int degree = ribbon.TrimDegree;
    const ReferencePanels reference(made.Panels);
    std::vector<Vector> points;
    for (int i = 0; i <= degree; ++i)
    {
      Vector ds;
      Vector dr;
      points.emplace_back();
      reference.EvaluatePatch(
        0, made.Panels.Coefficients[2 * i], made.Panels.Coefficients[2 * i + 1], points.back(), ds, dr);
    }
    // The same curve, every other time with a degree that is one higher.
    const int raised = degree + seed % 2;
    made.Panels.Coefficients.resize(ribbon.Edge);
    for (int i = 0; i <= raised; ++i)
    {
      const Real x = raised == degree ? 0.0L : static_cast<Real>(i) / raised;
      for (int d = 0; d < 3; ++d)
      {
        made.Panels.Coefficients.push_back(static_cast<double>(
          (i <= degree ? (1.0L - x) * points[i][d] : 0.0L) + (i > 0 ? x * points[i - 1][d] : 0.0L)));
      }
    }
    ribbon.EdgeDegree = static_cast<std::uint8_t>(raised);
    ribbon.Start = ribbon.EdgeStart = seed % 3 == 0 ? 0.25 : 0.0;
    ribbon.End = ribbon.EdgeEnd = seed % 5 == 0 ? 0.75 : 1.0;
    sm::PlanRequest request;
    request.Classes = Classes;
    request.Tolerances.assign(Count, 1e-12);
    for (const sm::PlannedItem& item : sm::PlanFace(made.Face, made.Panels, request).Items)
    {
      kept += item.Kind == sm::ItemKind::Ribbon ? 1 : 0;
    }
  }
  CheckEqual("ribbons on planes that are kept though they are rounding", 0, kept);
}

/// A patch of one cell, and a straight trim piece over `cells` of them that runs through it for a short way.
/// Its control points are those of an affine map, bent by `bend`, times weights of 1 to `weights` in all four
/// combinations of the directions' ends.
Case MakeLongPiece(Random& random, double cells, double bend, double weights)
{
  Case made;
  sm::Patch patch{};
  for (int d = 0; d < 2; ++d)
  {
    patch.Degree[d] = weights > 1.0 ? 2 : std::uniform_int_distribution<int>(1, bend > 0.0 ? 1 : 3)(random);
    patch.Width[d] = Uniform(random, 0.1, 10.0);
    patch.Start[d] = Uniform(random, -1.0, 1.0) * cells * patch.Width[d];
  }
  const auto fraction = [&patch](int i, int d) { return static_cast<double>(i) / patch.Degree[d]; };
  const double corner[4] = { 1.0, std::pow(weights, Uniform(random, 0.0, 1.0)),
    std::pow(weights, Uniform(random, 0.0, 1.0)), std::pow(weights, Uniform(random, 0.0, 1.0)) };
  double skew[3][2];
  for (double(&row)[2] : skew)
  {
    row[0] = Uniform(random, -0.5, 0.5);
    row[1] = Uniform(random, -0.5, 0.5);
  }
  // The weight is bilinear, and so is the position with weights of 1: their product in Bernstein form.
  const auto blend = [](int i, int n, const auto& term) {
    return n == 1 ? term(i, i) : i == 1 ? 0.5 * (term(0, 1) + term(1, 0)) : term(i / 2, i / 2);
  };
  for (int j = 0; j <= patch.Degree[1]; ++j)
  {
    for (int i = 0; i <= patch.Degree[0]; ++i)
    {
      std::array<double, 4> point{ 0.0, 0.0, 0.0, 1.0 };
      for (int c = 0; c < 4; ++c)
      {
        const auto position = [&](double s, double r)
        {
          return c == 3
            ? 1.0
            : skew[c][0] * (2.0 * s - 1.0) + skew[c][1] * (2.0 * r - 1.0) + (c == 2 ? bend * s * r : 0.0);
        };
        point[c] = weights > 1.0
          ? blend(i, 2,
              [&](int si, int wi)
              { return blend(j, 2, [&](int sj, int wj) { return position(si, sj) * corner[wi + 2 * wj]; }); })
          : position(fraction(i, 0), fraction(j, 1));
      }
      made.Panels.Points.push_back(point);
    }
  }
  sm::MeasurePatch(made.Panels.Points.data(), patch);
  made.Panels.Patches.push_back(patch);
  // The piece passes through (s, r) = inside at its parameter `start`.
  const double start = Uniform(random, 0.1, 0.9);
  const double end = start + 0.02 / cells;
  made.Panels.Coefficients.resize(4);
  for (int d = 0; d < 2; ++d)
  {
    const double inside = Uniform(random, 0.49, 0.51);
    const double toward = Uniform(random, 0.49, 0.51);
    const double slope = (toward - inside) / (end - start);
    for (int i = 0; i <= 1; ++i)
    {
      made.Panels.Coefficients[2 * i + d] = patch.Start[d] + patch.Width[d] * (inside + slope * (i - start));
    }
  }
  made.Panels.Ribbons.push_back({ 0, 0, 4, 1, 3, false, false, start, end, 0.0, 1.0, -1 });
  return made;
}

/// An edge that is the image of the trim curve, as far as extended precision and then doubles show: ribbons
/// whose gap is nothing but rounding are left out, and the bound is to hold what they were.
void CheckDroppedRibbons(double cells, double bend, double weights, int count)
{
  char label[100];
  std::snprintf(label, sizeof(label), "pieces over %g cells, bend %g, weights 1:%g", cells, bend, weights);
  int dropped = 0;
  int exceeded = 0;
  double largest = 0.0;
  for (int seed = 1; seed <= count; ++seed)
  {
    Random random(static_cast<unsigned int>(seed));
    Case made = MakeLongPiece(random, cells, bend, weights);
    const sm::Ribbon& ribbon = made.Panels.Ribbons[0];
    const sm::Patch& patch = made.Panels.Patches[0];
    // The cubic that is the image at four Chebyshev nodes: its values there, at thirds, and its Bernstein
    // coefficients.
    const ReferencePanels reference(made.Panels);
    const sm::ChebyshevRule& nodes = sm::ChebyshevRule::Get(4);
    Vector thirds[4] = {};
    for (int k = 0; k < 4; ++k)
    {
      const Real x = 0.5L * (1.0L + nodes.GetNode(k));
      Real point[2];
      Real slope[2];
      reference.EvaluateTrim(
        patch, 0, 1, ribbon.Start + (static_cast<Real>(ribbon.End) - ribbon.Start) * x, point, slope);
      Vector image;
      Vector ds;
      Vector dr;
      reference.EvaluatePatch(0, point[0], point[1], image, ds, dr);
      for (int i = 0; i < 4; ++i)
      {
        Real factor = 1;
        for (int j = 0; j < 4; ++j)
        {
          const Real y = 0.5L * (1.0L + nodes.GetNode(j));
          factor *= j == k ? 1 : (static_cast<Real>(i) / 3 - y) / (x - y);
        }
        for (int d = 0; d < 3; ++d)
        {
          thirds[i][d] += factor * image[d];
        }
      }
    }
    const int rows[4][4] = { { 6, 0, 0, 0 }, { -5, 18, -9, 2 }, { 2, -9, 18, -5 }, { 0, 0, 0, 6 } };
    for (const int(&row)[4] : rows)
    {
      for (int d = 0; d < 3; ++d)
      {
        made.Panels.Coefficients.push_back(static_cast<double>(
          (row[0] * thirds[0][d] + row[1] * thirds[1][d] + row[2] * thirds[2][d] + row[3] * thirds[3][d]) /
          6));
      }
    }
    sm::PlanRequest request;
    request.Classes = Classes;
    request.Tolerances.assign(Count, 1e-12);
    const sm::FacePlan plan = sm::PlanFace(made.Face, made.Panels, request);
    if (!plan.Items.empty())
    {
      continue;
    }
    ++dropped;
    const auto exact = ReferencePanelsOf<Quad>(made.Panels).IntegrateFinely({ sm::ItemKind::Ribbon, 0 });
    for (int k = 0; k < Count; ++k)
    {
      const double ratio = plan.QuadratureBound[k] > 0.0
        ? std::abs(static_cast<double>(exact[k])) / plan.QuadratureBound[k]
        : 0.0;
      largest = std::max(largest, ratio);
      exceeded += ratio <= 1.0 ? 0 : 1;
    }
  }
  std::printf("%s: %d of %d dropped, largest integral/bound %.3g\n", label, dropped, count, largest);
  CheckEqual(std::string(label) + ": dropped ribbons beyond their bound", 0, exceeded);
  CheckTrue(std::string(label) + ": ribbons are dropped", 4 * dropped >= count);
}

/// A pole whose control points differ by rounding, of doubles or of the digits of a file, is planned as one
/// that is a point, and the bounds hold what that changes.
void CheckRoundedPoles(double tolerance, int count)
{
  std::int64_t minimum = 0;
  for (const double spread : { 0.0, 1e-15, 1e-14, 1e-12, 1e-11 })
  {
    Score score;
    for (int seed = 1; seed <= count; ++seed)
    {
      Random random(static_cast<unsigned int>(seed));
      const Case made = MakeCase(random, 0.3, 2.0, true, 1e-3, 0.5, false, spread);
      char label[60];
      std::snprintf(label, sizeof(label), "pole with a spread of %g, seed %d", spread, seed);
      Run(made, 2.0, tolerance, label, score);
    }
    minimum = spread == 0.0 ? score.Points : minimum;
    std::printf("poles with a spread of %g, tolerance %g: %d estimated, %g times as many points\n", spread,
      tolerance, score.Estimated, static_cast<double>(score.Points) / static_cast<double>(minimum));
    CheckTrue("poles that are rounded: no bound exceeded", score.Exceeded == 0);
    // A motion may take a quarter of the tolerance, and some digits count as its derivatives.
    CheckRange("and they cost no more", 0.5, static_cast<double>(score.Points) / static_cast<double>(minimum),
      tolerance >= 500.0 * spread ? 1.1 : 1000.0);
  }
}

/// The magnitude that a face may have if it is not evaluated is that of its whole chain: of its caps, too.
void CheckMagnitudes(int count)
{
  double largest = 0.0;
  int exceeded = 0;
  for (int seed = 1; seed <= count; ++seed)
  {
    Random random(static_cast<unsigned int>(seed));
    Case made = MakeCase(random, 0.4, 2.0, false, 0.01, 0.5);
    sm::Cap cap{};
    for (std::array<double, 3>* corner : { &cap.Apex, &cap.From, &cap.To })
    {
      for (double& coordinate : *corner)
      {
        coordinate = 100.0 * Uniform(random, -1.0, 1.0);
      }
    }
    made.Panels.Caps.push_back(cap);
    sm::PlanRequest request;
    request.Classes = Classes;
    request.Tolerances.assign(Count, 1e-9);
    const sm::FacePlan plan = sm::PlanFace(made.Face, made.Panels, request);
    Values sum = ReferencePanels::IntegrateCap(cap);
    const ReferencePanels reference(made.Panels);
    for (const sm::PlannedItem& item : plan.Items)
    {
      const Values values = item.Kind == sm::ItemKind::Cap ? Values{} : reference.IntegrateFinely(item);
      for (int k = 0; k < Count; ++k)
      {
        sum[k] += values[k];
      }
    }
    for (int k = 0; k < Count; ++k)
    {
      const double ratio = static_cast<double>(std::abs(sum[k])) / plan.Magnitude[k];
      largest = std::max(largest, ratio);
      exceeded += ratio <= 1.0 ? 0 : 1;
    }
  }
  std::printf("magnitudes: largest value/bound %.2g\n", largest);
  CheckEqual("magnitudes exceeded", 0, exceeded);
  CheckRange("and they are not much too large", 0.1, largest, 1.0);
}
}

/// TestQuadraturePlan [CASES]
int TestQuadraturePlan(int argc, char* argv[])
{
  const int count = argc > 1 ? std::atoi(argv[1]) : 3;
  for (const double weights : { 1.0, 2.0, 30.0 })
  {
    for (const double bend : { 0.0, 0.4, 1.0 })
    {
      for (const double tolerance : { 1e-4, 1e-9, 1e-12 })
      {
        RunFamily(weights, bend, false, tolerance, count);
        RunFamily(weights, bend, true, tolerance, count);
      }
    }
  }
  for (const double tolerance : { 1e-4, 1e-9, 1e-12 })
  {
    RunFamily(1.0, 0.0, false, tolerance, 20 * count, true);
  }
  CheckNarrowRibbons(20 * count);
  for (const double cells : { 1.0, 30.0, 1000.0 })
  {
    CheckDroppedRibbons(cells, 0.0, 1.0, 100 * count);
    CheckDroppedRibbons(cells, 1e-4, 1.0, 100 * count);
    CheckDroppedRibbons(cells, 0.5, 1.0, 100 * count);
    CheckDroppedRibbons(cells, 0.0, 30.0, 100 * count);
  }
  CheckRoundedPoles(1e-9, 5 * count);
  CheckRoundedPoles(1e-12, 5 * count);
  CheckMagnitudes(10 * count);
  return Finish();
}
