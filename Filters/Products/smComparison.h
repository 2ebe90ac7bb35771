/**
 * @file smComparison.h
 * @brief Comparison of the parts of a product in two files; not installed
 */
#ifndef smComparison_h
#define smComparison_h

#include "smProductResults.h"
#include "smProductShapes.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sm
{
namespace states
{
constexpr const char* Unchanged = "unchanged";
constexpr const char* Moved = "moved";
constexpr const char* Changed = "changed";
constexpr const char* Mirrored = "mirrored";
constexpr const char* Added = "added";
constexpr const char* Removed = "removed";
}

/// New minus old of a quantity. The bound is the sum of both bounds and of the rounding of the subtraction.
template <std::size_t N>
struct QuantityDifference
{
  Quantity<N> Old, New, Change;
};

/// Differences of two solids, or of the totals.
struct Differences
{
  QuantityDifference<1> Volume, Area, Mass;
  QuantityDifference<3> Center, MassCenter;
  QuantityDifference<9> Inertia, MassInertia;
};

/// A pair of solids, or a solid without a counterpart.
struct ComparedBody
{
  std::string OldId, NewId;
  /// Translation, its length, and rotation in degrees; NaN unless both have the same shape.
  std::array<double, 3> Translation{ Unknown, Unknown, Unknown }, RotationAxis{ Unknown, Unknown, Unknown };
  double Distance = Unknown, RotationAngle = Unknown;
};

/// All solids of one state, name and model.
struct ComparedPart
{
  std::string State, Name;
  std::optional<std::string> OldName;
  std::size_t InOld = 0, InNew = 0; ///< solids of its name in either file
  std::vector<std::string> Notes;
  std::optional<Differences> Difference; ///< of the first of its bodies
  std::vector<ComparedBody> Bodies;
};

struct SMFILTERSPRODUCTS_EXPORT ProductDifference
{
  bool IsEqual = false;
  double Limit = 0.0;
  std::optional<std::string> LengthUnit;
  /// Numbers of solids by their states, in the order of the list.
  std::vector<std::pair<const char*, std::size_t>> Counts;
  Differences Total;
  std::vector<ComparedPart> Parts;

  void Visit(Fields& fields);
};

/**
 * Compares the solids of two files by their geometry (smPartMatch.h), each solid of one with at most one of
 * the other:
 *   - unchanged: the same shape in the same place, and the same mass and material;
 *   - moved: the same shape at another place; of several shapes, those of the same name come first, then the
 * nearest one;
 *   - mirrored: the mirror image, and not the same shape (AreMirrored()), of the same volume and principal
 * moments; of the same name, or, where neither has a counterpart by its name, of any. `Distance` is that of
 * the centres of the areas;
 *   - changed: the same shape with another mass or material, or another shape of the same name, the nearest
 * of these, or another shape where either file has one solid;
 *   - removed, added: all other solids.
 * Both have one length unit. `limit`: the largest relative difference, in addition to the bounds, that counts
 * as equal; that of places is relative to the diagonal of the larger product. `format` writes the densities
 * of the notes. There is no result if `shouldContinue` returned false.
 */
SMFILTERSPRODUCTS_EXPORT std::optional<ProductDifference> CompareProducts(const ProductResults& before,
  const ProductShapes& oldShapes, const ProductResults& after, const ProductShapes& newShapes, double limit,
  const std::function<std::string(double)>& format, const std::function<bool()>& shouldContinue);
}

#endif
