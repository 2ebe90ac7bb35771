/**
 * @file smRibbonPlanner.h
 * @brief Plans the ribbons of a face, see smQuadraturePlan.h
 *
 * A ribbon X = (1-l) A + l C with A = P/w along the trim curve, C the edge's curve, G = C - A and k = 1 - l has
 *
 *     x.n = det(C, G, C') - k det(C, G, G'),     n = G x (C' - k G').
 *
 * G = U/w with the polynomial U = C w - P, which is small where the gap is small. Its Chebyshev coefficients are sampled,
 * so that the bound, too, is as small as the gap; l is integrated exactly.
 */
#ifndef smRibbonPlanner_h
#define smRibbonPlanner_h

#include "smPatchMajorants.h"
#include "smQuadratureBound.h"
#include "smQuadraturePlan.h"
#include "smTrimSeries.h"

#include <array>
#include <vector>

namespace sm
{
class RibbonPlanner
{
public:
  /// The gap is a difference of two nearly equal curves: it is sampled in extended precision.
  using Wide = long double;

  RibbonPlanner(const Face& face, const FacePanels& panels, const PlanRequest& request, FacePlan& plan);

  /// Appends the parts of a ribbon to the plan and adds their bounds, and those of the residuals of its curves.
  void Plan(std::uint32_t index);

private:
  /// Upper bounds along the part in an ellipse of t.
  struct Majorants
  {
    double Curve, CurveSlope, Gap, GapSlope, Weight;
  };
  void PlanPart(std::uint32_t index, double start, double end, int depth);
  /// Fills AlongT and Supremum from real t and from ellipses.
  void BoundAlong(bool sound, const Majorants& real);
  /// The least order that all tolerances allow; above LargestOrder when none does.
  int ChooseOrder(double share) const;
  void AddItem(const PlannedItem& item);
  void ExpandEdge(const Ribbon& ribbon, double start, double end);
  /// Nodes that determine U and w, and a bound of the remainder.
  int ChooseNodes(const Ribbon& ribbon, double& tail);
  void SampleGap(const Ribbon& ribbon, double start, double end, int nodes, double tail);
  /// Stretch, TrimSlope and NormalLength from a patch's values at node x.
  void SampleTangents(double x, const Wide values[3][4]);
  /// The part is narrower than the rounding bound of its evaluation: its largest size is the better bound, and it
  /// is left out. Its gap counts as none.
  bool IsRounding(const Ribbon& ribbon, const Majorants& real) const;
  bool Evaluate(const Ellipse& t, Majorants& majorants) const;
  void Bound(const Majorants& majorants, std::vector<double>& bounds) const;
  void AddNoiseError(const Majorants& real);
  void AddResidualError(const Ribbon& ribbon, const Majorants& real);

  const FacePanels& Panels;
  const PlanRequest& Request;
  FacePlan& Result;
  /// Residuals of the trim curve, in u and v of the panels, and of the edge curve, per coedge.
  struct Residual
  {
    std::array<double, 2> Trim;
    double Edge;
  };
  std::vector<Residual> Residuals;

  // Values of the current part: series in t on [-1,1].
  TrimSeries Trim;
  PatchMajorants Crude;
  DirectionBound AlongT;
  std::vector<std::array<double, 3>> Curve;
  std::vector<std::array<double, 4>> Gap;
  double CurveDistance = 0.0;
  /// Bound of the remainder that the series of U lack, and the number of nodes.
  double Noise = 0.0;
  /// The nodes leave more of U than rounding does.
  bool Rough = false;
  int Nodes = 0;
  /// Largest values at the nodes: |Ss|, |Sr|, |Ss x Sr|, |ds/dt|, |dr/dt|.
  std::array<double, 2> Stretch{};
  double NormalLength = 0.0;
  std::array<double, 2> TrimSlope{};
  std::vector<double> Samples;
  std::vector<double> Bounds;
  std::vector<double> Supremum;
  mutable std::vector<double> Powers;
};
}

#endif
