#include "smBodySize.h"

#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// So few digits that details of the mesh do not reach them often.
double Round(double x)
{
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::round(128.0 * mantissa) / 128.0, exponent);
}

/// Extends the box to all points that are no farther from p than `distance`.
void AddPoint(const Vector3& p, double distance, BodySize& size)
{
  for (int d = 0; d < 3; ++d)
  {
    const double low = p[d] - distance;
    const double high = p[d] + distance;
    size.Bounds[2 * d] = size.IsKnown ? std::min(size.Bounds[2 * d], low) : low;
    size.Bounds[2 * d + 1] = size.IsKnown ? std::max(size.Bounds[2 * d + 1], high) : high;
  }
  size.IsKnown = true;
}
}

BodySize MeasureBody(const std::vector<FaceMesh>& meshes)
{
  BodySize size;
  for (const FaceMesh& mesh : meshes)
  {
    if (mesh.Sphere)
    {
      AddPoint(mesh.Sphere.Center, mesh.Sphere.Radius + mesh.Sphere.Error, size);
      size.FaceAreas.push_back(mesh.Sphere.GetArea());
      size.Area += size.FaceAreas.back();
      size.Volume += mesh.Sphere.GetSignedVolume();
      continue;
    }
    for (const Vector3& p : mesh.Points)
    {
      // The face bulges over its triangles by up to their deviation.
      AddPoint(p, mesh.Deviation, size);
    }
    size.FaceAreas.push_back(0.0);
    for (const std::array<int, 3>& t : mesh.Triangles)
    {
      const Vector3& a = mesh.Points[t[0]];
      const Vector3 n = Cross(Subtract(mesh.Points[t[1]], a), Subtract(mesh.Points[t[2]], a));
      size.Area += 0.5 * Norm(n);
      size.FaceAreas.back() += 0.5 * Norm(n);
      size.Volume += Dot(a, n) / 6.0;
    }
    size.VolumeError += mesh.Deviation * size.FaceAreas.back();
  }
  size.SignedVolume = size.Volume;
  size.Volume = Round(std::abs(size.Volume));
  size.Area = Round(size.Area);
  return size;
}
}
