#include "smShellNesting.h"

#include "smVector.h"
#include "smWindingTree.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{

/// Largest number of points at which the winding number is computed.
constexpr std::size_t MaxSamples = 24;
/// Longest side of a triangle, relative to the region of interest, above which it is halved, and the largest
/// number of halvings.
constexpr double SampleSpacing = 0.3;
constexpr int MaximumDepth = 16;

/// Distance from an integer above which a winding number indicates a point on the other mesh, or a mesh with
/// a hole.
constexpr double WholeNumber = 0.25;

/// Returns c + x a + y b.
Point3 Combine(const Point3& c, double x, const Point3& a, double y, const Point3& b)
{
  return { c[0] + x * a[0] + y * b[0], c[1] + x * a[1] + y * b[1], c[2] + x * a[2] + y * b[2] };
}

double GetLength(const vtkBoundingBox& box)
{
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}
}

void ShellMesh::AddTriangle(const std::array<Point3, 3>& corners, const std::array<Point3, 3>& normals)
{
  for (const Point3& corner : corners)
  {
    this->Box.AddPoint(corner[0], corner[1], corner[2]);
  }
  this->Triangles.push_back({ corners, EstimateDeviation(corners, normals) });
}

void ShellMesh::SetSphere(const Point3& center, double radius)
{
  this->Center = center;
  this->Radius = radius;
  this->Triangles.clear();
  for (int d = 0; d < 3; ++d)
  {
    Point3 p = center;
    p[d] = center[d] - radius;
    this->Box.AddPoint(p.data());
    p[d] = center[d] + radius;
    this->Box.AddPoint(p.data());
  }
}

void ShellMesh::AddSamples(const std::array<Point3, 3>& corners, double deviation,
  const vtkBoundingBox& region, int depth, std::vector<Sample>& samples)
{
  vtkBoundingBox own;
  int longest = 0;
  double length = -1.0;
  for (int i = 0; i < 3; ++i)
  {
    own.AddPoint(corners[i][0], corners[i][1], corners[i][2]);
    const double side = Norm(Subtract(corners[(i + 1) % 3], corners[i]));
    longest = side > length ? i : longest;
    length = std::max(length, side);
  }
  if (region.Intersects(own) == 0)
  {
    return;
  }
  if (length > SampleSpacing * GetLength(region) && depth < MaximumDepth)
  {
    const Point3& a = corners[longest];
    const Point3& b = corners[(longest + 1) % 3];
    const Point3& c = corners[(longest + 2) % 3];
    const Point3 middle = Combine(a, 0.5, Subtract(b, a), 0.0, a);
    AddSamples({ a, middle, c }, deviation, region, depth + 1, samples);
    AddSamples({ middle, b, c }, deviation, region, depth + 1, samples);
    return;
  }
  const Point3 center = Combine(
    corners[0], 1.0 / 3.0, Subtract(corners[1], corners[0]), 1.0 / 3.0, Subtract(corners[2], corners[0]));
  if (region.ContainsPoint(center.data()) != 0)
  {
    samples.push_back({ center, deviation });
  }
}

std::vector<ShellMesh::Sample> ShellMesh::TakeSamples(const vtkBoundingBox& box) const
{
  vtkBoundingBox region(this->Box);
  region.IntersectBox(box);
  std::vector<Sample> samples;
  for (const Triangle& triangle : this->Triangles)
  {
    AddSamples(triangle.Corners, triangle.Deviation, region, 0, samples);
  }
  if (samples.size() > MaxSamples)
  {
    for (std::size_t i = 0; i < MaxSamples; ++i)
    {
      samples[i] = samples[(2 * i + 1) * samples.size() / (2 * MaxSamples)];
    }
    samples.resize(MaxSamples);
  }
  return samples;
}

double ShellMesh::GetWindingNumber(const Point3& p) const
{
  double sum = 0.0;
  for (const Triangle& triangle : this->Triangles)
  {
    sum += GetSolidAngle(p, triangle.Corners);
  }
  return sum / (4.0 * vtkMath::Pi());
}

double ShellMesh::GetRounding() const
{
  return 1e-9 * GetLength(this->Box);
}

bool ShellMesh::IsFarFrom(const Sample& sample) const
{
  const double rounding = this->GetRounding();
  return std::none_of(this->Triangles.begin(), this->Triangles.end(),
    [&](const Triangle& t)
    { return GetDistance(sample.Position, t.Corners) <= sample.Deviation + t.Deviation + rounding; });
}

ShellMesh::Place ShellMesh::FindSphereInSphere(const ShellMesh& other) const
{
  const double slack = this->GetRounding() + other.GetRounding();
  const double distance = GetDistance(this->Center, other.Center);
  const bool isInside = distance + this->Radius <= other.Radius + slack;
  const bool isAround = distance + other.Radius <= this->Radius + slack;
  const bool isApart = distance >= this->Radius + other.Radius - slack;
  return isInside && isAround ? Place::Unknown
    : isInside                ? Place::Inside
    : isAround || isApart     ? Place::Outside
                              : Place::Crossing;
}

ShellMesh::Place ShellMesh::FindMeshInSphere(const ShellMesh& other) const
{
  const double rounding = other.GetRounding();
  int inside = 0;
  int outside = 0;
  // Corners are on the surface up to gaps. If they disagree, only those count that are farther from the
  // sphere than the triangle may be from its surface.
  for (const bool isStrict : { false, true })
  {
    inside = outside = 0;
    for (const Triangle& triangle : this->Triangles)
    {
      const double slack = rounding + (isStrict ? triangle.Deviation : 0.0);
      for (const Point3& corner : triangle.Corners)
      {
        const double height = GetDistance(corner, other.Center) - other.Radius;
        inside += height < -slack ? 1 : 0;
        outside += height > slack ? 1 : 0;
      }
    }
    if (inside == 0 || outside == 0)
    {
      break;
    }
  }
  return inside > 0 && outside > 0 ? Place::Crossing
    : inside > 0                   ? Place::Inside
    : outside > 0                  ? Place::Outside
                                   : Place::Unknown;
}

ShellMesh::Place ShellMesh::FindSphereInMesh(const ShellMesh& other) const
{
  const Place mesh = other.FindMeshInSphere(*this);
  if (mesh != Place::Outside)
  {
    return mesh == Place::Inside ? Place::Outside : mesh;
  }
  // All corners lie outside the sphere, but the surface next to the middle of a large triangle may not.
  const double rounding = this->GetRounding() + other.GetRounding();
  const bool isReached = std::any_of(other.Triangles.begin(), other.Triangles.end(),
    [&](const Triangle& triangle)
    { return GetDistance(this->Center, triangle.Corners) + triangle.Deviation + rounding < this->Radius; });
  if (isReached)
  {
    return Place::Crossing;
  }
  // The sphere touches the surface at most: it is where its centre is.
  const double winding = std::abs(other.GetWindingNumber(this->Center));
  return winding < WholeNumber              ? Place::Outside
    : std::abs(winding - 1.0) < WholeNumber ? Place::Inside
                                            : Place::Unknown;
}

ShellMesh::Place ShellMesh::Find(const ShellMesh& other) const
{
  if (this->Box.Intersects(other.Box) == 0)
  {
    return Place::Outside;
  }
  if (this->Radius > 0.0 || other.Radius > 0.0)
  {
    return !(other.Radius > 0.0) ? this->FindSphereInMesh(other)
      : this->Radius > 0.0       ? this->FindSphereInSphere(other)
                                 : this->FindMeshInSphere(other);
  }
  // A corner outside the other's box by more than the deviation of the other's surface is outside the shell.
  double bulge = 1e-9 * GetLength(other.Box);
  for (const Triangle& triangle : other.Triangles)
  {
    bulge = std::max(bulge, triangle.Deviation);
  }
  vtkBoundingBox inflated(other.Box);
  inflated.Inflate(bulge);
  const bool sticksOut = inflated.Contains(this->Box) == 0;

  int inside = 0;
  int outside = sticksOut ? 1 : 0;
  int unclear = 0;
  std::vector<std::pair<Sample, double>> asked;
  for (const Sample& sample : this->TakeSamples(other.Box))
  {
    const double winding = std::abs(other.GetWindingNumber(sample.Position));
    asked.emplace_back(sample, winding);
    inside += std::abs(winding - 1.0) < WholeNumber ? 1 : 0;
    outside += winding < WholeNumber ? 1 : 0;
    unclear += !(winding < WholeNumber) && !(std::abs(winding - 1.0) < WholeNumber) ? 1 : 0;
  }
  if (unclear > 0 || (inside > 0 && outside > 0))
  {
    inside = 0;
    outside = sticksOut ? 1 : 0;
    unclear = 0;
    for (const auto& [sample, winding] : asked)
    {
      if (other.IsFarFrom(sample))
      {
        inside += std::abs(winding - 1.0) < WholeNumber ? 1 : 0;
        outside += winding < WholeNumber ? 1 : 0;
        unclear += !(winding < WholeNumber) && !(std::abs(winding - 1.0) < WholeNumber) ? 1 : 0;
      }
    }
  }
  return inside > 0 && outside > 0     ? Place::Crossing
    : unclear > 0 || inside == outside ? Place::Unknown
    : inside > 0                       ? Place::Inside
                                       : Place::Outside;
}
}
