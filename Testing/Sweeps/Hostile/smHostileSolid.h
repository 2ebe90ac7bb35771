/**
 * @file smHostileSolid.h
 * @brief One solid of the sweep, from its seed: model, placements, truth
 */
#ifndef smHostileSolid_h
#define smHostileSolid_h

#include "smReferenceIntegral.h"

#include <vtkSmartPointer.h>
#include <vtkTrimmedNURBSModel.h>

#include <cstdint>
#include <string>
#include <vector>

namespace smhostile
{
struct HostileSolid
{
  std::uint64_t Seed = 0;
  std::string Family;
  std::string Description;
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  /// One or more instances of the model, row-major.
  std::vector<std::array<double, 16>> Placements;
  ReferenceIntegrals Truth;
  /// Largest difference between the truth and the independent ways of getting it (the map's own integral, a
  /// closed formula), over the error that the truth states; 0 where there are none.
  Real TruthDisagreement = 0;
};

/// `maximumCells`: budget of the truth, see IntegratePatches. `checkTruth`: fill TruthDisagreement.
HostileSolid MakeHostileSolid(std::uint64_t seed, int maximumCells, bool checkTruth);
}

#endif
