/**
 * @file smPanelBounds.h
 * @brief Bounds of the integrands on a part of a panel, along its trim curve and across, see Bounds.md
 *
 * A part can be bounded by three sets of series: those of its patch, which all panels of the patch share at
 * no further cost, those of a strip of it, which some share, and those of its own box, which give the
 * smallest bounds.
 */
#ifndef smPanelBounds_h
#define smPanelBounds_h

#include "smPatchSeries.h"
#include "smQuadratureBound.h"
#include "smQuadraturePlan.h"
#include "smTrimSeries.h"

#include <vector>

namespace sm
{
/// Ranges of t and xi as fractions of the panel's; the depth is the number of halvings.
struct PanelPart
{
  double Start = 0.0, End = 1.0, XiStart = 0.0, XiEnd = 1.0;
  int Depth = 0;
};

class PanelBounds
{
public:
  /// `degree`: highest degree of the factors g.
  PanelBounds(const FacePanels& panels, const PlanRequest& request, FaceSeries& series, int degree);

  /// Bounds a part by the series of its patch. Returns false if it leaves their box, or if |n| may have a
  /// zero there. `withForm`: |n| may be taken for a polynomial.
  bool ExpandByPatch(const Panel& panel, const PanelPart& part, bool withForm);
  /// The same by the series of a strip of the patch that other panels may share.
  bool ExpandByStrip(const Panel& panel, const PanelPart& part);
  /// Bounds a part by series of its own. `withForm`: |n| may be taken for a polynomial.
  void ExpandByPart(const Panel& panel, const PanelPart& part, bool withForm = true);

  const TrimSeries& GetTrim() const { return this->Trim; }
  const PatchMajorants& GetMajorants() const { return *this->Majorants; }
  const ParameterBox& GetBox() const { return this->Box; }
  /// True if derivatives of an area are among the integrands.
  bool NeedsDirection() const { return this->HasDirection; }
  /// The direction across a collapsed edge whose distance from the part is less than half the part's width: 0
  /// for s, 1 for r; -1 if there is none.
  int GetPoleDirection() const;
  const DirectionBound& GetAlongT() const { return this->AlongT; }
  const DirectionBound& GetAcrossXi() const { return this->AcrossXi; }
  /// Bounds of the modulus of each integrand's integral over the part, and of the Jacobian |s r'| there.
  double GetSupremum(std::size_t integrand) const { return this->Supremum[integrand]; }
  double GetJacobian() const { return this->Jacobian; }
  /// Bound of the error of a rule.
  double GetError(std::size_t integrand, int along, int across) const;
  /// Largest distance from the point that moments are about, over all parts so far.
  double GetReach() const { return this->Reach; }
  /// What changes on the part because edges that are nearly points were made points: the integrands differ by
  /// as much from those whose error is bounded.
  const PatchChange& GetChange();

private:
  const PatchSeries& GetSeries(const Panel& panel, const PanelPart& part, bool withForm);
  /// Returns true if the change of the integrands is within the part's share of the tolerances.
  bool Fits(const PatchSeries& series, const PanelPart& part) const;
  /// The changes where the part leaves the patch and points of it move by `moved`.
  PatchChange MakeChangeBeyond(const Patch& patch, double moved) const;
  void ExpandTrim(const Panel& panel, const PanelPart& part);
  void Bound(const Panel& panel, const PanelPart& part);
  void BoundAcross(const Panel& panel);
  /// Adds the bounds on the ellipses `s` and `r`, times `factor`, as those on the ellipse of a radius along a
  /// direction.
  EllipseGain AddEllipse(const Ellipse& s, const Ellipse& r, double factor, const EllipseRadius& radius,
    DirectionBound& direction);
  void BoundAlong(const PanelPart& part);
  void SetPolynomialOrders(const Patch& patch);
  /// An ellipse around the majorants' box that holds one around this part's.
  Ellipse Embed(const Ellipse& ellipse, int direction) const;

  const FacePanels& Panels;
  const PlanRequest& Request;
  int Degree;
  bool HasDirection;
  double Reach = 0.0;
  FaceSeries& Series;
  PatchMajorants OfPart;

  // Values of the current part.
  TrimSeries Trim;
  const Patch* PartPatch = nullptr;
  const PatchSeries* PartSeries = nullptr;
  PatchChange Change;
  ParameterBox Box{};
  const PatchMajorants* Majorants = nullptr;
  ParameterBox MajorantsBox{};
  bool IsPolynomial = false;
  double Jacobian = 0.0;
  DirectionBound AlongT;
  DirectionBound AcrossXi;
  std::vector<double> Supremum;
  std::vector<double> Shares;
  std::vector<double> Bounds;
};
}

#endif
