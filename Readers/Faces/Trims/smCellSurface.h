/**
 * @file smCellSurface.h
 * @brief A surface that is evaluated along curves on it
 */
#ifndef smCellSurface_h
#define smCellSurface_h

#include "smNURBSSurface.h"
#include "smPolynomialCurve.h"

#include <array>
#include <vector>

namespace sm
{
/// Evaluates a surface, and keeps the Bézier patch of the last point, because neighbouring points of a curve
/// are mostly on the same patch.
class CellSurface
{
public:
  explicit CellSurface(const NURBSSurface& surface)
    : Source(surface)
    , Breaks{ surface.GetSpanBreaks(0), surface.GetSpanBreaks(1) }
  {
  }

  /// Returns the cell of a coordinate; outside the domain the nearest one.
  int FindCell(int direction, double x) const;

  /// Returns the point at (u,v), and the derivatives if they are asked for.
  std::array<double, 3> Evaluate(const std::array<double, 2>& uv, std::array<double, 3>* du = nullptr,
    std::array<double, 3>* dv = nullptr);

private:
  const NURBSSurface& Source;
  std::vector<double> Breaks[2];
  int Cell[2] = { -1, -1 };
  double Start[2] = { 0.0, 0.0 };
  double Width[2] = { 1.0, 1.0 };
  std::array<double, 4> Points[(MaximumDegree + 1) * (MaximumDegree + 1)];
};
}

#endif
