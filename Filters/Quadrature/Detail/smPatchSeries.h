/**
 * @file smPatchSeries.h
 * @brief The series of whole patches, which all panels of a patch share, computed when they are first asked
 * for
 */
#ifndef smPatchSeries_h
#define smPatchSeries_h

#include "smPatchMajorants.h"
#include "smQuadraturePlan.h"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace sm
{
/// The largest change of an integrand where points move by `moved` and normals by `rotated`; normals are at
/// most `normal` long, points no farther than `reach`, and Bernstein polynomials over the weight `basis`.
/// 0 for AreaBasis, see PanelPlanner::GetDirectionError().
double GetIntegrandChange(
  const BoundClass& c, double moved, double rotated, double normal, double reach, double basis);

/// Bounds of what changes because edges that are nearly points were made points.
struct PatchChange
{
  /// Of points, of derivatives in s and r, and of normals.
  double Moved = 0.0;
  double Slope[2] = { 0.0, 0.0 };
  double Rotated = 0.0;
  /// The Bernstein polynomials' absolute values over the weight.
  double Basis = 0.0;
  /// Of the integrands of all classes, without the Jacobian, see GetIntegrandChange(); empty where nothing
  /// was changed.
  std::vector<double> Integrands;
};

/// The changes where points move by `moved` and derivatives by `slope`, if the patch has the radius and
/// derivatives of at most `stretch`. `basis`: PatchChange::Basis.
PatchChange MakePatchChange(const Patch& patch, const PlanRequest& request, double moved,
  const double slope[2], double radius, const double stretch[2], double basis);

/// The centre of a patch as seen from the point that moments are about.
std::array<double, 3> GetOrigin(const Patch& patch, const PlanRequest& request);

struct PatchSeries;

/// Series on strips of the box of a patch's series, of its whole extent in s and a part in r, for panels that
/// the series of the box does not suffice for. At a level strips are a fraction of the box wide, and begin at
/// multiples of half of that, so that each shorter interval lies in one. Thread safe.
class PatchStrips
{
public:
  /// A strip that contains the box, as narrow as strips are; null where the box is too wide, or beyond that
  /// of the series, or series of a panel's own take less time than finding out.
  const PatchMajorants* Find(const PatchSeries& series, const Patch& patch, const PlanRequest& request,
    const ParameterBox& box, ParameterBox& ofStrip) const;

private:
  static constexpr int Levels = 4;
  struct Strip
  {
    std::once_flag Once;
    std::unique_ptr<PatchMajorants> Majorants;
  };
  mutable std::once_flag Once;
  mutable std::vector<Strip> Strips;
};

struct PatchSeries
{
  /// Control points of the patch with poles made points; a bound of the change of points and derivatives; and
  /// what changes on the patch.
  std::vector<std::array<double, 4>> Points;
  double Moved = 0.0;
  /// True if that is of the size of rounding, so that the series hold everywhere.
  bool IsCertain = false;
  PatchChange Change;
  PatchTraits Traits;
  PatchMajorants Whole;
  /// The box of the series: of all panels of the patch, as far as they leave it by little.
  ParameterBox Box;
  PatchStrips Strips;
};

/// The series of a face's patches, each on the box of its panels. Thread safe.
class FaceSeries
{
public:
  /// Edges whose control points are nearly one point are made points, or only those that certainly are one.
  enum class Poles
  {
    Nearly,
    Certain
  };

  /// Neither is copied.
  FaceSeries(const FacePanels& panels, const PlanRequest& request);

  /// `withForm`: it is found out whether |m~| is a polynomial, which takes long where degrees are high.
  const PatchSeries& Get(std::uint32_t patch, Poles poles, bool withForm);
  /// Returns true where the form of |m~| takes less time than the points that it may save.
  bool HasCheapForm(std::uint32_t patch) const;

private:
  struct Lazy
  {
    std::once_flag Once;
    std::unique_ptr<PatchSeries> Series;
  };
  struct Entry
  {
    /// Of s and r, by all panels of the patch.
    std::array<double, 2> Ranges[2];
    /// By `poles` and `withForm`.
    std::array<Lazy, 4> Series;
  };
  std::unique_ptr<PatchSeries> Make(std::uint32_t index, Poles poles, bool withForm) const;

  const FacePanels& Panels;
  const PlanRequest& Request;
  std::vector<Entry> Entries;
};
}

#endif
