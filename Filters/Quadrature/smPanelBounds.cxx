#include "smPanelBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// Radii of the ellipses tried: the least bound counts.
const EllipseRadius Radii[] = { EllipseRadius(1.3), EllipseRadius(1.5), EllipseRadius(1.75),
  EllipseRadius(2.05), EllipseRadius(2.4), EllipseRadius(2.8), EllipseRadius(3.3), EllipseRadius(4.0),
  EllipseRadius(5.0), EllipseRadius(6.5), EllipseRadius(9.0), EllipseRadius(13.0), EllipseRadius(20.0),
  EllipseRadius(40.0), EllipseRadius(100.0) };
// The box of a patch's series is larger by this, so that it holds trim curves that leave the patch by rounding.
constexpr double Margin = 1e-6;

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

PanelBounds::PatchSeries& PanelBounds::GetSeries(const Panel& panel)
{
  std::unique_ptr<PatchSeries>& series = this->Series[panel.Patch];
  if (!series)
  {
    const Patch& patch = this->Panels.Patches[panel.Patch];
    series = std::make_unique<PatchSeries>();
    series->Traits =
      FindPatchTraits(this->Panels.Points.data() + patch.FirstPoint, patch.Degree[0], patch.Degree[1]);
  }
  return *series;
}

std::array<double, 3> PanelBounds::GetOrigin(const Panel& panel) const
{
  const Patch& patch = this->Panels.Patches[panel.Patch];
  return { patch.Center[0] + this->Request.Shift[0], patch.Center[1] + this->Request.Shift[1],
    patch.Center[2] + this->Request.Shift[2] };
}

void PanelBounds::ExpandTrim(const Panel& panel, const PanelPart& part)
{
  const double width = panel.End - panel.Start;
  this->Trim.Expand(this->Panels.Coefficients.data() + panel.Trim, panel.TrimDegree,
    this->Panels.Patches[panel.Patch], panel.Start + width * part.Start, panel.Start + width * part.End);
  this->Box = this->Trim.GetBox(part.XiStart, part.XiEnd);
}

bool PanelBounds::ExpandByPatch(const Panel& panel, const PanelPart& part)
{
  this->ExpandTrim(panel, part);
  PatchSeries& series = this->GetSeries(panel);
  const ParameterBox box = GetPatchBox(series.Traits);
  if (!IsInside(this->Box, box))
  {
    return false;
  }
  if (!series.IsExpanded)
  {
    const Patch& patch = this->Panels.Patches[panel.Patch];
    series.Whole.Expand(this->Panels.Points.data() + patch.FirstPoint, patch.Degree[0], patch.Degree[1],
      series.Traits, box, this->GetOrigin(panel));
    series.IsExpanded = true;
  }
  if (!series.Whole.HasLength())
  {
    return false;
  }
  this->Majorants = &series.Whole;
  this->MajorantsBox = box;
  this->IsPolynomial = series.Traits.Polynomial;
  this->Bound(panel, part);
  return true;
}

void PanelBounds::ExpandByPart(const Panel& panel, const PanelPart& part)
{
  this->ExpandTrim(panel, part);
  const PatchTraits& traits = this->GetSeries(panel).Traits;
  const Patch& patch = this->Panels.Patches[panel.Patch];
  this->OfPart.Expand(this->Panels.Points.data() + patch.FirstPoint, patch.Degree[0], patch.Degree[1], traits,
    this->Box, this->GetOrigin(panel));
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
  // The box is in that of the majorants: distances to the ends of a larger interval are longer by what is between the ends.
  const double ratio = this->Box.Half[direction] / this->MajorantsBox.Half[direction];
  return Ellipse::FromHalfAxis(1.0 + ratio * (ellipse.GetHalfAxis() - 1.0));
}

void PanelBounds::Bound(const Panel& panel, const PanelPart& part)
{
  const Ellipse real = Ellipse::FromRadius(1.0);
  this->Jacobian =
    this->Trim.GetLargestS(real) * (part.XiEnd - part.XiStart) * this->Trim.GetLargestSlope(real);
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
  // Half of the tolerance for each direction; nothing where that is more than the integral.
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
  for (const EllipseRadius& radius : Radii)
  {
    const Ellipse s = this->Embed(Ellipse::FromRadius(radius.GetValue()), 0);
    if (!this->Majorants->Evaluate(s, real, this->Request.Classes, this->Bounds))
    {
      return;
    }
    for (double& bound : this->Bounds)
    {
      bound *= this->Jacobian;
    }
    if (!this->AcrossXi.AddEllipse(radius, this->Bounds))
    {
      return;
    }
  }
}

void PanelBounds::BoundAlong(const PanelPart& part)
{
  for (const EllipseRadius& radius : Radii)
  {
    const Ellipse t = Ellipse::FromRadius(radius.GetValue());
    const Ellipse s = this->Trim.Map(t, 0, this->MajorantsBox, part.XiStart, part.XiEnd);
    const Ellipse r = this->Trim.Map(t, 1, this->MajorantsBox, part.XiStart, part.XiEnd);
    if (!this->Majorants->Evaluate(s, r, this->Request.Classes, this->Bounds))
    {
      return;
    }
    const double factor =
      this->Trim.GetLargestS(t) * (part.XiEnd - part.XiStart) * this->Trim.GetLargestSlope(t);
    for (double& bound : this->Bounds)
    {
      bound *= factor;
    }
    if (!this->AlongT.AddEllipse(radius, this->Bounds))
    {
      return;
    }
  }
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
