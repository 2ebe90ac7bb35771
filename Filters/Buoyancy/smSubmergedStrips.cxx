#include "Detail/smSubmergedStrips.h"

#include "Detail/smSignChanges.h"
#include "Detail/smStrip.h"
#include "smChebyshev.h"
#include "smPatchParts.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sm
{
namespace
{
// Share of the limits for one crossing.
constexpr double CrossingShare = 1.0 / 4096.0;
// Largest numbers of halvings of an interval and of parts of a strip.
constexpr int MaxHalvings = 44;
constexpr int MaxParts = 4096;
// Roundings of a point of an edge's curve, relative to its coordinates.
constexpr double EdgeRoundings = 32.0;

/// Clips the triangle at the plane into at most two triangles. h is linear on it, so that a rounding error of
/// the cut has only a second-order effect.
void CutCap(const Cap& cap, const HeightPlane& plane, FacePanels& to)
{
  const Point3* corners[3] = { &cap.Apex, &cap.From, &cap.To };
  std::vector<Point3> polygon;
  for (int i = 0; i < 3; ++i)
  {
    const Point3& a = *corners[i];
    const Point3& b = *corners[(i + 1) % 3];
    const double atA = plane.GetHeight(a);
    const double atB = plane.GetHeight(b);
    if (atA <= 0.0)
    {
      polygon.push_back(a);
    }
    if ((atA < 0.0 && atB > 0.0) || (atA > 0.0 && atB < 0.0))
    {
      const double share = atA / (atA - atB);
      polygon.push_back(
        { a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2]) });
    }
  }
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    to.Caps.push_back({ polygon[0], polygon[i - 1], polygon[i], cap.FlipNormal });
  }
}

/// Returns the residuals of each coedge's curve, in the parameters of the panels, and of its edge's curve.
std::vector<std::array<double, 3>> ListResiduals(const Face& face)
{
  // Panels may have u and v exchanged, see smFacePanels.h.
  const int u = face.Surface.Degree[0] > face.Surface.Degree[1] ? 1 : 0;
  std::vector<std::array<double, 3>> residuals;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      const std::array<double, 2>& trim = coedge.Curve.Residual;
      residuals.push_back({ trim[u], trim[1 - u], Norm(coedge.Use->Curve.Residual) });
    }
  }
  return residuals;
}

/// Returns a bound of the displacement of a point of the border on a patch by residuals of the coedge's
/// curves.
double GetDisplacement(const std::array<double, 3>& residual, const Patch& patch)
{
  double moved = residual[2];
  for (int d = 0; d < 2; ++d)
  {
    moved += 2.0 * residual[d] / patch.Width[d] * patch.Stretch[d];
  }
  return moved;
}

class StripCutter
{
public:
  StripCutter(const Face& face, const FacePanels& from, const HeightPlane& plane, const CutLimits& limits,
    FacePanels& to);
  void Cut(const Ribbon& ribbon);
  /// Adds the cap below the plane.
  void Cut(const Cap& cap);
  CutErrors Errors;

private:
  /// Heights of a curve of the strip over an interval: the height in the middle, the largest difference of
  /// other heights from it, and the bound of their error.
  struct Heights
  {
    double Middle, Spread, Noise;

    /// Returns true if all have one sign.
    bool IsCertain() const { return std::abs(this->Middle) >= this->Spread + this->Noise; }
    bool IsNoise() const { return std::abs(this->Middle) + this->Spread <= 2.0 * this->Noise; }
    double GetLargest() const { return std::abs(this->Middle) + this->Spread; }
  };
  /// A strip and the bounds that hold for all of it.
  struct Open
  {
    const Ribbon& Source;
    const Strip& Curves;
    const HeightNet& Net;
    /// Bound of the displacement of the strip's points relative to the plane.
    double Moved;
    double EdgeNoise;
    int Parts = 0;
    /// The interval that is below the plane and not yet appended.
    double From = 0.0;
    double To = 0.0;
  };

  double GetMoved(const Ribbon& ribbon) const;
  Heights GetFaceHeights(const Open& open, double start, double end) const;
  Heights GetEdgeHeights(const Open& open, double start, double end) const;
  /// Halves an interval until both curves are on a certain side on it, or the area of the strip there is
  /// small.
  void CutInterval(Open& open, double start, double end, int depth);
  void KeepInterval(Open& open, double start, double end);
  void Keep(const Ribbon& ribbon, double start, double end);

  const FacePanels& From;
  const HeightPlane& Plane;
  CutLimits Limits;
  FacePanels& To;
  /// Residuals of the curves of all coedges, see ListResiduals().
  std::vector<std::array<double, 3>> Residuals;
  /// Bound of the displacement of all points of the border relative to the plane.
  double MaxMoved;
  std::map<std::uint32_t, HeightNet> Nets;
  std::map<std::uint32_t, std::uint32_t> Patches;
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> Pieces;
};

StripCutter::StripCutter(
  const Face& face, const FacePanels& from, const HeightPlane& plane, const CutLimits& limits, FacePanels& to)
  : From(from)
  , Plane(plane)
  , Limits(limits)
  , To(to)
  , Residuals(ListResiduals(face))
  , MaxMoved(limits.Displacement + GetBorderResidual(face, from))
{
}

double StripCutter::GetMoved(const Ribbon& ribbon) const
{
  double moved = this->Limits.Displacement;
  if (ribbon.Coedge >= 0 && ribbon.Coedge < static_cast<int>(this->Residuals.size()))
  {
    moved += GetDisplacement(this->Residuals[ribbon.Coedge], this->From.Patches[ribbon.Patch]);
  }
  return moved;
}

StripCutter::Heights StripCutter::GetFaceHeights(const Open& open, double start, double end) const
{
  static thread_local std::vector<double> series;
  ExpandPolynomial(
    [&open](double t)
    {
      const std::array<double, 2> at = open.Curves.EvaluateTrim(t);
      return open.Net.Evaluate(at[0], at[1]);
    },
    open.Curves.FaceDegree, start, end, series);
  const double spread = GetLargest(series) - std::abs(series[0]);
  const double weight = open.Curves.MinWeight;
  return { series[0] / weight, spread / weight,
    this->Limits.HasArea() ? open.Net.GetNoise(open.Moved) / weight : 0.0 };
}

StripCutter::Heights StripCutter::GetEdgeHeights(const Open& open, double start, double end) const
{
  static thread_local std::vector<double> series;
  ExpandPolynomial([&open, this](double t) { return this->Plane.GetHeight(open.Curves.EvaluateEdge(t)); },
    open.Curves.EdgeDegree, start, end, series);
  return { series[0], GetLargest(series) - std::abs(series[0]), open.EdgeNoise };
}

void StripCutter::KeepInterval(Open& open, double start, double end)
{
  if (open.To == start && open.From < open.To)
  {
    open.To = end;
    return;
  }
  if (open.From < open.To)
  {
    this->Keep(open.Source, open.From, open.To);
  }
  open.From = start;
  open.To = end;
}

void StripCutter::CutInterval(Open& open, double start, double end, int depth)
{
  ++open.Parts;
  const Heights ofFace = this->GetFaceHeights(open, start, end);
  const Heights ofEdge = this->GetEdgeHeights(open, start, end);
  const bool isCertain = ofFace.IsCertain() && ofEdge.IsCertain();
  const bool isBelow = ofFace.Middle < 0.0 && ofEdge.Middle < 0.0;
  if (!isCertain || (ofFace.Middle < 0.0) != (ofEdge.Middle < 0.0))
  {
    const double gap = open.Curves.GetGap(start, end) + 2.0 * open.Moved;
    // Where the plane passes between the two curves, no point of the strip is further from it than the gap.
    const double height = isCertain ? gap : std::max(ofFace.GetLargest(), ofEdge.GetLargest());
    CutErrors cost;
    cost.Area = gap * open.Curves.Length * (end - start) + open.Moved * gap;
    cost.Volume = height * gap * open.Curves.Length * (end - start);
    const bool isSmall =
      cost.Volume <= CrossingShare * this->Limits.Volume && cost.Area <= CrossingShare * this->Limits.Area;
    const bool isNoise = ofFace.IsNoise() && ofEdge.IsNoise();
    if (!isCertain && !isSmall && !isNoise && depth < MaxHalvings && open.Parts < MaxParts)
    {
      const double middle = 0.5 * (start + end);
      this->CutInterval(open, start, middle, depth + 1);
      this->CutInterval(open, middle, end, depth + 1);
      return;
    }
    this->Errors.Volume += cost.Volume;
    this->Errors.Area += cost.Area;
  }
  if (isBelow)
  {
    this->KeepInterval(open, start, end);
  }
}

void StripCutter::Cut(const Ribbon& ribbon)
{
  const auto net =
    this->Nets.try_emplace(ribbon.Patch, this->From, this->From.Patches[ribbon.Patch], this->Plane);
  const Strip strip(this->From, ribbon);
  Open open{ ribbon, strip, net.first->second, this->GetMoved(ribbon), 0.0 };
  if (strip.FaceDegree >= ChebyshevRule::MaximumSize || strip.EdgeDegree >= ChebyshevRule::MaximumSize)
  {
    // Such a degree does not occur in files: the whole strip counts as uncertain.
    this->Errors.Area += (strip.Gap + 2.0 * open.Moved) * strip.Length;
    this->Errors.Volume += strip.Gap * strip.Length * (strip.Gap + strip.Length);
    return;
  }
  if (this->Limits.HasArea())
  {
    open.EdgeNoise = open.Moved + EdgeRoundings * UnitRoundoff * strip.EdgeReach;
  }
  this->CutInterval(open, 0.0, 1.0, 0);
  if (open.From < open.To)
  {
    this->Keep(ribbon, open.From, open.To);
  }
}

void StripCutter::Cut(const Cap& cap)
{
  CutCap(cap, this->Plane, this->To);
  const double moved = this->MaxMoved;
  int side = 0;
  for (const Point3* corner : { &cap.Apex, &cap.From, &cap.To })
  {
    const double height = this->Plane.GetHeight(*corner);
    side += height > moved ? 1 : height < -moved ? -1 : 0;
  }
  if (std::abs(side) < 3)
  {
    const double sides[2] = { Norm(Subtract(cap.From, cap.Apex)), Norm(Subtract(cap.To, cap.Apex)) };
    this->Errors.Area += 0.5 * sides[0] * sides[1] + 2.0 * moved * (sides[0] + sides[1]);
  }
}

void StripCutter::Keep(const Ribbon& ribbon, double start, double end)
{
  Ribbon part = ribbon;
  part.Start = ribbon.Start + (ribbon.End - ribbon.Start) * start;
  part.End = end == 1.0 ? ribbon.End : ribbon.Start + (ribbon.End - ribbon.Start) * end;
  part.EdgeStart = ribbon.EdgeStart + (ribbon.EdgeEnd - ribbon.EdgeStart) * start;
  part.EdgeEnd = end == 1.0 ? ribbon.EdgeEnd : ribbon.EdgeStart + (ribbon.EdgeEnd - ribbon.EdgeStart) * end;
  const Patch& patch = this->From.Patches[ribbon.Patch];
  const auto [place, isNew] = this->Patches.emplace(ribbon.Patch, 0);
  if (isNew)
  {
    place->second = AppendPatchPart(this->From, ribbon.Patch, { patch.Start[0], patch.Start[1] },
      { patch.Start[0] + patch.Width[0], patch.Start[1] + patch.Width[1] }, false, this->To);
  }
  part.Patch = place->second;
  const auto copy = [this](std::uint32_t first, int count)
  {
    const auto [piece, isNewPiece] = this->Pieces.emplace(
      std::make_pair(first, count), static_cast<std::uint32_t>(this->To.Coefficients.size()));
    if (isNewPiece)
    {
      const auto from = this->From.Coefficients.begin() + first;
      this->To.Coefficients.insert(this->To.Coefficients.end(), from, from + count);
    }
    return piece->second;
  };
  part.Trim = copy(ribbon.Trim, 2 * (ribbon.TrimDegree + 1));
  part.Edge = copy(ribbon.Edge, 3 * (ribbon.EdgeDegree + 1));
  this->To.Ribbons.push_back(part);
}
}

CutErrors CutStripsBelow(
  const Face& face, const FacePanels& from, const HeightPlane& plane, const CutLimits& limits, FacePanels& to)
{
  StripCutter cutter(face, from, plane, limits, to);
  for (const Ribbon& ribbon : from.Ribbons)
  {
    cutter.Cut(ribbon);
  }
  for (const Cap& cap : from.Caps)
  {
    cutter.Cut(cap);
  }
  return cutter.Errors;
}

double GetBorderResidual(const Face& face, const FacePanels& panels)
{
  double largest = 0.0;
  for (const std::array<double, 3>& residual : ListResiduals(face))
  {
    largest = std::max(largest, residual[2]);
    for (const Patch& patch : panels.Patches)
    {
      largest = std::max(largest, GetDisplacement(residual, patch));
    }
  }
  return largest;
}

double GetStripArea(const CutFace& face)
{
  if (const double known = face.StripArea.Value; known >= 0.0)
  {
    return known;
  }
  const FacePanels& panels = face.Panels;
  double area = 0.0;
  for (const Ribbon& ribbon : panels.Ribbons)
  {
    const Strip strip(panels, ribbon);
    area += strip.Gap * strip.Length;
  }
  for (const Cap& cap : panels.Caps)
  {
    area += 0.5 * Norm(Subtract(cap.From, cap.Apex)) * Norm(Subtract(cap.To, cap.Apex));
  }
  face.StripArea.Value = area;
  return area;
}
}
