/**
 * @file smExactBlocks.h
 * @brief The exact solids that are polynomial or rational images of the unit cube
 */
#ifndef smExactBlocks_h
#define smExactBlocks_h

#include "smExactSolids.h"

namespace smtest
{
/// Graphs and blocks up to degree 9, Möbius reparametrisations up to a weights ratio of 1e3, a graph that is
/// rational in earnest, and two solids with an offset surface.
const std::vector<NamedSolid>& GetExactBlocks();
}

#endif
