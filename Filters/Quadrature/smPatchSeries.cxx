#include "Detail/smPatchSeries.h"

#include "Detail/smIntegerPower.h"
#include "smTrimSeries.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// The box of a patch's series is that of its panels, to the next multiples of this, which are exact doubles,
// and leaves the patch by at most the margin.
constexpr double BoxStep = 1.0 / 1024.0;
constexpr double Margin = 1.0 / 32.0;
// The room that is left for the series of a part of a panel beyond the panel's, relative to their range.
constexpr double SeriesRoom = 1.0 / 64.0;
// An edge whose control points are this close together, relative to the patch, is nearly, or certainly, one
// point.
constexpr double NearlyCollapsed = 1e-9;
constexpr double CertainlyCollapsed = 1e-15;
// The largest number of samples of a patch, in both directions, whose form is cheap: bilinear to biquadratic
// ones, and long arcs.
constexpr int SamplesOfCheapForm = 40;
// The smallest number of samples of a patch that make series worth sharing.
constexpr int SamplesOfStrips = 100;

/// Samples of the numerators of a patch, in both directions.
int CountSamples(const Patch& patch)
{
  return (3 * patch.Degree[0] - 1) * (3 * patch.Degree[1] - 1);
}

/// Raises the ranges of s and r, [0] to [1], to those of a panel.
void AddPanel(
  const FacePanels& panels, const Panel& panel, TrimSeries& trim, std::array<double, 2> (&ranges)[2])
{
  trim.Expand(panels.Coefficients.data() + panel.Trim, panel.TrimDegree, panels.Patches[panel.Patch],
    panel.Start, panel.End);
  const ParameterBox box = trim.GetBox(0.0, 1.0);
  for (int d = 0; d < 2; ++d)
  {
    const double room = (1.0 + SeriesRoom) * box.Half[d];
    ranges[d][0] = std::min(ranges[d][0], box.Middle[d] - room);
    ranges[d][1] = std::max(ranges[d][1], box.Middle[d] + room);
  }
}

/// The box of the ranges. Beyond a collapsed edge |n| is not what it is on the patch.
ParameterBox MakeBox(const std::array<double, 2> (&ranges)[2], const PatchTraits& traits)
{
  ParameterBox box;
  for (int d = 0; d < 2; ++d)
  {
    const double first = traits.Collapsed[2 * d] ? 0.0 : -Margin;
    const double last = traits.Collapsed[2 * d + 1] ? 1.0 : 1.0 + Margin;
    const double low = BoxStep * std::floor(ranges[d][0] / BoxStep);
    const double high = BoxStep * std::ceil(ranges[d][1] / BoxStep);
    const double start = std::clamp(low, first, last - BoxStep);
    const double end = std::clamp(high, start + BoxStep, last);
    box.Middle[d] = 0.5 * (start + end);
    box.Half[d] = 0.5 * (end - start);
  }
  return box;
}
}

double GetIntegrandChange(
  const BoundClass& c, double moved, double rotated, double normal, double reach, double basis)
{
  const int k = c.Degree;
  const auto moment = [&](int degree)
  {
    return rotated * IntegerPower(reach, degree) +
      (degree > 0 ? degree * moved * normal * IntegerPower(reach, degree - 1) : 0.0);
  };
  return c.Kind == BoundClass::VectorArea ? rotated
    : c.Kind == BoundClass::AreaMoment    ? moment(k)
    : c.Kind == BoundClass::HeightMoment  ? moment(k + 1)
    : c.Kind == BoundClass::NormalBasis   ? basis * moment(k)
    : c.Kind == BoundClass::FluxBasis     ? basis * moment(k + 1)
    : c.Kind == BoundClass::AreaBasis     ? 0.0
                                          : moment(k + 1) / (3 + k);
}

PatchChange MakePatchChange(const Patch& patch, const PlanRequest& request, double moved,
  const double slope[2], double radius, const double stretch[2], double basis)
{
  PatchChange change;
  change.Moved = moved;
  std::copy_n(slope, 2, change.Slope);
  change.Rotated = slope[0] * stretch[1] + stretch[0] * slope[1] + slope[0] * slope[1];
  change.Basis = basis;
  const double normal = (stretch[0] + slope[0]) * (stretch[1] + slope[1]);
  const double reach = Norm(GetOrigin(patch, request).data()) + radius + moved;
  for (const BoundClass& c : request.Classes)
  {
    change.Integrands.push_back(GetIntegrandChange(c, moved, change.Rotated, normal, reach, basis));
  }
  return change;
}

std::array<double, 3> GetOrigin(const Patch& patch, const PlanRequest& request)
{
  return { patch.Center[0] + request.Shift[0], patch.Center[1] + request.Shift[1],
    patch.Center[2] + request.Shift[2] };
}

const PatchMajorants* PatchStrips::Find(const PatchSeries& series, const Patch& patch,
  const PlanRequest& request, const ParameterBox& box, ParameterBox& ofStrip) const
{
  const double width = 2.0 * series.Box.Half[1];
  const double start = series.Box.Middle[1] - series.Box.Half[1];
  const double low = (box.Middle[1] - box.Half[1] - start) / width;
  const double high = (box.Middle[1] + box.Half[1] - start) / width;
  if (CountSamples(patch) < SamplesOfStrips ||
    !(std::abs(box.Middle[0] - series.Box.Middle[0]) + box.Half[0] <= series.Box.Half[0]) || !(low >= 0.0) ||
    !(high <= 1.0))
  {
    return nullptr;
  }
  int level = 0;
  int index = 0;
  for (int next = 1; next <= Levels; ++next)
  {
    // Strip i of level n is [i / 2, i / 2 + 1] / 2^n.
    const double size = std::exp2(-next);
    const int at = std::min(static_cast<int>(2.0 * low / size), (2 << next) - 2);
    if (high <= (0.5 * at + 1.0) * size)
    {
      level = next;
      index = at;
    }
  }
  if (level == 0)
  {
    return nullptr;
  }
  std::call_once(this->Once, [this]() { this->Strips = std::vector<Strip>((4 << Levels) - Levels - 4); });
  // Before level n there are 2^(n+1) - n - 3 strips.
  Strip& strip = this->Strips[(2 << level) - level - 3 + index];
  const double size = std::exp2(-level);
  ofStrip = series.Box;
  ofStrip.Half[1] = size * series.Box.Half[1];
  ofStrip.Middle[1] = start + (0.5 * index + 0.5) * size * width;
  std::call_once(strip.Once,
    [&]()
    {
      strip.Majorants = std::make_unique<PatchMajorants>();
      strip.Majorants->Expand(series.Points.data(), patch.Degree[0], patch.Degree[1], series.Traits, ofStrip,
        GetOrigin(patch, request));
      strip.Majorants->ReleaseSamples();
    });
  return strip.Majorants.get();
}

FaceSeries::FaceSeries(const FacePanels& panels, const PlanRequest& request)
  : Panels(panels)
  , Request(request)
  , Entries(panels.Patches.size())
{
  for (Entry& entry : this->Entries)
  {
    for (std::array<double, 2>& range : entry.Ranges)
    {
      range = { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
    }
  }
  TrimSeries trim;
  for (const Panel& panel : panels.Panels)
  {
    AddPanel(panels, panel, trim, this->Entries[panel.Patch].Ranges);
  }
}

const PatchSeries& FaceSeries::Get(std::uint32_t patch, Poles poles, bool withForm)
{
  Lazy& lazy = this->Entries[patch].Series[(poles == Poles::Nearly ? 0 : 2) + (withForm ? 1 : 0)];
  std::call_once(lazy.Once, [&]() { lazy.Series = this->Make(patch, poles, withForm); });
  return *lazy.Series;
}

bool FaceSeries::HasCheapForm(std::uint32_t patch) const
{
  return CountSamples(this->Panels.Patches[patch]) <= SamplesOfCheapForm;
}

std::unique_ptr<PatchSeries> FaceSeries::Make(std::uint32_t index, Poles poles, bool withForm) const
{
  const Patch& patch = this->Panels.Patches[index];
  auto series = std::make_unique<PatchSeries>();
  const std::array<double, 4>* points = this->Panels.Points.data() + patch.FirstPoint;
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  series->Points.assign(points, points + (p + 1) * (q + 1));
  CollapseEdges(series->Points, p, q, poles == Poles::Nearly ? NearlyCollapsed : CertainlyCollapsed);
  series->Traits = FindPatchTraits(series->Points.data(), p, q);
  series->Box = MakeBox(this->Entries[index].Ranges, series->Traits);
  series->Whole.ExpandPatch(
    series->Points.data(), p, q, series->Traits, series->Box, GetOrigin(patch, this->Request), withForm);
  series->Whole.ReleaseSamples();
  // The difference is a rational patch with the same weights.
  std::vector<std::array<double, 4>> moved = series->Points;
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      moved[i][c] = points[i][c] - moved[i][c];
    }
  }
  Patch difference = patch;
  MeasurePatch(moved.data(), difference);
  series->Moved = difference.Radius;
  series->IsCertain = series->Moved <= CertainlyCollapsed * patch.Radius;
  if (series->Moved > 0.0)
  {
    const auto grown = [](double x) { return TrimSeries::OnPatchGrowth * x; };
    const double slope[2] = { grown(difference.Stretch[0]), grown(difference.Stretch[1]) };
    const double stretch[2] = { grown(patch.Stretch[0]), grown(patch.Stretch[1]) };
    double lightest = points[0][3];
    for (int i = 1; i < (p + 1) * (q + 1); ++i)
    {
      lightest = std::min(lightest, points[i][3]);
    }
    series->Change = MakePatchChange(
      patch, this->Request, grown(series->Moved), slope, grown(patch.Radius), stretch, grown(1.0 / lightest));
  }
  return series;
}
}
