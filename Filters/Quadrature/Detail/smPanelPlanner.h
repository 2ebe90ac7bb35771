/**
 * @file smPanelPlanner.h
 * @brief Plans the panels of a face, see smQuadraturePlan.h
 */
#ifndef smPanelPlanner_h
#define smPanelPlanner_h

#include "smPanelBounds.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sm
{
class PanelPlanner
{
public:
  PanelPlanner(const FacePanels& panels, const PlanRequest& request, FaceSeries& series, FacePlan& plan);

  /// Appends the parts of a panel to the plan and adds their bounds.
  void Plan(std::uint32_t index);

  /// Largest distance from the point that moments are about, over the patches planned so far.
  double GetReach() const { return std::max(this->FlatReach, this->Bounds.GetReach()); }

private:
  bool PlanExactly(std::uint32_t index);
  /// Plans a panel in as many parts as its bounds ask for.
  void PlanInParts(std::uint32_t index);
  /// Adds the error of exact orders for what a flat patch deviates from a parallelogram.
  void AddFlatError(const Panel& panel, const double extent[2], double reach);
  /// Plans a panel by the series of its patch. Returns false if their bounds do not suffice. `withForm`: |n|
  /// may be taken for a polynomial.
  bool PlanByPatch(std::uint32_t index, const PanelPart& part, bool withForm);
  /// The same by the series of a strip of the patch.
  bool PlanByStrip(std::uint32_t index, const PanelPart& part);
  /// Keeps a panel with the current bounds if they suffice.
  bool KeepIfSmall(std::uint32_t index, const PanelPart& part);
  void PlanPart(std::uint32_t index, const PanelPart& part);
  /// Bound of the errors of the area that the series do not contain: rounding, the kinks of collapsed edges,
  /// and the deviation of a nearly constant normal.
  double GetNoise(const Panel& panel, double kink) const;
  bool FindOrders(double share, bool withArea, int& along, int& across) const;
  bool IsSmall(double kink, double share) const;
  /// Bounds of the error of an area's derivative because tangents, and the normal's direction, are not those
  /// of the series: where edges were made points, and where |n| is nearly a polynomial. 0 for other
  /// integrands.
  struct DirectionError
  {
    double OfTangents = 0.0;
    double OfDirection = 0.0;
  };
  DirectionError GetDirectionError(std::size_t integrand);
  /// Bound of the error of a rule.
  double GetError(std::size_t integrand, int along, int across);
  bool IsDirectionSmall(double share);
  /// True if the bound of a rule's error is a small part of the integral of the largest values, for each of
  /// an area's derivatives.
  bool ConvergesInArea(int along, int across) const;
  void AddEndError(const Panel& panel, const PanelPart& part);
  int ChooseDirection(const PanelPart& part) const;
  /// Adds a part with these orders; `compared`: the error of its area is estimated by comparing orders where
  /// its bounds permit that.
  void Keep(std::uint32_t index, const PanelPart& part, int along, int across, bool compared, double noise);

  const FacePanels& Panels;
  const PlanRequest& Request;
  FacePlan& Result;
  /// Highest degree of the factors g, across a straight panel and along a flat one.
  int Degree;
  int FlatDegree;
  double FlatReach = 0.0;
  PanelBounds Bounds;
  const FaceSeries& Series;
  std::vector<PanelPart> Pending;
  std::size_t Parts = 0;
  /// Number of the parts at the depth that is planned now.
  std::size_t Abreast = 0;
  std::vector<double> Dropped;
};
}

#endif
