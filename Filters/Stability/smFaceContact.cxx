#include "Detail/smFaceContact.h"

#include "Detail/smGroundTrim.h"

#include <algorithm>

namespace sm
{
BorderKnot GetBorderKnot(const NURBSSurface& surface, const Patch& patch, int d, int end)
{
  BorderKnot knot;
  knot.Direction = patch.Exchanged ? 1 - d : d;
  const std::vector<double> breaks = surface.GetSpanBreaks(knot.Direction);
  knot.Value = end ? *std::upper_bound(breaks.begin(), breaks.end() - 1, patch.Start[d]) : patch.Start[d];
  knot.Outer = knot.Value == breaks.front() || knot.Value == breaks.back();
  return knot;
}

void FaceContact::Prepare()
{
  if (this->Ready)
  {
    return;
  }
  this->Ready = true;
  const FacePanels& panels = this->Cut->Panels;
  for (const Patch& patch : panels.Patches)
  {
    this->Patches.emplace_back(panels, patch, this->Frame);
    this->Heights.push_back(this->Patches.back().GetHeights());
  }
  this->Region = std::make_unique<TrimClassifier>(*this->Cut->Source);
  std::vector<std::int64_t> edgeIds;
  for (const Loop& loop : this->Cut->Source->Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      edgeIds.push_back(coedge.Use->FileId);
    }
  }
  for (std::size_t i = 0; i < panels.Ribbons.size(); ++i)
  {
    Segment segment;
    segment.Patch = static_cast<int>(panels.Ribbons[i].Patch);
    segment.Ribbon = static_cast<int>(i);
    segment.Coedge = panels.Ribbons[i].Coedge;
    segment.EdgeId =
      segment.Coedge >= 0 && segment.Coedge < static_cast<int>(edgeIds.size()) ? edgeIds[segment.Coedge] : 0;
    this->Segments.push_back(std::move(segment));
  }
  this->AddBorders();
}

/// Returns true if the surface may have a crease at a knot, that is, if the multiplicity of the knot is at
/// least the degree.
bool FaceContact::IsCrease(int direction, double knot) const
{
  const NURBSSurface& surface = this->Cut->Source->Surface;
  return std::count(surface.Knots[direction].begin(), surface.Knots[direction].end(), knot) >=
    surface.Degree[direction];
}

/// Adds the creases, and the ends of the domain if the face has no loops.
void FaceContact::AddBorders()
{
  const NURBSSurface& surface = this->Cut->Source->Surface;
  const bool untrimmed = this->Cut->Source->Loops.empty();
  const std::vector<Patch>& patches = this->Cut->Panels.Patches;
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      for (int end = 0; end < 2; ++end)
      {
        const BorderKnot knot = GetBorderKnot(surface, patches[i], d, end);
        if (knot.Outer ? untrimmed : this->IsCrease(knot.Direction, knot.Value))
        {
          Segment segment;
          segment.Patch = static_cast<int>(i);
          segment.Direction = d;
          segment.End = end;
          segment.Clipped = !knot.Outer;
          this->Segments.push_back(std::move(segment));
        }
      }
    }
  }
}

void FaceContact::Compose(Segment& segment)
{
  if (segment.Composed)
  {
    return;
  }
  segment.Composed = true;
  const GroundPatch& root = this->Patches[segment.Patch];
  if (segment.Ribbon < 0)
  {
    segment.Curve = root.GetBorder(segment.Direction, segment.End);
    return;
  }
  const FacePanels& panels = this->Cut->Panels;
  const Ribbon& ribbon = panels.Ribbons[segment.Ribbon];
  segment.Curve = ComposeTrim(root, panels.Patches[segment.Patch], panels.Coefficients.data() + ribbon.Trim,
    ribbon.TrimDegree, ribbon.Start, ribbon.End);
}

std::array<double, 2> FaceContact::GetParameters(const Segment& segment, double t) const
{
  if (segment.Ribbon < 0)
  {
    std::array<double, 2> sr;
    sr[segment.Direction] = segment.End;
    sr[1 - segment.Direction] = t;
    return sr;
  }
  const FacePanels& panels = this->Cut->Panels;
  const Ribbon& ribbon = panels.Ribbons[segment.Ribbon];
  return GetTrimPoint(panels.Patches[segment.Patch], panels.Coefficients.data() + ribbon.Trim,
    ribbon.TrimDegree, ribbon.Start, ribbon.End, t);
}

TrimSide FaceContact::Classify(int patch, const double low[2], const double high[2], bool* hopeless) const
{
  const Patch& p = this->Cut->Panels.Patches[patch];
  std::array<double, 2> from;
  std::array<double, 2> to;
  for (int d = 0; d < 2; ++d)
  {
    const int direction = p.Exchanged ? 1 - d : d;
    from[direction] = p.Start[d] + p.Width[d] * low[d];
    to[direction] = p.Start[d] + p.Width[d] * high[d];
  }
  return this->Region->Classify(from, to, hopeless);
}

TrimSide FaceContact::Classify(const Segment& segment, const GroundCurve& curve, bool* hopeless) const
{
  if (!segment.Clipped)
  {
    if (hopeless)
    {
      *hopeless = false;
    }
    return TrimSide::Inside;
  }
  double low[2];
  double high[2];
  low[segment.Direction] = high[segment.Direction] = segment.End;
  low[1 - segment.Direction] = curve.Start;
  high[1 - segment.Direction] = curve.End;
  return this->Classify(segment.Patch, low, high, hopeless);
}
}
