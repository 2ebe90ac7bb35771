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
/// Returns "1 face", "2 faces".
std::string Count(const Json& number, const std::string& one, const std::string& more);
/// Returns a text without quotation marks; "-" for null.
std::string Plain(const Json& value);
/// Returns a number with two digits.
std::string Short(const Json& value);
/// Returns a bound with two digits, rounded up.
std::string ShortBound(const Json& value);

std::string Row(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound);
/// Returns a row of a value with its bound, or with a note that it has none.
std::string BoundedRow(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound);
/// Returns three rows for a matrix whose entries have the bound `limit`, which is in the first row; `hasBound`: there should be one.
std::string Rows(
  const std::string& label, const Json& matrix, const Json& limit, const std::string& unit, bool hasBound);

/// Returns true if all densities are known and not all equal.
bool HasMixedDensities(const Json& total);

/// Returns the rows of requested results other than the mass properties: centre and inertia in a frame, static stability, integrals,
/// volumes below waterlines, sections, and the scheme of the paper.
std::string AnalysisRows(const Json& total, const Json& file);
}

#endif
