#include "smIntegrationOrders.h"

#include <algorithm>
#include <array>

namespace sm
{
namespace
{
// Steps wide enough that two orders do not agree by chance, the first of them a doubling: N against N+1 was
// wrong by up to 1700 times where N against 2N never was (Bounds.md).
constexpr std::array<int, 6> Ladder = { 3, 6, 9, 14, 20, 30 };
// Where an exact rule needs more points than this, increasing the order until two agree costs less.
constexpr int MaxExactOrder = 10;
}

OrderLadder::OrderLadder(const std::vector<Integrand>& integrands)
  : Degree(0)
{
  for (const Integrand& integrand : integrands)
  {
    if (integrand.Degree < 0)
    {
      this->Degree = -1;
      return;
    }
    this->Degree = std::max(this->Degree, integrand.Degree);
  }
}

int OrderLadder::GetAcross(PanelShape shape) const
{
  // Along a straight ruling of constant normal direction x.n is constant (Flat) or linear, |n| too, and g has
  // its degree D: rules exact to D or D + 1.
  if (this->Degree < 0 || shape == PanelShape::General)
  {
    return 0;
  }
  return shape == PanelShape::Flat ? (this->Degree + 2) / 2 : (this->Degree + 3) / 2;
}

Orders OrderLadder::GetPanelOrders(const Panel& panel, int level) const
{
  const int across = this->GetAcross(panel.Shape);
  if (panel.Shape == PanelShape::Flat && across > 0)
  {
    // In t: g(x(t)) of degree D d, s of degree d, r' of degree d - 1: exact to D d + 2 d - 1.
    const int along = ((this->Degree + 2) * std::max<int>(panel.TrimDegree, 1) + 1) / 2;
    if (along <= MaxExactOrder)
    {
      return { along, across, true, true };
    }
  }
  const int rung = std::min<int>(level, Ladder.size() - 1);
  const int along = Ladder[rung];
  return { along, across > 0 ? across : along, false, rung + 1 == static_cast<int>(Ladder.size()) };
}

Orders OrderLadder::GetRibbonOrders(int level) const
{
  const int rung = std::min<int>(level, Ladder.size() - 1);
  return { Ladder[rung], 1, false, rung + 1 == static_cast<int>(Ladder.size()) };
}

int OrderLadder::GetStripPoints() const
{
  // In l: x.n of degree 1, times g of degree D, times a tangent linear in l: exact to D + 2.
  return this->Degree < 0 ? 5 : (this->Degree + 4) / 2;
}
}
