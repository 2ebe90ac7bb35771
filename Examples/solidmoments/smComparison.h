/**
 * @file smComparison.h
 * @brief Comparison of the parts of a product in two files
 */
#ifndef smComparison_h
#define smComparison_h

#include "smJson.h"

#include <functional>

namespace sm
{
namespace states
{
constexpr const char* Unchanged = "unchanged";
constexpr const char* Moved = "moved";
constexpr const char* Changed = "changed";
constexpr const char* Added = "added";
constexpr const char* Removed = "removed";
}

/**
 * Compares the solids of two files by their geometry (smPartMatch.h), each solid of one with at most one of the other:
 *   - unchanged: the same shape in the same place, and the same mass and material;
 *   - moved: the same shape at another place; of several shapes, those of the same name come first, then the nearest one;
 *   - changed: the same shape with another mass or material, or another shape of the same name, the nearest of these, or another shape
 *     where either file has one solid;
 *   - removed, added: all other solids.
 * The entries have the shapes of MeasureProduct(), and one length unit. `limit`: the largest relative difference, in addition to the
 * bounds, that counts as equal; that of places is relative to the diagonal of the larger product.
 *
 * {"equal": true if all is unchanged, "limit", "length_unit", "counts": of solids by their states, "total": differences,
 *  "parts": [{"state", "name", "old_name", "count", "in_old", "in_new", "notes", "difference", "bodies"}]}
 * A part has all solids of one state, name and model. "in_old" and "in_new" count the solids of its name in either file; "difference" is
 * that of the first of its bodies. The result is null if `shouldContinue` returned false.
 */
Json CompareProducts(
  const Json& oldFile, const Json& newFile, double limit, const std::function<bool()>& shouldContinue);
}

#endif
