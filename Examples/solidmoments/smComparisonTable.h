/**
 * @file smComparisonTable.h
 * @brief The comparison of two products as a table
 */
#ifndef smComparisonTable_h
#define smComparisonTable_h

#include "smComparison.h"
#include "smResults.h"

#include <string>

namespace sm
{
/// Returns the statuses of both files, a row for each changed part and one for all unchanged parts, the
/// differences of the totals, and the result. `comparison`: of CompareProducts(); null where there is none.
std::string FormatComparison(
  const FileResult& oldFile, const FileResult& newFile, const std::optional<ProductDifference>& comparison);
}

#endif
