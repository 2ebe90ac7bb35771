/**
 * @file smValidation.h
 * @brief Compares the validation properties that a file states with the results; not installed
 */
#ifndef smValidation_h
#define smValidation_h

#include "smFields.h"
#include "smFiltersProductsModule.h"

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkDataObject;

namespace sm
{
struct ProductResults;
struct ProductTreeNode;
struct SolidResults;

/// What a file states of a product, in millimetres and its own coordinates; NaN for what it does not state.
struct StatedProduct
{
  std::string Name;
  long long Definition = -1; ///< entity number
  /// Why the statements of one quantity cannot be used; empty if they can.
  std::string VolumeProblem, AreaProblem, CentroidProblem;
  double Volume = Unknown, Area = Unknown;
  std::array<double, 3> Centroid{ Unknown, Unknown, Unknown };
};

/// The sums of the solids of a product, in millimetres: in the coordinates of the product if its placement is
/// known or if it is a part, otherwise in those of the world; NaN if not known.
struct ComputedProduct
{
  /// The reason why no value is known.
  std::string Reason;
  double Volume = 0.0, VolumeBound = 0.0;
  double Area = 0.0, AreaBound = 0.0;
  std::array<double, 3> Center{ Unknown, Unknown, Unknown };
  double CenterBound = Unknown;
  /// The reason why the centre cannot be compared; empty if it can.
  std::string NoCenter;
  /// False if some solid is flagged by more than a bound above the tolerance.
  bool IsSound = true;
  /// Material and density; empty and NaN for an assembly.
  std::string Material;
  double Density = Unknown;
  /// The materials that the file names for its solids, as those of the product or of an assembly; an empty
  /// name where it names none.
  std::set<std::string> FileMaterials;
};

/// The sums of products that are found by their names.
class SMFILTERSPRODUCTS_EXPORT ProductSums
{
public:
  /// `products` are all of the file; `tree` and `results` must outlive the object.
  ProductSums(
    const std::vector<StatedProduct>& products, const ProductTreeNode& tree, const ProductResults& results);
  /// Returns the sums of one of the products.
  ComputedProduct Find(const std::string& name) const;
  /// Returns the length unit of the results; 0 if it is not known.
  double GetMillimetres() const { return this->Millimetres; }

private:
  double Millimetres;
  std::map<std::string, int> Uses;
  /// The first node of each name, and if it is at the top level.
  std::map<std::string, std::pair<const ProductTreeNode*, bool>> NodesByName;
  /// All nodes of each name, whose materials may differ.
  std::map<std::string, std::vector<const ProductTreeNode*>> Occurrences;
  std::map<std::string, const SolidResults*> ById;
};

/// Returns true if the file is not flagged by more than a bound above the tolerance, or if a solid is: a flag
/// that no solid has is that of the file, in which something is missing or contradictory.
SMFILTERSPRODUCTS_EXPORT bool IsFileSound(const ProductResults& results);

/// A property that the file states, in the length unit of the results.
struct SMFILTERSPRODUCTS_EXPORT ValidationEntry
{
  std::string Product;
  long long Definition = -1; ///< entity number
  std::string Quantity;      ///< "volume", "area", "centroid"
  std::vector<double> Stated,
    Computed; ///< one number, three of a centroid; Computed is empty if it is
              ///< not comparable
  double Bound = Unknown, Difference = Unknown, Limit = Unknown;
  std::string Result; ///< "pass", "fail", "not-comparable"
  std::string Reason; ///< why it is not comparable

  void Visit(Fields& fields);
};

/**
 * Returns an entry for every property that is stated, also where the statement cannot be used. Volume and
 * area may differ by `limit` of the stated value, the centroid by `limit` of the cube root of the volume, and
 * all by their bounds. `leftOut` is the reader's note about the bodies that it left out, empty if it left out
 * none: then what differs, and a product that is missing, is not comparable.
 */
SMFILTERSPRODUCTS_EXPORT std::vector<ValidationEntry> CompareValidation(
  const std::vector<StatedProduct>& products, const ProductTreeNode& tree, const ProductResults& results,
  double limit, const std::string& leftOut);

/// Returns the note of a STEP reader about the bodies that it left out as hidden or shown; empty if there is
/// none.
SMFILTERSPRODUCTS_EXPORT std::string FindLeftOutNote(vtkDataObject* readerOutput);
}

#endif
