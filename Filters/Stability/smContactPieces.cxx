// Finds the contacts of ContactSearch, face by face.
#include "Detail/smContactSearchInternals.h"

namespace sm
{
namespace
{
void AppendProjected(const std::vector<GroundPoint>& points, std::vector<Point2>& projected)
{
  for (const GroundPoint& p : points)
  {
    projected.push_back(Project(p));
  }
}

/// Largest distance of a point from the first.
double GetExtent(const std::vector<Point2>& points)
{
  double extent = 0.0;
  for (const Point2& p : points)
  {
    extent = std::max(extent, std::hypot(p[0] - points[0][0], p[1] - points[0][1]));
  }
  return extent;
}
}

void ContactSearch::Internals::AddPoint(
  const FaceContact& face, const Segment& segment, double t, const GroundPoint& point)
{
  ContactPiece piece;
  piece.Inner = piece.Outer = { Project(point) };
  this->AddSample(face, segment.Patch, face.GetParameters(segment, t), piece.Inner[0]);
  this->Found.Pieces.push_back(std::move(piece));
}

/// Adds a contact: the whole curve touches.
void ContactSearch::Internals::AddCurve(
  const FaceContact& face, const Segment& segment, const GroundCurve& curve)
{
  ContactPiece piece;
  piece.Inner = { Project(curve.Points.front()), Project(curve.Points.back()) };
  AppendProjected(curve.Points, piece.Outer);
  piece.Curve = curve;
  const int samples = 4;
  for (int i = 0; i <= samples; ++i)
  {
    const double t = static_cast<double>(i) / samples;
    const GroundPoint p = BernsteinPiece<4>{ curve.Points.data(),
      std::min<int>(MaximumDegree, static_cast<int>(curve.Points.size()) - 1) }
                            .Evaluate(t);
    // A curve of a degree that BernsteinPiece does not evaluate gets a sample at its start only.
    if (static_cast<int>(curve.Points.size()) <= MaximumDegree + 1 || i == 0)
    {
      this->AddSample(face, segment.Patch,
        face.GetParameters(segment, curve.Start + t * (curve.End - curve.Start)), Project(p));
    }
  }
  this->Found.Pieces.push_back(std::move(piece));
}

void ContactSearch::Internals::FindOnTrims(FaceContact& face)
{
  for (std::size_t i = 0; i < face.Segments.size(); ++i)
  {
    Segment& segment = face.Segments[i];
    if (segment.Clipped || !this->MayReach(face, segment, this->Limit))
    {
      continue;
    }
    face.Compose(segment);
    const HeightRange heights = segment.Curve.GetHeights();
    if (heights.Low > this->Limit)
    {
      continue;
    }
    if (heights.High <= this->Limit)
    {
      this->AddCurve(face, segment, segment.Curve);
      if (segment.Coedge >= 0)
      {
        this->Found.EdgeIds.insert(segment.EdgeId);
      }
      continue;
    }
    this->FindOnCurve(face, segment);
    // Corners of loops and of creases; and kinks where the next piece rises again.
    const bool first = segment.Coedge < 0 || i == 0 || face.Segments[i - 1].Coedge != segment.Coedge;
    const bool last =
      segment.Coedge < 0 || i + 1 == face.Segments.size() || face.Segments[i + 1].Coedge != segment.Coedge;
    const std::vector<GroundPoint>& points = segment.Curve.Points;
    if (first && GetHeight(points.front()) <= this->Limit)
    {
      this->AddPoint(face, segment, 0.0, points.front());
    }
    if (GetHeight(points.back()) > this->Limit)
    {
      continue;
    }
    bool lowest = last;
    if (!last && !segment.Curve.Steps.empty())
    {
      Segment& next = face.Segments[i + 1];
      face.Compose(next);
      const auto slope = [](const GroundPoint& step, const GroundPoint& point)
      { return step[2] - GetHeight(point) * step[3]; };
      lowest = !next.Curve.Steps.empty() &&
        slope(segment.Curve.Steps.back(), points.back()) <= this->GetSlack(segment.Curve) &&
        slope(next.Curve.Steps.front(), next.Curve.Points.front()) >= -this->GetSlack(next.Curve);
    }
    if (lowest)
    {
      this->AddPoint(face, segment, 1.0, points.back());
    }
  }
}

/// Adds the stationary points of a curve that does not touch as a whole.
void ContactSearch::Internals::FindOnCurve(FaceContact& face, const Segment& segment)
{
  const double slack = this->GetSlack(segment.Curve);
  // Leaves of one stationary point lie side by side.
  double spread = 0.0;
  std::vector<GroundCurve> stack{ segment.Curve };
  for (int count = 0; !stack.empty(); ++count)
  {
    GroundCurve curve = std::move(stack.back());
    stack.pop_back();
    if (curve.GetHeights().Low > this->Limit || curve.Steps.empty() || curve.IsMonotone(slack))
    {
      continue;
    }
    std::vector<Point2> projected;
    AppendProjected(curve.Points, projected);
    const double extent = GetExtent(projected);
    const bool level = curve.IsLevel(slack);
    if (level || extent <= this->GetResolution() || curve.End - curve.Start < MinWidth ||
      count >= MaximumNets)
    {
      this->Found.Coarse = this->Found.Coarse || count >= MaximumNets;
      spread += extent;
      ContactPiece piece;
      piece.Inner = { projected.front(), projected.back() };
      piece.Outer = std::move(projected);
      this->AddSample(
        face, segment.Patch, face.GetParameters(segment, 0.5 * (curve.Start + curve.End)), piece.Inner[0]);
      this->Found.Pieces.push_back(std::move(piece));
      continue;
    }
    auto halves = curve.Split();
    stack.push_back(std::move(halves.first));
    stack.push_back(std::move(halves.second));
  }
  this->Found.Spread = std::max(this->Found.Spread, spread);
}

/// Adds the part of a patch's border that is inside the loops: the whole part if it touches, else its
/// stationary points.
void ContactSearch::Internals::FindOnBorder(
  FaceContact& face, const Segment& segment, const GroundCurve& root, bool whole)
{
  const double slack = this->GetSlack(root);
  // Its ends are corners of creases, or of a patch that touches.
  for (const bool last : { false, true })
  {
    GroundCurve end;
    end.Start = end.End = last ? 1.0 : 0.0;
    const GroundPoint& point = last ? root.Points.back() : root.Points.front();
    if (GetHeight(point) <= this->Limit && face.Classify(segment, end) == TrimSide::Inside)
    {
      this->AddPoint(face, segment, end.Start, point);
    }
  }
  double spread = 0.0;
  std::vector<GroundCurve> stack{ root };
  for (int count = 0; !stack.empty(); ++count)
  {
    GroundCurve curve = std::move(stack.back());
    stack.pop_back();
    if (curve.GetHeights().Low > this->Limit || this->IsCovered(curve.Points))
    {
      continue;
    }
    bool hopeless = false;
    const TrimSide side = face.Classify(segment, curve, &hopeless);
    if (side == TrimSide::Outside)
    {
      continue;
    }
    const bool inside = side == TrimSide::Inside;
    if (inside && whole)
    {
      this->AddCurve(face, segment, curve);
      continue;
    }
    // Where a trim curve crosses the border, the trim curve has a kink, which was found with that curve.
    if (curve.IsMonotone(slack))
    {
      continue;
    }
    if (hopeless || curve.End - curve.Start < MinWidth || curve.Steps.empty() || count >= MaximumNets ||
      (inside && curve.IsLevel(slack)))
    {
      this->Found.Coarse = this->Found.Coarse || count >= MaximumNets;
      ContactPiece piece;
      AppendProjected(curve.Points, piece.Outer);
      if (inside)
      {
        spread += GetExtent(piece.Outer);
        piece.Inner = { piece.Outer.front(), piece.Outer.back() };
      }
      this->Found.Pieces.push_back(std::move(piece));
      continue;
    }
    auto halves = curve.Split();
    stack.push_back(std::move(halves.first));
    stack.push_back(std::move(halves.second));
  }
  this->Found.Spread = std::max(this->Found.Spread, spread);
}

/// Adds a patch that touches as a whole. Where the map to the ground's plane keeps its orientation, the image
/// of the trimmed patch is bounded by the images of trim curves, which were added before, and of borders of
/// the patch. Borders at an end of the domain are not needed, because the loops end there, too.
void ContactSearch::Internals::FindArea(FaceContact& face, int patch)
{
  this->Found.FaceIds.insert(face.Cut->Source->FileId);
  for (int d = 0; d < 2; ++d)
  {
    for (int end = 0; end < 2; ++end)
    {
      if (GetBorderKnot(face.Cut->Source->Surface, face.Cut->Panels.Patches[patch], d, end).Outer)
      {
        continue;
      }
      Segment border;
      border.Patch = patch;
      border.Direction = d;
      border.End = end;
      border.Clipped = true;
      this->FindOnBorder(face, border, face.Patches[patch].GetBorder(d, end), true);
    }
  }
  std::vector<GroundPatch> stack{ face.Patches[patch] };
  for (int count = 0; !stack.empty(); ++count)
  {
    GroundPatch box = std::move(stack.back());
    stack.pop_back();
    if (box.IsRegular() || this->IsCovered(box.Points))
    {
      continue;
    }
    const TrimSide side = face.Classify(patch, box);
    if (side == TrimSide::Outside)
    {
      continue;
    }
    const double extents[2] = { box.GetExtent(0), box.GetExtent(1) };
    if (std::max(extents[0], extents[1]) <= 1e-6 * this->Size || count >= MaximumNets)
    {
      this->Found.Coarse = this->Found.Coarse || count >= MaximumNets;
      ContactPiece piece;
      AppendProjected(box.Points, piece.Outer);
      this->Found.Pieces.push_back(std::move(piece));
      continue;
    }
    auto halves = box.Split(extents[0] >= extents[1] ? 0 : 1);
    stack.push_back(std::move(halves.first));
    stack.push_back(std::move(halves.second));
  }
}

/// Adds a box that encloses stationary points as closely as rounding permits: a point, or a strip along a
/// line of them.
double ContactSearch::Internals::AddLeaf(
  const FaceContact& face, int patch, const GroundPatch& box, bool inside)
{
  const double extents[2] = { box.GetExtent(0), box.GetExtent(1) };
  const int across = extents[0] <= extents[1] ? 0 : 1;
  const bool strip = extents[1 - across] > this->GetResolution();
  ContactPiece piece;
  AppendProjected(box.Points, piece.Outer);
  if (!inside)
  {
    this->Found.Pieces.push_back(std::move(piece));
    return extents[across];
  }
  const int samples = strip ? 4 : 0;
  for (int i = 0; i <= samples; ++i)
  {
    const double t = samples ? static_cast<double>(i) / samples : 0.5;
    std::array<double, 2> sr;
    sr[across] = 0.5 * (box.Low[across] + box.High[across]);
    sr[1 - across] = box.Low[1 - across] + t * (box.High[1 - across] - box.Low[1 - across]);
    const GroundCurve border = box.GetBorder(across, 0);
    const GroundPoint p =
      BernsteinPiece<4>{ border.Points.data(), static_cast<int>(border.Points.size()) - 1 }.Evaluate(t);
    this->AddSample(face, patch, sr, Project(p));
  }
  if (!strip)
  {
    piece.Inner = { piece.Outer.front(), piece.Outer.back() };
    this->Found.Pieces.push_back(std::move(piece));
    return extents[1 - across];
  }
  for (int end = 0; end < 2; ++end)
  {
    ContactPiece side;
    side.Curve = box.GetBorder(across, end);
    side.Inner = { Project(side.Curve.Points.front()), Project(side.Curve.Points.back()) };
    AppendProjected(side.Curve.Points, side.Outer);
    this->Found.Pieces.push_back(std::move(side));
  }
  return extents[across];
}

void ContactSearch::Internals::FindOnPatch(FaceContact& face, int patch)
{
  const double slack = this->GetSlack(face.Patches[patch]);
  const double resolution = this->GetResolution();
  double spread = 0.0;
  std::vector<GroundPatch> stack{ face.Patches[patch] };
  for (int count = 0; !stack.empty(); ++count)
  {
    GroundPatch box = std::move(stack.back());
    stack.pop_back();
    const HeightRange heights = box.GetHeights();
    if (heights.Low > this->Limit || box.IsMonotone(0, slack) || box.IsMonotone(1, slack))
    {
      continue;
    }
    bool hopeless = false;
    const TrimSide side = face.Classify(patch, box, &hopeless);
    if (side == TrimSide::Outside)
    {
      continue;
    }
    const bool inside = side == TrimSide::Inside;
    const double extents[2] = { box.GetExtent(0), box.GetExtent(1) };
    const int longer = extents[0] >= extents[1] ? 0 : 1;
    const double variations[2] = { box.GetVariation(0), box.GetVariation(1) };
    const int steeper = variations[0] >= variations[1] ? 0 : 1;
    const bool small = extents[longer] <= resolution;
    const bool level = variations[steeper] <= slack || box.High[steeper] - box.Low[steeper] < MinWidth ||
      extents[steeper] <= resolution;
    if (this->IsCovered(box.Points) && (small || level))
    {
      // This point does not enlarge the hull, but the curvature there decides about rolling.
      this->AddSample(face, patch, { 0.5 * (box.Low[0] + box.High[0]), 0.5 * (box.Low[1] + box.High[1]) },
        Project(box.Points.front()));
      continue;
    }
    const bool spent = count >= MaximumNets;

    if (spent || small || (level && (inside || hopeless)) || box.High[longer] - box.Low[longer] < MinWidth)
    {
      this->Found.Coarse = this->Found.Coarse || spent;
      spread += this->AddLeaf(face, patch, box, inside && !spent);
      continue;
    }
    auto halves = box.Split(level ? longer : steeper);
    stack.push_back(std::move(halves.first));
    stack.push_back(std::move(halves.second));
  }
  this->Found.Spread = std::max(this->Found.Spread, spread);
}
}
