#include "Detail/smVariantPointsWriter.h"

#include "smBernstein.h"
#include "smGaussLegendre.h"

#include <utility>

namespace sm
{
namespace
{
/// Writes the samples of a face and the nets that they refer to.
class PointsWriter
{
public:
  explicit PointsWriter(const VariantFaceChain& chain)
    : Chain(chain)
    , Variables(chain.GetNumberOfVariables())
  {
    this->Face.Directions = chain.Directions;
  }

  PointsFace Write()
  {
    for (const VariantPatch& patch : this->Chain.Patches)
    {
      this->NetOfPatch.push_back(this->AddPatch(patch));
    }
    for (const VariantPanel& panel : this->Chain.Panels)
    {
      this->AddPanel(panel);
    }
    for (const VariantRibbon& ribbon : this->Chain.Ribbons)
    {
      this->AddRibbon(ribbon);
    }
    for (const VariantCap& cap : this->Chain.Caps)
    {
      this->AddCap(cap);
    }
    return std::move(this->Face);
  }

private:
  /// Appends a number of the nets: get(variable).
  template <typename Get>
  void AddNumber(const Get& get)
  {
    for (int a = 0; a < this->Variables; ++a)
    {
      this->Face.Nets.push_back(get(a));
    }
    ++this->Face.NetSize;
  }
  void AddNet(const std::vector<double>& net, int count)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < count; ++i)
      {
        this->AddNumber([&](int a) { return net[(3 * static_cast<std::size_t>(a) + c) * count + i]; });
      }
    }
  }
  std::size_t AddPatch(const VariantPatch& patch)
  {
    const std::size_t first = this->Face.NetSize;
    for (int c = 0; c < 3; ++c)
    {
      this->AddNumber([&](int a) { return patch.Centers[a][c]; });
    }
    this->AddNet(patch.Points, patch.GetNumberOfPoints());
    this->AddNet(patch.StepsS, patch.GetNumberOfStepsS());
    this->AddNet(patch.StepsR, patch.GetNumberOfStepsR());
    return first;
  }
  PointsBlock MakeBlock(PointsKind kind, std::uint32_t index) const
  {
    const VariantPatch& patch = this->Chain.Patches[index];
    return { kind, patch.GetNumberOfPoints(), patch.GetNumberOfStepsS(), patch.GetNumberOfStepsR(), 0,
      this->NetOfPatch[index], 0, this->Face.Records.size(), 0, 0 };
  }
  void Append(const std::vector<double>& values, double factor)
  {
    for (const double value : values)
    {
      this->Face.Records.push_back(factor * value);
    }
  }

  void AddPanel(const VariantPanel& panel)
  {
    const VariantPatch& patch = this->Chain.Patches[panel.Patch];
    PointsBlock block = this->MakeBlock(PointsKind::Panel, panel.Patch);
    block.RecordSize = 3 + static_cast<std::size_t>(block.Points + block.StepsS + block.StepsR);
    PatchBasis basis;
    VisitPanelNodes(this->Chain, panel,
      [&](double weight, double s, double r)
      {
        patch.FillBasis(s, r, basis);
        this->Face.Records.insert(this->Face.Records.end(), { weight, basis.TurnS, basis.TurnR });
        this->Append(basis.Position, 1.0);
        this->Append(basis.First, 1.0);
        this->Append(basis.Second, 1.0);
        ++block.Count;
      });
    this->Face.Blocks.push_back(block);
  }

  void AddRibbon(const VariantRibbon& ribbon)
  {
    const VariantPatch& patch = this->Chain.Patches[ribbon.Patch];
    const int n = ribbon.EdgeDegree;
    PointsBlock block = this->MakeBlock(PointsKind::Ribbon, ribbon.Patch);
    block.EdgePoints = n + 1;
    block.EdgeNet = this->Face.NetSize;
    block.RecordSize =
      2 + static_cast<std::size_t>(block.Points + block.StepsS + block.StepsR + 2 * block.EdgePoints);
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i <= n; ++i)
      {
        this->AddNumber(
          [&](int a) {
            return this->Chain
              .Coefficients[ribbon.Edge + 3 * ((n + 1) * static_cast<std::size_t>(a) + i) + c];
          });
      }
    }
    const double* rule =
      GetRuleTable().data() + static_cast<std::ptrdiff_t>(ribbon.Along) * (ribbon.Along - 1);
    const double width = ribbon.End - ribbon.Start;
    const double edgeWidth = ribbon.EdgeEnd - ribbon.EdgeStart;
    PatchBasis basis;
    for (int i = 0; i < ribbon.Along; ++i)
    {
      double point[2];
      double slope[2];
      EvaluateTrim(this->Chain.Coefficients.data() + ribbon.Trim, ribbon.TrimDegree,
        ribbon.Start + width * rule[2 * i], point, slope);
      patch.FillBasis(point[0], point[1], basis);
      const double slopes[2] = { width * slope[0], width * slope[1] };
      this->Face.Records.push_back(ribbon.Sign * rule[2 * i + 1]);
      this->Face.Records.push_back(slopes[0] * basis.TurnS + slopes[1] * basis.TurnR);
      this->Append(basis.Position, 1.0);
      this->Append(basis.First, slopes[0]);
      this->Append(basis.Second, slopes[1]);
      const double e = ribbon.EdgeStart + edgeWidth * rule[2 * i];
      std::vector<double> own(n + 1);
      std::vector<double> lower(n + 1, 0.0);
      FillBernsteinBasis(n, e, own.data());
      std::vector<double> derivative(n + 1, 0.0);
      if (n > 0)
      {
        FillBernsteinBasis(n - 1, e, lower.data());
        for (int k = 0; k <= n; ++k)
        {
          derivative[k] = n * ((k > 0 ? lower[k - 1] : 0.0) - (k < n ? lower[k] : 0.0));
        }
      }
      this->Append(own, 1.0);
      this->Append(derivative, edgeWidth);
      ++block.Count;
    }
    this->Face.Blocks.push_back(block);
  }

  void AddCap(const VariantCap& cap)
  {
    PointsBlock block{ PointsKind::Cap, 0, 0, 0, 0, this->Face.NetSize, 0, this->Face.Records.size(), 1, 1 };
    for (const auto& corner : cap.Corners)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->AddNumber([&](int a) { return corner[c][a]; });
      }
    }
    this->Face.Records.push_back(cap.Sign);
    this->Face.Blocks.push_back(block);
  }

  const VariantFaceChain& Chain;
  const int Variables;
  std::vector<std::size_t> NetOfPatch;
  PointsFace Face;
};
}

PointsFace WritePoints(const VariantFaceChain& chain)
{
  return PointsWriter(chain).Write();
}
}
