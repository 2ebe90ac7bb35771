#include "smSubmergedStrips.h"

#include "smChebyshev.h"
#include "smPatchParts.h"
#include "smPolynomialCurve.h"
#include "smSignChanges.h"
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

// Share of the tolerance for the position of one crossing.
constexpr double CrossingShare = 1.0 / 4096.0;

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

class StripCutter
{
public:
  StripCutter(const FacePanels& from, const HeightPlane& plane, double tolerance, FacePanels& to)
    : From(from)
    , Plane(plane)
    , Small(CrossingShare * tolerance)
    , To(to)
  {
  }
  void Cut(const Ribbon& ribbon);
  double CutError = 0.0;

private:
  /// Returns ranges of equal sign of the height of the face's curve, or of the edge's curve.
  std::vector<SignedRange> FindRanges(const Strip& strip, const HeightNet& net, bool ofEdge);
  void Keep(const Ribbon& ribbon, double start, double end);

  const FacePanels& From;
  const HeightPlane& Plane;
  double Small;
  FacePanels& To;
  std::map<std::uint32_t, HeightNet> Nets;
  std::map<std::uint32_t, std::uint32_t> Patches;
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> Pieces;
};

std::vector<SignedRange> StripCutter::FindRanges(const Strip& strip, const HeightNet& net, bool ofEdge)
{
  const auto evaluateFace = [&strip, &net](double t)
  {
    const std::array<double, 2> at = strip.EvaluateTrim(t);
    return net.Evaluate(at[0], at[1]);
  };
  const auto evaluateEdge = [&strip, this](double t) { return this->Plane.GetHeight(strip.EvaluateEdge(t)); };
  std::vector<SignedRange> ranges;
  const int degree = ofEdge ? strip.EdgeDegree : strip.FaceDegree;
  if (degree >= ChebyshevRule::MaximumSize)
  {
    // Such a degree does not occur in files: the whole strip counts as uncertain.
    this->CutError += strip.Gap * strip.Length * (strip.Gap + strip.Length);
    ranges.push_back({ 0.0, 1.0, evaluateFace(0.5) < 0.0 });
    return ranges;
  }
  const double weight = ofEdge ? 1.0 : strip.LowestWeight;
  FindSignedRanges([&](double t) { return ofEdge ? evaluateEdge(t) : evaluateFace(t); }, degree, 0.0, 1.0,
    [&](double start, double end, double largest, bool last)
    {
      const double cost = largest / weight * strip.Gap * strip.Length * (end - start);
      if (last || cost <= this->Small)
      {
        this->CutError += cost;
        return true;
      }
      return false;
    },
    ranges);
  return ranges;
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

void StripCutter::Cut(const Ribbon& ribbon)
{
  const auto net =
    this->Nets.try_emplace(ribbon.Patch, this->From, this->From.Patches[ribbon.Patch], this->Plane);
  const Strip strip(this->From, ribbon);
  const std::vector<SignedRange> ofFace = this->FindRanges(strip, net.first->second, false);
  const std::vector<SignedRange> ofEdge = this->FindRanges(strip, net.first->second, true);
  double start = 0.0;
  std::size_t a = 0;
  std::size_t b = 0;
  while (a < ofFace.size() && b < ofEdge.size())
  {
    const double end = std::min(ofFace[a].End, ofEdge[b].End);
    if (ofFace[a].Negative && ofEdge[b].Negative)
    {
      this->Keep(ribbon, start, end);
    }
    else if (ofFace[a].Negative != ofEdge[b].Negative)
    {
      // The plane passes between the two curves, so that no point of the strip is further from the plane than the gap.
      const double gap = strip.GetGap(start, end);
      this->CutError += gap * gap * strip.Length * (end - start);
    }
    start = end;
    a += ofFace[a].End == end ? 1 : 0;
    b += b < ofEdge.size() && ofEdge[b].End == end ? 1 : 0;
  }
}
}

double CutStripsBelow(const FacePanels& from, const HeightPlane& plane, double tolerance, FacePanels& to)
{
  StripCutter cutter(from, plane, tolerance, to);
  for (const Ribbon& ribbon : from.Ribbons)
  {
    cutter.Cut(ribbon);
  }
  for (const Cap& cap : from.Caps)
  {
    CutCap(cap, plane, to);
  }
  return cutter.CutError;
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
