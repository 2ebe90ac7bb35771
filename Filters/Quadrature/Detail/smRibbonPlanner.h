/**
 * @file smRibbonPlanner.h
 * @brief Plans the ribbons of a face, see smQuadraturePlan.h
 */
#ifndef smRibbonPlanner_h
#define smRibbonPlanner_h

#include "smGapSeries.h"
#include "smQuadratureBound.h"
#include "smQuadraturePlan.h"

#include <array>
#include <vector>

namespace sm
{
class RibbonPlanner
{
public:
  RibbonPlanner(const Face& face, const FacePanels& panels, const PlanRequest& request, FacePlan& plan);

  /// Appends the parts of a ribbon to the plan and adds their bounds, and those of the residuals of its
  /// curves.
  void Plan(std::uint32_t index);

private:
  using Majorants = GapSeries::Majorants;
  void PlanPart(std::uint32_t index, double start, double end, int depth);
  /// Fills Supremum and Shares. Returns false if any order meets all tolerances.
  bool FindShares(bool sound, const Majorants& real, double share);
  /// Fills AlongT by Shares, from ellipses.
  void BoundAlong(bool sound);
  /// Returns the lowest order that meets all tolerances; more than MaxOrder when none does.
  int ChooseOrder() const;
  void AddItem(const PlannedItem& item);
  /// Returns true if the part is narrower than the rounding bound of its evaluation. It is left out then,
  /// with the bound of its magnitude as its error, and its gap counts as 0.
  bool IsRounding(const Ribbon& ribbon, const Majorants& real) const;
  void Bound(const Majorants& majorants, std::vector<double>& bounds) const;
  void AddNoiseError(const Majorants& real);
  /// `sound`: the series have bounds, `real`.
  void AddResidualError(const Ribbon& ribbon, bool sound, const Majorants& real);

  const FacePanels& Panels;
  const PlanRequest& Request;
  FacePlan& Result;
  /// The coedges, counted through all loops of the face.
  std::vector<const Coedge*> Coedges;
  /// True if the panels have u and v exchanged, see smFacePanels.h.
  bool Transposed;

  /// True if a part of the current ribbon whose curves have a residual has no series with bounds.
  bool HasUnboundedResidual = false;
  // Values of the current part.
  GapSeries Gap;
  DirectionBound AlongT;
  std::vector<double> Bounds;
  std::vector<double> Supremum;
  std::vector<double> Shares;
};
}

#endif
