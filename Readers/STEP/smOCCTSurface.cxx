#include "smOCCTSurface.h"

#include "smChebyshevFit.h"
#include "smFormat.h"
#include "smOCCTProfile.h"
#include "smOCCTRounding.h"
#include "smOCCTSpline.h"
#include "smVector.h"

#include <vtkMath.h>

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>

#include <stdexcept>

namespace sm
{
namespace
{
/// A pole of a surface of revolution: w * position = w * Center + cos(u) X + sin(u) Y, all homogeneous.
struct RevolvedPole
{
  Vector3 Center;
  Vector3 X;
  Vector3 Y;
  double Weight;
};

std::vector<double> LinearKnots(double low, double high)
{
  return { low, low, high, high };
}

/// Sets the control net of `poles` revolved over the arcs of map.Map[0]; direction v is that of the profile.
void Revolve(const std::vector<RevolvedPole>& poles, ConvertedSurface& result)
{
  const std::vector<Vector3> arcs = result.Map[0].GetControlPoints();
  NURBSSurface& s = result.Surface;
  s.Degree[0] = 2;
  s.Knots[0] = result.Map[0].GetKnots();
  s.NumberOfControlPoints[0] = static_cast<int>(arcs.size());
  s.NumberOfControlPoints[1] = static_cast<int>(poles.size());
  s.Rational = true;
  for (const RevolvedPole& pole : poles)
  {
    for (const Vector3& arc : arcs)
    {
      std::array<double, 4> h;
      for (int c = 0; c < 3; ++c)
      {
        h[c] = arc[2] * pole.Center[c] + (arc[0] * pole.X[c] + arc[1] * pole.Y[c]);
      }
      h[3] = arc[2] * pole.Weight;
      s.ControlPoints.push_back(h);
    }
  }
}

/// Revolves the profile of a cylinder, cone, sphere or torus, given by homogeneous poles (radius, height, weight).
void RevolveElementary(
  const gp_Ax3& frame, const std::vector<Vector3>& profile, const AffineMap& map, ConvertedSurface& result)
{
  const Vector3 origin = map.MapPoint(frame.Location().XYZ());
  const Vector3 x = map.MapVector(frame.XDirection().XYZ());
  const Vector3 y = map.MapVector(frame.YDirection().XYZ());
  const Vector3 z = map.MapVector(frame.Direction().XYZ());
  std::vector<RevolvedPole> poles;
  for (const Vector3& p : profile)
  {
    RevolvedPole pole;
    for (int c = 0; c < 3; ++c)
    {
      pole.Center[c] = p[2] * origin[c] + p[1] * z[c];
      pole.X[c] = p[0] * x[c];
      pole.Y[c] = p[0] * y[c];
    }
    pole.Weight = p[2];
    poles.push_back(pole);
  }
  Revolve(poles, result);
}

void SetLinear(ConvertedSurface& result, int direction, double low, double high)
{
  result.Surface.Degree[direction] = 1;
  result.Surface.Knots[direction] = LinearKnots(low, high);
}

void ConvertPlane(const gp_Ax3& frame, const NativeBox& box, const AffineMap& map, ConvertedSurface& result)
{
  SetLinear(result, 0, box.Low[0], box.High[0]);
  SetLinear(result, 1, box.Low[1], box.High[1]);
  NURBSSurface& s = result.Surface;
  s.NumberOfControlPoints[0] = s.NumberOfControlPoints[1] = 2;
  const Vector3 origin = map.MapPoint(frame.Location().XYZ());
  const Vector3 x = map.MapVector(frame.XDirection().XYZ());
  const Vector3 y = map.MapVector(frame.YDirection().XYZ());
  for (const double v : { box.Low[1], box.High[1] })
  {
    for (const double u : { box.Low[0], box.High[0] })
    {
      std::array<double, 4> h{ 0.0, 0.0, 0.0, 1.0 };
      for (int c = 0; c < 3; ++c)
      {
        h[c] = origin[c] + (u * x[c] + v * y[c]);
      }
      s.ControlPoints.push_back(h);
    }
  }
}

/// An end of a range this close to a pole, relative to the range, is moved to the pole: the difference is the rounding of the file's
/// digits. The surface then has a row of coincident control points. Even if no loop bounds the face there, its area increases by less than
/// rounding.
constexpr double PoleDistance = 1e-8;

/// Returns the straight profile (radius, height) at both ends of v; a radius of the size of rounding is set to 0.
std::vector<Vector3> StraightProfile(
  const NativeBox& box, double radius, double radiusSlope, double heightSlope)
{
  std::vector<Vector3> profile;
  for (const double v : { box.Low[1], box.High[1] })
  {
    double r = radius + v * radiusSlope;
    if (std::abs(r) <= 8.0 * UnitRoundoff * std::max(std::abs(radius), std::abs(v * radiusSlope)))
    {
      r = 0.0;
    }
    profile.push_back({ r, v * heightSlope, 1.0 });
  }
  return profile;
}

/// Returns a circular profile around (major, 0) in the (radius, height) plane, over the arcs of v.
std::vector<Vector3> CircularProfile(const ParameterMap& arcs, double major, double minor)
{
  std::vector<Vector3> profile;
  for (const Vector3& p : arcs.GetControlPoints())
  {
    profile.push_back({ major * p[2] + minor * p[0], minor * p[1], p[2] });
  }
  return profile;
}

void SetArcs(ConvertedSurface& result, int direction, double low, double high)
{
  result.Map[direction] = ParameterMap::MakeCircular(low, high);
  result.Surface.Degree[direction] = 2;
  result.Surface.Knots[direction] = result.Map[direction].GetKnots();
}

void ConvertRevolution(const Handle(Geom_SurfaceOfRevolution) & surface, const NativeBox& box,
  const AffineMap& map, ConvertedSurface& result)
{
  const Profile profile = ConvertProfile(surface->BasisCurve(), box.Low[1], box.High[1]);
  const gp_Ax1 axis = surface->Axis();
  const gp_XYZ z = axis.Direction().XYZ();
  const Vector3 origin = map.MapPoint(axis.Location().XYZ());
  std::vector<RevolvedPole> poles;
  for (const std::array<double, 4>& h : profile.Poles)
  {
    const gp_XYZ fromAxis = gp_XYZ(h[0], h[1], h[2]) - h[3] * axis.Location().XYZ();
    const double height = fromAxis.Dot(z);
    gp_XYZ radius = fromAxis - height * z;
    if (radius.Modulus() < 8.0 * UnitRoundoff * (fromAxis.Modulus() + h[3] * axis.Location().XYZ().Modulus()))
    {
      radius = gp_XYZ(0.0, 0.0, 0.0);
    }
    RevolvedPole pole;
    const Vector3 along = map.MapVector(height * z);
    for (int c = 0; c < 3; ++c)
    {
      pole.Center[c] = h[3] * origin[c] + along[c];
    }
    pole.X = map.MapVector(radius);
    pole.Y = map.MapVector(z.Crossed(radius));
    pole.Weight = h[3];
    poles.push_back(pole);
  }
  result.Map[1] = profile.Map;
  result.Surface.Degree[1] = profile.Degree;
  result.Surface.Knots[1] = profile.Knots;
  result.Surface.Residual = profile.Residual * map.GetScale();
  Revolve(poles, result);
}

void ConvertExtrusion(const Handle(Geom_SurfaceOfLinearExtrusion) & surface, const NativeBox& box,
  const AffineMap& map, ConvertedSurface& result)
{
  const Profile profile = ConvertProfile(surface->BasisCurve(), box.Low[0], box.High[0]);
  const Vector3 direction = map.MapVector(surface->Direction().XYZ());
  NURBSSurface& s = result.Surface;
  result.Map[0] = profile.Map;
  s.Degree[0] = profile.Degree;
  s.Knots[0] = profile.Knots;
  s.Residual = profile.Residual * map.GetScale();
  SetLinear(result, 1, box.Low[1], box.High[1]);
  s.NumberOfControlPoints[0] = static_cast<int>(profile.Poles.size());
  s.NumberOfControlPoints[1] = 2;
  for (const double v : { box.Low[1], box.High[1] })
  {
    for (const std::array<double, 4>& h : profile.Poles)
    {
      const Vector3 linear = map.MapVector(gp_XYZ(h[0], h[1], h[2]));
      std::array<double, 4> point;
      for (int c = 0; c < 3; ++c)
      {
        point[c] = linear[c] + h[3] * map.Translation[c] + h[3] * v * direction[c];
      }
      point[3] = h[3];
      s.Rational = s.Rational || h[3] != profile.Poles[0][3];
      s.ControlPoints.push_back(point);
    }
  }
}

template <class SplineSurface>
std::array<double, 4> MapPole(
  const Handle(SplineSurface) & surface, int i, int j, bool rational, const AffineMap& map)
{
  const double w = rational ? surface->Weight(i + 1, j + 1) : 1.0;
  const Vector3 p = map.MapPoint(surface->Pole(i + 1, j + 1).XYZ());
  return { w * p[0], w * p[1], w * p[2], w };
}

void ConvertBSpline(const Handle(Geom_BSplineSurface) & surface, const NativeBox& box, const AffineMap& map,
  ConvertedSurface& result)
{
  const FlatKnots flat[2] = { MakeFlatKnots(surface->UDegree(), surface->UKnots(), surface->UMultiplicities(),
                                surface->IsUPeriodic(), box.Low[0], box.High[0]),
    MakeFlatKnots(surface->VDegree(), surface->VKnots(), surface->VMultiplicities(), surface->IsVPeriodic(),
      box.Low[1], box.High[1]) };
  NURBSSurface& s = result.Surface;
  for (int d = 0; d < 2; ++d)
  {
    s.Degree[d] = flat[d].Degree;
    s.Knots[d] = flat[d].Knots;
    s.NumberOfControlPoints[d] = static_cast<int>(flat[d].Poles.size());
  }
  s.Rational = surface->IsURational() || surface->IsVRational();
  for (const int j : flat[1].Poles)
  {
    for (const int i : flat[0].Poles)
    {
      s.ControlPoints.push_back(MapPole(surface, i, j, s.Rational, map));
    }
  }
}

void ConvertBezier(const Handle(Geom_BezierSurface) & surface, const AffineMap& map, ConvertedSurface& result)
{
  NURBSSurface& s = result.Surface;
  s.Degree[0] = surface->UDegree();
  s.Degree[1] = surface->VDegree();
  for (int d = 0; d < 2; ++d)
  {
    s.NumberOfControlPoints[d] = s.Degree[d] + 1;
    s.Knots[d].assign(s.Degree[d] + 1, 0.0);
    s.Knots[d].insert(s.Knots[d].end(), s.Degree[d] + 1, 1.0);
  }
  s.Rational = surface->IsURational() || surface->IsVRational();
  for (int j = 0; j <= s.Degree[1]; ++j)
  {
    for (int i = 0; i <= s.Degree[0]; ++i)
    {
      s.ControlPoints.push_back(MapPole(surface, i, j, s.Rational, map));
    }
  }
}

/// Returns the largest distance from OpenCASCADE's own evaluation at a few points of the box.
double MeasureDistance(const Handle(Geom_Surface) & surface, const NativeBox& box, const AffineMap& map,
  const ConvertedSurface& converted)
{
  double distance = 0.0;
  for (const double x : { 0.03, 0.41, 0.77 })
  {
    for (const double y : { 0.11, 0.5, 0.96 })
    {
      const double u = (1.0 - x) * box.Low[0] + x * box.High[0];
      const double v = (1.0 - y) * box.Low[1] + y * box.High[1];
      const Vector3 expected = map.MapPoint(surface->Value(u, v).XYZ());
      Vector3 actual;
      converted.Surface.Evaluate(converted.Map[0].Evaluate(u), converted.Map[1].Evaluate(v), actual.data());
      for (int c = 0; c < 3; ++c)
      {
        distance = std::max(distance, std::abs(actual[c] - expected[c]));
      }
    }
  }
  return distance;
}

struct NearSurface
{
  Handle(Geom_Surface) Surface;
  AffineMap Map;
};

/// Returns the same surface, translated so that the model's origin is that of OpenCASCADE. Evaluation far from the origin would lose digits
/// that the poles have.
NearSurface MoveToOrigin(const Handle(Geom_Surface) & surface, const AffineMap& map)
{
  NearSurface near{ surface, map };
  const double scale = map.GetScale();
  gp_XYZ origin;
  for (int j = 0; j < 3; ++j)
  {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      sum -= map.Linear[i][j] * map.Translation[i];
    }
    origin.SetCoord(j + 1, sum / (scale * scale));
  }
  // Subtracts the translation that remains after the rounding of `origin`; large terms cancel.
  for (int i = 0; i < 3; ++i)
  {
    long double sum = map.Translation[i];
    for (int j = 0; j < 3; ++j)
    {
      sum += static_cast<long double>(map.Linear[i][j]) * origin.Coord(j + 1);
    }
    near.Map.Translation[i] = static_cast<double>(sum);
  }
  near.Surface = Handle(Geom_Surface)::DownCast(surface->Translated(gp_Vec(origin.Reversed())));
  return near;
}

double GetSize(const NURBSSurface& surface)
{
  double size = 0.0;
  for (const std::array<double, 4>& h : surface.ControlPoints)
  {
    size = std::max({ size, std::abs(h[0] / h[3]), std::abs(h[1] / h[3]), std::abs(h[2] / h[3]) });
  }
  return size;
}

/// Converts by the surface's type; returns false if there is no exact conversion for it.
bool ConvertExactly(
  const Handle(Geom_Surface) & surface, const NativeBox& box, const AffineMap& map, ConvertedSurface& result)
{
  if (const auto plane = Handle(Geom_Plane)::DownCast(surface))
  {
    ConvertPlane(plane->Position(), box, map, result);
  }
  else if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface))
  {
    SetArcs(result, 0, box.Low[0], box.High[0]);
    SetLinear(result, 1, box.Low[1], box.High[1]);
    RevolveElementary(cylinder->Position(), StraightProfile(box, cylinder->Radius(), 0.0, 1.0), map, result);
  }
  else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface))
  {
    const double slope = std::sin(cone->SemiAngle());
    NativeBox whole = box;
    const double apex = -cone->RefRadius() / slope;
    for (double* const end : { &whole.Low[1], &whole.High[1] })
    {
      *end = std::abs(*end - apex) <= PoleDistance * (box.High[1] - box.Low[1]) ? apex : *end;
    }
    SetArcs(result, 0, box.Low[0], box.High[0]);
    SetLinear(result, 1, whole.Low[1], whole.High[1]);
    RevolveElementary(cone->Position(),
      StraightProfile(whole, cone->RefRadius(), slope, std::cos(cone->SemiAngle())), map, result);
  }
  else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface))
  {
    SetArcs(result, 0, box.Low[0], box.High[0]);
    const double near = PoleDistance * (box.High[1] - box.Low[1]);
    SetArcs(result, 1, box.Low[1] < near - 0.5 * vtkMath::Pi() ? -0.5 * vtkMath::Pi() : box.Low[1],
      box.High[1] > 0.5 * vtkMath::Pi() - near ? 0.5 * vtkMath::Pi() : box.High[1]);
    RevolveElementary(sphere->Position(), CircularProfile(result.Map[1], 0.0, sphere->Radius()), map, result);
  }
  else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface))
  {
    SetArcs(result, 0, box.Low[0], box.High[0]);
    SetArcs(result, 1, box.Low[1], box.High[1]);
    RevolveElementary(torus->Position(),
      CircularProfile(result.Map[1], torus->MajorRadius(), torus->MinorRadius()), map, result);
  }
  else if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface))
  {
    SetArcs(result, 0, box.Low[0], box.High[0]);
    ConvertRevolution(revolution, box, map, result);
  }
  else if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface))
  {
    ConvertExtrusion(extrusion, box, map, result);
  }
  else if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface))
  {
    ConvertBSpline(spline, box, map, result);
  }
  else if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface))
  {
    ConvertBezier(bezier, map, result);
  }
  else
  {
    return false;
  }
  return true;
}
}

Handle(Geom_Surface) GetBasisSurface(Handle(Geom_Surface) surface)
{
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
  {
    surface = trimmed->BasisSurface();
  }
  return surface;
}

ConvertedSurface ConvertSurface(
  const Handle(Geom_Surface) & source, const NativeBox& box, const AffineMap& map)
{
  const Handle(Geom_Surface) surface = GetBasisSurface(source);
  ConvertedSurface result;
  bool done = false;
  if (surface->IsKind(STANDARD_TYPE(Geom_OffsetSurface)))
  {
    const NearSurface near = MoveToOrigin(surface, map);
    // An offset of an elementary surface may be an elementary surface itself, which is used if it agrees at sample points.
    const Handle(Geom_Surface) same = Handle(Geom_OffsetSurface)::DownCast(near.Surface)->Surface();
    done = !same.IsNull() && ConvertExactly(GetBasisSurface(same), box, near.Map, result) &&
      MeasureDistance(near.Surface, box, near.Map, result) < 1e-13 * GetSize(result.Surface);
  }
  else
  {
    done = ConvertExactly(surface, box, map, result);
  }
  if (!done)
  {
    const NearSurface near = MoveToOrigin(surface, map);
    result = ConvertedSurface();
    result.Surface = FitSurface(near.Surface, box, near.Map);
  }
  const std::string problem = result.Surface.Check();
  if (!problem.empty())
  {
    throw std::runtime_error("its surface is not usable: " + problem);
  }
  // Rounding, of which there is more far from the frame of the surface, is charged to the bounds.
  const double none[3] = { 0.0, 0.0, 0.0 };
  const double allowed = 1e-10 * GetSize(result.Surface) + result.Surface.Residual +
    Norm(GetReadingRounding(source, box, map, none, 0, result.Surface));
  double distance = MeasureDistance(surface, box, map, result);
  if (!(distance <= allowed))
  {
    const NearSurface near = MoveToOrigin(surface, map);
    distance = MeasureDistance(near.Surface, box, near.Map, result);
  }
  if (!(distance <= allowed))
  {
    throw std::runtime_error(
      "its surface differs from the file's by " + FormatDistance(distance) + " after conversion");
  }
  return result;
}
}
