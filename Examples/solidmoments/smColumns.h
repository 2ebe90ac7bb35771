/**
 * @file smColumns.h
 * @brief A row of the CSV: names of columns with their values
 */
#ifndef smColumns_h
#define smColumns_h

#include "smFields.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
class Columns
{
public:
  /// A value that is not known is an empty cell.
  void Add(const std::string& head, std::optional<std::string> text)
  {
    this->Cells.emplace_back(head, std::move(text));
  }
  void Add(const std::string& head, double number);
  void Add(const std::string& head, long long count);
  /// Adds a column for each suffix, stem_suffix.
  void Add(const std::string& stem, const double* numbers, const std::vector<const char*>& suffixes);
  void AddPoint(const std::string& stem, const std::array<double, 3>& point)
  {
    this->Add(stem, point.data(), { "x", "y", "z" });
  }
  /// Adds the six different entries of a symmetric matrix.
  void AddMatrix(const std::string& stem, const std::array<double, 9>& matrix);
  bool Has(const std::string& head) const;
  /// Meaning of the columns from here to the next note, in Markdown, for the reference.
  void Note(const char* meaning) { this->Notes.emplace_back(this->Cells.size(), meaning); }
  const std::vector<std::pair<std::size_t, const char*>>& GetNotes() const { return this->Notes; }
  const std::vector<std::pair<std::string, std::optional<std::string>>>& GetCells() const
  {
    return this->Cells;
  }

private:
  std::vector<std::pair<std::string, std::optional<std::string>>> Cells;
  std::vector<std::pair<std::size_t, const char*>> Notes; ///< with the number of cells before each
};
}

#endif
