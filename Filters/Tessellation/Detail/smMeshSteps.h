/**
 * @file smMeshSteps.h
 * @brief Distances between the inner points of a face, and the rows in which they are laid
 */
#ifndef smMeshSteps_h
#define smMeshSteps_h

#include "smEdgeSamples.h"
#include "smSurfaceBlocks.h"

#include <array>
#include <functional>
#include <vector>

namespace sm
{
class MeshSteps
{
public:
  using Parameters = std::array<double, 2>;

  /// For a face in `box`, whose sides are longer than 0.
  MeshSteps(const SurfaceBlocks& blocks, const ParameterBox& box, const MeshLimits& limits);

  /// Densities in u and v, relative to each other, in which triangles are to be well shaped.
  Parameters GetMetric() const;

  /// Largest |S_u| and |S_v|.
  const Parameters& GetSpeed() const { return this->Speed; }

  /// Calls `add` for all points inside the box, row by row; `scale`: points per unit of u and v. Lays fewer
  /// than wanted where that would be millions, and none where no number would do.
  void LayRows(const std::function<void(const Parameters& at, const Parameters& scale)>& add) const;

private:
  const Parameters& GetStep(std::size_t i, std::size_t j) const;
  /// Largest density in direction d in strip `i` of that direction, over strips [first, last] of the other.
  double GetDensity(int d, std::size_t i, std::size_t first, std::size_t last) const;
  /// Points of steps of the wanted lengths.
  double CountWanted() const;
  /// The direction that is constant on a row: rows have different numbers of points.
  int ChooseRows() const;

  const SurfaceBlocks& Blocks;
  ParameterBox Box;
  Parameters Size{};
  Parameters Speed{ 0.0, 0.0 };
  /// Steps of each block.
  std::vector<Parameters> Steps;
};
}

#endif
