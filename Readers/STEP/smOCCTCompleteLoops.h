/**
 * @file smOCCTCompleteLoops.h
 * @brief Loops of a face as the file has them, with the trims, poles and seams that it leaves out
 */
#ifndef smOCCTCompleteLoops_h
#define smOCCTCompleteLoops_h

#include "smOCCTLoop.h"

#include <string>

namespace sm
{
/**
 * Gives the coedges that need them the feet of their edges' curves (smOCCTFootCurve.h), orders the loops and moves trims by whole
 * periods so that every loop is continuous. Where a loop passes a pole of the surface, the line in (u,v) that is the pole is
 * added; where loops go round a periodic surface, a seam joins two of them, or one and a pole. Loops are taken to run
 * counter-clockwise about the face, holes clockwise, as the standard demands.
 *
 * Returns why the face cannot be taken so, a few words; empty when all is well. Several threads may call this, each for a face of its own.
 */
std::string CompleteLoops(DraftFace& face);
}

#endif
