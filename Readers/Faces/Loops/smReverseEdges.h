/**
 * @file smReverseEdges.h
 * @brief Reverses the uses of edges that run against their loop
 */
#ifndef smReverseEdges_h
#define smReverseEdges_h

#include "smDraftFace.h"

namespace sm
{
/**
 * Reverses coedges whose direction contradicts the order of the file's loop: afterwards each begins at the
 * vertex at which the one before ends. Only a face with one loop without stored trim curves on a surface
 * without periods is changed, for there the direction of the whole loop, which the vertices do not determine,
 * follows from its area; see ReverseLoop().
 */
void ReverseEdges(DraftFace& face);

/// Reverses the loop of a face that ReverseEdges() changed.
void ReverseLoop(DraftFace& face);
}

#endif
