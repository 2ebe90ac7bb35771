#include "smSTEPShapeChecks.h"

#include "smFormat.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Distance of a vertex from the apex of its cone, relative to the cone's size, above which they contradict.
constexpr double ApexLimit = 2e-3;

/// Distance of a vertex from the sphere or torus that has no edges, relative to its radius, above which they
/// contradict each other: that of vertices from curves, by the extent.
constexpr double SurfaceLimit = 4e-3;

/// An arc below this part of its radius is not certain.
constexpr double ShortArc = 1e-9;

/// Rounding of coordinates, relative to them.
constexpr double Rounding = 1e-14;

double GetEndDistance(const STEPEdge& edge)
{
  return Norm(Subtract(edge.End, edge.Start));
}
}

std::string DescribeWholeTorus(
  std::uint64_t face, std::uint64_t surfaceId, const STEPSurface& surface, bool isBounded)
{
  const auto* torus = surface.Value->GetIf<ElementarySurface>();
  const bool isCrossing = torus && torus->Kind == ElementarySurface::Type::Torus && !isBounded &&
    torus->Selected == ElementarySurface::Part::Whole && torus->Radii[1] > std::abs(torus->Radii[0]);
  return !isCrossing ? std::string()
                     : "Face #" + std::to_string(face) +
      " of the file is a whole torus that crosses itself (#" + std::to_string(surfaceId) +
      ", its minor radius exceeds the major one): both its outer and its inner part are taken.";
}

std::string DescribeApex(std::uint64_t face, std::uint64_t vertex, std::uint64_t surfaceId,
  const ElementarySurface& cone, const Vector3& point)
{
  const double height = -cone.Radii[0] / std::tan(cone.Angle);
  Vector3 apex = cone.Frame.Origin;
  for (int c = 0; c < 3; ++c)
  {
    apex[c] += height * cone.Frame.Axes[2][c];
  }
  const double distance = Norm(Subtract(point, apex));
  return distance <= ApexLimit * std::max(cone.Radii[0], std::abs(height))
    ? std::string()
    : "Face #" + std::to_string(face) + " of the file: the vertex #" + std::to_string(vertex) +
      " of its loop is " + FormatDistance(distance) + " mm away from the apex of its cone #" +
      std::to_string(surfaceId) + ", which is taken. Export the file again.";
}

bool IsOffSurface(const ElementarySurface& surface, const Vector3& point)
{
  const bool isSphere = surface.Kind == ElementarySurface::Type::Sphere;
  const Vector3 away = Subtract(point, surface.Frame.Origin);
  const double height = Dot(away, surface.Frame.Axes[2]);
  const double radial = std::sqrt(std::max(0.0, Dot(away, away) - height * height));
  const double major = isSphere ? 0.0 : surface.Radii[0];
  const double minor = surface.Radii[isSphere ? 0 : 1];
  // A negative major radius stands for the inner part of a torus that crosses itself.
  return std::abs(std::hypot(radial - major, height) - minor) > SurfaceLimit * (std::abs(major) + minor);
}

std::string DescribeShortArc(const STEPEdge& edge)
{
  const double distance = GetEndDistance(edge);
  const auto* conic = edge.Curve->GetIf<ConicCurve<3>>();
  const bool isShort = conic && conic->Kind == ConicCurve<3>::Type::Ellipse &&
    distance > STEPEdges::SameVertex && distance <= ShortArc * conic->Radii[0];
  return !isShort ? std::string()
                  : "Edge #" + std::to_string(edge.Id) +
      " of the file is an arc of less than 1e-9 of its radius: its parameters have too few digits.";
}

bool IsNearlyClosed(const STEPEdge& edge)
{
  const double distance = GetEndDistance(edge);
  return edge.Curve->GetIf<ConicCurve<3>>() && distance <= STEPEdges::SameVertex &&
    distance > Rounding * (Norm(edge.Start) + Norm(edge.End));
}

std::string DescribeNearlyClosed(const STEPEdge& edge)
{
  return "Edge #" + std::to_string(edge.Id) +
    " of the file is on a closed curve, between two vertices that are " +
    FormatDistance(GetEndDistance(edge)) +
    " mm apart: they are taken as one, and the curve as a whole. The short part between them may be meant.";
}
}
