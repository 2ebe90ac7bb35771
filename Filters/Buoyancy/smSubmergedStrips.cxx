#include "smSubmergedStrips.h"

#include "smChebyshev.h"
#include "smPatchParts.h"
#include "smPolynomialCurve.h"
#include "smSignChanges.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace sm
{
namespace
{
using Point3 = std::array<double, 3>;

// Share of the limits for one crossing.
constexpr double CrossingShare = 1.0 / 4096.0;
// Largest numbers of halvings of an interval and of parts of a strip.
constexpr int MostHalvings = 44;
constexpr int MostParts = 4096;
// Roundings of a point of an edge's curve, relative to its coordinates.
constexpr double EdgeRoundings = 32.0;

/// A ribbon whose two curves are parametrised over [0,1].
class Strip
{
public:
  Strip(const FacePanels& panels, const Ribbon& ribbon);

  /// Returns the position of the face's curve in the parameters of the trim pieces, and that of the edge's curve.
  std::array<double, 2> EvaluateTrim(double t) const { return this->Trim.Evaluate(this->ToTrim(t)); }
  Point3 EvaluateEdge(double t) const { return this->EdgePiece.Evaluate(this->ToEdge(t)); }

  /// Returns an upper bound of the distance between the curves at equal t in [start, end].
  double GetGap(double start, double end) const;

  int FaceDegree;
  int EdgeDegree;
  /// Upper bounds of the gap between the curves and of the sum of their lengths. The strip's area is at most their product.
  double Gap;
  double Length;
  /// Lowest weight of the patch.
  double LowestWeight;
  /// Largest distance of the edge's control points from the model's origin.
  double EdgeReach = 0.0;

private:
  double ToTrim(double t) const { return this->Own.Start + (this->Own.End - this->Own.Start) * t; }
  double ToEdge(double t) const
  {
    return this->Own.EdgeStart + (this->Own.EdgeEnd - this->Own.EdgeStart) * t;
  }

  const FacePanels& Panels;
  const Patch& Source;
  const Ribbon& Own;
  std::vector<std::array<double, 2>> TrimPoints;
  std::vector<Point3> EdgePoints;
  BernsteinPiece<2> Trim;
  BernsteinPiece<3> EdgePiece;
};

template <std::size_t Dimension>
std::vector<std::array<double, Dimension>> GetPoints(
  const FacePanels& panels, std::uint32_t first, int degree)
{
  std::vector<std::array<double, Dimension>> points(degree + 1);
  for (int i = 0; i <= degree; ++i)
  {
    std::copy_n(panels.Coefficients.data() + first + Dimension * i, Dimension, points[i].begin());
  }
  return points;
}

Strip::Strip(const FacePanels& panels, const Ribbon& ribbon)
  : Panels(panels)
  , Source(panels.Patches[ribbon.Patch])
  , Own(ribbon)
  , TrimPoints(GetPoints<2>(panels, ribbon.Trim, ribbon.TrimDegree))
  , EdgePoints(GetPoints<3>(panels, ribbon.Edge, ribbon.EdgeDegree))
  , Trim{ this->TrimPoints.data(), ribbon.TrimDegree }
  , EdgePiece{ this->EdgePoints.data(), ribbon.EdgeDegree }
{
  const Patch& patch = this->Source;
  this->FaceDegree = 0;
  double length = 0.0;
  for (int d = 0; d < 2; ++d)
  {
    double largest = 0.0;
    for (int i = 0; i < ribbon.TrimDegree; ++i)
    {
      largest =
        std::max(largest, std::abs(this->Trim.Coefficients[i + 1][d] - this->Trim.Coefficients[i][d]));
    }
    this->FaceDegree += largest > 0.0 ? patch.Degree[d] * ribbon.TrimDegree : 0;
    length += ribbon.TrimDegree * largest * (ribbon.End - ribbon.Start) * patch.Stretch[d] / patch.Width[d];
  }
  this->EdgeDegree = ribbon.EdgeDegree;
  double step = 0.0;
  for (int i = 0; i < ribbon.EdgeDegree; ++i)
  {
    const Point3& a = this->EdgePiece.Coefficients[i];
    const Point3& b = this->EdgePiece.Coefficients[i + 1];
    step = std::max(step, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  this->Length = length + ribbon.EdgeDegree * step * std::abs(ribbon.EdgeEnd - ribbon.EdgeStart);
  for (const Point3& point : this->EdgePoints)
  {
    this->EdgeReach = std::max(this->EdgeReach, Norm(point));
  }
  this->LowestWeight = std::numeric_limits<double>::infinity();
  for (int i = 0; i < (patch.Degree[0] + 1) * (patch.Degree[1] + 1); ++i)
  {
    this->LowestWeight = std::min(this->LowestWeight, panels.Points[patch.FirstPoint + i][3]);
  }
  this->Gap = this->GetGap(0.0, 1.0);
}

double Strip::GetGap(double start, double end) const
{
  // With the edge curve C, the patch's homogeneous position P and its weight w, C w - P is a polynomial along the strip.
  const Patch& patch = this->Source;
  const int degree = this->FaceDegree + this->EdgeDegree;
  const auto sample = [&](double t)
  {
    const std::array<double, 2> at = this->EvaluateTrim(t);
    const double local[2] = { (at[0] - patch.Start[0]) / patch.Width[0],
      (at[1] - patch.Start[1]) / patch.Width[1] };
    std::array<double, 4> line[MaximumDegree + 1] = {};
    for (int j = 0; j <= patch.Degree[1]; ++j)
    {
      line[j] = BernsteinPiece<4>{ this->Panels.Points.data() + patch.FirstPoint + j * (patch.Degree[0] + 1),
        patch.Degree[0] }
                  .Evaluate(local[0]);
    }
    const std::array<double, 4> h = BernsteinPiece<4>{ line, patch.Degree[1] }.Evaluate(local[1]);
    const Point3 edge = this->EvaluateEdge(t);
    Point3 gap;
    for (int c = 0; c < 3; ++c)
    {
      gap[c] = (edge[c] - patch.Center[c]) * h[3] - h[c];
    }
    return gap;
  };
  if (degree >= ChebyshevRule::MaximumSize)
  {
    const Point3 gap = sample(0.5 * (start + end));
    return std::hypot(gap[0], gap[1], gap[2]) / this->LowestWeight + this->Length * (end - start);
  }
  Point3 largest{};
  std::vector<double> series;
  // The three expansions ask for the same nodes in the same order.
  std::vector<Point3> samples;
  for (int c = 0; c < 3; ++c)
  {
    std::size_t node = 0;
    const auto getComponent = [&](double t)
    {
      if (c == 0)
      {
        samples.push_back(sample(t));
      }
      return samples[node++][c];
    };
    ExpandPolynomial(getComponent, degree, start, end, series);
    largest[c] = GetLargest(series);
  }
  return std::hypot(largest[0], largest[1], largest[2]) / this->LowestWeight;
}

/// Clips the triangle at the plane into at most two triangles. h is linear on it, so that a rounding error of the cut has only a
/// second-order effect.
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

/// Returns a bound of the displacement of a point of the border on a patch by residuals of the coedge's curves.
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
  /// Height of a curve of the strip over an interval: that in the middle, how far the others may be from it, and the bound of their
  /// error.
  struct Heights
  {
    double Middle, Spread, Noise;

    /// True if all have one sign.
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
    /// Bound of the distance of the strip's points from where they should be.
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
  /// Halves an interval until both curves are on a certain side on it, or the area of the strip there is small.
  void CutInterval(Open& open, double start, double end, int depth);
  void KeepInterval(Open& open, double start, double end);
  void Keep(const Ribbon& ribbon, double start, double end);

  const FacePanels& From;
  const HeightPlane& Plane;
  CutLimits Limits;
  FacePanels& To;
  /// Of all coedges, see ListResiduals().
  std::vector<std::array<double, 3>> Residuals;
  /// Bound of the distance of all points of the border from where they should be.
  double LargestMoved;
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
  , LargestMoved(limits.Displacement + GetBorderResidual(face, from))
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
  const double weight = open.Curves.LowestWeight;
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
    if (!isCertain && !isSmall && !isNoise && depth < MostHalvings && open.Parts < MostParts)
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
  const double moved = this->LargestMoved;
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

double GetStripArea(const FacePanels& panels)
{
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
  return area;
}
}
