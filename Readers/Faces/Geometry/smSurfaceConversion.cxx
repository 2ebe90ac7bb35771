#include "smSurfaceConversion.h"

#include "smFormat.h"
#include "smGeometryConversion.h"
#include "smPlacement.h"
#include "smReadingRounding.h"
#include "smSurfaceFit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sm
{
namespace
{
/// Returns the largest distance from the surface at a few points of the box.
double MeasureDistance(const GeometricSurface& surface, const NativeBox& box, const AffineMap& map,
  const ConvertedSurface& converted)
{
  double distance = 0.0;
  for (const double x : { 0.03, 0.41, 0.77 })
  {
    for (const double y : { 0.11, 0.5, 0.96 })
    {
      const double u = (1.0 - x) * box.Low[0] + x * box.High[0];
      const double v = (1.0 - y) * box.Low[1] + y * box.High[1];
      const Vector3 expected = map.MapPoint(surface.Evaluate(u, v));
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
  SurfacePointer Surface;
  AffineMap Map;
};

/// Returns the same surface, translated so that the model's origin is that of its coordinates. Evaluation far
/// from the origin would lose digits that the control points have.
NearSurface MoveToOrigin(const SurfacePointer& surface, const AffineMap& map)
{
  NearSurface near{ surface, map };
  const double scale = map.GetScale();
  Vector3 origin;
  for (int j = 0; j < 3; ++j)
  {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      sum -= map.Linear[i][j] * map.Translation[i];
    }
    origin[j] = sum / (scale * scale);
  }
  // Subtracts the translation that remains after the rounding of `origin`; large terms cancel.
  for (int i = 0; i < 3; ++i)
  {
    long double sum = map.Translation[i];
    for (int j = 0; j < 3; ++j)
    {
      sum += static_cast<long double>(map.Linear[i][j]) * origin[j];
    }
    near.Map.Translation[i] = static_cast<double>(sum);
  }
  Placement shift;
  shift.Translation = Multiply(-1.0, origin);
  near.Surface = MoveSurface(surface, shift);
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

/// Fits a surface over the box.
NURBSSurface FitNear(const NearSurface& near, const NativeBox& box)
{
  try
  {
    return FitSurface([&near](double u, double v) { return near.Map.MapPoint(near.Surface->Evaluate(u, v)); },
      near.Surface->GetBreaks(0, box.Low[0], box.High[0]),
      near.Surface->GetBreaks(1, box.Low[1], box.High[1]));
  }
  catch (const std::runtime_error& failure)
  {
    throw std::runtime_error(
      std::string("its surface (") + GetKindName(*near.Surface) + "): " + failure.what());
  }
}
}

const char* GetKindName(const GeometricSurface& surface)
{
  if (const auto* elementary = surface.GetIf<ElementarySurface>())
  {
    static const char* const names[] = { "plane", "cylinder", "cone", "sphere", "torus" };
    return names[static_cast<int>(elementary->Kind)];
  }
  return surface.GetIf<ExtrudedSurface>() ? "extrusion"
    : surface.GetIf<RevolvedSurface>()    ? "surface of revolution"
    : surface.GetIf<SplineSurface>()      ? "B-spline"
                                          : "offset surface";
}

SurfacePointer SimplifyOffset(const SurfacePointer& surface)
{
  const auto* offset = surface->GetIf<OffsetSurface>();
  const auto* basis = offset ? offset->Basis->GetIf<ElementarySurface>() : nullptr;
  if (!basis)
  {
    return nullptr;
  }
  ElementarySurface result = *basis;
  const std::array<Vector3, 3>& axes = basis->Frame.Axes;
  // S_s x S_t points outwards in a right-handed frame.
  const double distance = Dot(Cross(axes[0], axes[1]), axes[2]) > 0.0 ? offset->Distance : -offset->Distance;
  double along = 0.0;
  switch (basis->Kind)
  {
    case ElementarySurface::Type::Plane:
      along = distance;
      break;
    case ElementarySurface::Type::Cone:
      result.Radii[0] += distance * std::cos(basis->Angle);
      along = -distance * std::sin(basis->Angle);
      break;
    case ElementarySurface::Type::Torus:
      result.Radii[1] += distance;
      break;
    default:
      result.Radii[0] += distance;
      break;
  }
  result.Frame.Origin = Sum(basis->Frame.Origin, Multiply(along, axes[2]));
  std::string problem;
  return GeometricSurface::Make(result, problem);
}

ConvertedSurface ConvertSurface(const SurfacePointer& surface, const NativeBox& box, const AffineMap& map)
{
  ConvertedSurface result;
  const SurfacePointer same = SimplifyOffset(surface);
  if (!ConvertExactly(same ? *same : *surface, box, map, result))
  {
    result = ConvertedSurface();
    result.Surface = FitNear(MoveToOrigin(surface, map), box);
  }
  const std::string problem = result.Surface.Check();
  if (!problem.empty())
  {
    throw std::runtime_error("its surface is not usable: " + problem);
  }
  // Rounding, of which there is more far from the frame of the surface, is charged to the bounds.
  const double none[3] = { 0.0, 0.0, 0.0 };
  const double allowed = 1e-10 * GetSize(result.Surface) + result.Surface.Residual +
    Norm(GetReadingRounding(*surface, box, map, none, 0, result.Surface));
  double distance = MeasureDistance(*surface, box, map, result);
  if (!(distance <= allowed))
  {
    const NearSurface near = MoveToOrigin(surface, map);
    distance = MeasureDistance(*near.Surface, box, near.Map, result);
  }
  if (!(distance <= allowed))
  {
    throw std::runtime_error(
      "its surface differs from the file's by " + FormatDistance(distance) + " after conversion");
  }
  return result;
}
}
