/**
 * @file smPanelPlanner.h
 * @brief Plans the panels of a face, see smQuadraturePlan.h
 */
#ifndef smPanelPlanner_h
#define smPanelPlanner_h

#include "smPatchMajorants.h"
#include "smQuadratureBound.h"
#include "smQuadraturePlan.h"
#include "smTrimSeries.h"

#include <vector>

namespace sm
{
/// More points than this cost more than bisecting.
constexpr int LargestOrder = 20;

class PanelPlanner
{
public:
  PanelPlanner(const FacePanels& panels, const PlanRequest& request, FacePlan& plan);

  /// Appends the parts of a panel to the plan and adds their bounds.
  void Plan(std::uint32_t index);

  /// Largest distance from the point that moments are about, over the patches planned so far.
  double GetReach() const { return this->Reach; }

private:
  struct Part
  {
    double Start, End, XiStart, XiEnd;
    int Depth;
  };
  const PatchTraits& GetTraits(std::uint32_t patch);
  bool PlanExactly(std::uint32_t index);
  /// Adds the error of exact orders for what a flat patch deviates from a parallelogram.
  void AddFlatError(const Patch& patch, double reach);
  void PlanPart(std::uint32_t index, const Part& part);
  void BoundDirections(const Panel& panel, const Part& part, double jacobian);
  void SetPolynomialOrders(const Patch& patch);
  /// False when larger ellipses will not ask for fewer points.
  bool MayImprove(const DirectionBound& direction, double share);
  bool FindOrders(double share, bool withArea, int& along, int& across) const;
  double GetError(std::size_t integrand, int along, int across) const;
  bool IsSmall(double kink, double share) const;
  void AddEndError(const Panel& panel, const Part& part);
  int ChooseDirection(const Part& part, double share) const;
  void Keep(std::uint32_t index, const Part& part, int along, int across, bool compared, double noise);

  const FacePanels& Panels;
  const PlanRequest& Request;
  FacePlan& Result;
  int Degree = 0;
  double Reach = 0.0;
  std::vector<PatchTraits> Traits;
  std::vector<bool> HasTraits;
  std::vector<Part> Pending;
  std::size_t Parts = 0;

  // Values of the current part.
  TrimSeries Trim;
  PatchMajorants Majorants;
  DirectionBound AlongT;
  DirectionBound AcrossXi;
  std::vector<double> Supremum;
  std::vector<double> Bounds;
  /// Fewest points so far, per class.
  std::vector<int> Best;
};
}

#endif
