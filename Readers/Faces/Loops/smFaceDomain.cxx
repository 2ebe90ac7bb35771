#include "smFaceDomain.h"

#include "Geometry/smGeometryTransform.h"
#include "smAxialProfile.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// A curve that is trimmed to less than a period by this fraction of it is trimmed to the whole: numbers of
/// seven digits are that good.
constexpr double WholePeriod = 1e-6;

/// A trim curve may lead beyond the domain by this fraction of the period.
constexpr double BeyondDomain = 1e-6;

/// Largest distance of a trim curve from its edge, relative to the length of that: the file may have
/// mistaken the unit of the trim curve.
constexpr double RoughTrim = 0.02;

/// Relative difference of numbers that are equal except for their digits in the file.
constexpr double Rounded = 1e-14;

/// Two parts of a surface are the same if points of one are closer than this to the other, relative to the
/// extent of the profile.
constexpr double SamePart = 1e-7;

/// A domain that begins at 0, or has no ends, does not state which part of the surface is meant
/// (smSTEPRevolvedConics.h).
constexpr double StatedStart = 1e-12;

/// Edges within this distance of a part, relative to the extent of the profile, may lie on it.
constexpr double OnPart = 1e-3;

/// Fractions of an edge at which it is compared with the parts of a surface.
constexpr double EdgeFractions[] = { 0.13, 0.37, 0.61, 0.86 };

/// An edge ends at the axis of a torus if it is closer than this, relative to the minor radius.
constexpr double AtAxis = 1e-6;

/// Fractions of an edge that show its extent.
constexpr double WideFractions[] = { 0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0 };

/// The part of a profile without ends is so many times longer than its edges need.
constexpr double ProfileMargin = 1.25;

/// A swept surface as its profile, the part of that, and a direction.
struct SweptSurface
{
  explicit SweptSurface(const GeometricSurface& surface)
    : Revolved(surface.GetIf<RevolvedSurface>())
    , Extruded(surface.GetIf<ExtrudedSurface>())
  {
    if (this->Revolved || this->Extruded)
    {
      this->Profile = this->Revolved ? this->Revolved->Profile : this->Extruded->Profile;
      this->Range = this->Revolved ? this->Revolved->Range : this->Extruded->Range;
      this->Direction = this->Revolved ? this->Revolved->Axis : this->Extruded->Direction;
    }
  }

  explicit operator bool() const { return this->Profile != nullptr; }
  /// Returns true if a part of the profile is swept.
  bool IsPart() const { return std::isfinite(this->Range.Low) || std::isfinite(this->Range.High); }
  ParameterRange GetDomain() const { return this->IsPart() ? this->Range : this->Profile->GetDomain(); }

  /// Returns the surface that is swept along another curve.
  SurfacePointer SweepAlong(const CurvePointer<3>& curve, const ParameterRange& range = {}) const
  {
    std::string problem;
    if (this->Revolved)
    {
      return GeometricSurface::Make(
        RevolvedSurface{ curve, range, this->Revolved->Origin, this->Revolved->Axis }, problem);
    }
    return GeometricSurface::Make(ExtrudedSurface{ curve, range, this->Extruded->Direction }, problem);
  }

  const RevolvedSurface* Revolved;
  const ExtrudedSurface* Extruded;
  CurvePointer<3> Profile;
  ParameterRange Range;
  Vector3 Direction{};
};

/// A part of a profile between poles or ends.
struct ProfilePart
{
  double First;
  double Last;
};

double GetMiddle(const ProfilePart& part)
{
  return 0.5 * (part.First + part.Last);
}

/// Returns a parameter, moved by whole periods to be nearest to the middle of a part.
double WrapInto(const ProfilePart& part, double t, double period)
{
  return period > 0.0 ? t + std::round((GetMiddle(part) - t) / period) * period : t;
}

std::vector<ProfilePart> ListParts(
  const AxialProfile& profile, const std::vector<double>& poles, double period)
{
  std::vector<ProfilePart> parts;
  std::vector<double> ends = poles;
  if (period > 0.0)
  {
    ends.push_back(poles[0] + period);
  }
  else
  {
    ends.insert(ends.begin(), profile.GetFirst());
    ends.push_back(profile.GetLast());
  }
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    parts.push_back({ ends[i], ends[i + 1] });
  }
  return parts;
}

/// Returns true if every point of a part lies on the other one.
bool AreSame(const AxialProfile& profile, const ProfilePart& a, const ProfilePart& b)
{
  constexpr int count = 16;
  for (int i = 1; i < count; ++i)
  {
    const double t = a.First + (a.Last - a.First) * i / count;
    if (!(profile.GetDistance(profile.Evaluate(t), b.First, b.Last) <= SamePart * profile.GetExtent()))
    {
      return false;
    }
  }
  return true;
}

/// Returns points of the edges of a face, at these fractions of each, in the frame of its surface.
template <class Fractions>
std::vector<Vector3> SampleEdges(const DraftFace& face, const Fractions& fractions)
{
  std::vector<Vector3> points;
  const Placement toSurface = Invert(face.Location);
  for (const WireShape& wire : face.Source->Wires)
  {
    for (const CoedgeShape& use : wire.Coedges)
    {
      for (const double x : fractions)
      {
        if (use.Edge->HasCurve())
        {
          points.push_back(toSurface.MapPoint(use.Edge->EvaluateAt(x)));
        }
      }
    }
  }
  return points;
}

/// Returns the number of stored trim curves whose middle lies in a part, moved by whole periods or, with
/// `isExact`, as it is.
int CountTrims(const DraftFace& face, const ProfilePart& part, double period, bool isExact)
{
  int count = 0;
  for (const WireShape& wire : face.Source->Wires)
  {
    for (const CoedgeShape& use : wire.Coedges)
    {
      if (use.Trim)
      {
        const double v = use.Trim->Evaluate(0.5 * (use.First + use.Last))[1];
        const double inside = isExact ? v : WrapInto(part, v, period);
        count += inside > part.First && inside < part.Last ? 1 : 0;
      }
    }
  }
  return count;
}

/// The parts of a profile on which the edges of a face may lie, the first of which is taken.
struct FoundParts
{
  std::vector<ProfilePart> Parts;
  bool AreSame = true;
  /// True if the trim curves say which one is meant.
  bool IsStated = false;
};

/// Finds the parts of the profile on which the edges lie. Parts with more trim curves come first, then the
/// one that has `middle`.
FoundParts FindParts(const DraftFace& face, const AxialProfile& profile,
  const std::vector<ProfilePart>& parts, double period, double middle)
{
  const std::vector<Vector3> points = SampleEdges(face, EdgeFractions);
  std::vector<double> distances;
  for (const ProfilePart& part : parts)
  {
    double distance = 0.0;
    for (const Vector3& point : points)
    {
      distance = std::max(distance, profile.GetDistance(profile.Locate(point), part.First, part.Last));
    }
    distances.push_back(distance);
  }
  const double minimum = *std::min_element(distances.begin(), distances.end());
  const double limit =
    std::min(OnPart * profile.GetExtent(), std::max(10.0 * minimum, SamePart * profile.GetExtent()));
  FoundParts found;
  std::vector<std::array<int, 3>> counts;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (distances[i] <= limit)
    {
      const bool isMiddle = std::abs(WrapInto(parts[i], middle, period) - GetMiddle(parts[i])) <
        0.4999 * (parts[i].Last - parts[i].First);
      counts.push_back({ CountTrims(face, parts[i], period, false), CountTrims(face, parts[i], period, true),
        isMiddle ? 1 : 0 });
      found.Parts.push_back(parts[i]);
    }
  }
  const auto best = std::max_element(counts.begin(), counts.end());
  if (best != counts.end())
  {
    found.IsStated = std::count_if(counts.begin(), counts.end(),
                       [&](const std::array<int, 3>& c) { return c[0] == (*best)[0]; }) == 1;
    std::rotate(found.Parts.begin(), found.Parts.begin() + (best - counts.begin()), found.Parts.end());
  }
  for (std::size_t i = 1; i < found.Parts.size(); ++i)
  {
    found.AreSame = found.AreSame && AreSame(profile, found.Parts[i], found.Parts[0]) &&
      AreSame(profile, found.Parts[0], found.Parts[i]);
  }
  return found;
}

/// Returns true if a part of a periodic curve is swept.
bool HasTrimOfPeriodic(const SweptSurface& swept)
{
  return swept && swept.IsPart() && swept.Profile->GetPeriod() > 0.0;
}

/// Replaces a surface of revolution that reaches its axis inside its domain by one of its parts. `middle` is
/// the middle of the domain that the file states, which begins at `start`.
void TakePart(DraftFace& face, double start, double middle)
{
  if (!face.Surface->GetIf<RevolvedSurface>())
  {
    return;
  }
  SurfacePointer surface = face.Surface;
  const auto findPoles = [&surface]
  {
    const AxialProfile profile(*surface);
    return profile.IsFinite() && profile.GetExtent() > 0.0 ? profile.FindPoles() : std::vector<double>();
  };
  std::vector<double> poles = findPoles();
  const SweptSurface stated(*surface);
  const CurvePointer<3> periodic =
    poles.empty() || HasTrimOfPeriodic(stated) ? nullptr : MakePeriodic(stated.Profile, Rounded);
  if (!poles.empty() && (HasTrimOfPeriodic(stated) || periodic))
  {
    surface = stated.SweepAlong(periodic ? periodic : stated.Profile);
    poles = findPoles();
  }
  if (poles.empty())
  {
    return;
  }
  const AxialProfile profile(*surface);
  const SweptSurface whole(*surface);
  const double period = surface->GetPeriod(1);
  const std::vector<ProfilePart> parts = ListParts(profile, poles, period);
  const FoundParts found = FindParts(face, profile, parts, period, middle);
  if (found.Parts.empty())
  {
    face.HasSeveralParts = parts.size() > 1;
    return;
  }
  const auto make = [&](const ProfilePart& part) {
    return whole.SweepAlong(whole.Profile, { part.First, part.Last });
  };
  face.Surface = make(found.Parts[0]);
  face.HasSeveralParts = !found.AreSame;
  face.IsPart = true;
  if (found.Parts.size() == 2 && found.AreSame && !found.IsStated && std::abs(start) <= StatedStart)
  {
    face.OtherSurface = make(found.Parts[1]);
  }
}

/// Returns the part of a parabola or hyperbola that has all points within a distance of its centre.
ParameterRange TakeWithin(const ConicCurve<3>& conic, double distance)
{
  const bool isHyperbola = conic.Kind == ConicCurve<3>::Type::Hyperbola;
  const double end = isHyperbola ? GetHyperbolaParameter(distance / conic.Radii[1]) : distance;
  return { -end, end };
}

/// Replaces a surface that is swept along a parabola or hyperbola without ends by the one along a part that
/// is more than long enough for the edges of the face. Returns true if there is one.
bool BoundProfile(DraftFace& face, const SweptSurface& swept)
{
  const auto* conic = swept.Profile->GetIf<ConicCurve<3>>();
  if (!conic || std::isfinite(swept.GetDomain().High))
  {
    return false;
  }
  const Vector3 normal = Normalized(Cross(conic->X, conic->Y));
  double distance = 0.0;
  for (const Vector3& point : SampleEdges(face, WideFractions))
  {
    // A point of an extrusion is that far along it from the plane of its profile; a revolution keeps the
    // distance from every point of the axis.
    const Vector3 away = Subtract(point, swept.Revolved ? swept.Revolved->Origin : conic->Center);
    const double height = swept.Revolved ? 0.0 : Dot(away, normal) / Dot(swept.Direction, normal);
    distance = std::max(distance, Norm(Subtract(away, Multiply(height, swept.Direction))));
  }
  distance += swept.Revolved ? Norm(Subtract(swept.Revolved->Origin, conic->Center)) : 0.0;
  if (distance > 0.0 && std::isfinite(distance))
  {
    face.Surface = swept.SweepAlong(swept.Profile, TakeWithin(*conic, ProfileMargin * distance));
  }
  return true;
}

/// Replaces a torus that crosses itself by the revolution of its circle if an edge of the face ends at its
/// axis: both its parts have poles there, which a torus has not.
void RevolveCrossingTorus(DraftFace& face)
{
  const ElementarySurface* torus = FindElementary(*face.Surface, ElementarySurface::Type::Torus);
  if (!torus || !(torus->Radii[1] > torus->Radii[0]))
  {
    return;
  }
  bool reachesAxis = false;
  const Placement toSurface = Invert(face.Location);
  for (const WireShape& wire : face.Source->Wires)
  {
    for (const CoedgeShape& use : wire.Coedges)
    {
      for (const VertexPointer& vertex : { use.Edge->Start, use.Edge->End })
      {
        const Vector3 away =
          vertex ? Subtract(toSurface.MapPoint(vertex->Point), torus->Frame.Origin) : torus->Frame.Axes[0];
        reachesAxis =
          reachesAxis || (vertex && Norm(Cross(away, torus->Frame.Axes[2])) <= AtAxis * torus->Radii[1]);
      }
    }
  }
  if (reachesAxis)
  {
    face.Surface = RevolveTorus(*torus);
  }
}

/// Replaces a surface that is swept along a curve without ends, or along a curve that was trimmed to a whole
/// period, by the one along the part that is needed or the curve itself, then a surface of revolution by its
/// part.
void ReplaceSurface(DraftFace& face)
{
  RevolveCrossingTorus(face);
  const SurfacePointer stated = face.Surface;
  const SweptSurface swept(*stated);
  if (!swept)
  {
    return;
  }
  const bool isUnbounded = BoundProfile(face, swept);
  const SurfacePointer bounded = face.Surface;
  const SweptSurface part(*bounded);
  const ParameterRange domain = part.GetDomain();
  const double start = isUnbounded ? 0.0 : domain.Low;
  if (HasTrimOfPeriodic(part) && domain.High - domain.Low >= (1.0 - WholePeriod) * part.Profile->GetPeriod())
  {
    face.Surface = part.SweepAlong(part.Profile);
  }
  TakePart(face, start, 0.5 * (domain.Low + domain.High));
}

/// Sets the periods, and the direction in which the formula repeats although the surface is not periodic,
/// with its domain.
void SetPeriods(DraftFace& face)
{
  const SweptSurface swept(*face.Surface);
  const bool isSphere = FindElementary(*face.Surface, ElementarySurface::Type::Sphere) != nullptr;
  const int d = swept.Extruded ? 0 : 1;
  const double period = isSphere ? 2.0 * vtkMath::Pi() : swept ? swept.Profile->GetPeriod() : 0.0;
  face.Period[0] = face.Surface->GetPeriod(0);
  face.Period[1] = face.Surface->GetPeriod(1);
  const ParameterRange& domain = face.Surface->GetDomain(d);
  if (period > 0.0 && face.Period[d] <= 0.0)
  {
    face.FormulaPeriod[d] = period;
    face.Low[d] = domain.Low;
    face.High[d] = domain.High;
  }
  face.EndsAtPole[0] = face.EndsAtPole[1] = isSphere;
  if (swept.Revolved && face.IsPart)
  {
    const AxialProfile profile(*face.Surface);
    face.Low[1] = domain.Low;
    face.High[1] = domain.High;
    face.EndsAtPole[0] = profile.MeetsAxis(domain.Low);
    face.EndsAtPole[1] = profile.MeetsAxis(domain.High);
  }
}

/// Returns true if the points of a trim curve are those of its edge, as far as a rough trim curve may have
/// them.
bool IsAlongEdge(const DraftFace& face, const EdgeShape& edge, const NativeTrim& trim)
{
  if (!edge.Curve)
  {
    return true;
  }
  const Placement toSurface = Invert(face.Location);
  double length = 0.0;
  double distance = 0.0;
  Vector3 last = toSurface.MapPoint(edge.EvaluateAt(0.0));
  for (const double x : EdgeFractions)
  {
    const Vector3 point = toSurface.MapPoint(edge.EvaluateAt(x));
    const std::array<double, 2> uv = trim.Evaluate((1.0 - x) * trim.First + x * trim.Last);
    distance = std::max(distance, Norm(Subtract(face.Surface->Evaluate(uv[0], uv[1]), point)));
    length += Norm(Subtract(point, last));
    last = point;
  }
  return distance <= RoughTrim * length;
}

/// Returns the trim curve mirrored at a pole, v = `pole`, and moved by half a turn, if it has the same points
/// in space; else one without a curve.
NativeTrim Mirror(const DraftFace& face, const NativeTrim& trim, double pole)
{
  NativeTrim mirrored;
  if (trim.Feet || face.Period[0] <= 0.0)
  {
    return mirrored;
  }
  mirrored = trim;
  AffineTransform<2> reflection;
  reflection.Linear = { { { 1.0, 0.0 }, { 0.0, -1.0 } } };
  reflection.Translation = { 0.0, 2.0 * (pole - trim.Shift[1]) };
  ParameterScale parameter;
  std::string problem;
  mirrored.Curve = TransformCurve<2>(trim.Curve, reflection, parameter, problem);
  if (!mirrored.Curve)
  {
    return mirrored;
  }
  mirrored.Shift[0] += 0.5 * face.Period[0];
  for (const double x : EdgeFractions)
  {
    const double t = (1.0 - x) * trim.First + x * trim.Last;
    const std::array<double, 2> from = trim.Evaluate(t);
    const std::array<double, 2> to = mirrored.Evaluate(t);
    const Vector3 here = face.Surface->Evaluate(from[0], from[1]);
    const Vector3 there = face.Surface->Evaluate(to[0], to[1]);
    if (!(Norm(Subtract(here, there)) <= 1e-12 * (Norm(here) + Norm(there)) + DefaultTolerance))
    {
      mirrored.Curve = nullptr;
      break;
    }
  }
  return mirrored;
}

/// Moves a trim curve by whole periods to be nearest to the middle of the domain; returns true if it lies in
/// the domain then.
bool MoveByPeriods(const DraftFace& face, NativeTrim& trim)
{
  NativeBox box{ { 1e300, 1e300 }, { -1e300, -1e300 } };
  trim.AddTo(box);
  for (int d = 0; d < 2; ++d)
  {
    const double period = face.FormulaPeriod[d];
    if (period > 0.0)
    {
      const double middle = 0.5 * (box.Low[d] + box.High[d]) + trim.Shift[d];
      trim.Shift[d] += std::round((0.5 * (face.Low[d] + face.High[d]) - middle) / period) * period;
    }
    box.Low[d] += trim.Shift[d];
    box.High[d] += trim.Shift[d];
  }
  return !LeavesDomain(face, box);
}

bool IsInDomain(const DraftFace& face, const NativeTrim& trim)
{
  NativeBox box{ { 1e300, 1e300 }, { -1e300, -1e300 } };
  trim.AddTo(box);
  for (int d = 0; d < 2; ++d)
  {
    const double slack = BeyondDomain * face.FormulaPeriod[d];
    if (face.FormulaPeriod[d] > 0.0 &&
      !(box.Low[d] + trim.Shift[d] >= face.Low[d] - slack &&
        box.High[d] + trim.Shift[d] <= face.High[d] + slack))
    {
      return false;
    }
  }
  return true;
}
}

void FindFaceDomain(DraftFace& face)
{
  face.Surface = face.Source->Surface;
  ReplaceSurface(face);
  SetPeriods(face);
}

bool MoveIntoDomain(const DraftFace& face, const EdgeShape& edge, NativeTrim& trim)
{
  if (face.FormulaPeriod[0] <= 0.0 && face.FormulaPeriod[1] <= 0.0)
  {
    return true;
  }
  if (SweptSurface(*face.Surface) && !IsAlongEdge(face, edge, trim))
  {
    return false;
  }
  if (IsInDomain(face, trim))
  {
    return true;
  }
  std::vector<NativeTrim> candidates{ trim };
  if (face.FormulaPeriod[1] > 0.0)
  {
    candidates.push_back(Mirror(face, trim, face.Low[1]));
    candidates.push_back(Mirror(face, trim, face.High[1]));
  }
  for (NativeTrim& candidate : candidates)
  {
    if (candidate.Curve && MoveByPeriods(face, candidate))
    {
      trim = candidate;
      return true;
    }
  }
  return false;
}

bool TakeOtherPart(DraftFace& face)
{
  if (!face.OtherSurface)
  {
    return false;
  }
  std::swap(face.Surface, face.OtherSurface);
  SetPeriods(face);
  for (DraftLoop& loop : face.Loops)
  {
    for (DraftCoedge& coedge : loop)
    {
      if (!coedge.NeedsFeet && !MoveIntoDomain(face, *coedge.Edge, coedge.Trim))
      {
        return false;
      }
    }
  }
  return true;
}

bool LeavesDomain(const DraftFace& face, const NativeBox& box)
{
  // A part of a profile that is not periodic ends at its pole to rounding.
  const double slack = BeyondDomain * std::max(face.FormulaPeriod[1], face.High[1] - face.Low[1]);
  return (face.EndsAtPole[0] && !(box.Low[1] >= face.Low[1] - slack)) ||
    (face.EndsAtPole[1] && !(box.High[1] <= face.High[1] + slack));
}
}
