/**
 * @file smProductMasses.h
 * @brief Masses that materials state for products, distributed over the solids of each occurrence
 *
 * The stated mass M of a product is that of all its solids with a volume, at any level below it. Solids whose
 * mass is stated, for themselves or by a product in it, keep that, together F; the others share M - F in
 * proportion to volume times density, or, unless all of them have a density, to volume. So solid k has the
 * density q d_k with q = (M - F) / sum d_i V_i, and moments of that density. With bounds e_i of V_i, q is off
 * by at most a share E / (W - E), W = sum d_i V_i and E = sum d_i e_i.
 */
#ifndef smProductMasses_h
#define smProductMasses_h

#include "smMassAnalysis.h"

#include <string>
#include <vector>

namespace sm
{
/// Sets `options.Shares` of all solids that share the stated mass of a product. `rows` have the volumes of
/// the bodies. Returns messages: the masses that are used, and how; products without a volume or solids,
/// statements that contradict each other, and rules that fit no product.
std::vector<std::string> ShareProductMasses(
  const std::vector<BodyIntegrals>& bodies, const std::vector<MassRow>& rows, MassAnalysisOptions& options);
}

#endif
