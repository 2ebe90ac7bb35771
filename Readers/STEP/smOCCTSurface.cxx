#include "smOCCTSurface.h"

#include "Geometry/smGeometryConversion.h"
#include "Geometry/smSurfaceFit.h"
#include "smFormat.h"
#include "smOCCTGeometry.h"
#include "smOCCTRounding.h"
#include "smOCCTSpline.h"
#include "smVector.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>

#include <stdexcept>

namespace sm
{
namespace
{
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

/// Returns the same surface, translated so that the model's origin is that of OpenCASCADE. Evaluation far
/// from the origin would lose digits that the poles have.
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

/// Returns the knots inside the box of the basis surface of an offset surface; cells of the fit must not
/// extend across them.
std::vector<double> GetFitBreaks(const Handle(Geom_Surface) & surface, int direction, double low, double high)
{
  std::vector<double> breaks{ low };
  Handle(Geom_Surface) basis = surface;
  while (const auto offset = Handle(Geom_OffsetSurface)::DownCast(basis))
  {
    basis = GetBasisSurface(offset->BasisSurface());
  }
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(basis))
  {
    const FlatKnots flat = direction == 0 ? MakeFlatKnots(spline->UDegree(), spline->UKnots(),
                                              spline->UMultiplicities(), spline->IsUPeriodic(), low, high)
                                          : MakeFlatKnots(spline->VDegree(), spline->VKnots(),
                                              spline->VMultiplicities(), spline->IsVPeriodic(), low, high);
    const double slack = 1e-12 * (high - low);
    for (const double knot : flat.Knots)
    {
      if (knot > breaks.back() + slack && knot < high - slack)
      {
        breaks.push_back(knot);
      }
    }
  }
  breaks.push_back(high);
  return breaks;
}

/// Converts by the value of the surface; returns false if there is no exact conversion for it.
bool ConvertKernelSurface(
  const Handle(Geom_Surface) & surface, const NativeBox& box, const AffineMap& map, ConvertedSurface& result)
{
  // Fits are made of OpenCASCADE's own evaluation.
  const SurfacePointer value =
    surface->IsKind(STANDARD_TYPE(Geom_OffsetSurface)) ? nullptr : MakeGeometry(surface);
  return value && ConvertExactly(*value, box, map, result);
}

/// Fits a surface over the box where there is no exact conversion (offset surfaces).
NURBSSurface FitKernelSurface(const NearSurface& near, const NativeBox& box)
{
  const auto position = [&near](double u, double v)
  { return near.Map.MapPoint(near.Surface->Value(u, v).XYZ()); };
  try
  {
    return FitSurface(position, GetFitBreaks(near.Surface, 0, box.Low[0], box.High[0]),
      GetFitBreaks(near.Surface, 1, box.Low[1], box.High[1]));
  }
  catch (const std::runtime_error& failure)
  {
    throw std::runtime_error(
      "its surface (" + std::string(near.Surface->DynamicType()->Name()) + "): " + failure.what());
  }
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
    // An offset of an elementary surface may be an elementary surface itself, which is used if it agrees at
    // sample points.
    const Handle(Geom_Surface) same = Handle(Geom_OffsetSurface)::DownCast(near.Surface)->Surface();
    done = !same.IsNull() && ConvertKernelSurface(GetBasisSurface(same), box, near.Map, result) &&
      MeasureDistance(near.Surface, box, near.Map, result) < 1e-13 * GetSize(result.Surface);
  }
  else
  {
    done = ConvertKernelSurface(surface, box, map, result);
  }
  if (!done)
  {
    const NearSurface near = MoveToOrigin(surface, map);
    result = ConvertedSurface();
    result.Surface = FitKernelSurface(near, box);
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
