#include "smReportRows.h"

#include "smFormat.h"

#include <algorithm>

namespace sm
{
std::string Count(long long number, const std::string& one, const std::string& more)
{
  return number < 0 ? "- " + more : std::to_string(number) + " " + (number == 1 ? one : more);
}

std::string Short(double value)
{
  return std::isfinite(value) ? FormatDigits(value, 2) : "-";
}

std::string ShortBound(double value)
{
  return std::isfinite(value) ? FormatBound(value, 2) : "-";
}

std::string RaiseUnit(const std::string& unit, int power)
{
  return unit.empty() || power == 1 ? unit : unit + "^" + std::to_string(power);
}

std::string Row(const std::string& label, const std::string& value, const std::string& unit, double bound)
{
  std::string line = "  " + Pad(label, 22) + value;
  if (value != "-" && !unit.empty())
  {
    line += " " + unit;
  }
  if (std::isfinite(bound))
  {
    line = Pad(line, 80) + "  +/- " + FormatBoundOfShown(bound, 2);
  }
  return line + "\n";
}

std::string BoundedRow(
  const std::string& label, const std::string& value, const std::string& unit, double bound)
{
  const std::string row = Row(label, value, unit, bound);
  return value == "-" || std::isfinite(bound) ? row : Pad(row.substr(0, row.size() - 1), 80) + "  no bound\n";
}

std::string MatrixRows(
  const std::string& label, const TensorQuantity& matrix, const std::string& unit, bool hasBound)
{
  if (!matrix.IsKnown())
  {
    return Row(label, "-", unit);
  }
  size_t width = 0;
  std::array<std::string, 9> cells;
  for (size_t i = 0; i < 9; ++i)
  {
    cells[i] = FormatValue(matrix.Value[i], matrix.Bound, 10);
    width = std::max(width, cells[i].size());
  }
  std::string text;
  for (size_t i = 0; i < 9; i += 3)
  {
    const std::string line = Pad(cells[i], width, true) + "  " + Pad(cells[i + 1], width, true) + "  " +
      Pad(cells[i + 2], width, true);
    text += i > 0 ? Row("", line, "")
      : hasBound  ? BoundedRow(label, line, unit, matrix.Bound)
                  : Row(label, line, unit);
  }
  return text;
}
}
