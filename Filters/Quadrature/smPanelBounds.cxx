#include "Detail/smPanelBounds.h"

#include "Detail/smIntegerPower.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// PanelRadii of the ellipses tried: the smallest bound counts.
const EllipseRadius PanelRadii[] = { EllipseRadius(1.3), EllipseRadius(1.5), EllipseRadius(1.75),
  EllipseRadius(2.05), EllipseRadius(2.4), EllipseRadius(2.8), EllipseRadius(3.3), EllipseRadius(4.0),
  EllipseRadius(5.0), EllipseRadius(6.5), EllipseRadius(9.0), EllipseRadius(13.0), EllipseRadius(20.0),
  EllipseRadius(40.0), EllipseRadius(100.0) };
// The fraction of a panel's tolerance that may be spent on the change by making edges points.
constexpr double MaxChange = 0.25;

bool IsInside(const ParameterBox& box, const ParameterBox& outer)
{
  return std::abs(box.Middle[0] - outer.Middle[0]) + box.Half[0] <= outer.Half[0] &&
    std::abs(box.Middle[1] - outer.Middle[1]) + box.Half[1] <= outer.Half[1];
}
}

PanelBounds::PanelBounds(const FacePanels& panels, const PlanRequest& request, FaceSeries& series, int degree)
  : Panels(panels)
  , Request(request)
  , Degree(degree)
  , HasDirection(std::any_of(request.Classes.begin(), request.Classes.end(),
      [](const BoundClass& c) { return c.Kind == BoundClass::AreaBasis; }))
  , Series(series)
{
}

int PanelBounds::GetPoleDirection() const
{
  for (int edge = 0; edge < 4; ++edge)
  {
    if (this->PartSeries->Traits.Collapsed[edge] && this->Box.GetDistance(edge) < this->Box.Half[edge / 2])
    {
      return edge / 2;
    }
  }
  return -1;
}

PatchChange PanelBounds::MakeChangeBeyond(const Patch& patch, double moved) const
{
  // A sum of control points times weights is at most `growth` times the weight and the longest of them, and
  // its derivative at most 2 n growth (1 + growth) times that.
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
  const double weight = this->Majorants->GetMinWeight();
  // The sum of the Bernstein polynomials' absolute values, over the weight.
  const double basis = weight > 0.0 ? growth / weight : std::numeric_limits<double>::infinity();
  growth *= weight > 0.0 ? largest / weight : std::numeric_limits<double>::infinity();
  const double factor = 2.0 * growth * (1.0 + growth);
  const double slope[2] = { factor * patch.Degree[0] * moved, factor * patch.Degree[1] * moved };
  const double stretch[2] = { factor * patch.Degree[0] * patch.Radius,
    factor * patch.Degree[1] * patch.Radius };
  return MakePatchChange(patch, this->Request, growth * moved, slope, growth * patch.Radius, stretch, basis);
}

const PatchChange& PanelBounds::GetChange()
{
  const PatchSeries& series = *this->PartSeries;
  if (series.Change.Integrands.empty() || this->Trim.IsOnPatch(*this->PartPatch))
  {
    return series.Change;
  }
  this->Change = this->MakeChangeBeyond(*this->PartPatch, series.Moved);
  return this->Change;
}

bool PanelBounds::Fits(const PatchSeries& series, const PanelPart& part) const
{
  const double share = std::exp2(-part.Depth);
  const std::vector<double>& change = series.Change.Integrands;
  for (std::size_t i = 0; i < change.size(); ++i)
  {
    const double tolerance = share * this->Request.Tolerances[i];
    if (tolerance > 0.0 && 2.0 * change[i] * this->Jacobian > MaxChange * tolerance)
    {
      return false;
    }
  }
  return true;
}

const PatchSeries& PanelBounds::GetSeries(const Panel& panel, const PanelPart& part, bool withForm)
{
  const Patch& patch = this->Panels.Patches[panel.Patch];
  const PatchSeries& nearly = this->Series.Get(panel.Patch, FaceSeries::Poles::Nearly, withForm);
  const bool chosen = nearly.IsCertain || (this->Trim.IsOnPatch(patch) && this->Fits(nearly, part));
  this->PartPatch = &patch;
  this->PartSeries = chosen ? &nearly : &this->Series.Get(panel.Patch, FaceSeries::Poles::Certain, withForm);
  return *this->PartSeries;
}

void PanelBounds::ExpandTrim(const Panel& panel, const PanelPart& part)
{
  const double width = panel.End - panel.Start;
  this->Trim.Expand(this->Panels.Coefficients.data() + panel.Trim, panel.TrimDegree,
    this->Panels.Patches[panel.Patch], panel.Start + width * part.Start, panel.Start + width * part.End);
  this->Box = this->Trim.GetBox(part.XiStart, part.XiEnd);
  const Ellipse real = Ellipse::FromRadius(1.0);
  this->Jacobian = this->Trim.GetMaxS(real) * (part.XiEnd - part.XiStart) * this->Trim.GetMaxSlope(real);
}

bool PanelBounds::ExpandByPatch(const Panel& panel, const PanelPart& part, bool withForm)
{
  this->ExpandTrim(panel, part);
  const PatchSeries& series = this->GetSeries(panel, part, withForm);
  if (!IsInside(this->Box, series.Box) || !series.Whole.HasLength())
  {
    return false;
  }
  this->Majorants = &series.Whole;
  this->MajorantsBox = series.Box;
  this->IsPolynomial = series.Traits.Polynomial;
  this->Bound(panel, part);
  return true;
}

bool PanelBounds::ExpandByStrip(const Panel& panel, const PanelPart& part)
{
  this->ExpandTrim(panel, part);
  const PatchSeries& series = this->GetSeries(panel, part, true);
  ParameterBox box;
  const PatchMajorants* strip =
    series.Strips.Find(series, this->Panels.Patches[panel.Patch], this->Request, this->Box, box);
  if (!strip || !strip->HasLength())
  {
    return false;
  }
  this->Majorants = strip;
  this->MajorantsBox = box;
  this->IsPolynomial = series.Traits.Polynomial;
  this->Bound(panel, part);
  return true;
}

void PanelBounds::ExpandByPart(const Panel& panel, const PanelPart& part, bool withForm)
{
  this->ExpandTrim(panel, part);
  const PatchSeries& series = this->GetSeries(panel, part, true);
  PatchTraits traits = series.Traits;
  // What is known of |m| was found on the box of the patch's series, and nothing is known beyond.
  const bool hasForm = withForm && IsInside(this->Box, series.Box);
  traits.PolynomialLength = traits.PolynomialLength && hasForm;
  traits.ConstantDirection = traits.ConstantDirection && hasForm;
  traits.SquareDeviation = hasForm ? traits.SquareDeviation : 0.0;
  for (int edge = 0; this->HasDirection && edge < 4; ++edge)
  {
    // Beyond a collapsed edge the normal's direction is not that of the series.
    traits.Collapsed[edge] = traits.Collapsed[edge] && this->Box.GetDistance(edge) >= 0.0;
  }
  const Patch& patch = this->Panels.Patches[panel.Patch];
  this->OfPart.Expand(series.Points.data(), patch.Degree[0], patch.Degree[1], traits, this->Box,
    GetOrigin(patch, this->Request));
  this->Majorants = &this->OfPart;
  this->MajorantsBox = this->Box;
  this->IsPolynomial = traits.Polynomial;
  this->Bound(panel, part);
}

Ellipse PanelBounds::Embed(const Ellipse& ellipse, int direction) const
{
  // The box lies within that of the majorants: distances to the ends of the larger interval are longer by the
  // distances between the ends.
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
  // Each direction gets half of the tolerance. An integral that is smaller than its tolerance needs no order
  // of its own (share 0).
  this->Shares.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double half = 0.5 * std::exp2(-part.Depth) * this->Request.Tolerances[i];
    this->Shares[i] = this->Supremum[i] <= half ? 0.0 : half;
  }
  this->AlongT.Reset(this->Shares, MaxOrder);
  this->AcrossXi.Reset(this->Shares, MaxOrder);
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
      const BoundClass& c = this->Request.Classes[i];
      // The direction of the normal is constant to 1e-13 only, which matters to derivatives of an area.
      if (c.Kind != BoundClass::AreaBasis &&
        (c.Kind != BoundClass::AreaMoment || panel.Shape == PanelShape::Prismatic ||
          this->Majorants->HasLength()))
      {
        this->AcrossXi.SetExactOrder(i, order);
      }
    }
    if (!this->HasDirection)
    {
      return;
    }
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
      const double factor = this->Trim.GetMaxS(t) * (part.XiEnd - part.XiStart) * this->Trim.GetMaxSlope(t);
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
  // Numerators have degree 3p-2 in s and 3q-2 in r, heights times normals one more, positions p and q; in t
  // all of these times the trim's degree, and s(t) r'(t).
  const int p = patch.Degree[0];
  const int q = patch.Degree[1];
  const int d = this->Trim.GetDegree();
  const bool straight = this->Trim.IsConstantInS();
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    if (!c.HasLength())
    {
      // With equal weights a component of the normal has the degrees 2p - 1 and 2q - 1.
      const int more = c.Kind == BoundClass::HeightMoment ? 1 : 0;
      const bool isNormal = c.Kind == BoundClass::NormalBasis;
      const int basis = c.HasBasis() ? 1 : 0;
      const int inS = (isNormal ? 2 * p - 1 : 3 * p - 2) + basis * p + more + c.Degree * p;
      const int inR = (isNormal ? 2 * q - 1 : 3 * q - 2) + basis * q + more + c.Degree * q;
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
