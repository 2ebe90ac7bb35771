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
/// Points along t and across (xi of a panel; the shader knows a ribbon's).
struct Orders
{
  int Along = 1;
  int Across = 1;
  /// Exact for all integrands: nothing to compare with.
  bool Exact = false;
  /// No higher order follows.
  bool Last = false;
};

/// The ladder of orders for a list of integrands.
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

  /// Highest degree of the integrands' polynomials; -1 when one is no polynomial.
  int Degree;
};
}

#endif
