// The contacts of ContactSearch, face by face.
#include "smContactSearchInternals.h"

namespace sm
{
namespace
{
void AppendProjected(const std::vector<GroundPoint>& points, std::vector<Point2D>& projected)
{
  for (const GroundPoint& p : points)
  {
    projected.push_back(Project(p));
  }
}

/// How far points are from the first, at most.
double GetExtent(const std::vector<Point2D>& points)
{
  double extent = 0.0;
  for (const Point2D& p : points)
  {
    extent = std::max(extent, std::hypot(p[0] - points[0][0], p[1] - points[0][1]));
  }
  return extent;
}
}

Point2D GetContactDirection(int k)
{
  const double angle = 6.283185307179586 * k / ContactDirections;
  return { std::cos(angle), std::sin(angle) };
}

/// Looks at points beside a point that is tangent to the ground: which of them do the loops leave? Along a border it goes on.
std::uint32_t ContactSearch::Internals::FindDirections(
  const FaceContact& face, int patch, const std::array<double, 2>& sr, const GroundPatch::Shape& shape)
{
  const auto& [a, b] = shape.Tangents;
  const double determinant = a[0] * b[1] - a[1] * b[0];
  const Patch& source = face.Cut->Panels.Patches[patch];
  const NURBSSurface& surface = face.Cut->Source->Surface;
  std::uint32_t directions = ~0u;
  for (int k = 0; k < ContactDirections; ++k)
  {
    const Point2D e = GetContactDirection(k);
    std::array<double, 2> step = { (e[0] * b[1] - e[1] * b[0]) / determinant,
      (a[0] * e[1] - a[1] * e[0]) / determinant };
    const double largest = std::max(std::abs(step[0]), std::abs(step[1]));
    TrimSide side = TrimSide::Undecided;
    for (double length = 1e-4; length < 0.05 && side == TrimSide::Undecided; length *= 10.0)
    {
      double at[2];
      bool leaves = false;
      for (int d = 0; d < 2; ++d)
      {
        // Rounding does not turn a step along a border.
        at[d] = sr[d] + (std::abs(step[d]) < 1e-9 * largest ? 0.0 : length * step[d] / largest);
        const int direction = source.Exchanged ? 1 - d : d;
        const double x = source.Start[d] + source.Width[d] * at[d];
        leaves = leaves || x < surface.GetDomainStart(direction) || x > surface.GetDomainEnd(direction);
      }
      side = leaves ? TrimSide::Outside : face.Classify(patch, at, at);
    }
    directions &= side == TrimSide::Outside ? ~(1u << k) : ~0u;
  }
  return directions;
}

/// The same at a pole, where the border sr[across] = 0 or 1 of the patch is one point: lines of constant parameter leave it in the
/// directions of their tangents. 0 where it is no pole.
std::uint32_t ContactSearch::Internals::FindPoleDirections(
  const FaceContact& face, int patch, std::array<double, 2> sr)
{
  // The sample is the middle of a small box.
  const GroundPatch& root = face.Patches[patch];
  for (double& x : sr)
  {
    x = std::abs(x - std::round(x)) < 1e-4 ? std::round(x) : x;
  }
  const GroundPatch::Shape shape = root.GetShape(sr[0], sr[1]);
  const double lengths[2] = { std::hypot(shape.Tangents[0][0], shape.Tangents[0][1]),
    std::hypot(shape.Tangents[1][0], shape.Tangents[1][1]) };
  const int across = lengths[0] >= lengths[1] ? 0 : 1;
  if (lengths[1 - across] > 1e-6 * lengths[across] || (sr[across] != 0.0 && sr[across] != 1.0))
  {
    return 0;
  }
  const double inward = sr[across] == 0.0 ? 1.0 : -1.0;
  const int lines = 64;
  std::uint32_t directions = 0;
  Point2D before{};
  bool leftBefore = true;
  for (int i = 0; i <= lines; ++i)
  {
    std::array<double, 2> at = sr;
    at[1 - across] = static_cast<double>(i) / lines;
    const std::array<double, 2> tangent = root.GetShape(at[0], at[1]).Tangents[across];
    const Point2D now = { inward * tangent[0], inward * tangent[1] };
    TrimSide side = TrimSide::Undecided;
    for (double length = 1e-4; length < 0.05 && side == TrimSide::Undecided; length *= 10.0)
    {
      at[across] = sr[across] + inward * length;
      side = face.Classify(patch, at.data(), at.data());
    }
    const bool left = side == TrimSide::Outside;
    for (int k = 0; k < ContactDirections && i > 0 && !(left && leftBefore); ++k)
    {
      // Between the two tangents, which are less than half a turn apart; rounding does not turn it out.
      const Point2D e = GetContactDirection(k);
      const auto cross = [](const Point2D& a, const Point2D& b) { return a[0] * b[1] - a[1] * b[0]; };
      const double turn = cross(before, now) < 0.0 ? -1.0 : 1.0;
      const double slack = 1e-9 * lengths[across];
      const bool between = turn * cross(before, e) >= -slack && turn * cross(e, now) >= -slack &&
        (before[0] + now[0]) * e[0] + (before[1] + now[1]) * e[1] > 0.0;
      directions |= between ? 1u << k : 0u;
    }
    before = now;
    leftBefore = left;
  }
  return directions;
}

/// Surfaces without a normal (poles) are looked at a little away from there.
void ContactSearch::Internals::AddSample(
  const FaceContact& face, int patch, std::array<double, 2> sr, const Point2D& position)
{
  const std::size_t enough = 512;
  if (this->Found.Samples.size() >= enough)
  {
    return;
  }
  const GroundPatch& root = face.Patches[patch];
  const auto clamp = [](double x) { return std::clamp(x, 0.0, 1.0); };
  GroundPatch::Shape shape = root.GetShape(clamp(sr[0]), clamp(sr[1]));
  ContactSample sample{ position, 0.0, 0.0, 0.0 };
  if (std::isnan(shape.Curvature))
  {
    const auto look = [&](double share)
    {
      return root.GetShape(
        clamp(sr[0]) + share * (0.5 - clamp(sr[0])), clamp(sr[1]) + share * (0.5 - clamp(sr[1])));
    };
    const GroundPatch::Shape near = look(1e-3);
    const GroundPatch::Shape far = look(2e-3);
    // The normal turns by about the distance.
    if (near.Normal >= 1.0 - 1e-4 && far.Normal <= near.Normal + 1e-9)
    {
      sample.Radius = near.Curvature > 0.0 ? 1.0 / near.Curvature : Infinity;
      sample.Doubt =
        std::abs(sample.Radius - (far.Curvature > 0.0 ? 1.0 / far.Curvature : Infinity)) + 1e-9 * this->Size;
      sample.Widest = near.LeastCurvature * this->Size > 1e-9 ? 1.0 / near.LeastCurvature : Infinity;
      const std::uint32_t directions = FindPoleDirections(face, patch, { clamp(sr[0]), clamp(sr[1]) });
      sample.Doubt = directions == 0 ? Infinity : sample.Doubt;
      sample.GoesOn = directions == 0 ? ~0u : directions;
    }
  }
  else if (shape.Normal >= TangentCosine)
  {
    sample.Radius = shape.Curvature * this->Size > 1e-9 ? 1.0 / shape.Curvature : Infinity;
    sample.Doubt = 1e-9 * this->Size;
    sample.Widest = shape.LeastCurvature * this->Size > 1e-9 ? 1.0 / shape.LeastCurvature : Infinity;
    sample.GoesOn = FindDirections(face, patch, { clamp(sr[0]), clamp(sr[1]) }, shape);
  }
  this->Found.Samples.push_back(sample);
}

void ContactSearch::Internals::AddPoint(
  const FaceContact& face, const Segment& segment, double t, const GroundPoint& point)
{
  ContactPiece piece;
  piece.Inner = piece.Outer = { Project(point) };
  this->AddSample(face, segment.Patch, face.GetParameters(segment, t), piece.Inner[0]);
  this->Found.Pieces.push_back(std::move(piece));
}

/// All of the curve touches.
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
    // Of a curve of higher degree the ends alone.
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

/// Stationary points of a curve that does not touch as a whole.
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
    std::vector<Point2D> projected;
    AppendProjected(curve.Points, projected);
    const double extent = GetExtent(projected);
    const bool level = curve.IsLevel(slack);
    if (level || extent <= this->GetResolution() || curve.End - curve.Start < LeastWidth ||
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

/// What the loops leave of a border of a patch: all of it touches, or its stationary points do.
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
    // Where a trim curve crosses it, that has a kink.
    if (curve.IsMonotone(slack))
    {
      continue;
    }
    if (hopeless || curve.End - curve.Start < LeastWidth || curve.Steps.empty() || count >= MaximumNets ||
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

/// A patch that touches as a whole. Where the map to the ground's plane keeps its sense, what the loops leave of it is bounded by
/// trim curves, which were found, and by borders of the patch; not by those where the domain ends, for the loops end there, too.
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

/// A box in which stationary points were enclosed as closely as they can be: a point, or a strip along a line of them.
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
    const bool level = variations[steeper] <= slack || box.High[steeper] - box.Low[steeper] < LeastWidth ||
      extents[steeper] <= resolution;
    if (this->IsCovered(box.Points) && (small || level))
    {
      // No new point of the hull; how it rolls there is worth knowing.
      this->AddSample(face, patch, { 0.5 * (box.Low[0] + box.High[0]), 0.5 * (box.Low[1] + box.High[1]) },
        Project(box.Points.front()));
      continue;
    }
    const bool spent = count >= MaximumNets;

    if (spent || small || (level && (inside || hopeless)) || box.High[longer] - box.Low[longer] < LeastWidth)
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
