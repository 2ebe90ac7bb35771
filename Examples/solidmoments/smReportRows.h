/**
 * @file smReportRows.h
 * @brief Rows of the table for people: a label, a value with its unit, and its bound
 */
#ifndef smReportRows_h
#define smReportRows_h

#include "smTableText.h"

#include <string>

namespace sm
{
/// Returns "1 face", "2 faces"; "- faces" for a negative number.
std::string Count(long long number, const std::string& one, const std::string& more);
/// Returns a number with two digits.
std::string Short(double value);
/// Returns a bound with two digits, rounded up.
std::string ShortBound(double value);
/// Returns "mm^3" for the unit "mm" and the power 3.
std::string RaiseUnit(const std::string& unit, int power);

std::string Row(
  const std::string& label, const std::string& value, const std::string& unit, double bound = Unknown);
/// Returns a row of a value with its bound, or with a note that it has none.
std::string BoundedRow(
  const std::string& label, const std::string& value, const std::string& unit, double bound);
inline std::string MeasuredRow(
  const std::string& label, const ScalarQuantity& quantity, const std::string& unit)
{
  return BoundedRow(label, FormatValue(quantity.Get(), quantity.Bound), unit, quantity.Bound);
}
inline std::string MeasuredRow(
  const std::string& label, const VectorQuantity& quantity, const std::string& unit)
{
  return BoundedRow(label, FormatVector(quantity.Value, quantity.Bound), unit, quantity.Bound);
}
/// Returns three rows for a matrix, the first of which has the bound of all entries; `hasBound`: there should
/// be one.
std::string MatrixRows(
  const std::string& label, const TensorQuantity& matrix, const std::string& unit, bool hasBound = true);
}

#endif
