/**
 * @file smStatus.h
 * @brief Status of a result, ordered from good to bad
 */
#ifndef smStatus_h
#define smStatus_h

#include "smFiltersSurfaceIntegralsModule.h"

namespace sm
{
/// Status of a run or a body. The status of several bodies is the largest one.
enum class Status
{
  /// There was no run.
  None,
  /// Every value is within its bound, and every bound within the tolerance.
  Ok,
  /// A bound is above the tolerance, or there is no bound.
  ToleranceNotMet,
  /// The file or the result contradicts itself.
  Suspect,
  /// Edges are used once: the body is a surface, or a solid with openings in its boundary.
  Open,
  /// The run failed: memory was insufficient, or an error of the program was caught.
  NotComputed,
  /// The input holds no body.
  Empty,
  /// The file could not be read.
  Unreadable
};

/// Returns the name in outputs (smIntegralNames.h): "ok", "open", …; empty for None.
SMFILTERSSURFACEINTEGRALS_EXPORT const char* GetText(Status status);
}

#endif
