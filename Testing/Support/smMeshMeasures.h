/**
 * @file smMeshMeasures.h
 * @brief Measures of the triangles of faces
 */
#ifndef smMeshMeasures_h
#define smMeshMeasures_h

#include "smBodyMesh.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace smtest
{
struct MeshMeasures
{
  long long Points = 0;
  long long Triangles = 0;
  /// Faces without triangles.
  int EmptyFaces = 0;
  /// Sides of triangles, by the bits of their ends, that are not used as often one way as the other.
  int OpenSides = 0;
  /// Triangles, no lines, whose normal is against the surface's in the middle.
  int Inverted = 0;
  /// The number of triangles inverted that the meshes state themselves.
  int Named = 0;
  /// Largest distance of a sample from the surface, also as a part of the face's promise.
  double Deviation = 0.0;
  double WorstShare = 0.0;
  /// Largest angle of a sample's normal from that of the nearest corner in this sense, as a part of what the
  /// face states.
  double WorstTurnShare = 0.0;
  double Volume = 0.0;
  double Area = 0.0;
};

/// Distance of a point from a surface, near the parameters (u,v); an upper bound, for the foot point is
/// sought, until a distance is `enough`.
inline double FindDistance(sm::NURBSSurface::Walker& walker, const sm::NURBSSurface& surface,
  const sm::Vector3& point, double u, double v, double enough = 0.0)
{
  double best = 1e300;
  for (int step = 0; step < 4 && best > enough; ++step)
  {
    sm::Vector3 s, du, dv;
    walker.Evaluate(u, v, s.data(), du.data(), dv.data());
    const sm::Vector3 d = sm::Subtract(point, s);
    best = std::min(best, sm::Norm(d));
    const double a = sm::Dot(du, du), b = sm::Dot(du, dv), c = sm::Dot(dv, dv);
    const double determinant = a * c - b * b;
    if (!(determinant > 1e-12 * a * c))
    {
      break;
    }
    const double x = sm::Dot(d, du), y = sm::Dot(d, dv);
    u += (c * x - b * y) / determinant;
    v += (a * y - b * x) / determinant;
    // The surface goes on a little beyond its borders, where a chord may lie.
    const double low[2] = { surface.GetDomainStart(0), surface.GetDomainStart(1) };
    const double high[2] = { surface.GetDomainEnd(0), surface.GetDomainEnd(1) };
    u = std::clamp(u, low[0] - 0.1 * (high[0] - low[0]), high[0] + 0.1 * (high[0] - low[0]));
    v = std::clamp(v, low[1] - 0.1 * (high[1] - low[1]), high[1] + 0.1 * (high[1] - low[1]));
  }
  return best;
}

/// Returns true for a triangle, no line, whose normal is against the surface's at its middle.
inline bool IsInverted(const sm::Face& face, sm::NURBSSurface::Walker& walker, const sm::FaceMesh& mesh,
  const std::array<int, 3>& t)
{
  double uv[2] = { 0.0, 0.0 };
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    uv[0] += mesh.Parameters[t[k]][0] / 3.0;
    uv[1] += mesh.Parameters[t[k]][1] / 3.0;
    longest = std::max(longest, sm::Norm(sm::Subtract(mesh.Points[t[k]], mesh.Points[t[(k + 1) % 3]])));
  }
  sm::Vector3 s, du, dv;
  walker.Evaluate(uv[0], uv[1], s.data(), du.data(), dv.data());
  const sm::Vector3& a = mesh.Points[t[0]];
  const sm::Vector3 normal =
    sm::Cross(sm::Subtract(mesh.Points[t[1]], a), sm::Subtract(mesh.Points[t[2]], a));
  return sm::Norm(normal) > 1e-6 * longest * longest &&
    (sm::Dot(normal, sm::Cross(du, dv)) < 0.0) != face.Reversed;
}

/// The largest angle of the surface's normals at samples of a triangle from the normal at one of its corners,
/// the one for which it is smallest.
inline double MeasureTurn(
  sm::NURBSSurface::Walker& walker, const sm::FaceMesh& mesh, const std::array<int, 3>& t)
{
  constexpr double Samples[7][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { .5, .5, 0 }, { 0, .5, .5 },
    { .5, 0, .5 }, { 1. / 3, 1. / 3, 1. / 3 } };
  std::vector<sm::Vector3> normals;
  std::size_t corners = 0;
  for (const auto& w : Samples)
  {
    double uv[2] = { 0, 0 };
    for (int k = 0; k < 3; ++k)
    {
      uv[0] += w[k] * mesh.Parameters[t[k]][0];
      uv[1] += w[k] * mesh.Parameters[t[k]][1];
    }
    sm::Vector3 s, du, dv;
    walker.Evaluate(uv[0], uv[1], s.data(), du.data(), dv.data());
    const sm::Vector3 normal = sm::Cross(du, dv);
    if (sm::Norm(normal) > 1e-9 * sm::Norm(du) * sm::Norm(dv))
    {
      normals.push_back(sm::Normalized(normal));
      corners += std::max({ w[0], w[1], w[2] }) == 1.0 ? 1 : 0;
    }
  }
  // The square of the distance of the ends of two unit vectors.
  double minimum = corners == 0 ? 0.0 : 4.0;
  for (std::size_t k = 0; k < corners; ++k)
  {
    double maximum = 0.0;
    for (const sm::Vector3& n : normals)
    {
      const sm::Vector3 d = sm::Subtract(n, normals[k]);
      maximum = std::max(maximum, sm::Dot(d, d));
    }
    minimum = std::min(minimum, maximum);
  }
  return 2.0 * std::asin(std::min(0.5 * std::sqrt(minimum), 1.0));
}

/// `skip`: one of so many triangles is sampled for its deviation.
inline MeshMeasures MeasureMesh(
  const std::vector<sm::FacePointer>& faces, const std::vector<sm::FaceMesh>& meshes, int skip = 1)
{
  MeshMeasures result;
  std::map<sm::Vector3, int> points;
  std::map<std::pair<int, int>, int> sides;
  long long count = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const sm::FaceMesh& mesh = meshes[f];
    result.EmptyFaces += mesh.Triangles.empty() ? 1 : 0;
    result.Named += mesh.InvertedTriangles;
    result.Points += static_cast<long long>(mesh.Points.size());
    result.Triangles += static_cast<long long>(mesh.Triangles.size());
    std::vector<int> ids;
    for (const sm::Vector3& p : mesh.Points)
    {
      ids.push_back(points.emplace(p, static_cast<int>(points.size())).first->second);
    }
    const sm::NURBSSurface& surface = faces[f]->Surface;
    sm::NURBSSurface::Walker walker(surface);
    for (const auto& t : mesh.Triangles)
    {
      const sm::Vector3 corner[3] = { mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]] };
      const sm::Vector3 normal =
        sm::Cross(sm::Subtract(corner[1], corner[0]), sm::Subtract(corner[2], corner[0]));
      result.Area += 0.5 * sm::Norm(normal);
      result.Volume += sm::Dot(corner[0], normal) / 6.0;
      for (int k = 0; k < 3; ++k)
      {
        const int a = ids[t[k]];
        const int b = ids[t[(k + 1) % 3]];
        sides[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
      }
      if (count++ % skip != 0)
      {
        continue;
      }
      result.WorstTurnShare = std::max(result.WorstTurnShare, MeasureTurn(walker, mesh, t) / mesh.NormalTurn);
      result.Inverted += IsInverted(*faces[f], walker, mesh, t) ? 1 : 0;
      constexpr double Samples[7][3] = { { 1. / 3, 1. / 3, 1. / 3 }, { .5, .5, 0 }, { 0, .5, .5 },
        { .5, 0, .5 }, { .6, .2, .2 }, { .2, .6, .2 }, { .2, .2, .6 } };
      for (const auto& w : Samples)
      {
        sm::Vector3 p{ 0, 0, 0 };
        double uv[2] = { 0, 0 };
        for (int k = 0; k < 3; ++k)
        {
          for (int c = 0; c < 3; ++c)
          {
            p[c] += w[k] * corner[k][c];
          }
          uv[0] += w[k] * mesh.Parameters[t[k]][0];
          uv[1] += w[k] * mesh.Parameters[t[k]][1];
        }
        // A distance that raises neither of the results need not be sharp.
        const double distance = FindDistance(
          walker, surface, p, uv[0], uv[1], std::min(result.Deviation, result.WorstShare * mesh.Deviation));
        result.Deviation = std::max(result.Deviation, distance);
        result.WorstShare = std::max(result.WorstShare, distance / mesh.Deviation);
      }
    }
  }
  for (const auto& side : sides)
  {
    result.OpenSides += side.first.first != side.first.second && side.second != 0 ? 1 : 0;
  }
  return result;
}
}

#endif
