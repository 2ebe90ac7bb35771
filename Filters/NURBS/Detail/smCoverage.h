/**
 * @file smCoverage.h
 * @brief The parts of cells that lie inside the trim, by signed coverage instead of parity
 *
 * Green's theorem row by row: a piece of a loop that runs from v = a to v = b in row j of column c adds its
 * own part of cell (c, j), and the whole width of every cell (c', j) with c' < c between a and b, with
 * the sign of b - a. Kept as events (+1 at a, -1 at b) that are merged from right to left, all events of a
 * loop cancel except where it truly passes a knot line, because neighbours share their end points as the same
 * doubles. Nothing here asks whether a point is inside, and any loop gets the same sum as row-wise Green.
 */
#ifndef smCoverage_h
#define smCoverage_h

#include <map>
#include <utility>
#include <vector>

namespace sm
{
/// The part StartV..EndV of the right edge of cell (Column, Row) whose whole width is covered Multiplicity
/// times.
struct EdgePanel
{
  int Column;
  int Row;
  double StartV;
  double EndV;
  int Multiplicity;
};

class Coverage
{
public:
  Coverage(int columns, int rows);

  /// A piece of a loop in cell (column, row), from v = start to v = end. `sign` is +1 in loop direction.
  /// Column `columns` (one past the last) stands for the right border of the domain.
  void AddPiece(int column, int row, double start, double end, int sign);

  /// The covered parts of all right edges, by column from right to left.
  std::vector<EdgePanel> ComputeEdgePanels() const;

private:
  int Columns;
  int Rows;
  /// Events of (column, row): v and +-1.
  std::map<std::pair<int, int>, std::vector<std::pair<double, int>>> Events;
};
}

#endif
