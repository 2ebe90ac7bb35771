#include "smSTEPRevolvedConics.h"

#include "smSTEPGeometryReading.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPTopologyAttributes.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr STEPAttribute SurfaceOfRevolvedFace = { "FACE_SURFACE", 0, 2, "surface" };
constexpr STEPAttribute SenseOfRevolvedFace = { "FACE_SURFACE", 1, 3, "same sense" };
constexpr STEPAttribute BoundsOfRevolvedFace = { "FACE", 0, 1, "bounds" };
constexpr STEPAttribute SurfaceOfRevolvedTrim = { "PCURVE", 0, 1, "surface" };
constexpr STEPAttribute DefinitionOfRevolvedTrim = { "PCURVE", 1, 2, "curve" };

/// Largest distance of the centre from the axis, relative to the radius, or in millimetres.
constexpr double MaxDistance = 1e-6;

using Index = Part21File::Index;

/// Returns true if the axis passes the centre of a circle or ellipse, in its plane. `outer` gets the
/// parameter at which the half begins that has outer normals.
bool IsThroughCenter(const RevolvedSurface& surface, const ConicCurve<3>& conic, double& outer)
{
  const Vector3 side = Cross(conic.X, conic.Y);
  const Vector3 away = Subtract(conic.Center, surface.Origin);
  if (!(Norm(Cross(away, surface.Axis)) <= MaxDistance * std::max(1.0, conic.Radii[0])) ||
    !(std::abs(Dot(surface.Axis, side)) <= MaxDistance))
  {
    return false;
  }
  // The part from a pole on has outer normals if it lies on this side of the axis and runs along it, or on
  // the other side against it.
  const Vector3 across = Cross(side, surface.Axis);
  const double x = conic.Radii[0] * Dot(conic.X, across);
  const double y = conic.Radii[1] * Dot(conic.Y, across);
  outer = std::atan2(-x, y);
  const double along = conic.Radii[0] * std::cos(outer) * Dot(conic.X, surface.Axis) +
    conic.Radii[1] * std::sin(outer) * Dot(conic.Y, surface.Axis);
  outer += along > 0.0 ? vtkMath::Pi() : 0.0;
  return true;
}

/// Finds v of a parameter curve that has one value, or one in the middle, whatever its edge. Lines along v
/// depend on the edge's parameters.
bool FindMiddle(const STEPCurve<2>& curve, double& v)
{
  if (const auto* line = curve.Value->GetIf<LineCurve<2>>())
  {
    v = line->Origin[1];
    return std::abs(line->Direction[1]) < 1e-9;
  }
  const ParameterRange& domain = curve.Value->GetDomain();
  const bool isSpline = curve.Value->GetIf<SplineCurve<2>>() != nullptr;
  v = isSpline ? curve.Value->Evaluate(0.5 * (domain.Low + domain.High))[1] : 0.0;
  return isSpline;
}

/// Returns true if all bounds of a face are loops of one vertex.
bool IsWithoutEdges(const STEPAttributes& entities, Index face)
{
  Part21Values bounds(entities.Get(face, BoundsOfRevolvedFace).Text);
  for (Part21Value value; bounds.Next(value);)
  {
    const Index loop = entities.Follow(entities.Get(entities.Follow(value), LoopOfBound));
    std::string_view record;
    if (!entities.FindRecord(loop, "VERTEX_LOOP", record))
    {
      return false;
    }
  }
  return true;
}
}

bool FindRevolvedRange(const STEPAttributes& entities, STEPGeometry& geometry, Index entity,
  const STEPSurface& surface, ParameterRange& range)
{
  const auto* revolved = surface.Value->GetIf<RevolvedSurface>();
  const auto* conic = revolved ? revolved->Profile->GetIf<ConicCurve<3>>() : nullptr;
  double outer = 0.0;
  if (!conic || conic->Kind != ConicCurve<3>::Type::Ellipse ||
    revolved->Range.High - revolved->Range.Low < revolved->Profile->GetPeriod() ||
    !IsThroughCenter(*revolved, *conic, outer))
  {
    return false;
  }
  constexpr double half = vtkMath::Pi();
  double direction[2] = { 0.0, 0.0 };
  for (Index i = 0; i < entities.File.GetNumberOfInstances(); ++i)
  {
    if (entities.Has(i, STEPRole::Face) &&
      entities.Follow(entities.Get(i, SurfaceOfRevolvedFace)) == entity && IsWithoutEdges(entities, i))
    {
      range.Low = outer + (entities.Get(i, SenseOfRevolvedFace).Text != "F" ? 0.0 : half);
      range.High = range.Low + half;
      return true;
    }
    if (entities.Follow(entities.Get(i, SurfaceOfRevolvedTrim)) != entity)
    {
      continue;
    }
    const Index definition = entities.Follow(entities.Get(i, DefinitionOfRevolvedTrim));
    const std::vector<Index> items =
      ReadGeometryList(entities, entities.Get(definition, ItemsOfRepresentation));
    const STEPCurve<2>* curve = items.empty() ? nullptr : geometry.GetPlaneCurve(items[0]);
    std::string problem;
    const STEPCurve<2> natural = curve ? geometry.MapToNatural(*curve, surface, problem) : STEPCurve<2>();
    double v = 0.0;
    if (natural.Value && FindMiddle(natural, v))
    {
      direction[0] += std::cos(v);
      direction[1] += std::sin(v);
    }
  }
  const bool isStated = direction[0] != 0.0 || direction[1] != 0.0;
  range.Low = isStated ? std::atan2(direction[1], direction[0]) + half : 0.0;
  range.High = range.Low + 2.0 * half;
  return true;
}
}
