#include "smFigureTable.h"

#include <smFormat.h>
#include <smSafeFile.h>

namespace smfigure
{
std::string FormatNumber(double value)
{
  return sm::FormatDigits(value, 17);
}

std::string WriteTable(const FigureTable& table, const std::string& folder)
{
  std::string text;
  const auto addRow = [&text](const std::vector<std::string>& row)
  {
    for (const std::string& cell : row)
    {
      text += cell + (&cell == &row.back() ? "\n" : ",");
    }
  };
  addRow(table.Columns);
  for (const auto& row : table.Rows)
  {
    addRow(row);
  }
  const std::string path = folder + "/" + table.Name + ".csv";
  const std::string problem = sm::SaveFile(path, text);
  return problem.empty() ? "" : path + " could not be written: " + problem;
}
}
