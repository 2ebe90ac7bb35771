#include "Detail/smSubmergedPanels.h"

#include "smPatchParts.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// Shares of the tolerance for all boxes that remain unresolved together, and for a single cut or fit.
constexpr double LeftoverShare = 0.25;
// Boxes are not halved any more when their errors are below this fraction of the errors that halving cannot
// reduce.
constexpr double FinalShare = 1.0 / 64.0;
constexpr double PieceShare = 1.0 / 4096.0;
// Largest number of boxes per face in addition to its patches, and smallest width of a box relative to its
// patch.
constexpr std::size_t MaxBoxes = 20000;
constexpr double MinBox = 1e-13;
// Largest slope of a graph in units of its box, so that few polynomials fit it; and the width on each side of
// a box, relative to the box, within which the height must be monotone too.
constexpr double SteepestGraph = 8.0;
constexpr double Room = 1.0 / 64.0;
// Largest number of halvings of graphs in a box.
constexpr int MaxGraphHalvings = 1000;

}

SubmergedPanels::SubmergedPanels(const FacePanels& source, const HeightPlane& plane, const CutLimits& limits)
  : From(source)
  , Plane(plane)
  , Limits(limits)
  , Small(PieceShare)
{
}

void SubmergedPanels::Cut()
{
  std::map<std::uint32_t, Region> regions;
  std::map<std::uint32_t, PiecePointer> pieces;
  std::map<std::uint32_t, const Panel*> panels;
  for (const Panel& panel : this->From.Panels)
  {
    PiecePointer& piece = pieces[panel.Trim];
    if (!piece)
    {
      std::vector<Point2> points;
      for (int i = 0; i <= panel.TrimDegree; ++i)
      {
        const double* from = this->From.Coefficients.data() + panel.Trim + 2 * i;
        points.push_back({ from[0], from[1] });
      }
      piece = std::make_shared<const std::vector<Point2>>(std::move(points));
    }
    regions[panel.Patch].push_back(
      { piece, panel.Start, panel.End, panel.From, panel.To, panel.Negative ? -1 : 1, panel.Covered });
    panels[panel.Patch] = &panel;
  }
  for (auto& [patch, parts] : regions)
  {
    const Panel& panel = *panels[patch];
    const HeightNet net(this->From, this->From.Patches[patch], this->Plane);
    this->Sources.push_back({ patch, panel.Shape, panel.FlipNormal, net, net.Exchanged() });
    this->AddPatch(patch, std::move(parts));
  }
  // The box with the largest error bound is halved first, until the remaining bounds are small.
  const auto isLess = [](const Box& a, const Box& b) { return a.Excess < b.Excess; };
  std::make_heap(this->Open.begin(), this->Open.end(), isLess);
  const auto sum = [this]()
  {
    double total = 0.0;
    for (const Box& box : this->Open)
    {
      total += box.Excess;
    }
    return total;
  };
  const std::size_t maximum = this->Boxes + MaxBoxes;
  double left = sum();
  double final = 0.0;
  while (!this->Open.empty() && this->Boxes < maximum &&
    left > std::max(LeftoverShare - final, FinalShare * final))
  {
    std::pop_heap(this->Open.begin(), this->Open.end(), isLess);
    const Box box = std::move(this->Open.back());
    this->Open.pop_back();
    if (this->IsFinal(box))
    {
      final += box.Excess;
      this->AddLeftover(box);
      left = sum();
      continue;
    }
    const std::size_t before = this->Open.size();
    this->Halve(box);
    left -= box.Excess;
    for (std::size_t i = before; i < this->Open.size(); ++i)
    {
      left += this->Open[i].Excess;
      std::push_heap(this->Open.begin(), this->Open.begin() + static_cast<std::ptrdiff_t>(i) + 1, isLess);
    }
    left = std::isfinite(left) ? left : sum();
  }
  for (const Box& box : this->Open)
  {
    this->AddLeftover(box);
  }
}

double SubmergedPanels::GetMaxNormal(std::uint32_t patch, const ParameterRange& range) const
{
  FacePanels part;
  AppendPatchPart(this->From, patch, range.Low, range.High, false, part);
  return HeightNet(part, part.Patches[0], this->Plane).GetMaxNormal();
}

bool SubmergedPanels::IsFinal(const Box& box) const
{
  const Source& source = this->Sources[box.Net];
  const Patch& patch = this->From.Patches[source.Patch];
  if (box.Range.High[0] - box.Range.Low[0] < MinBox * patch.Width[0] ||
    box.Range.High[1] - box.Range.Low[1] < MinBox * patch.Width[1])
  {
    return true;
  }
  const NetRange range = source.Net.GetRange(box.Range);
  return std::max(range.High, -range.Low) < this->GetNoise(source.Net);
}

void SubmergedPanels::AddLeftover(const Box& box)
{
  this->Add(box.Majorant);
  const Patch& patch = this->From.Patches[this->Sources[box.Net].Patch];
  for (int d = 0; d < 2; ++d)
  {
    const double length = patch.Stretch[d] * (box.Range.High[d] - box.Range.Low[d]) / patch.Width[d];
    this->Errors.Area += 2.0 * this->Limits.Displacement * length;
  }
}

void SubmergedPanels::AddPatch(std::uint32_t index, Region parts)
{
  const Patch& patch = this->From.Patches[index];
  Box box;
  box.Net = this->Sources.size() - 1;
  for (int d = 0; d < 2; ++d)
  {
    // Trim pieces may leave the patch slightly; its polynomial is continued there.
    std::array<double, 2> extent{ patch.Start[d], patch.Start[d] + patch.Width[d] };
    for (const RegionPart& part : parts)
    {
      extent = GetExtent(part, d, extent[0], extent[1]);
    }
    box.Range.Low[d] = extent[0];
    box.Range.High[d] = extent[1];
  }
  if (box.Range.Low[0] < patch.Start[0])
  {
    // The parts describe the region right of the patch's left border.
    SignedIntervals covered;
    for (const RegionPart& part : parts)
    {
      covered.Add(part.From[1], part.To[1], part.Sign);
    }
    for (const SignedIntervals::Interval& interval : covered.Get())
    {
      parts.push_back(MakeLine(patch.Start[0], interval.Start, interval.End, -interval.Multiplicity));
    }
  }
  if (box.Range.Low[0] < patch.Start[0] || box.Range.Low[1] < patch.Start[1] ||
    box.Range.High[0] > patch.Start[0] + patch.Width[0] ||
    box.Range.High[1] > patch.Start[1] + patch.Width[1])
  {
    // The normal bound of the patch does not hold outside of the patch.
    FacePanels wider;
    AppendPatchPart(this->From, index, box.Range.Low, box.Range.High, false, wider);
    const double normal = HeightNet(wider, wider.Patches[0], this->Plane).GetMaxNormal();
    Source& source = this->Sources.back();
    source.Net.RaiseNormal(normal);
    source.Exchanged.RaiseNormal(normal);
  }
  box.Parts = std::move(parts);
  if (!this->Resolve(box))
  {
    this->Open.push_back(std::move(box));
  }
}

bool SubmergedPanels::IsMonotone(const HeightNet& net, const ParameterRange& range, Monotone& found) const
{
  ParameterRange wide = range;
  const double room = Room * (range.High[0] - range.Low[0]);
  wide.Low[0] -= room;
  wide.High[0] += room;
  const NetRange bounds = net.GetRange(wide);
  if (!(bounds.MinWeight > 0.0) || !(bounds.SlopeLow[0] > 0.0 || bounds.SlopeHigh[0] < 0.0))
  {
    return false;
  }
  const double width[2] = { net.ToLocal(0, range.High[0]) - net.ToLocal(0, range.Low[0]),
    net.ToLocal(1, range.High[1]) - net.ToLocal(1, range.Low[1]) };
  // Differences of coefficients that are rounded.
  const double rounding =
    this->Limits.HasArea() ? 2.0 * net.GetDegree(0) * net.GetRounding() / width[0] : 0.0;
  const double slope = std::min(std::abs(bounds.SlopeLow[0]), std::abs(bounds.SlopeHigh[0])) - rounding;
  const double across = std::max(std::abs(bounds.SlopeLow[1]), std::abs(bounds.SlopeHigh[1]));
  if (!(slope > 0.0))
  {
    return false;
  }
  if (!(SteepestGraph * slope * width[0] >= across * width[1]))
  {
    return false;
  }
  found.Net = &net;
  found.Range = range;
  found.Increasing = bounds.SlopeLow[0] > 0.0;
  // Slope per unit of the trim pieces' parameter.
  found.Slope = slope * width[0] / (range.High[0] - range.Low[0]);
  // |h| <= N / w on a sliver of width N / slope.
  found.Rate = net.GetMaxNormal() / (bounds.MinWeight * found.Slope);
  found.AreaRate = net.GetMaxNormal() / found.Slope;
  found.Noise = this->GetNoise(net);
  found.Room = room;
  found.Whole.Area = net.GetMaxNormal() * (wide.High[0] - wide.Low[0]);
  found.Whole.Volume = bounds.GetMaxHeight() * found.Whole.Area;
  found.Halvings = MaxGraphHalvings;
  return true;
}

bool SubmergedPanels::IsResolved(const Box& box, bool& below, int& monotone) const
{
  const Source& source = this->Sources[box.Net];
  const NetRange range = source.Net.GetRange(box.Range);
  const double noise = this->GetNoise(source.Net);
  below = range.High <= -noise;
  monotone = -1;
  if (below || range.Low >= noise)
  {
    return true;
  }
  Monotone found;
  if (this->IsMonotone(source.Net, box.Range, found))
  {
    monotone = 0;
    return true;
  }
  if (this->IsMonotone(source.Exchanged, box.Range.Exchanged(), found))
  {
    monotone = 1;
    return true;
  }
  return false;
}

bool SubmergedPanels::Resolve(Box& box)
{
  if (box.Parts.empty())
  {
    return true;
  }
  ++this->Boxes;
  const Source& source = this->Sources[box.Net];
  bool below = false;
  int monotone = -1;
  if (!this->IsResolved(box, below, monotone))
  {
    const NetRange range = source.Net.GetRange(box.Range);
    const double size = (box.Range.High[0] - box.Range.Low[0]) * (box.Range.High[1] - box.Range.Low[1]);
    box.Majorant.Volume = range.GetMaxHeight() * source.Net.GetMaxNormal() * size;
    // Near a collapsed edge the normals of a box are much smaller than those of its patch.
    box.Majorant.Area = size * (this->Limits.HasArea() ? this->GetMaxNormal(source.Patch, box.Range) : 0.0);
    box.Excess = std::max(box.Majorant.Volume / this->Limits.Volume, box.Majorant.Area / this->Limits.Area);
    return false;
  }
  if (below)
  {
    const std::uint32_t patch =
      AppendPatchPart(this->From, source.Patch, box.Range.Low, box.Range.High, false, this->Results[0]);
    for (const RegionPart& part : box.Parts)
    {
      this->AddPanel(false, patch, source.Shape, source.Flip, part);
    }
  }
  else if (monotone >= 0)
  {
    const bool exchanged = monotone == 1;
    Monotone found;
    this->IsMonotone(
      exchanged ? source.Exchanged : source.Net, exchanged ? box.Range.Exchanged() : box.Range, found);
    found.Exchanged = exchanged;
    this->CutMonotone(
      source, found, exchanged ? ExchangeRegion(box.Parts, box.Range.Low[0], box.Range.Low[1]) : box.Parts);
  }
  return true;
}

int SubmergedPanels::ChooseDirection(const Box& box) const
{
  // The direction that resolves more halves; if both resolve the same number, the one that reduces the ranges
  // of the slopes more.
  int settled[2] = { 0, 0 };
  double spread[2] = { 0.0, 0.0 };
  for (int d = 0; d < 2; ++d)
  {
    for (int half = 0; half < 2; ++half)
    {
      Box part;
      part.Net = box.Net;
      part.Range = box.Range;
      (half == 0 ? part.Range.High : part.Range.Low)[d] = 0.5 * (box.Range.Low[d] + box.Range.High[d]);
      bool below;
      int monotone;
      settled[d] += this->IsResolved(part, below, monotone) ? 1 : 0;
      const HeightNet& net = this->Sources[box.Net].Net;
      const NetRange range = net.GetRange(part.Range);
      for (int e = 0; e < 2; ++e)
      {
        spread[d] += (range.SlopeHigh[e] - range.SlopeLow[e]) *
          (net.ToLocal(e, box.Range.High[e]) - net.ToLocal(e, box.Range.Low[e]));
      }
    }
  }
  if (settled[0] != settled[1])
  {
    return settled[0] > settled[1] ? 0 : 1;
  }
  return spread[0] < spread[1] ? 0 : 1;
}

void SubmergedPanels::Halve(const Box& box)
{
  const int d = this->ChooseDirection(box);
  const double middle = 0.5 * (box.Range.Low[d] + box.Range.High[d]);
  Box halves[2];
  CutRegion(box.Parts, d, middle, halves[0].Parts, halves[1].Parts);
  for (int half = 0; half < 2; ++half)
  {
    halves[half].Net = box.Net;
    halves[half].Range = box.Range;
    (half == 0 ? halves[half].Range.High : halves[half].Range.Low)[d] = middle;
    if (!this->Resolve(halves[half]))
    {
      this->Open.push_back(std::move(halves[half]));
    }
  }
}

void SubmergedPanels::AddPanel(
  bool exchanged, std::uint32_t patch, PanelShape shape, bool flip, const RegionPart& part)
{
  FacePanels& result = this->Results[exchanged ? 1 : 0];
  const std::vector<Point2>& b = *part.Piece;
  const double left = result.Patches[patch].Start[0];
  const bool leavesLeft =
    std::any_of(b.begin(), b.end(), [left](const Point2& point) { return point[0] != left; });
  const bool rises =
    std::any_of(b.begin(), b.end(), [&b](const Point2& point) { return point[1] != b[0][1]; });
  if (!leavesLeft || !rises || !(part.End > part.Start))
  {
    return;
  }
  const auto [entry, isNew] = this->Trims[exchanged ? 1 : 0].emplace(
    part.Piece.get(), static_cast<std::uint32_t>(result.Coefficients.size()));
  if (isNew)
  {
    this->Kept.push_back(part.Piece);
    for (const Point2& point : b)
    {
      result.Coefficients.insert(result.Coefficients.end(), point.begin(), point.end());
    }
  }
  for (int m = 0; m < std::abs(part.Sign); ++m)
  {
    result.Panels.push_back({ patch, entry->second, static_cast<std::uint8_t>(part.GetDegree()), shape,
      part.Sign < 0, flip, part.Start, part.End, part.Covered, part.From, part.To });
  }
}
}
