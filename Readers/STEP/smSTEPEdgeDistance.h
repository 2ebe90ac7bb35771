/**
 * @file smSTEPEdgeDistance.h
 * @brief How far two edges are apart, with a bound
 */
#ifndef smSTEPEdgeDistance_h
#define smSTEPEdgeDistance_h

#include "smSTEPEdges.h"

#include <cstddef>
#include <vector>

namespace sm
{
/// What may still be spent on the comparison of the edges of a shell: 50 for a point of a curve that is
/// closest to another one, 1 for a box or a vertex. All edges are apart when it is spent.
struct STEPEdgeWork
{
  static constexpr std::size_t Foot = 50;

  explicit STEPEdgeWork(std::size_t numberOfEdges)
    : Left(100000000 + 30000 * numberOfEdges)
  {
  }
  bool IsSpent() const { return this->Left == 0; }
  void Take(std::size_t amount) { this->Left -= amount < this->Left ? amount : this->Left; }

  std::size_t Left;
};

/// Points of an edge, several in each span of its curve.
class STEPEdgeSamples
{
public:
  /// Keeps a reference.
  explicit STEPEdgeSamples(const STEPEdge& edge);

  const STEPEdge& GetEdge() const { return this->Edge; }
  /// Returns the parameter between `first` and `last` of the point that is closest to a point; NaN if it is
  /// farther away than `limit` or the work is spent, but not always.
  double FindFoot(double first, double last, const Vector3& point, double limit, STEPEdgeWork& work) const;

private:
  /// A box around neighbouring samples.
  struct Block
  {
    std::size_t First = 0;
    std::size_t Last = 0;
    Vector3 Low{};
    Vector3 High{};
    /// Largest distance of neighbours.
    double Reach = 0.0;
  };
  void AddBlock(std::size_t first, std::size_t last);

  const STEPEdge& Edge;
  std::vector<double> Parameters;
  std::vector<Vector3> Points;
  std::vector<Block> Blocks;
};

/// A part of an edge.
struct STEPEdgePart
{
  const STEPEdgeSamples* Samples = nullptr;
  double First = 0.0;
  double Last = 0.0;
};

/**
 * Returns a bound of the distance of any point of one part from the other one; infinite if it is above the
 * limit, if the work is spent, or if the curves are neither lines, conics, splines nor composites of these.
 *
 * Both parts are divided at the breaks of both curves, conics and their like into four, too. In each piece of
 * degree d the distance is measured at 4 d Chebyshev points and the ends. A polynomial of degree d is nowhere
 * larger than its largest value there divided by cos(pi / 8) (Ehlich and Zeller 1964); the distance of a
 * rational piece from a line is at most so much times the ratio of its weights.
 */
double BoundEdgeDistance(const STEPEdgePart& a, const STEPEdgePart& b, double limit, STEPEdgeWork& work);
}

#endif
