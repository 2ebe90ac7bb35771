#include "Detail/smVariantChain.h"

#include "smGaussLegendre.h"

#include <cmath>

namespace sm
{
namespace
{
void Resize(VariantSample& sample, int variables)
{
  for (std::vector<double>* values : { &sample.Position, &sample.First, &sample.Second })
  {
    values->resize(3 * static_cast<std::size_t>(variables));
  }
}

const double* GetRule(int points)
{
  return GetRuleTable().data() + static_cast<std::ptrdiff_t>(points) * (points - 1);
}

constexpr int StripPoints = 3;
}

void VisitPanel(const VariantFaceChain& chain, const VariantPanel& panel,
  const std::function<void(const VariantSample&)>& visit)
{
  const VariantPatch& patch = chain.Patches[panel.Patch];
  PatchBasis basis;
  VariantSample sample;
  Resize(sample, patch.Variables);
  VisitPanelNodes(chain, panel,
    [&](double weight, double s, double r)
    {
      patch.FillBasis(s, r, basis);
      patch.Sample(basis, sample.Position.data(), sample.First.data(), sample.Second.data(), false);
      sample.Weight = weight;
      visit(sample);
    });
}

void VisitRibbon(const VariantFaceChain& chain, const VariantRibbon& ribbon,
  const std::function<void(const VariantSample&)>& visit)
{
  const VariantPatch& patch = chain.Patches[ribbon.Patch];
  const int variables = patch.Variables;
  const double* ruleL = GetRule(StripPoints);
  VariantSample sample;
  Resize(sample, variables);
  VisitRibbonNodes(chain, ribbon,
    [&](const RibbonNode& node)
    {
      for (int k = 0; k < StripPoints; ++k)
      {
        const double l = ruleL[2 * k];
        for (int c = 0; c < 3; ++c)
        {
          for (int a = 0; a < variables; ++a)
          {
            const std::size_t i = static_cast<std::size_t>(c) * variables + a;
            sample.Position[i] = patch.Centers[a][c] + (1.0 - l) * node.Face[i] + l * node.Edge[i];
            sample.First[i] = node.Edge[i] - node.Face[i];
            sample.Second[i] = (1.0 - l) * node.FaceTangent[i] + l * node.EdgeTangent[i];
          }
        }
        sample.Weight = ribbon.Sign * node.Weight * ruleL[2 * k + 1];
        visit(sample);
      }
    });
}

void VisitCap(const VariantCap& cap, int variables, const std::function<void(const VariantSample&)>& visit)
{
  const double* rule = GetRule(StripPoints);
  VariantSample sample;
  Resize(sample, variables);
  for (int i = 0; i < StripPoints; ++i)
  {
    for (int k = 0; k < StripPoints; ++k)
    {
      const double t = rule[2 * i];
      const double l = rule[2 * k];
      for (int c = 0; c < 3; ++c)
      {
        for (int a = 0; a < variables; ++a)
        {
          const double apex = cap.Corners[0][c][a];
          const double from = cap.Corners[1][c][a];
          const double to = cap.Corners[2][c][a];
          const std::size_t at = static_cast<std::size_t>(c) * variables + a;
          sample.Position[at] = (1.0 - l) * apex + l * ((1.0 - t) * from + t * to);
          sample.First[at] = from - apex;
          sample.Second[at] = to - apex;
        }
      }
      sample.Weight = cap.Sign * rule[2 * i + 1] * rule[2 * k + 1] * l;
      visit(sample);
    }
  }
}

int FindEdgePiece(const EdgeCurve& curve, const Ribbon& ribbon, double start, double width)
{
  const double middle = start + 0.5 * width * (ribbon.Start + ribbon.End);
  const int found = curve.FindPiece(middle);
  const auto getDistance = [&](int piece)
  {
    const double first = curve.Breaks[piece];
    return std::abs(
      first + 0.5 * (ribbon.EdgeStart + ribbon.EdgeEnd) * (curve.Breaks[piece + 1] - first) - middle);
  };
  int best = found;
  for (const int piece : { found - 1, found + 1 })
  {
    if (piece >= 0 && piece < curve.GetNumberOfPieces() && getDistance(piece) < getDistance(best))
    {
      best = piece;
    }
  }
  return best;
}

void EvaluateTrim(const double* trim, int degree, double t, double point[2], double slope[2])
{
  std::array<double, 2> coefficients[MaximumDegree + 1] = {};
  for (int i = 0; i <= degree; ++i)
  {
    coefficients[i] = { trim[2 * i], trim[2 * i + 1] };
  }
  std::array<double, 2> derivative;
  const std::array<double, 2> value = BernsteinPiece<2>{ coefficients, degree }.Evaluate(t, &derivative);
  for (int d = 0; d < 2; ++d)
  {
    point[d] = value[d];
    slope[d] = derivative[d];
    // A line of constant parameter stays one.
    bool isConstant = true;
    for (int i = 1; i <= degree; ++i)
    {
      isConstant = isConstant && trim[2 * i + d] == trim[d];
    }
    point[d] = isConstant ? trim[d] : point[d];
    slope[d] = isConstant ? 0.0 : slope[d];
  }
}

void VisitPanelNodes(const VariantFaceChain& chain, const VariantPanel& panel,
  const std::function<void(double weight, double s, double r)>& visit)
{
  const double* ruleT = GetRule(panel.Along);
  const double* ruleX = GetRule(panel.Across);
  const double width = panel.End - panel.Start;
  const double across = panel.AcrossEnd - panel.AcrossStart;
  for (int i = 0; i < panel.Along; ++i)
  {
    double point[2];
    double slope[2];
    EvaluateTrim(chain.Coefficients.data() + panel.Trim, panel.TrimDegree, panel.Start + width * ruleT[2 * i],
      point, slope);
    for (int k = 0; k < panel.Across; ++k)
    {
      visit(panel.Sign * ruleT[2 * i + 1] * ruleX[2 * k + 1] * width * across * slope[1] * point[0],
        (panel.AcrossStart + across * ruleX[2 * k]) * point[0], point[1]);
    }
  }
}

void VisitRibbonNodes(const VariantFaceChain& chain, const VariantRibbon& ribbon,
  const std::function<void(const RibbonNode&)>& visit)
{
  const VariantPatch& patch = chain.Patches[ribbon.Patch];
  const int variables = patch.Variables;
  const std::size_t size = 3 * static_cast<std::size_t>(variables);
  const double* rule = GetRule(ribbon.Along);
  const double width = ribbon.End - ribbon.Start;
  const double edgeWidth = ribbon.EdgeEnd - ribbon.EdgeStart;
  PatchBasis basis;
  RibbonNode node;
  for (std::vector<double>* values : { &node.Face, &node.Edge, &node.FaceTangent, &node.EdgeTangent })
  {
    values->resize(size);
  }
  std::vector<double> second(size);
  for (int i = 0; i < ribbon.Along; ++i)
  {
    double point[2];
    double slope[2];
    EvaluateTrim(chain.Coefficients.data() + ribbon.Trim, ribbon.TrimDegree,
      ribbon.Start + width * rule[2 * i], point, slope);
    patch.FillBasis(point[0], point[1], basis);
    patch.Sample(basis, node.Face.data(), node.FaceTangent.data(), second.data(), true);
    for (std::size_t k = 0; k < size; ++k)
    {
      node.FaceTangent[k] = width * (slope[0] * node.FaceTangent[k] + slope[1] * second[k]);
    }
    const double e = ribbon.EdgeStart + edgeWidth * rule[2 * i];
    const int n = ribbon.EdgeDegree + 1;
    for (int a = 0; a < variables; ++a)
    {
      std::array<double, 3> coefficients[MaximumDegree + 1] = {};
      for (int k = 0; k < n; ++k)
      {
        const double* from =
          chain.Coefficients.data() + ribbon.Edge + 3 * (static_cast<std::ptrdiff_t>(n) * a + k);
        coefficients[k] = { from[0], from[1], from[2] };
      }
      std::array<double, 3> tangent;
      const std::array<double, 3> value =
        BernsteinPiece<3>{ coefficients, ribbon.EdgeDegree }.Evaluate(e, &tangent);
      for (int c = 0; c < 3; ++c)
      {
        node.Edge[static_cast<std::size_t>(c) * variables + a] = value[c];
        node.EdgeTangent[static_cast<std::size_t>(c) * variables + a] = edgeWidth * tangent[c];
      }
    }
    node.Weight = rule[2 * i + 1];
    visit(node);
  }
}

void VisitSamples(const VariantFaceChain& chain, const std::function<void(const VariantSample&)>& visit)
{
  for (const VariantPanel& panel : chain.Panels)
  {
    VisitPanel(chain, panel, visit);
  }
  for (const VariantRibbon& ribbon : chain.Ribbons)
  {
    VisitRibbon(chain, ribbon, visit);
  }
  for (const VariantCap& cap : chain.Caps)
  {
    VisitCap(cap, chain.GetNumberOfVariables(), visit);
  }
}

std::int64_t CountSamples(const VariantFaceChain& chain)
{
  std::int64_t count = 0;
  for (const VariantPanel& panel : chain.Panels)
  {
    count += static_cast<std::int64_t>(panel.Along) * panel.Across;
  }
  for (const VariantRibbon& ribbon : chain.Ribbons)
  {
    count += static_cast<std::int64_t>(ribbon.Along) * StripPoints;
  }
  return count;
}
}
