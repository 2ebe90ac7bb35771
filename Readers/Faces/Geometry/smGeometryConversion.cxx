#include "smGeometryConversion.h"

#include "smCurveFit.h"
#include "smSurfaceFit.h"
#include "smUnitRoundoff.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
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

/// Revolves the profile of a cylinder, cone, sphere or torus, given by homogeneous poles (radius, height,
/// weight).
void RevolveElementary(const GeometricFrame& frame, const std::vector<Vector3>& profile, const AffineMap& map,
  ConvertedSurface& result)
{
  const Vector3 origin = map.MapPoint(frame.Origin);
  const Vector3 x = map.MapVector(frame.Axes[0]);
  const Vector3 y = map.MapVector(frame.Axes[1]);
  const Vector3 z = map.MapVector(frame.Axes[2]);
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

void ConvertPlane(
  const GeometricFrame& frame, const NativeBox& box, const AffineMap& map, ConvertedSurface& result)
{
  SetLinear(result, 0, box.Low[0], box.High[0]);
  SetLinear(result, 1, box.Low[1], box.High[1]);
  NURBSSurface& s = result.Surface;
  s.NumberOfControlPoints[0] = s.NumberOfControlPoints[1] = 2;
  const Vector3 origin = map.MapPoint(frame.Origin);
  const Vector3 x = map.MapVector(frame.Axes[0]);
  const Vector3 y = map.MapVector(frame.Axes[1]);
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

/// An end of a range this close to a pole, relative to the range, is moved to the pole: the difference is the
/// rounding of the file's digits. The surface then has a row of coincident control points. Even if no loop
/// bounds the face there, its area increases by less than rounding.
constexpr double PoleDistance = 1e-8;

/// Returns the straight profile (radius, height) at both ends of v; a radius of the size of rounding is set
/// to 0.
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

void ConvertRevolution(
  const RevolvedSurface& surface, const NativeBox& box, const AffineMap& map, ConvertedSurface& result)
{
  const RationalProfile profile = ConvertProfile(*surface.Profile, box.Low[1], box.High[1]);
  const Vector3& z = surface.Axis;
  const Vector3 origin = map.MapPoint(surface.Origin);
  const double distance = Norm(surface.Origin);
  std::vector<RevolvedPole> poles;
  for (const std::array<double, 4>& h : profile.Poles)
  {
    Vector3 fromAxis;
    for (int c = 0; c < 3; ++c)
    {
      fromAxis[c] = h[c] - h[3] * surface.Origin[c];
    }
    const double height = Dot(fromAxis, z);
    const Vector3 axial{ height * z[0], height * z[1], height * z[2] };
    Vector3 radius = Subtract(fromAxis, axial);
    if (Norm(radius) < 8.0 * UnitRoundoff * (Norm(fromAxis) + h[3] * distance))
    {
      radius = {};
    }
    RevolvedPole pole;
    const Vector3 along = map.MapVector(axial);
    for (int c = 0; c < 3; ++c)
    {
      pole.Center[c] = h[3] * origin[c] + along[c];
    }
    pole.X = map.MapVector(radius);
    pole.Y = map.MapVector(Cross(z, radius));
    pole.Weight = h[3];
    poles.push_back(pole);
  }
  result.Map[1] = profile.Map;
  result.Surface.Degree[1] = profile.Degree;
  result.Surface.Knots[1] = profile.Knots;
  result.Surface.Residual = profile.Residual * map.GetScale();
  Revolve(poles, result);
}

void ConvertExtrusion(
  const ExtrudedSurface& surface, const NativeBox& box, const AffineMap& map, ConvertedSurface& result)
{
  const RationalProfile profile = ConvertProfile(*surface.Profile, box.Low[0], box.High[0]);
  const Vector3 direction = map.MapVector(surface.Direction);
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
      const Vector3 linear = map.MapVector(Vector3{ h[0], h[1], h[2] });
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

void ConvertSpline(
  const SplineSurface& surface, const NativeBox& box, const AffineMap& map, ConvertedSurface& result)
{
  NURBSSurface& s = result.Surface;
  FlatKnots flat[2];
  for (int d = 0; d < 2; ++d)
  {
    flat[d] = surface.Basis[d].Flatten(box.Low[d], box.High[d]);
    s.Degree[d] = flat[d].Degree;
    s.Knots[d] = flat[d].Knots;
    s.NumberOfControlPoints[d] = static_cast<int>(flat[d].Poles.size());
  }
  s.Rational = !surface.Weights.empty();
  const std::size_t columns = surface.Basis[0].GetCount();
  for (const int j : flat[1].Poles)
  {
    for (const int i : flat[0].Poles)
    {
      const std::size_t pole = i + j * columns;
      const double w = s.Rational ? surface.Weights[pole] : 1.0;
      const Vector3 p = map.MapPoint(surface.Poles[pole]);
      s.ControlPoints.push_back({ w * p[0], w * p[1], w * p[2], w });
    }
  }
}

void ConvertElementary(
  const ElementarySurface& surface, const NativeBox& box, const AffineMap& map, ConvertedSurface& result)
{
  using Type = ElementarySurface::Type;
  const double half = 0.5 * vtkMath::Pi();
  const double radius = surface.Radii[0];
  const double near = PoleDistance * (box.High[1] - box.Low[1]);
  if (surface.Kind == Type::Plane)
  {
    ConvertPlane(surface.Frame, box, map, result);
    return;
  }
  SetArcs(result, 0, box.Low[0], box.High[0]);
  std::vector<Vector3> profile;
  if (surface.Kind == Type::Cylinder)
  {
    SetLinear(result, 1, box.Low[1], box.High[1]);
    profile = StraightProfile(box, radius, 0.0, 1.0);
  }
  else if (surface.Kind == Type::Cone)
  {
    const double slope = std::sin(surface.Angle);
    NativeBox whole = box;
    const double apex = -radius / slope;
    for (double* const end : { &whole.Low[1], &whole.High[1] })
    {
      *end = std::abs(*end - apex) <= near ? apex : *end;
    }
    SetLinear(result, 1, whole.Low[1], whole.High[1]);
    profile = StraightProfile(whole, radius, slope, std::cos(surface.Angle));
  }
  else if (surface.Kind == Type::Sphere)
  {
    SetArcs(result, 1, box.Low[1] < near - half ? -half : box.Low[1],
      box.High[1] > half - near ? half : box.High[1]);
    profile = CircularProfile(result.Map[1], 0.0, radius);
  }
  else
  {
    SetArcs(result, 1, box.Low[1], box.High[1]);
    profile = CircularProfile(result.Map[1], radius, surface.Radii[1]);
  }
  RevolveElementary(surface.Frame, profile, map, result);
}
}

bool ConvertExactly(
  const GeometricSurface& surface, const NativeBox& box, const AffineMap& map, ConvertedSurface& result)
{
  if (const auto* elementary = surface.GetIf<ElementarySurface>())
  {
    ConvertElementary(*elementary, box, map, result);
  }
  else if (const auto* revolved = surface.GetIf<RevolvedSurface>())
  {
    SetArcs(result, 0, box.Low[0], box.High[0]);
    ConvertRevolution(*revolved, box, map, result);
  }
  else if (const auto* extruded = surface.GetIf<ExtrudedSurface>())
  {
    ConvertExtrusion(*extruded, box, map, result);
  }
  else if (const auto* spline = surface.GetIf<SplineSurface>())
  {
    ConvertSpline(*spline, box, map, result);
  }
  else
  {
    return false;
  }
  return true;
}

ConvertedSurface ConvertGeometry(const GeometricSurface& surface, const NativeBox& box, const AffineMap& map)
{
  ConvertedSurface result;
  if (!ConvertExactly(surface, box, map, result))
  {
    result = ConvertedSurface();
    result.Surface = FitSurface([&](double s, double t) { return map.MapPoint(surface.Evaluate(s, t)); },
      surface.GetBreaks(0, box.Low[0], box.High[0]), surface.GetBreaks(1, box.Low[1], box.High[1]));
  }
  const std::string problem = result.Surface.Check();
  if (!problem.empty())
  {
    throw std::runtime_error("its surface is not usable: " + problem);
  }
  return result;
}
}
