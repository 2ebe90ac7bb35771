/**
 * @file smQuadraturePlan.h
 * @brief The Gauss orders of a face's panels and ribbons, chosen by a proved bound before a point is
 * evaluated
 *
 * See Bounds.md. Every panel and ribbon gets the fewest points whose bound is within its share of the face's
 * tolerances; where more than MaxOrder would be needed it is bisected. The bounds of all items add up to
 * the face's, so nothing has to be evaluated twice. Where the bound of the area cannot hold, because normals
 * nearly vanish, a panel that has been bisected often enough is to be evaluated at two orders and compared:
 * the face is then `estimated`.
 */
#ifndef smQuadraturePlan_h
#define smQuadraturePlan_h

#include "Detail/smHullBound.h"
#include "Detail/smReadingError.h"
#include "smFacePanels.h"
#include "smFiltersQuadratureModule.h"
#include "smPatchMajorants.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace sm
{
/// Largest number of Gauss points in one direction; where more would be needed, bisecting costs less.
constexpr int MaxOrder = 20;

enum class ItemKind
{
  Panel = 0,
  Ribbon = 1,
  Cap = 2
};

/// One work item with its orders.
struct PlannedItem
{
  ItemKind Kind;
  /// Index into the face's panels, ribbons or caps.
  std::uint32_t Index;
  /// Parts of the item's range of t, and of xi (a panel's), as fractions of it.
  double Start = 0.0, End = 1.0;
  double XiStart = 0.0, XiEnd = 1.0;
  /// Gauss points along t, and across.
  int Along = 1;
  int Across = 1;
  /// The fraction of the face's tolerances that this item may use, if it is compared.
  double Share = 1.0;
  /// True if the item is evaluated again with twice the points and the results are compared, because its area
  /// has no bound.
  bool Compared = false;
};

struct FacePlan
{
  std::vector<PlannedItem> Items;
  /// One number for each class of integrands (BoundClass): bound of the quadrature error of all items; where
  /// items are compared the area's is not in it.
  std::vector<double> QuadratureBound;
  /// Per class: bound of the error from residuals of trim curves, edge curves and surface, and rounding of
  /// control points.
  std::vector<double> ConversionBound;
  /// The part of ConversionBound that comes from residuals of curves and surfaces, which are measured, not
  /// proved (Bounds.md, 3).
  std::vector<double> ResidualBound;
  /// Per class: bound of the integral's magnitude, panels, ribbons and caps together, for a face that is not
  /// evaluated.
  std::vector<double> Magnitude;
  /// True if Magnitude counts a panel or ribbon by its hull, because no ellipse gave as small a bound:
  /// weights differ by orders of magnitude. Then the quadrature's bound may be larger than Magnitude, and
  /// useless.
  bool IsLimitedByHull = false;
  /// True if the bounds of all moments are useless: nothing but the ribbons and caps, which measure gaps, is
  /// evaluated.
  bool IsLeftOut = false;
  /// Bound of the face's area that is known before anything is evaluated.
  double Area = 0.0;
  /// Error of reading, which is added to ConversionBound once the face's area is known.
  ReadingError Reading;
  /// Points of all items, caps aside.
  std::int64_t Evaluations = 0;
  /// True if the area of an item is compared, or if the surface is a fit whose normals have no bound: the
  /// bounds of areas are estimates.
  bool Estimated = false;

  /// Limits what was added to Magnitude, which was `before`, by that of a hull.
  void LimitMagnitude(
    const std::vector<double>& before, const std::vector<BoundClass>& classes, const HullBound& hull);
};

struct PlanRequest
{
  std::vector<BoundClass> Classes;
  /// Absolute tolerance per class for the face; not positive: no requirement.
  std::vector<double> Tolerances;
  /// Position relative to the point that moments are about, minus that in model coordinates, rotated back by
  /// the placement: zero without one.
  std::array<double, 3> Shift{};
  /// Points that integrate the flat directions of ribbons and caps exactly.
  int StripPoints = 3;

  bool operator==(const PlanRequest& other) const
  {
    return this->Classes == other.Classes && this->Tolerances == other.Tolerances &&
      this->Shift == other.Shift && this->StripPoints == other.StripPoints;
  }
};

/// Residuals and orders come from `face`, everything else from its panels. Thread safe.
SMFILTERSQUADRATURE_EXPORT FacePlan PlanFace(
  const Face& face, const FacePanels& panels, const PlanRequest& request);

class FaceSeries;

/// PlanFace() in portions, for threads: they are planned in any order, then joined. The division into
/// portions depends on the panels alone, so the plan has the same bits with any number of threads.
class SMFILTERSQUADRATURE_EXPORT FacePlanner
{
public:
  /// Nothing is copied.
  FacePlanner(const Face& face, const FacePanels& panels, const PlanRequest& request);
  ~FacePlanner();

  std::size_t GetNumberOfPortions() const { return this->Portions.size(); }
  /// To be called once for every portion. Thread safe.
  void PlanPortion(std::size_t portion);
  /// To be called when all portions are planned.
  FacePlan Join() const;

private:
  struct Portion
  {
    FacePlan Plan;
    double Reach = 0.0;
  };

  const Face& Source;
  const FacePanels& Panels;
  const PlanRequest& Request;
  /// The request for one item.
  PlanRequest Shares;
  /// Released when all panels are planned.
  std::unique_ptr<FaceSeries> Series;
  std::atomic<std::size_t> PanelPortionsLeft;
  std::vector<Portion> Portions;
};
}

#endif
