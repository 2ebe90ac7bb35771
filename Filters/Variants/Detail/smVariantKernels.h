/**
 * @file smVariantKernels.h
 * @brief Evaluates forms for several variants side by side in vector registers
 *
 * Results are bitwise the same for every width: each variant has the same operations in the same order, and
 * none is fused.
 */
#ifndef smVariantKernels_h
#define smVariantKernels_h

#include <cstddef>
#include <vector>

namespace sm
{
/// Monomials of a degree times a matrix: one column for each form.
struct VariantMatrix
{
  int Degree = 0;
  std::size_t Rows = 0;
  /// A multiple of 4; columns that fill up are 0.
  std::size_t Columns = 0;
  /// [block of 4 columns][row][column]
  const double* Entries = nullptr;
};

struct VariantForms
{
  int Variables = 1;
  /// counts[degree * (Variables + 1) + n]: monomials of a degree in n variables.
  const std::size_t* Counts = nullptr;
  int MaximumDegree = 0;
  const VariantMatrix* Matrices = nullptr;
  std::size_t MatrixCount = 0;
  std::size_t TotalColumns = 0;
};

/// Roundings of each term of a form of `rows` monomials: products, and sums in blocks of 64.
inline double GetRoundingsOfForm(std::size_t rows)
{
  return 8.0 + 64.0 + static_cast<double>((rows + 63) / 64);
}

/// Number of variants that the widest kernel of this processor takes at a time.
int GetVariantLanes();

/**
 * For `count` variants, no more than GetVariantLanes(): values[column * lanes + lane] of all matrices'
 * columns one after another. `c` has Variables - 1 numbers for each variant. `scratch` is kept between calls.
 */
void EvaluateForms(const VariantForms& forms, const double* c, std::size_t count, double* values,
  std::vector<double>& scratch);
}

#endif
