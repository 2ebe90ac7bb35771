/**
 * @file smItemLanes.h
 * @brief The samples of several items of one shape, evaluated side by side in the lanes of vector registers
 */
#ifndef smItemLanes_h
#define smItemLanes_h

#include "smItemKernels.h"

namespace sm
{
/// Items of one shape: kind, degrees, orders and flags are equal. Lane l of the array entry i is at i *
/// (number of lanes) + l.
struct ItemLanes
{
  ItemKind Kind;
  /// Degrees for which the code is compiled; those of the patch follow from Shape.
  int Degree[2];
  /// Degrees of the patch.
  unsigned int Shape[2];
  /// smWorkRecord::detail, with the first edge coefficient relative to Coefficients.
  unsigned int Detail[4];
  /// smWorkRecord::range.
  const double* Range;
  /// Centre, radius, start, width and stretch of the patch.
  const double* Patch;
  /// Four doubles per control point.
  const double* Points;
  /// Coefficients of trim curve and edge curve, or coordinates of the cap.
  const double* Coefficients;
  /// Twelve per item, used if UsePlacements is set.
  const double* Placement;
  /// The Gauss rules, the same for all lanes.
  const double* Rules;
  bool UsePlacements;
  double Perturbation;
  int StripPoints;
  const SampleFormulas::Term* Terms;
  int NumberOfTerms;
  const int* More;
  const SampleFormulas::Magnitude* Magnitudes;
  int NumberOfMagnitudes;

  // Results: a value per term, a rounding per magnitude (in units of u), three numbers about the gaps.
  double* Values;
  double* Roundings;
  double* Gaps;
};

///@{
/// Evaluates as many items as the name says. IntegrateLanes4 needs a processor with AVX2, IntegrateLanes8 one
/// with AVX-512.
unsigned int IntegrateLanes1(const ItemLanes& items);
unsigned int IntegrateLanes2(const ItemLanes& items);
unsigned int IntegrateLanes4(const ItemLanes& items);
unsigned int IntegrateLanes8(const ItemLanes& items);
///@}

///@{
/// Writes entry i of the array from[l], of `size` doubles, a multiple of 8, to to[i * (number of lanes) + l].
void InterleaveLanes2(const double* const* from, std::size_t size, double* to);
void InterleaveLanes4(const double* const* from, std::size_t size, double* to);
void InterleaveLanes8(const double* const* from, std::size_t size, double* to);
///@}

///@{
/// sm::SumRows with that many columns side by side.
void SumRowsLanes2(const double* rows, std::size_t count, int stride, double* sums);
void SumRowsLanes4(const double* rows, std::size_t count, int stride, double* sums);
void SumRowsLanes8(const double* rows, std::size_t count, int stride, double* sums);
///@}
}

#endif
