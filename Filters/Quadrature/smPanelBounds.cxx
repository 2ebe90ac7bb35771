#include "smPanelBounds.h"

#include "smIntegerPower.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// PanelRadii of the ellipses tried: the least bound counts.
const EllipseRadius PanelRadii[] = { EllipseRadius(1.3), EllipseRadius(1.5), EllipseRadius(1.75),
  EllipseRadius(2.05), EllipseRadius(2.4), EllipseRadius(2.8), EllipseRadius(3.3), EllipseRadius(4.0),
  EllipseRadius(5.0), EllipseRadius(6.5), EllipseRadius(9.0), EllipseRadius(13.0), EllipseRadius(20.0),
  EllipseRadius(40.0), EllipseRadius(100.0) };
// The box of a patch's series is larger than the patch by this, so that it contains trim curves that leave the patch by rounding.
constexpr double Margin = 1e-6;
// An edge whose control points are this close together, relative to the patch, is taken for a point: below the first value where the
// tolerance allows the change, below the second one always.
constexpr double NearlyCollapsed = 1e-9;
constexpr double CertainlyCollapsed = 1e-15;
// The fraction of a panel's tolerance that may be spent on the change by making edges points.
constexpr double LargestChange = 0.25;

bool IsInside(const ParameterBox& box, const ParameterBox& outer)
{
  return std::abs(box.Middle[0] - outer.Middle[0]) + box.Half[0] <= outer.Half[0] &&
    std::abs(box.Middle[1] - outer.Middle[1]) + box.Half[1] <= outer.Half[1];
}

/// Beyond a collapsed edge |n| is not what it is on the patch.
ParameterBox GetPatchBox(const PatchTraits& traits)
{
  const auto& c = traits.Collapsed;
  const double half = c[0] || c[1] || c[2] || c[3] ? 0.5 : 0.5 + Margin;
  return { { 0.5, 0.5 }, { half, half } };
}
}

PanelBounds::PanelBounds(const FacePanels& panels, const PlanRequest& request, int degree)
  : Panels(panels)
  , Request(request)
  , Degree(degree)
  , Series(panels.Patches.size())
{
}

double GetIntegrandChange(const BoundClass& c, double moved, double turned, double normal, double reach)
{
  const int k = c.Degree;
  const auto moment = [&](int degree)
  {
    return turned * IntegerPower(reach, degree) +
      (degree > 0 ? degree * moved * normal * IntegerPower(reach, degree - 1) : 0.0);
  };
  return c.Kind == BoundClass::VectorArea ? turned
    : c.Kind == BoundClass::AreaMoment    ? moment(k)
    : c.Kind == BoundClass::HeightMoment  ? moment(k + 1)
                                          : moment(k + 1) / (3 + k);
}

void PanelBounds::FillChange(const Patch& patch, double moved, const double slope[2], double radius,
  const double stretch[2], std::vector<double>& change) const
{
  const double turned = slope[0] * stretch[1] + stretch[0] * slope[1] + slope[0] * slope[1];
  const double normal = (stretch[0] + slope[0]) * (stretch[1] + slope[1]);
  const double reach = Norm(this->GetOrigin(patch).data()) + radius + moved;
  change.clear();
  for (const BoundClass& c : this->Request.Classes)
  {
    change.push_back(GetIntegrandChange(c, moved, turned, normal, reach));
  }
}

void PanelBounds::FillChangeBeyond(const Patch& patch, double moved, std::vector<double>& change) const
{
  // A sum of control points times weights is at most `growth` times the weight and the longest of them, and its derivative at most
  // 2 n growth (1 + growth) times that.
  double growth = 1.0;
  for (int d = 0; d < 2; ++d)
  {
    growth *= IntegerPower(
      1.0 + 2.0 * std::max({ 0.0, -this->Trim.GetLow(d), this->Trim.GetHigh(d) - 1.0 }), patch.Degree[d]);
  }
  double largest = 0.0;
  for (int i = 0; i < (patch.Degree[0] + 1) * (patch.Degree[1] + 1); ++i)
  {
    largest = std::max(largest, this->Panels.Points[patch.FirstPoint + i][3]);
  }
  const double weight = this->Majorants->GetLowestWeight();
  growth *= weight > 0.0 ? largest / weight : std::numeric_limits<double>::infinity();
  const double factor = 2.0 * growth * (1.0 + growth);
  const double slope[2] = { factor * patch.Degree[0] * moved, factor * patch.Degree[1] * moved };
  const double stretch[2] = { factor * patch.Degree[0] * patch.Radius,
    factor * patch.Degree[1] * patch.Radius };
  this->FillChange(patch, growth * moved, slope, growth * patch.Radius, stretch, change);
}

const std::vector<double>& PanelBounds::GetChange()
{
  const PatchSeries& series = *this->PartSeries;
  if (series.Change.empty() || this->Trim.IsOnPatch(*this->PartPatch))
  {
    return series.Change;
  }
  this->FillChangeBeyond(*this->PartPatch, series.Moved, this->Change);
  return this->Change;
}

void PanelBounds::MakeSeries(const Patch& patch, double size, PatchSeries& series) const
{
  const std::array<double, 4>* points = this->Panels.Points.data() + patch.FirstPoint;
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  series.Points.assign(points, points + (p + 1) * (q + 1));
  CollapseEdges(series.Points, p, q, size);
  series.Traits = FindPatchTraits(series.Points.data(), p, q);
  series.Whole.ExpandPatch(
    series.Points.data(), p, q, series.Traits, GetPatchBox(series.Traits), this->GetOrigin(patch));
  // The difference is a rational patch with the same weights.
  std::vector<std::array<double, 4>> moved = series.Points;
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      moved[i][c] = points[i][c] - moved[i][c];
    }
  }
  Patch difference = patch;
  MeasurePatch(moved.data(), difference);
  series.Moved = difference.Radius;
  if (series.Moved > 0.0)
  {
    const auto grown = [](double x) { return TrimSeries::OnPatchGrowth * x; };
    const double slope[2] = { grown(difference.Stretch[0]), grown(difference.Stretch[1]) };
    const double stretch[2] = { grown(patch.Stretch[0]), grown(patch.Stretch[1]) };
    this->FillChange(patch, grown(series.Moved), slope, grown(patch.Radius), stretch, series.Change);
  }
}

bool PanelBounds::Fits(const PatchSeries& series, const PanelPart& part) const
{
  const double share = std::exp2(-part.Depth);
  for (std::size_t i = 0; i < series.Change.size(); ++i)
  {
    const double tolerance = share * this->Request.Tolerances[i];
    if (tolerance > 0.0 && 2.0 * series.Change[i] * this->Jacobian > LargestChange * tolerance)
    {
      return false;
    }
  }
  return true;
}

PanelBounds::PatchSeries& PanelBounds::GetSeries(const Panel& panel, const PanelPart& part)
{
  const Patch& patch = this->Panels.Patches[panel.Patch];
  std::array<std::unique_ptr<PatchSeries>, 2>& series = this->Series[panel.Patch];
  const auto get = [&](std::size_t i, double size) -> PatchSeries&
  {
    if (!series[i])
    {
      series[i] = std::make_unique<PatchSeries>();
      this->MakeSeries(patch, size, *series[i]);
    }
    return *series[i];
  };
  PatchSeries& nearly = get(0, NearlyCollapsed);
  const bool certain = nearly.Moved <= CertainlyCollapsed * patch.Radius;
  const bool chosen = certain || (this->Trim.IsOnPatch(patch) && this->Fits(nearly, part));
  this->PartPatch = &patch;
  PatchSeries& found = chosen ? nearly : get(1, CertainlyCollapsed);
  this->PartSeries = &found;
  return found;
}

std::array<double, 3> PanelBounds::GetOrigin(const Patch& patch) const
{
  return { patch.Center[0] + this->Request.Shift[0], patch.Center[1] + this->Request.Shift[1],
    patch.Center[2] + this->Request.Shift[2] };
}

void PanelBounds::ExpandTrim(const Panel& panel, const PanelPart& part)
{
  const double width = panel.End - panel.Start;
  this->Trim.Expand(this->Panels.Coefficients.data() + panel.Trim, panel.TrimDegree,
    this->Panels.Patches[panel.Patch], panel.Start + width * part.Start, panel.Start + width * part.End);
  this->Box = this->Trim.GetBox(part.XiStart, part.XiEnd);
  const Ellipse real = Ellipse::FromRadius(1.0);
  this->Jacobian =
    this->Trim.GetLargestS(real) * (part.XiEnd - part.XiStart) * this->Trim.GetLargestSlope(real);
}

bool PanelBounds::ExpandByPatch(const Panel& panel, const PanelPart& part)
{
  this->ExpandTrim(panel, part);
  const PatchSeries& series = this->GetSeries(panel, part);
  const ParameterBox box = GetPatchBox(series.Traits);
  if (!IsInside(this->Box, box) || !series.Whole.HasLength())
  {
    return false;
  }
  this->Majorants = &series.Whole;
  this->MajorantsBox = box;
  this->IsPolynomial = series.Traits.Polynomial;
  this->Bound(panel, part);
  return true;
}

void PanelBounds::ExpandByPart(const Panel& panel, const PanelPart& part, bool withForm)
{
  this->ExpandTrim(panel, part);
  const PatchSeries& series = this->GetSeries(panel, part);
  PatchTraits traits = series.Traits;
  traits.PolynomialLength = traits.PolynomialLength && withForm;
  traits.ConstantDirection = traits.ConstantDirection && withForm;
  const Patch& patch = this->Panels.Patches[panel.Patch];
  this->OfPart.Expand(
    series.Points.data(), patch.Degree[0], patch.Degree[1], traits, this->Box, this->GetOrigin(patch));
  this->Majorants = &this->OfPart;
  this->MajorantsBox = this->Box;
  this->IsPolynomial = traits.Polynomial;
  this->Bound(panel, part);
}

bool PanelBounds::IsPatch() const
{
  return this->Box.Half[0] >= 0.49 && this->Box.Half[1] >= 0.49;
}

Ellipse PanelBounds::Embed(const Ellipse& ellipse, int direction) const
{
  // The box lies within that of the majorants: distances to the ends of the larger interval are longer by the distances between the ends.
  const double ratio = this->Box.Half[direction] / this->MajorantsBox.Half[direction];
  return Ellipse::FromHalfAxis(1.0 + ratio * (ellipse.GetHalfAxis() - 1.0));
}

void PanelBounds::Bound(const Panel& panel, const PanelPart& part)
{
  const Ellipse real = Ellipse::FromRadius(1.0);
  const std::size_t count = this->Request.Classes.size();
  if (this->Majorants->Evaluate(real, real, this->Request.Classes, this->Supremum))
  {
    this->Reach = std::max(this->Reach, this->Majorants->GetReach());
    for (double& value : this->Supremum)
    {
      value *= this->Jacobian;
    }
  }
  else
  {
    this->Supremum.assign(count, std::numeric_limits<double>::infinity());
  }
  // Each direction gets half of the tolerance. An integral that is smaller than its tolerance needs no order of its own (share 0).
  this->Shares.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double half = 0.5 * std::exp2(-part.Depth) * this->Request.Tolerances[i];
    this->Shares[i] = this->Supremum[i] <= half ? 0.0 : half;
  }
  this->AlongT.Reset(this->Shares, LargestOrder);
  this->AcrossXi.Reset(this->Shares, LargestOrder);
  this->BoundAcross(panel);
  this->BoundAlong(part);
  if (this->IsPolynomial)
  {
    this->SetPolynomialOrders(this->Panels.Patches[panel.Patch]);
  }
}

void PanelBounds::BoundAcross(const Panel& panel)
{
  if (panel.Shape != PanelShape::General)
  {
    // Along a straight ruling x.n is linear, |n| too unless it vanishes somewhere, and g has its degree.
    const int order = (this->Degree + 3) / 2;
    for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
    {
      if (this->Request.Classes[i].Kind != BoundClass::AreaMoment || panel.Shape == PanelShape::Prismatic ||
        this->Majorants->HasLength())
      {
        this->AcrossXi.SetExactOrder(i, order);
      }
    }
    return;
  }
  const Ellipse real = Ellipse::FromRadius(1.0);
  SearchEllipses(PanelRadii,
    [&](const EllipseRadius& radius)
    {
      const Ellipse s = this->Embed(Ellipse::FromRadius(radius.GetValue()), 0);
      return this->AddEllipse(s, real, this->Jacobian, radius, this->AcrossXi);
    });
}

void PanelBounds::BoundAlong(const PanelPart& part)
{
  SearchEllipses(PanelRadii,
    [&](const EllipseRadius& radius)
    {
      const Ellipse t = Ellipse::FromRadius(radius.GetValue());
      const Ellipse s = this->Trim.Map(t, 0, this->MajorantsBox, part.XiStart, part.XiEnd);
      const Ellipse r = this->Trim.Map(t, 1, this->MajorantsBox, part.XiStart, part.XiEnd);
      const double factor =
        this->Trim.GetLargestS(t) * (part.XiEnd - part.XiStart) * this->Trim.GetLargestSlope(t);
      return this->AddEllipse(s, r, factor, radius, this->AlongT);
    });
}

EllipseGain PanelBounds::AddEllipse(
  const Ellipse& s, const Ellipse& r, double factor, const EllipseRadius& radius, DirectionBound& direction)
{
  if (!this->Majorants->Evaluate(s, r, this->Request.Classes, this->Bounds))
  {
    return EllipseGain::None;
  }
  for (double& bound : this->Bounds)
  {
    bound *= factor;
  }
  return direction.AddEllipse(radius, this->Bounds) ? EllipseGain::Useful : EllipseGain::Worse;
}

void PanelBounds::SetPolynomialOrders(const Patch& patch)
{
  // Numerators have degree 3p-2 in s and 3q-2 in r, heights times normals one more, positions p and q; in t all of these times
  // the trim's degree, and s(t) r'(t).
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  const int d = this->Trim.GetDegree();
  const bool straight = this->Trim.IsConstantInS();
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    if (c.Kind != BoundClass::AreaMoment)
    {
      const int more = c.Kind == BoundClass::HeightMoment ? 1 : 0;
      const int inS = 3 * p - 2 + more + c.Degree * p;
      const int inR = 3 * q - 2 + more + c.Degree * q;
      const int inT = straight ? inR * d + d - 1 : (inS + inR) * d + 2 * d - 1;
      this->AcrossXi.SetExactOrder(i, inS / 2 + 1);
      this->AlongT.SetExactOrder(i, std::max(inT, 0) / 2 + 1);
    }
  }
}

double PanelBounds::GetError(std::size_t integrand, int along, int across) const
{
  // The rule's weights are positive: it cannot be off by more than twice the largest value.
  return std::min(2.0 * this->Supremum[integrand],
    this->AlongT.GetError(integrand, along) + this->AcrossXi.GetError(integrand, across));
}
}
