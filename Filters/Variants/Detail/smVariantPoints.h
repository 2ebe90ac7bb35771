/**
 * @file smVariantPoints.h
 * @brief Frozen samples of the faces that move, evaluated for several variants side by side
 *
 * The nets of a variant are products of a matrix with (1, c); the samples multiply them by values of the
 * basis that were computed once. Results are bitwise the same for every width of the registers.
 */
#ifndef smVariantPoints_h
#define smVariantPoints_h

#include <cstddef>
#include <vector>

namespace sm
{
enum class PointsKind
{
  Panel,
  Ribbon,
  Cap
};

/// Items that have one layout: `Count` records, and the first number of their net. The net of a patch has the
/// centre, the points, the steps in s and those in r, each as x, y, z of all; that of an edge its
/// coefficients; that of a triangle its corners. Records have the weight and the values of the basis.
struct PointsBlock
{
  PointsKind Kind;
  /// Numbers of points and steps.
  int Points, StepsS, StepsR;
  int EdgePoints;
  std::size_t Net, EdgeNet;
  std::size_t Record, Count;
  /// Numbers of a record: weight, turns, and the basis.
  std::size_t RecordSize;
};

struct PointsFace
{
  /// Directions that move the face.
  std::vector<int> Directions;
  /// [number of the net][variable].
  std::size_t NetSize = 0;
  std::vector<double> Nets;
  std::vector<double> Records;
  std::vector<PointsBlock> Blocks;
};

/// The same for the kernels, which call no function that other files have, too.
struct PointsView
{
  const int* Directions;
  int DirectionCount;
  std::size_t NetSize;
  const double* Nets;
  const double* Records;
  const PointsBlock* Blocks;
  std::size_t BlockCount;
};

/// Adds the ten moments of a face for `count` variants, no more than GetVariantLanes(): sums[moment * lanes +
/// lane], and carries in the same order, which compensate their rounding. `c` has `directions` numbers for
/// each variant.
void AddPoints(const PointsFace& face, const double* c, std::size_t directions, std::size_t count,
  double* sums, double* carries, std::vector<double>& scratch);
}

#endif
