#include "smOCCTFaceDomain.h"

#include "smOCCTAxialProfile.h"
#include "smOCCTSurface.h"

#include <vtkMath.h>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2d.hxx>
#include <gp_Lin.hxx>

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

/// Largest distance of a trim curve from its edge, relative to the length of that: OpenCASCADE may have
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

/// Returns the surface that is swept along another curve.
Handle(Geom_Surface) SweepAlong(const Handle(Geom_SweptSurface) & surface, const Handle(Geom_Curve) & curve)
{
  if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface))
  {
    return new Geom_SurfaceOfRevolution(curve, revolution->Axis());
  }
  return new Geom_SurfaceOfLinearExtrusion(curve, surface->Direction());
}

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
std::vector<gp_Pnt> SampleEdges(const DraftFace& face, const Fractions& fractions)
{
  std::vector<gp_Pnt> points;
  for (TopExp_Explorer it(face.Face, TopAbs_EDGE); it.More(); it.Next())
  {
    TopLoc_Location location;
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(it.Current()), location, first, last);
    if (!curve.IsNull() && last > first)
    {
      const gp_Trsf placement = face.Location.Inverted() * location.Transformation();
      for (const double x : fractions)
      {
        points.push_back(curve->Value((1.0 - x) * first + x * last).Transformed(placement));
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
  for (TopExp_Explorer it(face.Face, TopAbs_EDGE); it.More(); it.Next())
  {
    TopLoc_Location location;
    double first = 0.0;
    double last = 0.0;
    Handle(Geom2d_Curve) curve;
    Handle(Geom_Surface) surface;
    for (int i = 1; i <= 4; ++i)
    {
      BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), curve, surface, location, first, last, i);
      if (surface == face.Stored && !curve.IsNull())
      {
        const double v = curve->Value(0.5 * (first + last)).Y();
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
  const std::vector<gp_Pnt> points = SampleEdges(face, EdgeFractions);
  std::vector<double> distances;
  for (const ProfilePart& part : parts)
  {
    double distance = 0.0;
    for (const gp_Pnt& point : points)
    {
      distance = std::max(distance, profile.GetDistance(profile.Locate(point), part.First, part.Last));
    }
    distances.push_back(distance);
  }
  const double least = *std::min_element(distances.begin(), distances.end());
  const double limit =
    std::min(OnPart * profile.GetExtent(), std::max(10.0 * least, SamePart * profile.GetExtent()));
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

/// Returns a closed spline whose ends have the same control point and weight as a periodic one: its parts
/// between poles may pass its ends. Returns null for other curves.
Handle(Geom_BSplineCurve) MakePeriodic(const Handle(Geom_Curve) & curve)
{
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  if (spline.IsNull() || spline->IsPeriodic() || spline->Degree() < 1 || !spline->IsClosed())
  {
    return {};
  }
  const int last = spline->NbPoles();
  const gp_Pnt start = spline->Pole(1);
  const bool isSame = start.Distance(spline->Pole(last)) <=
      Rounded * (start.XYZ().Modulus() + spline->Pole(last).XYZ().Modulus()) &&
    std::abs(spline->Weight(1) - spline->Weight(last)) <= Rounded * spline->Weight(1);
  const bool isClamped = spline->Multiplicity(1) == spline->Degree() + 1 &&
    spline->Multiplicity(spline->NbKnots()) == spline->Degree() + 1;
  if (!isSame || !isClamped)
  {
    return {};
  }
  const auto periodic = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
  periodic->SetPeriodic();
  return periodic;
}

/// Returns the surface along the whole curve for one that is swept along a trimmed curve.
Handle(Geom_Surface) RemoveTrim(const Handle(Geom_SweptSurface) & surface)
{
  return SweepAlong(surface, GetUntrimmed(surface->BasisCurve()));
}

/// Returns the curve whose trim is swept, if that is periodic, else null.
Handle(Geom_TrimmedCurve) GetTrimOfPeriodic(const Handle(Geom_Surface) & surface)
{
  const auto swept = Handle(Geom_SweptSurface)::DownCast(surface);
  const auto trimmed =
    Handle(Geom_TrimmedCurve)::DownCast(swept.IsNull() ? Handle(Geom_Curve)() : swept->BasisCurve());
  const bool isPeriodic = !trimmed.IsNull() && GetUntrimmed(Handle(Geom_Curve)(trimmed))->IsPeriodic();
  return isPeriodic ? trimmed : Handle(Geom_TrimmedCurve)();
}

/// Replaces a surface of revolution that reaches its axis inside its domain by one of its parts. `middle` is
/// the middle of the domain that the file states, which begins at `start`.
void TakePart(DraftFace& face, double start, double middle)
{
  auto surface = Handle(Geom_SurfaceOfRevolution)::DownCast(face.Surface);
  if (surface.IsNull())
  {
    return;
  }
  AxialProfile profile(surface);
  std::vector<double> poles =
    profile.IsFinite() && profile.GetExtent() > 0.0 ? profile.FindPoles() : std::vector<double>();
  if (!poles.empty() && !GetTrimOfPeriodic(surface).IsNull())
  {
    surface = Handle(Geom_SurfaceOfRevolution)::DownCast(RemoveTrim(surface));
    profile = AxialProfile(surface);
    poles = profile.FindPoles();
  }
  const Handle(Geom_BSplineCurve) periodic =
    poles.empty() ? Handle(Geom_BSplineCurve)() : MakePeriodic(surface->BasisCurve());
  if (!periodic.IsNull())
  {
    surface = Handle(Geom_SurfaceOfRevolution)::DownCast(SweepAlong(surface, periodic));
    profile = AxialProfile(surface);
    poles = profile.FindPoles();
  }
  if (poles.empty())
  {
    return;
  }
  const double period = surface->IsVPeriodic() ? surface->VPeriod() : 0.0;
  const std::vector<ProfilePart> parts = ListParts(profile, poles, period);
  const FoundParts found = FindParts(face, profile, parts, period, middle);
  if (found.Parts.empty())
  {
    face.HasSeveralParts = parts.size() > 1;
    return;
  }
  const Handle(Geom_Curve) curve = GetUntrimmed(surface->BasisCurve());
  const auto make = [&](const ProfilePart& part)
  { return SweepAlong(surface, new Geom_TrimmedCurve(curve, part.First, part.Last, true, false)); };
  face.Surface = make(found.Parts[0]);
  face.HasSeveralParts = !found.AreSame;
  face.IsPart = true;
  if (found.Parts.size() == 2 && found.AreSame && !found.IsStated && std::abs(start) <= StatedStart)
  {
    face.OtherSurface = make(found.Parts[1]);
  }
}

/// Returns the part of a parabola or hyperbola that has all points within a distance of its centre.
Handle(Geom_Curve) TakeWithin(const Handle(Geom_Conic) & conic, double distance)
{
  const auto hyperbola = Handle(Geom_Hyperbola)::DownCast(conic);
  const double end = hyperbola.IsNull() ? distance : std::asinh(distance / hyperbola->MinorRadius());
  return new Geom_TrimmedCurve(conic, -end, end);
}

/// Replaces a surface that is swept along a parabola or hyperbola without ends by the one along a part that
/// is more than long enough for the edges of the face. Returns true if there is one.
bool BoundProfile(DraftFace& face, const Handle(Geom_SweptSurface) & swept)
{
  const auto conic = Handle(Geom_Conic)::DownCast(swept->BasisCurve());
  if (conic.IsNull() || !Precision::IsInfinite(conic->LastParameter()))
  {
    return false;
  }
  const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(swept);
  const gp_XYZ center = conic->Location().XYZ();
  const gp_XYZ normal = conic->Axis().Direction().XYZ();
  const gp_XYZ along = swept->Direction().XYZ();
  double distance = 0.0;
  for (const gp_Pnt& point : SampleEdges(face, WideFractions))
  {
    // A point of an extrusion is that far along it from the plane of its profile; a revolution keeps the
    // distance from every point of the axis.
    const gp_XYZ away = point.XYZ() - (revolution.IsNull() ? center : revolution->Location().XYZ());
    const gp_XYZ foot = revolution.IsNull() ? away - (away.Dot(normal) / along.Dot(normal)) * along : away;
    distance = std::max(distance, foot.Modulus());
  }
  distance += revolution.IsNull() ? 0.0 : (revolution->Location().XYZ() - center).Modulus();
  if (distance > 0.0 && std::isfinite(distance))
  {
    face.Surface = SweepAlong(swept, TakeWithin(conic, ProfileMargin * distance));
  }
  return true;
}

/// Replaces a torus that crosses itself by the revolution of its circle if an edge of the face ends at its
/// axis: both its parts have poles there, which a torus has not.
void RevolveCrossingTorus(DraftFace& face)
{
  const auto torus = Handle(Geom_ToroidalSurface)::DownCast(face.Surface);
  if (torus.IsNull() || !(torus->MinorRadius() > torus->MajorRadius()))
  {
    return;
  }
  const gp_Lin axis(torus->Axis());
  bool reachesAxis = false;
  for (TopExp_Explorer it(face.Face, TopAbs_VERTEX); it.More(); it.Next())
  {
    const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).Transformed(face.Location.Inverted());
    reachesAxis = reachesAxis || axis.Distance(point) <= AtAxis * torus->MinorRadius();
  }
  if (reachesAxis)
  {
    face.Surface = RevolveTorus(torus);
  }
}

/// Replaces a surface that is swept along a curve without ends, or along a curve that was trimmed to a whole
/// period, by the one along the part that is needed or the curve itself, then a surface of revolution by its
/// part.
void ReplaceSurface(DraftFace& face)
{
  double start = 0.0;
  double middle = 0.0;
  RevolveCrossingTorus(face);
  auto swept = Handle(Geom_SweptSurface)::DownCast(face.Surface);
  if (!swept.IsNull())
  {
    const bool isUnbounded = BoundProfile(face, swept);
    swept = Handle(Geom_SweptSurface)::DownCast(face.Surface);
    start = isUnbounded ? 0.0 : swept->BasisCurve()->FirstParameter();
    middle = 0.5 * (swept->BasisCurve()->FirstParameter() + swept->BasisCurve()->LastParameter());
    const Handle(Geom_TrimmedCurve) trimmed = GetTrimOfPeriodic(swept);
    if (!trimmed.IsNull() &&
      trimmed->LastParameter() - start >= (1.0 - WholePeriod) * GetUntrimmed(swept->BasisCurve())->Period())
    {
      face.Surface = RemoveTrim(swept);
    }
    TakePart(face, start, middle);
  }
}

/// Sets the periods, and the direction in which the formula repeats although the surface is not periodic,
/// with its domain.
void SetPeriods(DraftFace& face)
{
  face.Period[0] = face.Surface->IsUPeriodic() ? face.Surface->UPeriod() : 0.0;
  face.Period[1] = face.Surface->IsVPeriodic() ? face.Surface->VPeriod() : 0.0;
  const auto swept = Handle(Geom_SweptSurface)::DownCast(face.Surface);
  const bool isSphere = !Handle(Geom_SphericalSurface)::DownCast(face.Surface).IsNull();
  const int d = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(face.Surface).IsNull() ? 1 : 0;
  double period = isSphere ? 2.0 * vtkMath::Pi() : 0.0;
  if (!swept.IsNull())
  {
    const Handle(Geom_Curve) curve = GetUntrimmed(swept->BasisCurve());
    period = curve->IsPeriodic() ? curve->Period() : 0.0;
  }
  double low[2];
  double high[2];
  face.Surface->Bounds(low[0], high[0], low[1], high[1]);
  if (period > 0.0 && face.Period[d] <= 0.0)
  {
    face.FormulaPeriod[d] = period;
    face.Low[d] = low[d];
    face.High[d] = high[d];
  }
  face.EndsAtPole[0] = face.EndsAtPole[1] = isSphere;
  const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(face.Surface);
  if (!revolution.IsNull() && face.IsPart)
  {
    const AxialProfile profile(revolution);
    face.Low[1] = low[1];
    face.High[1] = high[1];
    face.EndsAtPole[0] = profile.MeetsAxis(low[1]);
    face.EndsAtPole[1] = profile.MeetsAxis(high[1]);
  }
}

/// Returns true if the points of a trim curve are those of its edge, as far as a rough trim curve may have
/// them.
bool IsAlongEdge(const DraftFace& face, const TopoDS_Edge& edge, const NativeTrim& trim)
{
  TopLoc_Location location;
  double range[2] = { 0.0, 0.0 };
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, range[0], range[1]);
  if (curve.IsNull())
  {
    return true;
  }
  const gp_Trsf placement = face.Location.Inverted() * location.Transformation();
  double length = 0.0;
  double distance = 0.0;
  gp_Pnt last = curve->Value(range[0]).Transformed(placement);
  for (const double x : EdgeFractions)
  {
    const gp_Pnt point = curve->Value((1.0 - x) * range[0] + x * range[1]).Transformed(placement);
    const std::array<double, 2> uv = trim.Evaluate((1.0 - x) * trim.First + x * trim.Last);
    distance = std::max(distance, face.Surface->Value(uv[0], uv[1]).Distance(point));
    length += point.Distance(last);
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
  mirrored.Curve = Handle(Geom2d_Curve)::DownCast(
    trim.Curve->Mirrored(gp_Ax2d(gp_Pnt2d(0.0, pole - trim.Shift[1]), gp_Dir2d(1.0, 0.0))));
  mirrored.Shift[0] += 0.5 * face.Period[0];
  for (const double x : EdgeFractions)
  {
    const double t = (1.0 - x) * trim.First + x * trim.Last;
    const std::array<double, 2> from = trim.Evaluate(t);
    const std::array<double, 2> to = mirrored.Evaluate(t);
    const gp_Pnt here = face.Surface->Value(from[0], from[1]);
    const gp_Pnt there = face.Surface->Value(to[0], to[1]);
    if (!(here.Distance(there) <=
          1e-12 * (here.XYZ().Modulus() + there.XYZ().Modulus()) + Precision::Confusion()))
    {
      mirrored.Curve.Nullify();
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
  face.Surface = GetBasisSurface(face.Stored);
  ReplaceSurface(face);
  SetPeriods(face);
}

bool MoveIntoDomain(const DraftFace& face, const TopoDS_Edge& edge, NativeTrim& trim)
{
  if (face.FormulaPeriod[0] <= 0.0 && face.FormulaPeriod[1] <= 0.0)
  {
    return true;
  }
  const bool isSwept = !Handle(Geom_SweptSurface)::DownCast(face.Surface).IsNull();
  if (isSwept && !IsAlongEdge(face, edge, trim))
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
    if (!candidate.Curve.IsNull() && MoveByPeriods(face, candidate))
    {
      trim = candidate;
      return true;
    }
  }
  return false;
}

bool TakeOtherPart(DraftFace& face)
{
  if (face.OtherSurface.IsNull())
  {
    return false;
  }
  std::swap(face.Surface, face.OtherSurface);
  SetPeriods(face);
  for (DraftLoop& loop : face.Loops)
  {
    for (DraftCoedge& coedge : loop)
    {
      if (!coedge.NeedsFeet && !MoveIntoDomain(face, coedge.Edge, coedge.Trim))
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
