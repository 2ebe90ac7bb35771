/**
 * @file smOpenEdges.h
 * @brief Open edges of bodies, and open borders of faces without loops
 */
#ifndef smOpenEdges_h
#define smOpenEdges_h

#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
struct BodyIntegrals;

/**
 * Counts the edges whose signed uses do not add up to 0, and the open borders of faces without loops: those
 * of the four borders of the surface's domain that are not point (a pole), do not coincide with the opposite
 * one (a seam), to 1e-9 of the surface's size, nor with a border of another such face, by length, centre and
 * vector area to 1e-3 of the length. Flags the body if there are any.
 */
void CountOpenEdges(BodyIntegrals& body);

/// Lists the first five entity numbers.
std::string ListIds(const std::vector<std::int64_t>& ids);
}

#endif
