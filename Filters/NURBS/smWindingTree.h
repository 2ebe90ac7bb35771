/**
 * @file smWindingTree.h
 * @brief Winding number of a closed triangulation about a point, in logarithmic time; not installed
 */
#ifndef smWindingTree_h
#define smWindingTree_h

#include "smFiltersNURBSModule.h"

#include "smVector.h"

#include <array>
#include <cstddef>
#include <vector>

namespace sm
{
/// A triangle of a mesh, counter-clockwise seen from outside.
struct MeshTriangle
{
  std::array<Vector3, 3> Corners;
  /// Largest distance between the triangle and the surface that it stands for.
  double Deviation = 0.0;
};

/// Returns how far a surface with these normals at the corners, unit or zero, may be from the flat triangle.
SMFILTERSNURBS_EXPORT double EstimateDeviation(
  const std::array<Vector3, 3>& corners, const std::array<Vector3, 3>& normals);

/// Returns the solid angle of a triangle seen from p (Van Oosterom and Strackee 1983): positive if p is
/// behind it.
SMFILTERSNURBS_EXPORT double GetSolidAngle(const Vector3& p, const std::array<Vector3, 3>& corners);

/// Returns the distance of p from a triangle.
SMFILTERSNURBS_EXPORT double GetDistance(const Vector3& p, const std::array<Vector3, 3>& corners);

/// Returns true if every side of a triangle is a side of another one, in the opposite direction and with the
/// same bits, as often as it occurs: then winding numbers are whole. Meshes that are not closed pass with a
/// probability of 2^-64.
SMFILTERSNURBS_EXPORT bool IsClosed(const std::vector<MeshTriangle>& triangles);

/**
 * A hierarchy of triangles. The winding number about a point is the sum of their solid angles over 4 pi;
 * triangles far away enter by their area vector, a dipole, and its first moment, as in Barill, Dickson,
 * Schmidt, Levin and Jacobson, Fast winding numbers for soups and clouds, ACM Transactions on Graphics 37(4),
 * 2018. A query is thread safe, and depends on nothing but the triangles and the point.
 */
class SMFILTERSNURBS_EXPORT WindingTree
{
public:
  explicit WindingTree(const std::vector<MeshTriangle>& triangles);

  /// No triangle is left out.
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  /// Returns the winding number, to 0.1 for the meshes of the tests. `without` is the index of a triangle to
  /// leave out.
  double EvaluateWindingNumber(const Vector3& p, std::size_t without = None) const
  {
    return this->Evaluate(p, without, FarRatio);
  }
  /// The same as a sum over all triangles, to rounding.
  double EvaluateExactWindingNumber(const Vector3& p, std::size_t without = None) const;

  /**
   * Counts the triangles that a ray from p crosses, those that it leaves through less those that it enters
   * through: the winding number about p if the mesh is closed, which takes a fraction of the time of
   * EvaluateWindingNumber(). The ray runs along the axis on which p is nearest to the end of the mesh, where
   * it meets few triangles. Returns false if rounding could change the number, because the ray meets the side
   * of a triangle, or a triangle contains p.
   */
  bool CountCrossings(const Vector3& p, int& number) const;

  /**
   * Returns true if p is farther from every triangle than its deviation plus `slack`. The triangles can then
   * be moved to the surface without passing p, so that the winding number of the surface about p is that of
   * the mesh.
   */
  bool IsFarFrom(const Vector3& p, double slack) const;

private:
  /// A cluster of triangles. The first child follows its parent.
  struct Node
  {
    Vector3 Low, High;
    double Deviation = 0.0;
    /// Sum of the areas.
    double Weight = 0.0;
    /// Point of the expansion, the mean of the centroids by area, and a distance from it that no corner
    /// exceeds.
    Vector3 Center{};
    double Radius = 0.0;
    /// Sum of area vectors, and of the products of each with its centroid relative to Center: xx yy zz xy yz
    /// xz, symmetrised.
    Vector3 Area{};
    std::array<double, 6> Moment{};
    std::size_t Begin = 0;
    std::size_t End = 0;
    /// Index of the second child; 0: a leaf.
    std::size_t Second = 0;

    void SetCenter(const Vector3& mean);
    /// Adds an area vector at a point to Moment.
    void AddMoment(const Vector3& area, const Vector3& at);
  };

  /// Largest number of triangles of a leaf.
  static constexpr std::size_t LeafSize = 8;
  /// What Build() sorts: a triangle's centroid, the longest side of its box, and its index.
  struct Item
  {
    Vector3 Centroid;
    double Extent;
    std::size_t Index;
  };
  struct Input
  {
    const std::vector<MeshTriangle>& Triangles;
    std::vector<Item> Items;
  };

  /// Distance of a cluster, in its radii, from which on its expansion is used.
  static constexpr double FarRatio = 2.0;

  /// Part of the hierarchy of triangles [Begin, End): two others, or a subtree with indices of its own.
  struct Branch
  {
    std::size_t Begin = 0;
    std::size_t End = 0;
    std::size_t Children[2] = { 0, 0 };
    std::vector<Node> Nodes;
  };
  /// Sorts the triangles into two children; returns the first one of the second child.
  static std::size_t Split(Input& input, std::size_t begin, std::size_t end);
  static std::size_t Build(Input& input, std::size_t begin, std::size_t end, std::vector<Node>& nodes);
  static std::vector<Branch> MakeBranches(Input& input);
  std::size_t Join(const std::vector<Branch>& branches, std::size_t index);
  static void SumTriangles(const Input& input, Node& node);
  std::array<Vector3, 3> GetTriangle(std::size_t i) const;
  static void SumChildren(const Node& first, const Node& second, Node& node);
  double SumAngles(const Vector3& p, const Node& node, std::size_t without) const;
  /// CountCrossings() along an axis, upwards or downwards.
  bool CountAlong(const Vector3& p, int axis, bool upwards, int& number) const;
  bool CountInLeaf(const Vector3& p, const Node& node, int axis, double direction, int& number) const;
  double Evaluate(const Vector3& p, std::size_t without, double farRatio) const;

  std::vector<Node> Nodes;
  /// Index of each triangle in the constructor's argument, leaf after leaf.
  std::vector<std::size_t> Order;
  /// Coordinates 0 to 2 of corner 0, then those of corners 1 and 2, of the triangles in this order, so that
  /// the compiler computes the solid angles of a leaf side by side; and zeros for as many triangles as a leaf
  /// has.
  std::array<std::vector<double>, 9> Coordinates;
  std::vector<double> Deviations;
};
}

#endif
