/**
 * @file smSTEPProducts.h
 * @brief Reads the products of a STEP file with their validation properties, and appends such properties to
 * its text
 */
#ifndef smSTEPProducts_h
#define smSTEPProducts_h

#include "smPart21File.h"
#include "smReadersPart21Module.h"
#include "smSTEPCensus.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace sm
{
/// Geometric validation properties; NaN for a property that is not stated. In a STEPProduct lengths are
/// millimetres, in its own coordinates.
struct STEPValidation
{
  double Volume = std::numeric_limits<double>::quiet_NaN();
  double Area = std::numeric_limits<double>::quiet_NaN();
  std::array<double, 3> Centroid{ Volume, Volume, Volume };
};

/// A PRODUCT_DEFINITION whose shape has a representation.
struct STEPProduct
{
  std::uint64_t Definition = 0;
  /// Name of its PRODUCT, or its id if the name is empty; '' is ', but \X2\ is as in the file.
  std::string Name;
  /// Numbers of its PRODUCT_DEFINITION_SHAPE and of the context of its representation.
  std::uint64_t Shape = 0;
  std::uint64_t Context = 0;
  /// Millimetres of the context's length unit; NaN if it has none.
  double Millimetres = std::numeric_limits<double>::quiet_NaN();
  STEPValidation Stated;
  /// True if the file states a density for it, usable or not (smSTEPDensities.h).
  bool HasDensity = false;
  /// True if the file states the name of its material.
  bool HasMaterial = false;
  /// The reasons why the statements of one quantity cannot be used: a wrong unit, or the same property twice
  /// with different values. Empty if they can. Those of the others can be used all the same.
  std::string VolumeProblem, AreaProblem, CentroidProblem;
};

/**
 * Returns the products, sorted by their numbers.
 *
 * A validation property is an item of a representation of a PROPERTY_DEFINITION with the name "geometric
 * validation property" of the product's shape (CAx-IF recommended practice; Pro/ENGINEER writes underscores,
 * and as the shape of a part the only SHAPE_ASPECT of it that has such properties): a VOLUME_MEASURE, an
 * AREA_MEASURE (surface area, which some systems call wetted), each with a DERIVED_UNIT of a length, or a
 * CARTESIAN_POINT "centre point" in the unit of its representation's context, whether or not a body has this
 * context.
 */
SMREADERSPART21_EXPORT std::vector<STEPProduct> ReadSTEPProducts(const Part21File& file);
/// The same for a file whose census has been taken.
SMREADERSPART21_EXPORT std::vector<STEPProduct> ReadSTEPProducts(
  const Part21File& file, const STEPCensus& census);

/// The values that AppendSTEPValidation() writes for a product: lengths are millimetres.
struct STEPStatement
{
  /// A product from ReadSTEPProducts().
  STEPProduct Product;
  STEPValidation Values;
  /// Density in kg/m^3, and name of the material, which may be empty. NaN: no density.
  double Density = std::numeric_limits<double>::quiet_NaN();
  std::string Material;
};

/// Returns the text of the file with new entities at the end of its last DATA section; all other bytes stay
/// as they are. Empty if it has no such section. Values that are NaN, and the centroid in a context without a
/// unit, are left out.
SMREADERSPART21_EXPORT std::string AppendSTEPValidation(
  const Part21File& file, const std::vector<STEPStatement>& statements);
}

#endif
