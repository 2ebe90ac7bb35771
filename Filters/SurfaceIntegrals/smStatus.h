/**
 * @file smStatus.h
 * @brief What a result is worth: one order, from good to bad
 */
#ifndef smStatus_h
#define smStatus_h

#include "smFiltersSurfaceIntegralsModule.h"

namespace sm
{
/// The status of several bodies is the largest of theirs.
enum class Status
{
  /// There was no run.
  None,
  /// Every value is within its bound, and every bound within the tolerance.
  Ok,
  /// A bound is above the tolerance, or nothing bounds the error.
  ToleranceNotMet,
  /// The file or the result contradicts itself.
  Suspect,
  /// Edges are used once: a surface, or a solid with holes in its boundary.
  Open,
  /// The run failed: memory was short, or an error of the program was caught.
  NotComputed,
  /// The input holds no body.
  Empty,
  /// The file could not be read.
  Unreadable
};

/// The name in outputs (smIntegralNames.h): "ok", "open", …; empty for None.
SMFILTERSSURFACEINTEGRALS_EXPORT const char* GetText(Status status);
}

#endif
