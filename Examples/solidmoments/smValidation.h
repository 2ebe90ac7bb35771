/**
 * @file smValidation.h
 * @brief Compares the validation properties of a STEP file with the results, and writes them
 */
#ifndef smValidation_h
#define smValidation_h

#include "smFields.h"

#include <string>
#include <vector>

namespace sm
{
struct FileResult;
struct ProductTreeNode;

/// A property that the file states, in the length unit of the results.
struct ValidationEntry
{
  std::string Product;
  long long Definition = -1; ///< entity number
  std::string Quantity;      ///< "volume", "area", "centroid"
  std::vector<double> Stated,
    Computed; ///< one number, three of a centroid; Computed is empty if it is not comparable
  double Bound = Unknown, Difference = Unknown, Limit = Unknown;
  std::string Result; ///< "pass", "fail", "not-comparable"
  std::string Reason; ///< why it is not comparable

  void Visit(Fields& fields);
};

/**
 * Returns an entry for every property that the file states. Volume and area may differ by `limit` of the
 * stated value, the centroid by `limit` of the cube root of the volume, and all by their bounds.
 */
std::vector<ValidationEntry> CompareValidation(
  const std::string& fileName, const ProductTreeNode& tree, const FileResult& file, double limit);

/// Writes the text of the file with the validation properties and densities of the products that were
/// computed. Existing statements are kept. Returns an error message; empty if the file was written.
std::string WriteValidation(const std::string& fileName, const ProductTreeNode& tree, const FileResult& file,
  const std::string& target);

/// Returns the number of entries with that result.
long long CountValidation(const FileResult& file, const std::string& result);
}

#endif
