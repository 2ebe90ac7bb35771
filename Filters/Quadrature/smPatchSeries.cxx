#include "Detail/smPatchSeries.h"

#include "Detail/smIntegerPower.h"
#include "smTrimSeries.h"
#include "smVector.h"

#include <algorithm>
#include <limits>

namespace sm
{
namespace
{
// The box of a patch's series is larger than the patch by this, so that it contains trim curves that leave
// the patch by rounding.
constexpr double Margin = 1e-6;
// An edge whose control points are this close together, relative to the patch, is nearly, or certainly, one
// point.
constexpr double NearlyCollapsed = 1e-9;
constexpr double CertainlyCollapsed = 1e-15;
// The largest number of samples of a patch, in both directions, whose form is cheap: bilinear to biquadratic
// ones, and long arcs.
constexpr int SamplesOfCheapForm = 40;

/// Beyond a collapsed edge |n| is not what it is on the patch.
ParameterBox GetPatchBox(const PatchTraits& traits)
{
  const auto& c = traits.Collapsed;
  const double half = c[0] || c[1] || c[2] || c[3] ? 0.5 : 0.5 + Margin;
  return { { 0.5, 0.5 }, { half, half } };
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
    : c.Kind == BoundClass::AreaBasis     ? std::numeric_limits<double>::infinity()
                                          : moment(k + 1) / (3 + k);
}

void FillIntegrandChange(const Patch& patch, const PlanRequest& request, double moved, const double slope[2],
  double radius, const double stretch[2], double basis, std::vector<double>& change)
{
  const double rotated = slope[0] * stretch[1] + stretch[0] * slope[1] + slope[0] * slope[1];
  const double normal = (stretch[0] + slope[0]) * (stretch[1] + slope[1]);
  const double reach = Norm(GetOrigin(patch, request).data()) + radius + moved;
  change.clear();
  for (const BoundClass& c : request.Classes)
  {
    change.push_back(GetIntegrandChange(c, moved, rotated, normal, reach, basis));
  }
}

std::array<double, 3> GetOrigin(const Patch& patch, const PlanRequest& request)
{
  return { patch.Center[0] + request.Shift[0], patch.Center[1] + request.Shift[1],
    patch.Center[2] + request.Shift[2] };
}

FaceSeries::FaceSeries(const FacePanels& panels, const PlanRequest& request)
  : Panels(panels)
  , Request(request)
  , Entries(panels.Patches.size())
{
}

const PatchSeries& FaceSeries::Get(std::uint32_t patch, Poles poles, bool withForm)
{
  Entry& entry = this->Entries[patch][(poles == Poles::Nearly ? 0 : 2) + (withForm ? 1 : 0)];
  std::call_once(
    entry.Once, [&]() { entry.Series = this->Make(this->Panels.Patches[patch], poles, withForm); });
  return *entry.Series;
}

bool FaceSeries::HasCheapForm(std::uint32_t patch) const
{
  const Patch& p = this->Panels.Patches[patch];
  return (3 * p.Degree[0] - 1) * (3 * p.Degree[1] - 1) <= SamplesOfCheapForm;
}

std::unique_ptr<PatchSeries> FaceSeries::Make(const Patch& patch, Poles poles, bool withForm) const
{
  auto series = std::make_unique<PatchSeries>();
  const std::array<double, 4>* points = this->Panels.Points.data() + patch.FirstPoint;
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  series->Points.assign(points, points + (p + 1) * (q + 1));
  CollapseEdges(series->Points, p, q, poles == Poles::Nearly ? NearlyCollapsed : CertainlyCollapsed);
  series->Traits = FindPatchTraits(series->Points.data(), p, q);
  series->Box = GetPatchBox(series->Traits);
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
    FillIntegrandChange(patch, this->Request, grown(series->Moved), slope, grown(patch.Radius), stretch,
      grown(1.0 / lightest), series->Change);
  }
  return series;
}
}
