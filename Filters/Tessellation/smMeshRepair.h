/**
 * @file smMeshRepair.h
 * @brief Repairs triangles that are inverted in space though not in (u,v)
 *
 * That happens where edges lie off their surface, and where a face is narrower than its edges bend between
 * two points.
 */
#ifndef smMeshRepair_h
#define smMeshRepair_h

#include "smFiltersTessellationModule.h"

#include "smTriangulation.h"
#include "smVector.h"

#include <array>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace sm
{
struct MeshVertex
{
  std::array<double, 2> At{};
  Vector3 Position{};
  /// Along Su x Sv; 0 where that vanishes.
  Vector3 Normal{};
  /// Su and Sv.
  std::array<Vector3, 2> Derivatives{};
  /// The point of the body, see BoundaryPoint; -1: none.
  int Shared = -1;
  /// Distance from the surface.
  double Gap = 0.0;
};

class SMFILTERSTESSELLATION_EXPORT MeshRepair
{
public:
  using Corners = std::array<int, 3>;

  /// Answers whether a triangle is inverted, and bounds its distance from the surface.
  struct TriangleTests
  {
    std::function<bool(const Corners&)> IsInverted;
    std::function<double(const Corners&)> GetDeviation;
  };

  /// The sides of a triangulation that are segments, as the constructor takes them.
  static std::map<std::pair<int, int>, int> FindSegments(const Triangulation& mesh);

  /// `segments`: sides that stay, pairs of vertices with the smaller one first, and their numbers. `allowed`:
  /// the deviation that no repair exceeds, but where triangles exceed it already; and there none exceeds 1.5
  /// times the largest of all triangles before any repair.
  MeshRepair(std::vector<Corners>& triangles, const std::vector<GridPoint>& points,
    const std::map<std::pair<int, int>, int>& segments, const TriangleTests& tests, double allowed);

  /**
   * Exchanges diagonals, and merges vertices that lie on no segment with a neighbour, where fewer triangles
   * are inverted then. All stay counter-clockwise in (u,v). Returns those that are left over.
   */
  std::vector<Corners> Run();

private:
  bool Flip(std::size_t triangle);
  bool Merge(std::size_t triangle);
  /// Puts `after` in the place of `before` if that turns triangles back.
  bool Replace(const std::vector<std::size_t>& before, const std::vector<Corners>& after);
  bool IsOnSegment(int vertex) const { return this->Fixed.count(vertex) > 0; }

  std::vector<Corners>& Triangles;
  const std::vector<GridPoint>& Points;
  const std::map<std::pair<int, int>, int>& Segments;
  std::set<int> Fixed;
  const TriangleTests& Tests;
  double Allowed;
  double Maximum;
  /// Indices of the triangles at each vertex.
  std::vector<std::vector<std::size_t>> Stars;
  /// Number of triangles that were judged.
  std::size_t Trials = 0;
};
}

#endif
