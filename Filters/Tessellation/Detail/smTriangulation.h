/**
 * @file smTriangulation.h
 * @brief Constrained Delaunay triangulation of points on an integer grid
 *
 * Points have integer coordinates below 2^30, so that the side of a line on which a point lies is exact in 64
 * bits. Which of two diagonals is better is a matter of quality: it is judged in floating point, and a
 * diagonal is exchanged only where that is certain, so that no sequence of exchanges returns to where it
 * began.
 */
#ifndef smTriangulation_h
#define smTriangulation_h

#include "smFiltersTessellationModule.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace sm
{
struct GridPoint
{
  std::int64_t X = 0;
  std::int64_t Y = 0;
};

/// Twice the area of the triangle a b c, positive when it is counter-clockwise; exact.
inline std::int64_t Orient(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  return (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}

class Triangulation
{
public:
  /// All points lie strictly inside the square from 0 to this.
  static constexpr std::int64_t Extent = (std::int64_t(1) << 30) - 1;

  /// Side k of a triangle lies opposite its vertex k and runs from vertex k+1 to vertex k+2.
  struct Side
  {
    int Neighbor = -1;
    /// Index of a segment along it; -1: none.
    int Segment = -1;
    /// Change of the winding number from its right to its left.
    int Winding = 0;
  };
  struct Triangle
  {
    std::array<int, 3> Vertex{};
    std::array<Side, 3> Sides;
    bool Inside = false;
  };

  /// Lengths of a grid step in x and y in which triangles are to be well shaped. `points`: about so many will
  /// be inserted.
  SMFILTERSTESSELLATION_EXPORT explicit Triangulation(
    const std::array<double, 2>& step, std::size_t points = 0);

  /// Index of a new vertex, or of the one that is there already; the first four are the corners of the
  /// square. -1: the point lies on a segment and `keepSegments`.
  SMFILTERSTESSELLATION_EXPORT int Insert(const GridPoint& point, bool keepSegments);

  /// Index of the triangle that holds the point, in its interior or on a side.
  SMFILTERSTESSELLATION_EXPORT int Locate(const GridPoint& point);

  /**
   * Makes the straight line from vertex `a` to vertex `b` a chain of sides; a winding number grows by 1 from
   * its right to its left. Returns the segment that it crosses inside both; -1: none. Nothing is changed
   * then, unless `split`: both get a vertex at the crossing. -2: the line cannot be inserted.
   */
  SMFILTERSTESSELLATION_EXPORT int InsertSegment(int a, int b, int segment, bool split);

  /// Sets Inside of all triangles whose winding number is positive, or negative where none is positive, and
  /// makes them Delaunay. A triangle at a corner of the square is never inside.
  SMFILTERSTESSELLATION_EXPORT void MarkInside();

  const std::vector<GridPoint>& GetPoints() const { return this->Points; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  /// Triangles that the last Insert() made or changed; some may be named twice.
  const std::vector<int>& GetChanged() const { return this->Changed; }
  /// Number of diagonals that were exchanged: some for each point, but one for each triangle of a fan in
  /// which triangles are needles.
  std::size_t GetNumberOfFlips() const { return this->NumberOfFlips; }

private:
  static int NextCorner(int k) { return k == 2 ? 0 : k + 1; }
  static int PreviousCorner(int k) { return k == 0 ? 2 : k - 1; }

  struct Place
  {
    int Triangle;
    int Side;
  };
  /// The sides and the end of a walk along a line from vertex `a` to the next vertex on it.
  struct Crossing
  {
    /// Sides that the line crosses, as pairs of vertices: right, left.
    std::vector<std::pair<int, int>> Sides;
    /// The vertex at which the walk ended; -1: nowhere.
    int End = -1;
    /// The segment that stopped it.
    int Segment = -1;
  };

  bool IsFlipBetter(int triangle, int side) const;
  /// Sets the triangle beyond the side that begins at vertex `from`.
  void SetNeighbor(int triangle, int from, int neighbor);
  void Flip(int triangle, int side);
  void SplitTriangle(int triangle, int vertex);
  void SplitSide(int triangle, int side, int vertex);
  void Legalize(std::vector<Place>& places);
  /// Exchanges diagonals of inner triangles until none is better.
  void Improve();
  int FindVertexIn(int triangle, int vertex) const
  {
    const std::array<int, 3>& v = this->Triangles[triangle].Vertex;
    return v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2);
  }
  /// The side from `from` to `to`; Triangle is -1 where there is none.
  Place FindSide(int from, int to) const;
  Crossing Walk(int a, int b) const;
  bool FlipAway(int a, int b, std::vector<std::pair<int, int>>& sides);
  void AddSegment(int a, int b, int segment, int winding);
  int InsertPart(int a, int b, int segment, int winding, bool split, int depth);

  std::array<double, 2> Step;
  std::vector<GridPoint> Points;
  std::vector<int> VertexTriangle;
  std::vector<Triangle> Triangles;
  std::vector<int> Changed;
  std::vector<Place> Stack;
  std::size_t NumberOfFlips = 0;
  int Last = 0;
};
}

#endif
