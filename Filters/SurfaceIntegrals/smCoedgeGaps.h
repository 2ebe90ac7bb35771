/**
 * @file smCoedgeGaps.h
 * @brief Adds the gaps measured along parts of coedges to the list of gaps of a face
 */
#ifndef smCoedgeGaps_h
#define smCoedgeGaps_h

#include "Engine/smFaceIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"

#include <vector>

namespace sm
{
struct Face;

/// Adds up measurements so that the list has one entry for each coedge that was measured, in the order of the
/// first measurement. A face may have 100,000 coedges (a perforated plate): n additions take O(n log n) time.
class SMFILTERSSURFACEINTEGRALS_EXPORT CoedgeGaps
{
public:
  /// Adds to `gaps`, which may hold entries of this face already. Both arguments must outlive the object.
  CoedgeGaps(const Face& face, std::vector<CoedgeGap>& gaps);

  /// Adds a measurement. `coedge` is the index of the coedge, counted through all loops of the face; Loop and
  /// Coedge of `measured` are ignored.
  void Add(int coedge, const CoedgeGap& measured);

private:
  std::vector<CoedgeGap>& Gaps;
  /// Number of the first coedge of every loop, counted through all loops.
  std::vector<int> LoopStarts;
  /// Index in Gaps of every coedge, counted through all loops; -1: not there yet.
  std::vector<int> Places;
};

/// Adds the gaps of a part of a face to those of the face.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddGaps(const FaceIntegrals& part, FaceIntegrals& face);
}

#endif
