#include "smReportRows.h"

#include "smFormat.h"
#include "smTableText.h"
#include "smText.h"

#include <algorithm>

namespace sm
{
std::string Count(const Json& number, const std::string& one, const std::string& more)
{
  return number.is_null() ? "- " + more : Dump(number) + " " + (number == 1 ? one : more);
}

std::string Plain(const Json& value)
{
  return value.is_string() ? value.get<std::string>() : value.is_null() ? "-" : Dump(value);
}

std::string Short(const Json& value)
{
  return value.is_number() ? FormatDigits(value.get<double>(), 2) : "-";
}

std::string ShortBound(const Json& value)
{
  return value.is_number() ? FormatBound(value.get<double>(), 2) : "-";
}

std::string Row(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound)
{
  std::string line = "  " + Pad(label, 22) + value;
  if (value != "-" && !unit.empty())
  {
    line += " " + unit;
  }
  if (bound.is_number())
  {
    line = Pad(line, 80) + "  +/- " + FormatBoundOfShown(bound.get<double>(), 2);
  }
  return line + "\n";
}

std::string BoundedRow(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound)
{
  const std::string row = Row(label, value, unit, bound);
  return value == "-" || bound.is_number() ? row : Pad(row.substr(0, row.size() - 1), 80) + "  no bound\n";
}

std::string Rows(
  const std::string& label, const Json& matrix, const Json& limit, const std::string& unit, bool hasBound)
{
  if (matrix.is_null())
  {
    return Row(label, "-", unit, nullptr);
  }
  size_t width = 0;
  std::string cells[3][3];
  for (size_t i = 0; i < 3; ++i)
  {
    for (size_t j = 0; j < 3; ++j)
    {
      cells[i][j] = FormatValue(matrix[i][j], limit, 10);
      width = std::max(width, cells[i][j].size());
    }
  }
  std::string text;
  for (size_t i = 0; i < 3; ++i)
  {
    const std::string line = Pad(cells[i][0], width, true) + "  " + Pad(cells[i][1], width, true) + "  " +
      Pad(cells[i][2], width, true);
    text += i == 0 ? (hasBound ? BoundedRow(label, line, unit, limit) : Row(label, line, unit, nullptr))
                   : Row("", line, "", nullptr);
  }
  return text;
}

bool HasMixedDensities(const Json& total)
{
  return total["mass"].is_number() && total["density"].is_null();
}
}
