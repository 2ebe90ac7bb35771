#include "smColumns.h"

#include "smText.h"

#include <algorithm>

namespace sm
{
void Columns::Add(const std::string& head, double number)
{
  this->Add(head, std::isfinite(number) ? std::optional(FormatExact(number)) : std::nullopt);
}

void Columns::Add(const std::string& head, long long count)
{
  this->Add(head, count >= 0 ? std::optional(std::to_string(count)) : std::nullopt);
}

void Columns::Add(const std::string& stem, const double* numbers, const std::vector<const char*>& suffixes)
{
  for (std::size_t i = 0; i < suffixes.size(); ++i)
  {
    this->Add(stem + "_" + suffixes[i], numbers[i]);
  }
}

void Columns::AddMatrix(const std::string& stem, const std::array<double, 9>& matrix)
{
  const double six[] = { matrix[0], matrix[4], matrix[8], matrix[1], matrix[5], matrix[2] };
  this->Add(stem, six, { "xx", "yy", "zz", "xy", "yz", "xz" });
}

bool Columns::Has(const std::string& head) const
{
  return std::any_of(
    this->Cells.begin(), this->Cells.end(), [&head](const auto& cell) { return cell.first == head; });
}
}
