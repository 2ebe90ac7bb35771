#include "Detail/smNetChange.h"
#include "smModelEdit.h"
#include "smParallelFor.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace sm
{
namespace
{
// Smallest number of parameters of a coedge at which gaps are measured. They are distributed over the pieces
// of its curves, at least one in each.
constexpr std::size_t Samples = 32;
// Increase of a gap, relative to the size of the body, above which an edge counts as opened; many times the
// rounding of the points that are compared.
constexpr double OpeningTolerance = 1e-12;
constexpr int FootSteps = 3;

/// Returns the distance of a point from a curve near parameter t, by Newton's method for the foot point; at
/// most the distance at t itself.
double GetDistance(const EdgeCurve& curve, double t, const double point[3])
{
  double minimum = std::numeric_limits<double>::max();
  for (int step = 0; step <= FootSteps; ++step)
  {
    EdgeCurve::Point tangent;
    const EdgeCurve::Point foot = curve.Evaluate(t, &tangent);
    const double off[3] = { point[0] - foot[0], point[1] - foot[1], point[2] - foot[2] };
    const double distance = std::hypot(off[0], off[1], off[2]);
    if (!(distance < minimum))
    {
      return std::isnan(distance) ? distance : minimum;
    }
    minimum = distance;
    const double speed = Dot(tangent, tangent);
    if (!(speed > 0.0))
    {
      break;
    }
    const double dot = Dot(off, tangent.data());
    t = std::clamp(t + dot / speed, curve.GetStart(), curve.GetEnd());
  }
  return minimum;
}

/// Returns the largest distance of the coedge on the surface from its edge; NaN if one of them is.
double MeasureGap(const Face& face, const Coedge& coedge)
{
  const EdgeCurve& curve = coedge.Use->Curve;
  if (curve.GetNumberOfPieces() < 1 || coedge.Curve.GetNumberOfPieces() < 1)
  {
    return 0.0;
  }
  std::vector<double> breaks = coedge.Curve.Breaks;
  breaks.insert(breaks.end(), curve.Breaks.begin(), curve.Breaks.end());
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  const std::size_t each = Samples / std::max<std::size_t>(breaks.size() - 1, 1) + 1;
  double gap = 0.0;
  NURBSSurface::Walker surface(face.Surface);
  for (std::size_t i = 0; i < breaks.size(); ++i)
  {
    // Samples at a break, and inside the piece from there to the next: a fitted curve interpolates at the
    // breaks, so that its error is larger between them.
    const double width = i + 1 < breaks.size() ? breaks[i + 1] - breaks[i] : 0.0;
    for (std::size_t k = 0; k <= (width > 0.0 ? each : 0); ++k)
    {
      const double t = breaks[i] + width * (k == 0 ? 0.0 : (k - 0.5) / each);
      const TrimCurve::Point uv = coedge.Curve.Evaluate(t);
      double position[3];
      surface.Evaluate(uv[0], uv[1], position);
      const double distance = GetDistance(curve, t, position);
      gap = std::isnan(gap) || distance <= gap ? gap : distance;
    }
  }
  return gap;
}

/// The region of the parameter domain in which two surfaces with the same degrees and knots may differ.
class Difference
{
public:
  Difference(const NURBSSurface& before, const NURBSSurface& after)
    : SameLayout(before.Degree[0] == after.Degree[0] && before.Degree[1] == after.Degree[1] &&
        before.Knots[0] == after.Knots[0] && before.Knots[1] == after.Knots[1])
  {
    const int columns = after.NumberOfControlPoints[0];
    int first[2] = { std::numeric_limits<int>::max(), std::numeric_limits<int>::max() };
    int last[2] = { -1, -1 };
    for (std::size_t i = 0; this->SameLayout && i < after.ControlPoints.size(); ++i)
    {
      if (before.ControlPoints[i] != after.ControlPoints[i])
      {
        const int at[2] = { static_cast<int>(i) % columns, static_cast<int>(i) / columns };
        for (int d = 0; d < 2; ++d)
        {
          first[d] = std::min(first[d], at[d]);
          last[d] = std::max(last[d], at[d]);
        }
      }
    }
    this->Some = last[0] >= 0;
    for (int d = 0; d < 2 && this->Some; ++d)
    {
      this->Start[d] = after.GetDomainStart(d);
      this->End[d] = after.GetDomainEnd(d);
      this->Low[d] = after.Knots[d][first[d]];
      this->High[d] = after.Knots[d][last[d] + after.Degree[d] + 1];
      // Basis functions that do not vanish at an end of the domain: the region includes that end.
      this->Low[d] -= first[d] == 0 ? this->End[d] - this->Start[d] : 0.0;
      this->High[d] += last[d] + 1 == after.NumberOfControlPoints[d] ? this->End[d] - this->Start[d] : 0.0;
    }
  }

  /// Returns true if the control polygon of a curve lies outside the region, so that both surfaces agree
  /// along it. A curve that leaves the domain, where the polynomials of the last spans are continued, gives
  /// false.
  bool Spares(const TrimCurve& trim) const
  {
    if (!this->SameLayout || !this->Some || trim.Coefficients.empty())
    {
      return this->SameLayout;
    }
    bool apart = false;
    for (int d = 0; d < 2; ++d)
    {
      const auto [low, high] = std::minmax_element(trim.Coefficients.begin(), trim.Coefficients.end(),
        [d](const TrimCurve::Point& a, const TrimCurve::Point& b) { return a[d] < b[d]; });
      if ((*low)[d] < this->Start[d] || (*high)[d] > this->End[d])
      {
        return false;
      }
      apart = apart || (*high)[d] <= this->Low[d] || (*low)[d] >= this->High[d];
    }
    return apart;
  }

private:
  bool SameLayout;
  bool Some = false;
  double Start[2] = { 0.0, 0.0 };
  double End[2] = { 0.0, 0.0 };
  /// The open box of parameters in which the surfaces may differ.
  double Low[2] = { 0.0, 0.0 };
  double High[2] = { 0.0, 0.0 };
};

bool IsSame(const TrimCurve& a, const TrimCurve& b)
{
  return a.Breaks == b.Breaks && a.Offsets == b.Offsets && a.Coefficients == b.Coefficients;
}

std::vector<OpenedEdge> CompareFace(const Face& before, const Face& after, int index, double tolerance)
{
  std::vector<OpenedEdge> opened;
  // Gaps can be measured on valid surfaces only.
  if (!before.Surface.Check().empty() || !after.Surface.Check().empty())
  {
    return opened;
  }
  const Difference difference(before.Surface, after.Surface);
  for (std::size_t l = 0; l < after.Loops.size(); ++l)
  {
    const std::vector<Coedge>& coedges = after.Loops[l].Coedges;
    const std::vector<Coedge> none;
    const std::vector<Coedge>& old = l < before.Loops.size() ? before.Loops[l].Coedges : none;
    for (std::size_t c = 0; c < coedges.size(); ++c)
    {
      const Coedge& coedge = coedges[c];
      if (old.size() == coedges.size() && coedge.Use == old[c].Use && difference.Spares(coedge.Curve) &&
        IsSame(coedge.Curve, old[c].Curve))
      {
        continue;
      }
      const double gap = MeasureGap(after, coedge);
      if (gap <= tolerance)
      {
        continue;
      }
      // A loop with another number of coedges has no predecessor: its whole gap is new.
      const double past = old.size() == coedges.size() ? MeasureGap(before, old[c]) : 0.0;
      if (!(gap <= past + tolerance))
      {
        opened.push_back({ coedge.Use, index, static_cast<int>(l), static_cast<int>(c), past, gap });
      }
    }
  }
  return opened;
}

/// Returns true if two faces have the same edges in the same order and directions.
bool UsesSameEdges(const Face& a, const Face& b)
{
  bool same = a.Reversed == b.Reversed && a.Loops.size() == b.Loops.size();
  for (std::size_t l = 0; same && l < a.Loops.size(); ++l)
  {
    same = std::equal(a.Loops[l].Coedges.begin(), a.Loops[l].Coedges.end(), b.Loops[l].Coedges.begin(),
      b.Loops[l].Coedges.end(),
      [](const Coedge& x, const Coedge& y) { return x.Use == y.Use && x.Reversed == y.Reversed; });
  }
  return same;
}

/// Returns the signed sum of the uses of every edge that is not degenerate.
std::unordered_map<const Edge*, int> CountUses(
  vtkTrimmedNURBSModel* model, std::vector<std::shared_ptr<const Edge>>& edges)
{
  std::unordered_map<const Edge*, int> uses;
  for (const FacePointer& face : model->GetFaces())
  {
    for (const Loop& loop : face->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        if (!coedge.Use->Degenerate)
        {
          const auto [place, isNew] = uses.emplace(coedge.Use.get(), 0);
          place->second += coedge.Reversed == face->Reversed ? 1 : -1;
          if (isNew)
          {
            edges.push_back(coedge.Use);
          }
        }
      }
    }
  }
  return uses;
}

/// Appends the edges whose signed uses cancelled before the edit and do not any more.
void FindLostUses(vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* after, std::vector<OpenedEdge>& opened)
{
  std::vector<std::shared_ptr<const Edge>> oldEdges;
  std::vector<std::shared_ptr<const Edge>> edges;
  const std::unordered_map<const Edge*, int> oldUses = CountUses(before, oldEdges);
  const std::unordered_map<const Edge*, int> uses = CountUses(after, edges);
  for (const std::shared_ptr<const Edge>& edge : edges)
  {
    const auto old = oldUses.find(edge.get());
    if (uses.at(edge.get()) != 0 && old != oldUses.end() && old->second == 0)
    {
      opened.push_back({ edge, -1, 0, 0, 0.0, std::numeric_limits<double>::infinity() });
    }
  }
}
}

std::vector<OpenedEdge> FindOpenedEdges(vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* after)
{
  std::vector<OpenedEdge> opened;
  const std::size_t count = std::min(before->GetFaces().size(), after->GetFaces().size());
  const double tolerance = OpeningTolerance * GetBodySize(before);
  std::vector<std::size_t> changed;
  bool sameEdges = before->GetFaces().size() == after->GetFaces().size();
  for (std::size_t f = 0; f < count; ++f)
  {
    if (before->GetFaces()[f] != after->GetFaces()[f])
    {
      changed.push_back(f);
      sameEdges = sameEdges && UsesSameEdges(*before->GetFaces()[f], *after->GetFaces()[f]);
    }
  }
  std::vector<std::vector<OpenedEdge>> found(changed.size());
  ParallelFor(changed.size(), 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::size_t f = changed[i];
        found[i] = CompareFace(*before->GetFaces()[f], *after->GetFaces()[f], static_cast<int>(f), tolerance);
      }
    });
  for (const std::vector<OpenedEdge>& face : found)
  {
    opened.insert(opened.end(), face.begin(), face.end());
  }
  if (!sameEdges)
  {
    FindLostUses(before, after, opened);
  }
  // Sorted by width, with NaN and lost uses first; edges of equal width by their ids and faces.
  const auto width = [](const OpenedEdge& edge)
  { return std::isnan(edge.Gap) ? std::numeric_limits<double>::infinity() : edge.Gap; };
  std::sort(opened.begin(), opened.end(),
    [&width](const OpenedEdge& a, const OpenedEdge& b)
    {
      return width(a) != width(b)      ? width(a) > width(b)
        : a.Source->Id != b.Source->Id ? a.Source->Id < b.Source->Id
                                       : a.Face < b.Face;
    });
  return opened;
}
}
