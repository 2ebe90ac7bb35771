/**
 * @file smFigureTable.h
 * @brief The numbers of a figure as CSV, which draw_figures.py draws
 */
#ifndef smFigureTable_h
#define smFigureTable_h

#include <string>
#include <vector>

namespace smfigure
{
struct FigureTable
{
  /// The name of the file, without an extension.
  std::string Name;
  std::vector<std::string> Columns;
  std::vector<std::vector<std::string>> Rows;
};

/// Returns a number with 17 digits, which identify a double.
std::string FormatNumber(double value);

/// Writes FOLDER/NAME.csv. Returns an error message, empty when it is written.
std::string WriteTable(const FigureTable& table, const std::string& folder);
}

#endif
