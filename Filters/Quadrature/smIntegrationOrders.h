/**
 * @file smIntegrationOrders.h
 * @brief Gauss rules of an item of integration, level by level
 */
#ifndef smIntegrationOrders_h
#define smIntegrationOrders_h

#include "smFacePanels.h"
#include "smFiltersQuadratureModule.h"
#include "smIntegrand.h"

#include <vector>

namespace sm
{
/// Numbers of Gauss points along t and across. Across is the xi of a panel; the shader has the fixed number
/// of a ribbon.
struct Orders
{
  int Along = 1;
  int Across = 1;
  /// The rule is exact for all integrands, so that no second order is compared.
  bool Exact = false;
  /// This is the highest order of the ladder.
  bool Last = false;
};

/// The increasing orders at which items are evaluated until two orders agree, for a list of integrands.
class SMFILTERSQUADRATURE_EXPORT OrderLadder
{
public:
  explicit OrderLadder(const std::vector<Integrand>& integrands);

  Orders GetPanelOrders(const Panel& panel, int level) const;
  Orders GetRibbonOrders(int level) const;

  /// Gauss points that integrate the flat directions of ribbons and caps exactly.
  int GetStripPoints() const;

private:
  int GetAcross(PanelShape shape) const;

  /// Highest degree of the integrands' polynomials; -1 when one is not a polynomial.
  int Degree;
};
}

#endif
