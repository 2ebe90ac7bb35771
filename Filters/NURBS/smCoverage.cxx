#include "Detail/smCoverage.h"

namespace sm
{
Coverage::Coverage(int columns, int rows)
  : Columns(columns)
  , Rows(rows)
{
}

void Coverage::AddPiece(int column, int row, double start, double end, int sign)
{
  if (start != end)
  {
    std::vector<std::pair<double, int>>& events = this->Events[{ column, row }];
    events.emplace_back(start, sign);
    events.emplace_back(end, -sign);
  }
}

std::vector<EdgePanel> Coverage::ComputeEdgePanels() const
{
  std::vector<EdgePanel> panels;
  std::vector<std::map<double, int>> open(this->Rows);
  for (int column = this->Columns; column > 0; --column)
  {
    const auto first = this->Events.lower_bound({ column, 0 });
    const auto last = this->Events.lower_bound({ column + 1, 0 });
    for (auto cell = first; cell != last; ++cell)
    {
      std::map<double, int>& row = open[cell->first.second];
      for (const auto& [v, sign] : cell->second)
      {
        int& sum = row[v];
        sum += sign;
        if (sum == 0)
        {
          row.erase(v);
        }
      }
    }
    for (int row = 0; row < this->Rows; ++row)
    {
      int multiplicity = 0;
      double start = 0.0;
      for (const auto& [v, change] : open[row])
      {
        if (multiplicity != 0)
        {
          panels.push_back({ column - 1, row, start, v, multiplicity });
        }
        multiplicity += change;
        start = v;
      }
    }
  }
  return panels;
}
}
