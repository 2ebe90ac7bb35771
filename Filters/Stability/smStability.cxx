#include "Detail/smStability.h"

#include "Detail/smMinimumTip.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double HalfPi = 1.5707963267948966;
// Height of a curved side over its chord in the polygon that is drawn, relative to the size.
constexpr double DrawnSagitta = 1e-3;
// Width of the margin's interval that refinement aims at, relative to the size, and the limit of its cost.
constexpr double AimedWidth = 1e-10;
// The same where the sign of the margin is certain: where the margin exceeds the width of its interval by the
// factor CertainSign.
constexpr double RelaxedWidth = 1e-5;
constexpr double CertainSign = 100.0;
constexpr std::size_t MaximumPieces = 12000;
// If there are more critical directions than this, all pieces are refined.
constexpr std::size_t ManyDirections = 64;
// Width, relative to the size, below which a hull counts as a line or a point.
constexpr double LineWidth = 1e-9;

struct Hulls
{
  SupportPolygon Inner;
  SupportPolygon Outer;
};

Hulls MakeHulls(const std::vector<ContactPiece>& pieces, double merge)
{
  std::vector<Point2> inner;
  std::vector<Point2> outer;
  for (const ContactPiece& piece : pieces)
  {
    inner.insert(inner.end(), piece.Inner.begin(), piece.Inner.end());
    outer.insert(outer.end(), piece.Inner.begin(), piece.Inner.end());
    outer.insert(outer.end(), piece.Outer.begin(), piece.Outer.end());
  }
  return { SupportPolygon::FromPoints(std::move(inner), merge),
    SupportPolygon::FromPoints(std::move(outer), merge) };
}

ContactPiece MakePiece(GroundCurve curve)
{
  ContactPiece piece;
  for (const GroundPoint& p : curve.Points)
  {
    piece.Outer.push_back({ p[0] / p[3], p[1] / p[3] });
  }
  piece.Inner = { piece.Outer.front(), piece.Outer.back() };
  piece.Curve = std::move(curve);
  return piece;
}

/// Largest distance of the control points from the chord's line (from its ends where it has no length).
double GetSagitta(const ContactPiece& piece)
{
  const Point2& a = piece.Outer.front();
  const Point2& b = piece.Outer.back();
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  double sagitta = 0.0;
  for (const Point2& p : piece.Outer)
  {
    const double turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    sagitta =
      std::max(sagitta, length > 0.0 ? std::abs(turn) / length : std::hypot(p[0] - a[0], p[1] - a[1]));
  }
  return sagitta;
}

/// Halves the pieces for which `wanted` returns true; returns false if there were none.
template <typename Predicate>
bool HalvePieces(std::vector<ContactPiece>& pieces, const Predicate& wanted)
{
  bool any = false;
  const std::size_t count = pieces.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (pieces[i].Curve.Steps.empty() || !wanted(pieces[i]))
    {
      continue;
    }
    auto halves = pieces[i].Curve.Split();
    pieces[i] = MakePiece(std::move(halves.first));
    pieces.push_back(MakePiece(std::move(halves.second)));
    any = true;
  }
  return any;
}

double GetSupport(const ContactPiece& piece, const Point2& direction)
{
  double support = -Infinity;
  for (const Point2& p : piece.Outer)
  {
    support = std::max(support, p[0] * direction[0] + p[1] * direction[1]);
  }
  return support;
}

/// Halves curves until the margins of both hulls agree, or there are too many pieces.
Hulls Refine(std::vector<ContactPiece>& pieces, const Point2& foot, double size, double merge)
{
  const double aim = AimedWidth * size;
  Hulls hulls = MakeHulls(pieces, merge);
  for (int round = 0; round < 60 && pieces.size() < MaximumPieces; ++round)
  {
    const double inner = hulls.Inner.GetMargin(foot);
    const double outer = hulls.Outer.GetMargin(foot);
    const double width = outer - inner;
    const bool sure = std::min(std::abs(inner), std::abs(outer)) > CertainSign * width;
    if (!(width > (sure ? RelaxedWidth * size : aim)))
    {
      break;
    }
    const std::vector<Point2> directions =
      std::isfinite(inner) ? hulls.Inner.GetCriticalDirections(foot, outer - inner) : std::vector<Point2>();
    std::vector<double> supports;
    for (const Point2& d : directions.size() > ManyDirections ? std::vector<Point2>() : directions)
    {
      supports.push_back(hulls.Inner.GetSupport(d));
    }
    const bool halved = HalvePieces(pieces,
      [&](const ContactPiece& piece)
      {
        if (directions.size() > ManyDirections)
        {
          return GetSagitta(piece) > 0.25 * aim;
        }
        for (std::size_t i = 0; i < directions.size(); ++i)
        {
          if (GetSupport(piece, directions[i]) > supports[i] + 0.25 * aim)
          {
            return true;
          }
        }
        return false;
      });
    if (!halved)
    {
      break;
    }
    hulls = MakeHulls(pieces, merge);
  }
  return hulls;
}

struct Frame
{
  const StabilityCase& Body;
  Point2 Center;
  Point2 ProjectedCenter;
  double Height;
  double Bound;

  StabilitySide MakeSide(const Point2& from, const Point2& to, double slack) const
  {
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    // The inward normal is on the left of the side.
    const Point2 v = { (from[1] - to[1]) / length, (to[0] - from[0]) / length };
    const auto distance = [&](const Point2& p) { return (p[0] - from[0]) * v[0] + (p[1] - from[1]) * v[1]; };
    const Tip tip = ComputeTip(distance(this->Center), this->Height,
      this->Body.Up[0] * v[0] + this->Body.Up[1] * v[1], this->Body.Up[2], this->Bound + slack);
    return { from, to, distance(this->ProjectedCenter), this->Bound + slack, tip.Angle, tip.AngleBound,
      tip.Rise, tip.RiseBound };
  }

  std::vector<StabilitySide> MakeSides(const SupportPolygon& polygon, double slack) const
  {
    std::vector<StabilitySide> sides;
    const std::size_t count = polygon.Corners.size();
    for (std::size_t i = 0; i < count && count > 1; ++i)
    {
      sides.push_back(this->MakeSide(polygon.Corners[i], polygon.Corners[(i + 1) % count], slack));
    }
    return sides;
  }
};

/// Makes the frame with the projected centre of mass; `heightBound` is the bound of the centre's height.
Frame MakeFrame(const StabilityCase& body, double heightBound)
{
  const double ground = 0.5 * (body.Ground.Low + body.Ground.High);
  Frame frame{ body, { body.Center[0], body.Center[1] }, {}, body.Center[2] - ground, 0.0 };
  const double lean[2] = { body.Up[0] / body.Up[2], body.Up[1] / body.Up[2] };
  for (int i = 0; i < 2; ++i)
  {
    frame.ProjectedCenter[i] = body.Center[i] - frame.Height * lean[i];
  }
  // On a slope the height adds to the error of the projected centre.
  const double steep = 1.0 + std::hypot(lean[0], lean[1]);
  // The directions are rounded, too: the lean by 8 u (1 + its square), more than it is where the ground is
  // steep.
  frame.Bound =
    steep * (heightBound + body.Rounding + 8.0 * UnitRoundoff * steep * (std::abs(frame.Height) + body.Size));
  return frame;
}

/// Stores an interval as its middle and half its width.
void SetInterval(double low, double high, double& value, double& bound)
{
  value = 0.5 * (low + high);
  bound = 0.5 * (high - low) + 2.0 * UnitRoundoff * std::abs(value);
}

/// Encloses the minimum angle and rise over all directions; contacts may be off by `slack`.
MinimumTip GetMinimumTip(const Frame& frame, const SupportPolygon& polygon, double slack)
{
  MinimumTip minimum{ { Infinity, Infinity }, { Infinity, Infinity } };
  for (const StabilitySide& side : frame.MakeSides(polygon, slack))
  {
    minimum.Angle[0] = std::min(minimum.Angle[0], side.TipAngle - side.TipAngleBound);
    minimum.Angle[1] = std::min(minimum.Angle[1], side.TipAngle + side.TipAngleBound);
    minimum.Rise[0] =
      std::min(minimum.Rise[0], std::max(0.0, side.CenterOfMassRise - side.CenterOfMassRiseBound));
    minimum.Rise[1] = std::min(minimum.Rise[1], side.CenterOfMassRise + side.CenterOfMassRiseBound);
  }
  IncludeCorners(polygon, { frame.Center, frame.Height, frame.Body.Up }, frame.Bound + slack, minimum);
  return minimum;
}

/// Sets the sides of the drawn polygon. Their bounds include the distance by which possible contacts lie
/// beyond them.
void SetSides(const Frame& frame, const std::vector<StabilitySide>& sides, const SupportPolygon& outer,
  double beyond, StabilityResult& result)
{
  for (const StabilitySide& side : sides)
  {
    // Contacts that are possible but not certain lie beyond the side by at most this distance.
    const double length = std::hypot(side.To[0] - side.From[0], side.To[1] - side.From[1]);
    const Point2 outward = { (side.To[1] - side.From[1]) / length, (side.From[0] - side.To[0]) / length };
    const double support =
      std::max(0.0, outer.GetSupport(outward) - (side.From[0] * outward[0] + side.From[1] * outward[1]));
    result.Sides.push_back(frame.MakeSide(side.From, side.To, support + beyond));
  }
}

/// Sets the tip angle and rise of a body that rests on a single point of level ground.
void SetTipOverPoint(const Frame& frame, const Point2& p, double beyond, StabilityResult& result)
{
  const double offset = std::hypot(frame.ProjectedCenter[0] - p[0], frame.ProjectedCenter[1] - p[1]);
  const double reach = std::hypot(frame.Center[0] - p[0], frame.Center[1] - p[1], frame.Height);
  result.TipAngle = -std::asin(std::min(1.0, offset * frame.Body.Up[2] / std::max(reach, offset)));
  result.TipAngleBound = HalfPi * std::min(2.0, (frame.Bound + beyond) / reach);
  result.CenterOfMassRise = result.CenterOfMassRiseBound = 0.0;
}

/// Returns the value, at the projected centre of mass, of the upper concave envelope of the radii along the
/// line of contacts, for rolling in a direction. A surface that ends in that direction has radius 0, as an
/// edge.
ContactSample GetEnvelope(
  const std::vector<ContactSample>& all, const Point2& foot, const Point2& along, double reach, int direction)
{
  ContactSample best{ foot, -Infinity, 0.0, 0.0 };
  std::vector<ContactSample> samples = all;
  for (ContactSample& sample : samples)
  {
    if ((sample.GoesOn >> direction & 1u) == 0)
    {
      sample.Radius = sample.RadiusError = sample.Widest = 0.0;
    }
  }
  const auto take = [&best](double radius, double radiusError, double widest)
  {
    if (radius > best.Radius)
    {
      best.Radius = radius;
      best.RadiusError = radiusError;
      best.Widest = widest;
    }
  };
  const auto position = [&](const ContactSample& s)
  { return (s.Position[0] - foot[0]) * along[0] + (s.Position[1] - foot[1]) * along[1]; };
  for (const ContactSample& a : samples)
  {
    const double x = position(a);
    if (std::abs(x) <= reach)
    {
      take(a.Radius, a.RadiusError, a.Widest);
    }
    for (const ContactSample& b : samples)
    {
      const double y = position(b);
      if (x < -reach && y > reach)
      {
        const double share = -x / (y - x);
        take(a.Radius + share * (b.Radius - a.Radius), std::max(a.RadiusError, b.RadiusError),
          std::max(a.Widest, b.Widest));
      }
    }
  }
  return best;
}

void Roll(
  const Frame& frame, const GroundContacts& contacts, const SupportPolygon& hull, StabilityResult& result)
{
  Point2 along{ 1.0, 0.0 };
  if (result.Support == SupportKind::Line)
  {
    double longest = 0.0;
    for (const Point2& p : hull.Corners)
    {
      const double dx = p[0] - hull.Corners[0][0];
      const double dy = p[1] - hull.Corners[0][1];
      const double length = std::hypot(dx, dy);
      if (length > longest)
      {
        longest = length;
        along = { dx / length, dy / length };
      }
    }
  }
  const double reach = std::max(frame.Body.Tolerance, frame.Bound);
  // The direction in which the body rolls most easily: one of both sides of a line, any direction for a
  // point.
  const bool isLine = result.Support == SupportKind::Line;
  ContactSample sample{ frame.ProjectedCenter, Infinity, 0.0, Infinity };
  for (int k = 0; k < ContactDirections; ++k)
  {
    const Point2 e = GetContactDirection(k);
    const double skew = std::abs(e[0] * along[0] + e[1] * along[1]);
    if (!isLine || skew <= 1.01 * std::sin(2.0 * HalfPi / ContactDirections))
    {
      const ContactSample one = GetEnvelope(contacts.Samples, frame.ProjectedCenter, along, reach, k);
      sample = one.Radius < sample.Radius || !(one.Radius >= 0.0) ? one : sample;
    }
  }
  if (!(sample.Radius >= 0.0))
  {
    return;
  }
  // On a slope the balanced centre is z / u_h above the contact, along u. A rotation about the axis a moves
  // it horizontally by 1 - (a.u)^2 times that, and the contact by u_h times the radius. So z has the factor
  // (1 - (a.u)^2) / u_h^2.
  const std::array<double, 3>& up = frame.Body.Up;
  const double slopeAlong = isLine ? along[0] * up[0] + along[1] * up[1] : 0.0;
  const double factor =
    up[0] == 0.0 && up[1] == 0.0 ? 1.0 : (1.0 - slopeAlong * slopeAlong) / (up[2] * up[2]);
  result.RollingRadius = sample.Radius;
  result.RollingMargin = sample.Radius - factor * frame.Height;
  result.RollingMarginBound = sample.RadiusError + factor * frame.Bound;
  // The smallest radius belongs to one direction, which need not be the worst one for a point on a slope, or
  // for two points that form a line.
  if (isLine ? sample.Widest < 1e6 * frame.Body.Size : factor > 1.0)
  {
    result.RollingMarginBound += std::max(0.0, sample.Widest - sample.Radius);
  }
  if (result.StabilityMargin + result.StabilityMarginBound < -reach)
  {
    return; // not in balance
  }
  result.ByRolling = true;
  // Along the line the body tips over the ends.
  double ends[2] = { 0.0, 0.0 };
  for (const Point2& p : hull.Corners)
  {
    const double x =
      (p[0] - frame.ProjectedCenter[0]) * along[0] + (p[1] - frame.ProjectedCenter[1]) * along[1];
    ends[0] = std::min(ends[0], x);
    ends[1] = std::max(ends[1], x);
  }
  if (result.Support == SupportKind::Line && std::min(-ends[0], ends[1]) <= frame.Bound &&
    !(result.RollingMargin < -result.RollingMarginBound))
  {
    result.Decision = Verdict::TooClose;
    return;
  }
  result.Decision = result.RollingMargin > result.RollingMarginBound ? Verdict::Stable
    : result.RollingMargin < -result.RollingMarginBound ||
      (!isLine && sample.Radius + sample.RadiusError + frame.Bound < frame.Height)
    ? Verdict::Unstable
    : Verdict::TooClose;
}
}

StabilityResult::StabilityResult()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->ProjectedCenter = { nan, nan };
  this->Height = this->HeightBound = this->StabilityMargin = this->StabilityMarginBound = this->TipAngle =
    this->TipAngleBound = this->CenterOfMassRise = this->CenterOfMassRiseBound = this->RollingRadius =
      this->RollingMargin = this->RollingMarginBound = nan;
}

StabilityResult ComputeStability(const StabilityCase& body, GroundContacts contacts)
{
  StabilityResult result;
  if (!std::isfinite(body.CenterBound) || !std::isfinite(body.Center[0] + body.Center[1] + body.Center[2]))
  {
    return result;
  }
  // Errors of the centre, of the ground and of rounding.
  result.HeightBound = body.CenterBound + 0.5 * (body.Ground.High - body.Ground.Low) + body.Rounding;
  const Frame frame = MakeFrame(body, result.HeightBound);
  result.ProjectedCenter = frame.ProjectedCenter;
  result.Height = frame.Height;
  if (contacts.Pieces.empty())
  {
    result.Decision = Verdict::NoContact;
    return result;
  }

  // Points nearer to each other than the accuracy of stationary points count as one.
  const double merge = body.Resolution + 2.0 * contacts.Spread;
  while (contacts.Pieces.size() < MaximumPieces &&
    HalvePieces(contacts.Pieces,
      [&](const ContactPiece& piece) { return GetSagitta(piece) > DrawnSagitta * body.Size; }))
  {
  }
  const Hulls drawn = MakeHulls(contacts.Pieces, merge);
  result.Polygon = drawn.Inner.Corners.empty() ? drawn.Outer.Corners : drawn.Inner.Corners;
  result.Support = !(drawn.Outer.GetWidth() <= LineWidth * body.Size) ? SupportKind::Area
    : drawn.Outer.GetLength() <= LineWidth * body.Size                ? SupportKind::Point
                                                                      : SupportKind::Line;

  const Hulls fine = Refine(contacts.Pieces, frame.ProjectedCenter, body.Size, merge);
  // The outer hull may leave out contacts by this distance: points close to others are merged, and stationary
  // points have the accuracy Spread.
  const double beyond = 8.0 * merge + contacts.Spread;
  const double inner = fine.Inner.GetMargin(frame.ProjectedCenter);
  double low = inner - contacts.Spread - frame.Bound;
  double high = fine.Outer.GetMargin(frame.ProjectedCenter) + beyond + frame.Bound;
  if (!std::isfinite(low))
  {
    // There are only possible contacts: the distance of the projected centre of mass from the farthest of
    // them is the only certain limit.
    low = -body.Size - std::abs(high);
  }
  SetInterval(low, high, result.StabilityMargin, result.StabilityMarginBound);
  result.Decision = low > 0.0 ? Verdict::Stable : high < 0.0 ? Verdict::Unstable : Verdict::TooClose;

  SetSides(frame, frame.MakeSides(drawn.Inner, contacts.Spread), fine.Outer, beyond, result);
  const bool isLevel = body.Up[0] == 0.0 && body.Up[1] == 0.0;
  if (isLevel && fine.Inner.Corners.size() == 1 && fine.Outer.Corners.size() == 1)
  {
    SetTipOverPoint(frame, fine.Inner.Corners[0], beyond, result);
  }
  else if (!fine.Inner.Corners.empty() && frame.Height > frame.Bound + beyond)
  {
    const MinimumTip certain = GetMinimumTip(frame, fine.Inner, contacts.Spread);
    const MinimumTip possible = GetMinimumTip(frame, fine.Outer, beyond);
    SetInterval(certain.Angle[0], possible.Angle[1], result.TipAngle, result.TipAngleBound);
    SetInterval(certain.Rise[0], possible.Rise[1], result.CenterOfMassRise, result.CenterOfMassRiseBound);
  }
  if (result.Support != SupportKind::Area)
  {
    Roll(frame, contacts, drawn.Outer, result);
  }
  return result;
}
}
