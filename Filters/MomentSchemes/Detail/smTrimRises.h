/**
 * @file smTrimRises.h
 * @brief The loops of a face, cut at the extrema of v, so that each part crosses a line of constant v at most
 * once
 */
#ifndef smTrimRises_h
#define smTrimRises_h

#include "smFiltersMomentSchemesModule.h"

#include "smFace.h"

#include <array>
#include <vector>

namespace sm
{
/// A polynomial part of a loop along which v only increases or only decreases, by its Bernstein coefficients
/// (u,v) in the direction of the loop. Its end points differ in v, and all its coefficients lie between them
/// in v.
using TrimRise = std::vector<std::array<double, 2>>;

/**
 * Returns every trim piece of a face, cut at the extrema of v, and the straight closing piece wherever the
 * end of a coedge is not the start of the next one. Adjacent parts have bitwise equal end points, so that the
 * winding number depends only on the end points. Parts whose ends have equal v are omitted, as they cross no
 * line of constant v. Curves are not approximated, except that a part is replaced by its chord where v varies
 * by less than 2^-46 of its size. Coedges without a curve are omitted. Requires a degree of at most
 * MaximumDegree and finite coefficients. Thread safe.
 */
SMFILTERSMOMENTSCHEMES_EXPORT std::vector<TrimRise> CutIntoRises(const Face& face);
}

#endif
