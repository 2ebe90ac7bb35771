#include "Detail/smPatchLines.h"

#include "smGaussLegendre.h"
#include "smUnitRoundoff.h"

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

/// Nodes of an item along and across: twice as many where it is compared.
std::array<int, 2> GetRuleSizes(const PlannedItem& item)
{
  const int factor = item.Compared ? 2 : 1;
  return { std::min(factor * item.Along, MaximumRuleSize), std::min(factor * item.Across, MaximumRuleSize) };
}

void AddLines(const PatchTask& task, const PlannedItem& item, std::vector<PatchLine>& lines)
{
  const Patch& patch = task.GetPatch();
  const Panel& panel = task.Panels->Panels[item.Index];
  const double* trim = task.Panels->Coefficients.data() + panel.Trim;
  const auto [along, across] = GetRuleSizes(item);
  const double* rule = GetRuleTable().data() + along * (along - 1);
  const double width = panel.End - panel.Start;
  const double start = panel.Start + width * item.Start;
  const double tWidth = width * (item.End - item.Start);
  PatchLine line;
  line.Coverage = panel.Negative ? -1.0 : 1.0;
  line.Side = panel.FlipNormal ? -1.0 : 1.0;
  line.Growth = BoundBasis(*task.Panels, panel);
  line.XiStart = item.XiStart;
  line.XiWidth = item.XiEnd - item.XiStart;
  line.Across = across;
  // Coefficients far from the patch round its parameters by more, in units of its width.
  double reach = 1.0;
  for (int i = 0; i <= panel.TrimDegree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      reach = std::max(reach, std::abs(trim[2 * i + d]) / patch.Width[d]);
    }
  }
  line.TrimRounding = 3.0 * reach;
  for (int a = 0; a < along; ++a)
  {
    const TrimPoint at = EvaluateTrim(trim, panel.TrimDegree, patch, start + tWidth * rule[2 * a]);
    line.EdgeS = at.S;
    line.R = at.R;
    line.Weight = rule[2 * a + 1] * tWidth * at.SlopeR * line.XiWidth;
    lines.push_back(line);
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

PatchConstants MakePatchConstants(const PatchTask& task)
{
  const Patch& patch = task.GetPatch();
  PatchConstants constants;
  for (int c = 0; c < 3; ++c)
  {
    constants.Origin[c] = patch.Center[c] + task.Shift[c];
  }
  constants.Radius = patch.Radius;
  // A net that is off by d has differences (w_i+1 d_i+1 - w_i d_i), and with Radius d in StretchOf() its
  // derivatives are at most 2 p d times the ratio of neighbours' weights.
  const double moved = std::hypot(task.Moved[0] + patch.Displacement[0],
    task.Moved[1] + patch.Displacement[1], task.Moved[2] + patch.Displacement[2]);
  const double ratio = std::max(1.0, patch.WeightRatio);
  constants.Off = moved / UnitRoundoff;
  for (int d = 0; d < 2; ++d)
  {
    constants.Stretch[d] = patch.Stretch[d];
    constants.OffSlope[d] = 2.0 * patch.Degree[d] * ratio * moved / UnitRoundoff;
  }
  // A polynomial has at most 3 roundings a degree and a sum over the net one for each term: 4 (p + q) and a
  // few more for a numerator, and as many for the weight that it is divided by. Differences, quotients and
  // products of a tangent are the rest. All polynomials and weights are positive, so that these are relative
  // errors.
  constants.Roundings = 8.0 * (patch.Degree[0] + patch.Degree[1]) + 24.0;
  std::size_t lines = 0;
  int longest = 1;
  for (const PlannedItem& item : task.Plan->Items)
  {
    const auto [along, across] = GetRuleSizes(item);
    lines += along;
    longest = std::max(longest, across);
  }
  constants.Additions = static_cast<double>(lines) + longest;
  return constants;
}

std::vector<PatchLine> MakePatchLines(const PatchTask& task)
{
  std::vector<PatchLine> lines;
  for (const PlannedItem& item : task.Plan->Items)
  {
    AddLines(task, item, lines);
  }
  return lines;
}

DerivedBasis::DerivedBasis(int degree, double x)
{
  FillBernsteinBasis(degree, x, this->Values);
  FillBernsteinBasis(degree - 1, x, this->Lower);
  this->Lower[degree] = 0.0;
  FillBernsteinSlopes(degree, this->Lower, this->Slopes);
}
}
