/**
 * @file smReportRows.h
 * @brief Rows of the table for people: a label, a value with its unit, and its bound
 */
#ifndef smReportRows_h
#define smReportRows_h

#include "smJson.h"

#include <string>

namespace sm
{
/// "1 face", "2 faces".
std::string Count(const Json& number, const std::string& one, const std::string& more);
/// Text without quotation marks; "-" for null.
std::string Plain(const Json& value);
/// A number with two digits.
std::string Short(const Json& value);
/// The bound with two digits, rounded up.
std::string ShortBound(const Json& value);

std::string Row(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound);
/// A row of a value that has a bound, or says that it has none.
std::string BoundedRow(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound);
/// Three rows for a matrix whose entries are known to within `limit`, with the bound in the first; `hasBound` says that there should be one.
std::string Rows(
  const std::string& label, const Json& matrix, const Json& limit, const std::string& unit, bool hasBound);

/// True if all densities are known and not all the same.
bool HasMixedDensities(const Json& total);

/// What the user asked for beside the mass properties; nothing where he did not.
/// Centre and inertia in a frame, static stability, integrals, volumes below waterlines, sections, and the scheme of the paper.
std::string AnalysisRows(const Json& total, const Json& file);
}

#endif
