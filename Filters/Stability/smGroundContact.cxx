#include "Detail/smGroundContact.h"

#include "Detail/smContactSearchInternals.h"
#include "Detail/smGroundTrim.h"

namespace sm
{
ContactSearch::ContactSearch()
  : Implementation(new Internals)
{
}

ContactSearch::~ContactSearch() = default;

void ContactSearch::AddFace(const CutFacePointer& cut, const GroundFrame& frame)
{
  if (!cut->Error.empty() || cut->Panels.Patches.empty())
  {
    return;
  }
  FaceContact face;
  face.Cut = cut;
  face.Frame = frame;
  face.Low = Infinity;
  for (const Patch& patch : cut->Panels.Patches)
  {
    const int count = (patch.Degree[0] + 1) * (patch.Degree[1] + 1);
    for (int i = 0; i < count; ++i)
    {
      const GroundPoint p = frame.Transform(cut->Panels.Points[patch.FirstPoint + i], patch.Center);
      for (int c = 0; c < 3; ++c)
      {
        this->Implementation->Size = std::max(this->Implementation->Size, std::abs(p[c] / p[3]));
      }
      face.Low = std::min(face.Low, GetHeight(p));
    }
  }
  this->Implementation->Faces.push_back(std::move(face));
}

double ContactSearch::GetSize() const
{
  return this->Implementation->Size;
}

double ContactSearch::GetRounding() const
{
  return this->Implementation->GetRounding();
}

double ContactSearch::GetResolution() const
{
  return this->Implementation->GetResolution();
}

HeightRange ContactSearch::FindLowest()
{
  Internals& self = *this->Implementation;
  if (self.Faces.empty())
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return { nan, nan };
  }
  std::sort(self.Faces.begin(), self.Faces.end(),
    [](const FaceContact& a, const FaceContact& b) { return a.Low < b.Low; });
  double low = Infinity;
  for (FaceContact& face : self.Faces)
  {
    if (face.Low >= self.Reached)
    {
      break;
    }
    face.Low = std::max(face.Low, self.BoundFace(face));
    low = std::min(low, face.Low);
  }
  // A trim curve that leaves the parameter square of its patch may be lower than the control net.
  for (const FaceContact& face : self.Faces)
  {
    low = std::min(low, face.Low);
  }
  const double rounding = self.GetRounding();
  const double high = std::isfinite(self.Reached) ? self.Reached : low;
  return { std::min(low, high) - rounding, high + rounding };
}

bool ContactSearch::Internals::MayReach(const FaceContact& face, const Segment& segment, double height) const
{
  if (face.Heights[segment.Patch].Low <= height || segment.Ribbon < 0)
  {
    return face.Heights[segment.Patch].Low <= height;
  }
  // The segment is above the limit if its patch is, unless the trim curve leaves the square for which the net
  // is a bound.
  const FacePanels& panels = face.Cut->Panels;
  const Ribbon& ribbon = panels.Ribbons[segment.Ribbon];
  return !StaysInSquare(panels.Patches[segment.Patch], panels.Coefficients.data() + ribbon.Trim,
    ribbon.TrimDegree, ribbon.Start, ribbon.End);
}

/// Returns a lower bound of the minimum height of the face. The search stops above the height that another
/// face reaches.
double ContactSearch::Internals::BoundFace(FaceContact& face)
{
  face.Prepare();
  std::priority_queue<Candidate> queue;
  for (std::size_t i = 0; i < face.Segments.size(); ++i)
  {
    Segment& segment = face.Segments[i];
    if (this->MayReach(face, segment, this->Reached))
    {
      face.Compose(segment);
      if (!segment.Clipped)
      {
        this->Reach(GetHeight(segment.Curve.Points.front()));
        this->Reach(GetHeight(segment.Curve.Points.back()));
      }
      queue.push({ segment.Curve.GetHeights().Low, static_cast<int>(i), segment.Curve, {} });
    }
  }
  for (std::size_t i = 0; i < face.Patches.size(); ++i)
  {
    if (face.Heights[i].Low <= this->Reached)
    {
      queue.push({ face.Heights[i].Low, -1 - static_cast<int>(i), {}, face.Patches[i] });
    }
  }
  double low = Infinity;
  for (int count = 0; !queue.empty(); ++count)
  {
    Candidate item = queue.top();
    queue.pop();
    if (item.Low >= this->Reached - this->GetRounding() || count >= MaximumNets)
    {
      return std::min(low, item.Low);
    }
    item.Owner >= 0 ? this->StepCurve(face, item, queue, low) : this->StepPatch(face, item, queue, low);
  }
  return std::min(low, this->Reached);
}

bool ContactSearch::Internals::StepCurve(
  FaceContact& face, Candidate& item, std::priority_queue<Candidate>& queue, double& low)
{
  const Segment& segment = face.Segments[item.Owner];
  bool hopeless = false;
  const TrimSide side = face.Classify(segment, item.Curve, &hopeless);
  if (side == TrimSide::Outside)
  {
    return false;
  }
  const GroundPoint& first = item.Curve.Points.front();
  const GroundPoint& last = item.Curve.Points.back();
  if (side == TrimSide::Inside)
  {
    this->Reach(std::min(GetHeight(first), GetHeight(last)));
  }
  if (item.Curve.IsMonotone(this->GetSlack(segment.Curve)))
  {
    // The lowest point is an end. There a trim curve crosses the border, the next part of the same curve
    // begins, or the whole curve ends.
    const bool falls = GetHeight(last) < GetHeight(first);
    if (side == TrimSide::Undecided && (falls ? item.Curve.End == 1.0 : item.Curve.Start == 0.0))
    {
      GroundCurve end;
      end.Start = end.End = falls ? 1.0 : 0.0;
      low = face.Classify(segment, end) == TrimSide::Outside ? low
                                                             : std::min(low, GetHeight(falls ? last : first));
    }
    return false;
  }
  if (hopeless || item.Curve.End - item.Curve.Start < MinWidth || item.Curve.Steps.empty())
  {
    low = std::min(low, item.Low);
    return false;
  }
  auto halves = item.Curve.Split();
  for (GroundCurve* half : { &halves.first, &halves.second })
  {
    const double lowest = half->GetHeights().Low;
    queue.push({ lowest, item.Owner, std::move(*half), {} });
  }
  return true;
}

bool ContactSearch::Internals::StepPatch(
  FaceContact& face, Candidate& item, std::priority_queue<Candidate>& queue, double& low)
{
  const int patch = -1 - item.Owner;
  const double slack = this->GetSlack(face.Patches[patch]);
  if (item.Box.IsMonotone(0, slack) || item.Box.IsMonotone(1, slack))
  {
    return false;
  }
  const TrimSide side = face.Classify(patch, item.Box);
  if (side == TrimSide::Outside)
  {
    return false;
  }
  if (side == TrimSide::Inside)
  {
    this->Reach(GetHeight(item.Box.Points.front()));
    this->Reach(GetHeight(item.Box.Points.back()));
  }
  double variation[2];
  for (int d = 0; d < 2; ++d)
  {
    variation[d] = item.Box.High[d] - item.Box.Low[d] < MinWidth ? -1.0 : item.Box.GetVariation(d);
  }
  const int direction = variation[0] >= variation[1] ? 0 : 1;
  if (variation[direction] < 0.0)
  {
    low = std::min(low, item.Low);
    return false;
  }
  auto halves = item.Box.Split(direction);
  for (GroundPatch* half : { &halves.first, &halves.second })
  {
    const double lowest = half->GetHeights().Low;
    queue.push({ lowest, item.Owner, {}, std::move(*half) });
  }
  return true;
}

GroundContacts ContactSearch::FindContacts(double limit)
{
  Internals& self = *this->Implementation;
  self.Limit = limit + self.GetRounding();
  self.Found = GroundContacts();
  std::vector<FaceContact*> faces;
  for (FaceContact& face : self.Faces)
  {
    if (face.Low <= self.Limit)
    {
      face.Prepare();
      faces.push_back(&face);
    }
  }
  // Curves come first: patches inside the hull of their contacts need no search.
  for (FaceContact* face : faces)
  {
    self.FindOnTrims(*face);
  }
  self.UpdateCertain();
  for (FaceContact* face : faces)
  {
    for (Segment& segment : face->Segments)
    {
      if (segment.Clipped && self.MayReach(*face, segment, self.Limit))
      {
        face->Compose(segment);
        self.FindOnBorder(*face, segment, segment.Curve, segment.Curve.GetHeights().High <= self.Limit);
      }
    }
    for (std::size_t i = 0; i < face->Patches.size(); ++i)
    {
      if (face->Heights[i].High <= self.Limit)
      {
        self.FindArea(*face, static_cast<int>(i));
      }
      else if (face->Heights[i].Low <= self.Limit)
      {
        self.FindOnPatch(*face, static_cast<int>(i));
      }
    }
    self.UpdateCertain();
  }
  return std::move(self.Found);
}

void ContactSearch::Internals::UpdateCertain()
{
  std::vector<Point2> points = this->Certain.Corners;
  for (const ContactPiece& piece : this->Found.Pieces)
  {
    points.insert(points.end(), piece.Inner.begin(), piece.Inner.end());
  }
  this->Certain = SupportPolygon::FromPoints(std::move(points), this->GetResolution());
}

bool ContactSearch::Internals::IsCovered(const std::vector<GroundPoint>& points) const
{
  return std::all_of(points.begin(), points.end(),
    [this](const GroundPoint& p)
    { return this->Certain.GetMargin(Project(p)) >= -4.0 * this->GetResolution(); });
}
}
