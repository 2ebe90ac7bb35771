/**
 * @file smVariantErrors.h
 * @brief Errors of the items of faces for the |c| of a variant at frozen points
 */
#ifndef smVariantErrors_h
#define smVariantErrors_h

#include "smUnitRoundoff.h"
#include "smVariantChain.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace sm
{
/// Covers the rounding of a bound's term, some thousand operations with positive numbers.
constexpr double PointsRounding = 1.0 + 1e-11;

/// Covers that of a sum of so many positive terms, and of some more that go into the sum.
inline double GetSumRounding(std::size_t terms)
{
  return std::max(PointsRounding, 1.0 + 2.0 * UnitRoundoff * (static_cast<double>(terms) + 64.0));
}

/// The errors of a face's items as forms in (1, c of Directions), for any |c|.
struct PointsErrors
{
  std::vector<int> Directions;
  std::vector<VariantError> Terms;
};

/**
 * The factor of errors for nets that are made from c. A net is a sum of products with c, which adds one
 * rounding for each variable and two more to the numbers of the net; errors of positions and tangents are at
 * least 2 unit roundoffs of these, those of a patch's centre no more.
 */
double GetErrorGrowth(std::size_t variables);

/// Adds the bounds of a face's items; `sizes` are 1 and |c| of the face's directions.
void AddErrors(
  const PointsErrors& face, const std::vector<double>& sizes, std::array<double, NumberOfMoments>& bounds);

/// Adds the bounds of all faces for a variant, c of all directions.
void AddErrors(const std::vector<PointsErrors>& faces, const double* c, std::vector<double>& sizes,
  std::array<double, NumberOfMoments>& bounds);
}

#endif
