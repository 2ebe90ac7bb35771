#include "smCellSurface.h"

#include <algorithm>

namespace sm
{
int CellSurface::FindCell(int direction, double x) const
{
  const std::vector<double>& breaks = this->Breaks[direction];
  return static_cast<int>(std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x) - breaks.begin()) - 1;
}

std::array<double, 3> CellSurface::Evaluate(
  const std::array<double, 2>& uv, std::array<double, 3>* du, std::array<double, 3>* dv)
{
  const int cell[2] = { this->FindCell(0, uv[0]), this->FindCell(1, uv[1]) };
  if (cell[0] != this->Cell[0] || cell[1] != this->Cell[1])
  {
    for (int d = 0; d < 2; ++d)
    {
      this->Cell[d] = cell[d];
      this->Start[d] = this->Breaks[d][cell[d]];
      this->Width[d] = this->Breaks[d][cell[d] + 1] - this->Start[d];
    }
    this->Source.ExtractBezier(this->Start[0], this->Breaks[0][cell[0] + 1], this->Start[1],
      this->Breaks[1][cell[1] + 1], this->Points);
  }
  const int p = this->Source.Degree[0];
  const int q = this->Source.Degree[1];
  const double s = (uv[0] - this->Start[0]) / this->Width[0];
  const double r = (uv[1] - this->Start[1]) / this->Width[1];
  std::array<double, 4> rows[MaximumDegree + 1] = {};
  std::array<double, 4> rowsS[MaximumDegree + 1];
  for (int j = 0; j <= q; ++j)
  {
    rows[j] = BernsteinPiece<4>{ this->Points + j * (p + 1), p }.Evaluate(s, du ? &rowsS[j] : nullptr);
  }
  std::array<double, 4> hr;
  const std::array<double, 4> h = BernsteinPiece<4>{ rows, q }.Evaluate(r, dv ? &hr : nullptr);
  const std::array<double, 4> hs = du ? BernsteinPiece<4>{ rowsS, q }.Evaluate(r) : std::array<double, 4>{};
  std::array<double, 3> position;
  for (int c = 0; c < 3; ++c)
  {
    position[c] = h[c] / h[3];
    if (du)
    {
      (*du)[c] = (hs[c] - position[c] * hs[3]) / h[3] / this->Width[0];
    }
    if (dv)
    {
      (*dv)[c] = (hr[c] - position[c] * hr[3]) / h[3] / this->Width[1];
    }
  }
  return position;
}
}
