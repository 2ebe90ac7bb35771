/**
 * @file smTrimRises.h
 * @brief The loops of a face cut where they turn in v, so that each part crosses a line of constant v once
 */
#ifndef smTrimRises_h
#define smTrimRises_h

#include "smFiltersNURBSModule.h"

#include "smFace.h"

#include <array>
#include <vector>

namespace sm
{
/// A polynomial part of a loop along which v rises, or falls, throughout: its Bernstein coefficients (u,v) in loop direction.
/// Its ends differ in v, and no two coefficients are further apart in v than they.
using TrimRise = std::vector<std::array<double, 2>>;

/**
 * Every trim piece of a face, cut where v turns; and, where the end of a coedge is not the start of the next one, the straight
 * closing piece. Parts that meet share their end to the bit, so that the windings of a loop are those of its ends; parts
 * that begin and end at one v are left out, for they cross no line. No curve is approximated: only where v stays within 2^-46 of
 * its size is a part replaced by its chord. Coedges without a curve are passed over. The degree of a piece is at most MaximumDegree, and
 * coefficients are finite. Thread safe.
 */
SMFILTERSNURBS_EXPORT std::vector<TrimRise> CutIntoRises(const Face& face);
}

#endif
