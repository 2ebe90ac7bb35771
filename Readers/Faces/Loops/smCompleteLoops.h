/**
 * @file smCompleteLoops.h
 * @brief Completes the loops of a face from a STEP file: adds the trim curves, poles and seams that the file
 * omits
 */
#ifndef smCompleteLoops_h
#define smCompleteLoops_h

#include "smDraftFace.h"

#include <string>

namespace sm
{
/**
 * Sets the trim curves of the coedges that need them to the foot points of their edges' curves
 * (smFootCurve.h), orders the loops, and moves trim curves by whole periods so that every loop is
 * continuous in (u,v). Where a loop passes a pole of the surface, the line in (u,v) that is mapped to the
 * pole is added; where loops wind around a periodic surface, a seam joins two of them, or one and a pole.
 * Outer loops are assumed to run counter-clockwise and holes clockwise, as the standard requires.
 *
 * Returns a short reason if the loops cannot be completed, else an empty text. Thread safe for different
 * faces.
 */
std::string CompleteLoops(DraftFace& face);
}

#endif
