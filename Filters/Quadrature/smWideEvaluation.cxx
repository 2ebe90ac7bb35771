#include "Detail/smWideEvaluation.h"

#include "smBernstein.h"
#include "smChebyshev.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace sm
{
namespace
{
/// i / n.
Wide GetRatio(int i, int n)
{
  static const std::vector<Wide> ratios = []()
  {
    std::vector<Wide> table((MaximumDegree + 1) * (MaximumDegree + 1));
    for (std::size_t at = MaximumDegree + 1; at < table.size(); ++at)
    {
      table[at] = static_cast<Wide>(at % (MaximumDegree + 1)) / (at / (MaximumDegree + 1));
    }
    return table;
  }();
  return ratios[n * (MaximumDegree + 1) + i];
}

template <int Dimension>
void RaiseDegree(Wide coefficients[][Dimension], int from, int to)
{
  for (int n = from + 1; n <= to; ++n)
  {
    std::copy_n(coefficients[n - 1], Dimension, coefficients[n]);
    for (int i = n - 1; i > 0; --i)
    {
      const Wide x = GetRatio(i, n);
      for (int d = 0; d < Dimension; ++d)
      {
        coefficients[i][d] = x * coefficients[i - 1][d] + (1 - x) * coefficients[i][d];
      }
    }
  }
}
}

void FillWideBasis(int degree, Wide t, Wide* basis)
{
  Wide power = 1;
  for (int i = 0; i <= degree; ++i)
  {
    basis[i] = power * Binomials[degree][i];
    power *= t;
  }
  power = 1;
  for (int i = degree; i-- > 0;)
  {
    power *= 1 - t;
    basis[i] *= power;
  }
}

const Wide* GetWideBases(int degree, int nodes)
{
  struct Table
  {
    std::once_flag IsMade;
    std::vector<Wide> Bases;
  };
  static std::array<std::array<Table, ChebyshevRule::MaximumSize + 1>, MaximumDegree + 1> tables;
  Table& table = tables[degree][nodes];
  std::call_once(table.IsMade,
    [&table, degree, nodes]()
    {
      const ChebyshevRule& rule = ChebyshevRule::Get(nodes);
      table.Bases.resize(static_cast<std::size_t>(nodes) * (degree + 1));
      for (int i = 0; i < nodes; ++i)
      {
        FillWideBasis(degree, 0.5L * (1.0L + rule.GetWideNode(i)), table.Bases.data() + i * (degree + 1));
      }
    });
  return table.Bases.data();
}

WideCurves::WideCurves(const FacePanels& panels, const Ribbon& ribbon, bool raised)
  : TrimDegree(ribbon.TrimDegree)
  , EdgeDegree(ribbon.EdgeDegree)
{
  const Patch& patch = panels.Patches[ribbon.Patch];
  const double* trim = panels.Coefficients.data() + ribbon.Trim;
  const double* edge = panels.Coefficients.data() + ribbon.Edge;
  const Wide scale[2] = { 1 / static_cast<Wide>(patch.Width[0]), 1 / static_cast<Wide>(patch.Width[1]) };
  for (int i = 0; i <= this->TrimDegree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      this->Trim[i][d] = (static_cast<Wide>(trim[2 * i + d]) - patch.Start[d]) * scale[d];
      this->Constant[d] = this->Constant[d] && trim[2 * i + d] == trim[d];
    }
  }
  for (int i = 0; i <= this->EdgeDegree; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Edge[i][c] = static_cast<Wide>(edge[3 * i + c]) - patch.Center[c];
    }
  }
  if (raised)
  {
    const int degree = std::max(this->TrimDegree, this->EdgeDegree);
    RaiseDegree<2>(this->Trim, this->TrimDegree, degree);
    RaiseDegree<3>(this->Edge, this->EdgeDegree, degree);
    this->TrimDegree = this->EdgeDegree = degree;
  }
}

WidePatch::WidePatch(const std::array<double, 4>* points, int p, int q, const Wide* s, const Wide* r)
  : Points(points)
  , Degree{ p, q }
  , Constant{ s != nullptr, !s && r }
{
  if (!s && !r)
  {
    return;
  }
  const int along = s ? 1 : 0;
  const int across = 1 - along;
  const std::size_t step = along == 1 ? 1 : p + 1;
  const std::size_t next = along == 1 ? p + 1 : 1;
  Wide basis[MaximumDegree + 1];
  FillWideBasis(this->Degree[across], s ? *s : *r, basis);
  for (int j = 0; j <= this->Degree[along]; ++j)
  {
    for (int c = 0; c < 4; ++c)
    {
      Wide value = 0;
      for (int i = 0; i <= this->Degree[across]; ++i)
      {
        value += basis[i] * points[next * j + step * i][c];
      }
      this->Curve[j][c] = value;
    }
  }
}

void WidePatch::Evaluate(Wide s, Wide r, Wide h[4]) const
{
  Wide basis[2][MaximumDegree + 1];
  if (this->Constant[0] || this->Constant[1])
  {
    const int degree = this->Degree[this->Constant[0] ? 1 : 0];
    FillWideBasis(degree, this->Constant[0] ? r : s, basis[0]);
    SumBasis<4>(basis[0], this->Curve, degree, h);
    return;
  }
  const auto [p, q] = this->Degree;
  FillWideBasis(p, s, basis[0]);
  FillWideBasis(q, r, basis[1]);
  std::fill(h, h + 4, Wide(0));
  for (int j = 0; j <= q; ++j)
  {
    for (int c = 0; c < 4; ++c)
    {
      // Sums in registers: storing a wide number costs more than adding one.
      Wide value = 0;
      for (int i = 0; i <= p; ++i)
      {
        value += basis[0][i] * this->Points[i + (p + 1) * j][c];
      }
      h[c] += basis[1][j] * value;
    }
  }
}
}
