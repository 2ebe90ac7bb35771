#include "Detail/smVariantDevicePoints.h"

#include "smBernstein.h"
#include "smGaussLegendre.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Variables, the first included, for which `isMoved` holds.
template <typename Predicate>
std::vector<int> SelectVariables(int count, const Predicate& isMoved)
{
  std::vector<int> selected{ 0 };
  for (int a = 1; a < count; ++a)
  {
    if (isMoved(a))
    {
      selected.push_back(a);
    }
  }
  return selected;
}

std::vector<int> FindVariables(const VariantPatch& patch)
{
  const int size = 3 * patch.GetNumberOfPoints();
  return SelectVariables(patch.Variables,
    [&](int a)
    {
      const auto first = patch.Points.begin() + static_cast<std::ptrdiff_t>(a) * size;
      return std::any_of(first, first + size, [](double x) { return x != 0.0; }) ||
        std::any_of(patch.Centers[a].begin(), patch.Centers[a].end(), [](double x) { return x != 0.0; });
    });
}

/// Bernstein polynomials of a degree, and their derivatives.
void FillDerivedBasis(int degree, double x, std::vector<double>& basis, std::vector<double>& derivatives)
{
  basis.resize(degree + 1);
  derivatives.resize(degree + 1);
  std::vector<double> lower(degree + 1, 0.0);
  FillBernsteinBasis(degree, x, basis.data());
  FillBernsteinBasis(degree - 1, x, lower.data());
  FillBernsteinSlopes(degree, lower.data(), derivatives.data());
}

/// The weight of a patch at a point.
double EvaluateWeight(
  const VariantPatch& patch, const std::vector<double>& basisS, const std::vector<double>& basisR)
{
  if (patch.IsPolynomial)
  {
    return patch.Weights.front();
  }
  double sum = 0.0;
  for (std::size_t j = 0; j < basisR.size(); ++j)
  {
    for (std::size_t i = 0; i < basisS.size(); ++i)
    {
      sum += basisS[i] * basisR[j] * patch.Weights[j * basisS.size() + i];
    }
  }
  return sum;
}
}

DevicePointsWriter::DevicePointsWriter()
  : One(1)
  , Totals(One)
  , Map(One, {}, One)
{
  constexpr int points = 3;
  const double* rule = GetRuleTable().data() + static_cast<std::ptrdiff_t>(points) * (points - 1);
  for (int i = 0; i < points; ++i)
  {
    this->Result.Numbers.insert(
      this->Result.Numbers.end(), { 1.0 - rule[2 * i], rule[2 * i], rule[2 * i + 1] });
  }
}

std::uint32_t DevicePointsWriter::AddList(const VariantFaceChain& chain, const std::vector<int>& variables)
{
  const auto first = static_cast<std::uint32_t>(this->Result.Words.size());
  for (std::size_t k = 1; k < variables.size(); ++k)
  {
    this->Result.Words.push_back(static_cast<std::uint32_t>(chain.Directions[variables[k] - 1]));
  }
  return first;
}

void DevicePointsWriter::AddItem(
  const GroupKey& key, const std::vector<std::uint32_t>& words, std::size_t cost, std::size_t steps)
{
  Items& items = this->Groups[key];
  items.Words.insert(items.Words.end(), words.begin(), words.end());
  items.Costs.push_back(static_cast<std::uint32_t>(cost));
  items.Steps.push_back(static_cast<std::uint32_t>(steps));
}

/// [variable][number]: the centre, then the points.
std::uint32_t DevicePointsWriter::AddMatrix(const VariantPatch& patch, const std::vector<int>& variables)
{
  std::vector<double>& numbers = this->Result.Numbers;
  const auto first = static_cast<std::uint32_t>(numbers.size());
  const int count = patch.GetNumberOfPoints();
  for (const int a : variables)
  {
    numbers.insert(numbers.end(), patch.Centers[a].begin(), patch.Centers[a].end());
    for (int i = 0; i < count; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        numbers.push_back(patch.Points[(3 * static_cast<std::size_t>(a) + c) * count + i]);
      }
    }
  }
  return first;
}

/// Nodes along, each with the basis in r and the nodes across it. The weight of the patch divides the basis
/// in s.
std::uint32_t DevicePointsWriter::AddPanel(
  const VariantFaceChain& chain, const VariantPanel& panel, const VariantPatch& patch)
{
  std::vector<double>& numbers = this->Result.Numbers;
  const auto first = static_cast<std::uint32_t>(numbers.size());
  PatchBasis whole;
  std::vector<double> basis[2];
  std::vector<double> slopes[2];
  int across = 0;
  VisitPanelNodes(chain, panel,
    [&](double weight, double s, double r)
    {
      if (across == 0)
      {
        FillDerivedBasis(patch.Degree[1], r, basis[1], slopes[1]);
        numbers.insert(numbers.end(), basis[1].begin(), basis[1].end());
        numbers.insert(numbers.end(), slopes[1].begin(), slopes[1].end());
      }
      across = (across + 1) % panel.Across;
      patch.FillBasis(s, r, whole);
      FillDerivedBasis(patch.Degree[0], s, basis[0], slopes[0]);
      const double w = EvaluateWeight(patch, basis[0], basis[1]);
      numbers.insert(numbers.end(), { weight, whole.TurnS, whole.TurnR });
      for (const std::vector<double>* values : { &basis[0], &slopes[0] })
      {
        for (const double value : *values)
        {
          numbers.push_back(value / w);
        }
      }
    });
  return first;
}

template <typename Visit>
void DevicePointsWriter::AddConstant(const Visit& visit)
{
  VariantSums sums(this->One, this->Map, this->Totals);
  VariantSample one;
  visit(
    [&](const VariantSample& sample)
    {
      const auto select = [](const std::vector<double>& from, std::vector<double>& to)
      {
        const std::size_t variables = from.size() / 3;
        to = { from[0], from[variables], from[2 * variables] };
      };
      one.Weight = sample.Weight;
      select(sample.Position, one.Position);
      select(sample.First, one.First);
      select(sample.Second, one.Second);
      sums.Add(one);
    });
  sums.Flush();
}

void DevicePointsWriter::AddPatch(
  const VariantFaceChain& chain, std::uint32_t index, const std::vector<const VariantPanel*>& panels)
{
  const VariantPatch& patch = chain.Patches[index];
  const std::vector<int> variables = FindVariables(patch);
  if (variables.size() == 1)
  {
    this->AddConstant(
      [&](const auto& add)
      {
        for (const VariantPanel* panel : panels)
        {
          VisitPanel(chain, *panel, add);
        }
      });
    return;
  }
  const GroupKey key = { DeviceStep::Panels, patch.Degree[0], patch.Degree[1] };
  if (std::max(patch.Degree[0], patch.Degree[1]) > MaximumRegisterDegree)
  {
    this->Result.MaxNet = std::max<std::size_t>(this->Result.MaxNet, 3 * patch.GetNumberOfPoints());
  }
  const std::uint32_t matrix = this->AddMatrix(patch, variables);
  const std::uint32_t list = this->AddList(chain, variables);
  for (std::size_t begin = 0; begin < panels.size();)
  {
    std::size_t cost = 0;
    // The net, then each curve with the nodes on it; a loop counts one more than its iterations.
    const std::size_t p = patch.Degree[0];
    const std::size_t q = patch.Degree[1];
    const std::size_t stepsOfNet =
      variables.size() * (3 * static_cast<std::size_t>(patch.GetNumberOfPoints()) + 2);
    std::size_t steps = 0;
    std::size_t end = begin;
    for (; end < panels.size() && CountWork(cost, steps) < MaximumItemWork; ++end)
    {
      const std::size_t along = panels[end]->Along;
      const std::size_t across = panels[end]->Across;
      cost += along * across;
      steps += along * (3 + (p + 1) * (q + 3) + across * (p + 3)) + 2;
    }
    std::vector<std::uint32_t> words;
    for (std::size_t i = begin; i < end; ++i)
    {
      words.push_back(this->AddPanel(chain, *panels[i], patch));
      words.push_back(static_cast<std::uint32_t>(panels[i]->Along));
      words.push_back(static_cast<std::uint32_t>(panels[i]->Across));
    }
    const auto first = static_cast<std::uint32_t>(this->Result.Words.size());
    this->Result.Words.insert(this->Result.Words.end(), words.begin(), words.end());
    this->AddItem(key,
      { matrix, static_cast<std::uint32_t>(variables.size()), list, first,
        static_cast<std::uint32_t>(end - begin) },
      cost, steps + stepsOfNet);
    begin = end;
  }
}

void DevicePointsWriter::AddRibbon(const VariantFaceChain& chain, const VariantRibbon& ribbon)
{
  const VariantPatch& patch = chain.Patches[ribbon.Patch];
  const std::size_t count = patch.Variables;
  std::vector<RibbonNode> nodes;
  VisitRibbonNodes(chain, ribbon, [&nodes](const RibbonNode& node) { nodes.push_back(node); });
  const auto isMoved = [&](const RibbonNode& node, std::size_t a)
  {
    const std::vector<double>* parts[4] = { &node.Face, &node.Edge, &node.FaceTangent, &node.EdgeTangent };
    return std::any_of(parts, parts + 4,
      [&](const std::vector<double>* part)
      { return (*part)[a] != 0.0 || (*part)[count + a] != 0.0 || (*part)[2 * count + a] != 0.0; });
  };
  const std::vector<int> variables = SelectVariables(patch.Variables,
    [&](int a)
    {
      return std::any_of(
               nodes.begin(), nodes.end(), [&](const RibbonNode& node) { return isMoved(node, a); }) ||
        std::any_of(patch.Centers[a].begin(), patch.Centers[a].end(), [](double x) { return x != 0.0; });
    });
  if (variables.size() == 1)
  {
    this->AddConstant([&](const auto& add) { VisitRibbon(chain, ribbon, add); });
    return;
  }
  const auto first = static_cast<std::uint32_t>(this->Result.Numbers.size());
  for (const RibbonNode& node : nodes)
  {
    this->Result.Numbers.push_back(ribbon.Sign * node.Weight);
    for (const int a : variables)
    {
      this->Result.Numbers.insert(
        this->Result.Numbers.end(), patch.Centers[a].begin(), patch.Centers[a].end());
      for (const std::vector<double>* part : { &node.Face, &node.Edge, &node.FaceTangent, &node.EdgeTangent })
      {
        for (int c = 0; c < 3; ++c)
        {
          this->Result.Numbers.push_back((*part)[c * count + a]);
        }
      }
    }
  }
  this->AddItem({ DeviceStep::Ribbons, 0, 0 },
    { first, static_cast<std::uint32_t>(variables.size()), this->AddList(chain, variables),
      static_cast<std::uint32_t>(nodes.size()) },
    3 * nodes.size(), nodes.size() * (variables.size() + 6));
}

void DevicePointsWriter::AddCap(const VariantFaceChain& chain, const VariantCap& cap)
{
  const int count = chain.GetNumberOfVariables();
  const std::vector<int> variables = SelectVariables(count,
    [&cap](int a)
    {
      return std::any_of(cap.Corners.begin(), cap.Corners.end(),
        [a](const auto& corner)
        { return corner[0][a] != 0.0 || corner[1][a] != 0.0 || corner[2][a] != 0.0; });
    });
  if (variables.size() == 1)
  {
    this->AddConstant([&](const auto& add) { VisitCap(cap, count, add); });
    return;
  }
  const auto first = static_cast<std::uint32_t>(this->Result.Numbers.size());
  this->Result.Numbers.push_back(cap.Sign);
  for (const int a : variables)
  {
    for (const auto& corner : cap.Corners)
    {
      this->Result.Numbers.insert(this->Result.Numbers.end(), { corner[0][a], corner[1][a], corner[2][a] });
    }
  }
  this->AddItem({ DeviceStep::Caps, 0, 0 },
    { first, static_cast<std::uint32_t>(variables.size()), this->AddList(chain, variables), 1 }, 9,
    variables.size() + 20);
}

/// A term has its factors, and for each variable the values of position and tangents, then their errors.
void DevicePointsWriter::AddErrorsOf(const VariantFaceChain& chain)
{
  PointsErrors errors{ chain.Directions, chain.Errors };
  this->Result.Terms += errors.Terms.size();
  for (VariantError& term : errors.Terms)
  {
    for (int c = 0; term.Patch >= 0 && c < 3; ++c)
    {
      for (std::size_t a = 0; a < term.Forms.Position[c].size(); ++a)
      {
        const double error = 2.0 * term.Forms.Position[c][a].Error;
        term.Forms.First[c][a].Error += error * chain.Patches[term.Patch].Degree[0];
        term.Forms.Second[c][a].Error += error * chain.Patches[term.Patch].Degree[1];
      }
    }
  }
  if (chain.Directions.empty())
  {
    AddErrors(errors, { 1.0 }, this->Result.ConstantBound);
    return;
  }
  const double growth = GetErrorGrowth(errors.Directions.size() + 1);
  std::vector<double>& numbers = this->Result.Numbers;
  for (const VariantError& term : errors.Terms)
  {
    const std::array<std::vector<ErrorBound>, 3>* forms[3] = { &term.Forms.Position, &term.Forms.First,
      &term.Forms.Second };
    const std::vector<int> variables = SelectVariables(chain.GetNumberOfVariables(),
      [&](int a)
      {
        return std::any_of(forms, forms + 3,
          [a](const auto* form)
          {
            return std::any_of(form->begin(), form->end(),
              [a](const auto& part) { return part[a].Value != 0.0 || part[a].Error != 0.0; });
          });
      });
    const std::size_t first = numbers.size();
    numbers.insert(numbers.end(), { term.ValueFactor, term.ErrorFactor * growth });
    for (const int a : variables)
    {
      for (const auto part : { &ErrorBound::Value, &ErrorBound::Error })
      {
        for (const auto* form : forms)
        {
          numbers.insert(numbers.end(), { (*form)[0][a].*part, (*form)[1][a].*part, (*form)[2][a].*part });
        }
      }
    }
    // What the shader would make of infinity is not known.
    this->Result.HasBounds = this->Result.HasBounds &&
      std::all_of(numbers.begin() + static_cast<std::ptrdiff_t>(first), numbers.end(),
        [](double x) { return std::isfinite(x); });
    this->AddItem({ DeviceStep::Bounds, 0, 0 },
      { static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(variables.size()),
        this->AddList(chain, variables) },
      2 + variables.size() / 4, variables.size() + 2);
  }
  this->Result.Errors.push_back(std::move(errors));
}

void DevicePointsWriter::AddFace(const VariantFaceChain& chain)
{
  this->AddErrorsOf(chain);
  if (chain.Directions.empty())
  {
    this->AddConstant([&chain](const auto& add) { VisitSamples(chain, add); });
    return;
  }
  std::map<std::uint32_t, std::vector<const VariantPanel*>> panels;
  for (const VariantPanel& panel : chain.Panels)
  {
    panels[panel.Patch].push_back(&panel);
  }
  for (const auto& [patch, ofPatch] : panels)
  {
    this->AddPatch(chain, patch, ofPatch);
  }
  for (const VariantRibbon& ribbon : chain.Ribbons)
  {
    this->AddRibbon(chain, ribbon);
  }
  for (const VariantCap& cap : chain.Caps)
  {
    this->AddCap(chain, cap);
  }
}

DevicePoints DevicePointsWriter::Finish()
{
  for (const auto& [key, items] : this->Groups)
  {
    const auto [step, degreeS, degreeR] = key;
    DeviceGroup group;
    group.Step = step;
    group.Degree[0] = degreeS;
    group.Degree[1] = degreeR;
    group.IsNetInBuffer = std::max(degreeS, degreeR) > MaximumRegisterDegree;
    group.FirstWord = static_cast<std::uint32_t>(this->Result.Words.size());
    group.WordsOfItem = static_cast<std::uint32_t>(items.Words.size() / items.Costs.size());
    group.Costs = items.Costs;
    group.Steps = items.Steps;
    this->Result.Words.insert(this->Result.Words.end(), items.Words.begin(), items.Words.end());
    for (const std::uint32_t cost : group.Costs)
    {
      this->Result.Samples += step == DeviceStep::Bounds ? 0 : cost;
    }
    this->Result.Groups.push_back(std::move(group));
  }
  for (int m = 0; m < NumberOfMoments; ++m)
  {
    this->Result.Constant[m] = this->Totals.Get(m, 0);
  }
  return std::move(this->Result);
}
}
