#include "smFaceMeshWriter.h"

#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sm
{
namespace
{
/// Points without a normal of the surface get that of their triangles.
void FillNormals(FaceMesh& mesh)
{
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const Vector3 n =
      Cross(Subtract(mesh.Points[t[1]], mesh.Points[t[0]]), Subtract(mesh.Points[t[2]], mesh.Points[t[0]]));
    for (const int k : t)
    {
      if (Dot(mesh.Normals[k], mesh.Normals[k]) == 0.0 && Dot(n, n) > 0.0)
      {
        mesh.Normals[k] = Normalized(n);
      }
    }
  }
}

/// Returns the diagonal of the box of the control points, in which the face lies, and its triangles except
/// for the gaps of their corners; HUGE_VAL for a face that leaves the domain of its surface.
double GetHullDiagonal(const NURBSSurface& surface, const ParameterBox& box)
{
  for (int d = 0; d < 2; ++d)
  {
    if (box.Low[d] < surface.GetDomainStart(d) || box.High[d] > surface.GetDomainEnd(d))
    {
      return HUGE_VAL;
    }
  }
  Vector3 low{ HUGE_VAL, HUGE_VAL, HUGE_VAL };
  Vector3 high{ -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (const std::array<double, 4>& p : surface.ControlPoints)
  {
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c] / p[3]);
      high[c] = std::max(high[c], p[c] / p[3]);
    }
  }
  return Norm(Subtract(high, low));
}

/// Adds the vertex, and returns its index.
int AddPoint(const MeshVertex& v, const MeshedFace& face, FaceMesh& result)
{
  result.Points.push_back(v.Position);
  result.Parameters.push_back(v.At);
  Vector3 normal = Dot(v.Normal, v.Normal) > 0.0 ? v.Normal : face.FindNormal(v.At);
  if (face.Source.Reversed)
  {
    normal = { -normal[0], -normal[1], -normal[2] };
  }
  result.Normals.push_back(normal);
  return static_cast<int>(result.Points.size()) - 1;
}
}

void WriteFaceMesh(
  const std::vector<MeshRepair::Corners>& triangles, const MeshedFace& face, FaceMesh& result)
{
  std::vector<int> place(face.Vertices.size(), -1);
  result.Points.reserve(face.Vertices.size());
  result.Parameters.reserve(face.Vertices.size());
  result.Normals.reserve(face.Vertices.size());
  result.Triangles.reserve(triangles.size());
  double farthest = 0.0;
  double widestGap = 0.0;
  for (const MeshRepair::Corners& t : triangles)
  {
    std::array<int, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      const MeshVertex& v = face.Vertices[t[k]];
      int& index = place[t[k]];
      if (index < 0)
      {
        index = AddPoint(v, face, result);
        farthest =
          std::max({ farthest, std::abs(v.Position[0]), std::abs(v.Position[1]), std::abs(v.Position[2]) });
      }
      corners[k] = index;
    }
    if (face.Source.Reversed)
    {
      std::swap(corners[1], corners[2]);
    }
    result.Triangles.push_back(corners);
    const double deviation = face.Judge.GetDeviation(t);
    widestGap = std::max(widestGap, face.Judge.GetGap(t));
    result.NormalTurn = std::max(result.NormalTurn, face.Judge.GetNormalTurn(t, result.NormalTurn));
    // Not std::max, which loses a NaN.
    result.Deviation = deviation <= result.Deviation ? result.Deviation
      : std::isnan(deviation)                        ? HUGE_VAL
                                                     : deviation;
  }
  // Positions are rounded, and so are parameters.
  const SurfaceBlocks::Block all = face.Blocks.GetLargest(face.Blocks.GetCovered());
  for (int d = 0; d < 2; ++d)
  {
    farthest += all.Speed[d] * std::max(std::abs(face.Box.Low[d]), std::abs(face.Box.High[d]));
  }
  result.Deviation += 64.0 * UnitRoundoff * farthest + face.Blocks.GetSmallJumps();
  // Where weights differ much, only the hull bounds the deviation.
  result.Deviation = std::min(result.Deviation, widestGap + GetHullDiagonal(face.Source.Surface, face.Box));
  FillNormals(result);
}
}
