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
double GetIntegrandChange(
  const BoundClass& c, double moved, double rotated, double normal, double reach, double basis);

/// The changes of the integrands of all classes where points move by `moved` and derivatives by `slope`, if
/// the patch has the radius and derivatives of at most `stretch`; without the Jacobian. `basis`: see above.
void FillIntegrandChange(const Patch& patch, const PlanRequest& request, double moved, const double slope[2],
  double radius, const double stretch[2], double basis, std::vector<double>& change);

/// The centre of a patch as seen from the point that moments are about.
std::array<double, 3> GetOrigin(const Patch& patch, const PlanRequest& request);

struct PatchSeries
{
  /// Control points of the patch with poles made points; bounds of the change of points and derivatives; and
  /// bounds of the change of the integrands on the patch, without the Jacobian, empty where nothing was
  /// changed.
  std::vector<std::array<double, 4>> Points;
  double Moved = 0.0;
  /// True if that is of the size of rounding, so that the series hold everywhere.
  bool IsCertain = false;
  std::vector<double> Change;
  PatchTraits Traits;
  PatchMajorants Whole;
  /// The box of the series.
  ParameterBox Box;
};

/// The series of a face's patches. Thread safe.
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
  struct Entry
  {
    std::once_flag Once;
    std::unique_ptr<PatchSeries> Series;
  };
  std::unique_ptr<PatchSeries> Make(const Patch& patch, Poles poles, bool withForm) const;

  const FacePanels& Panels;
  const PlanRequest& Request;
  /// For every patch, by `poles` and `withForm`.
  std::vector<std::array<Entry, 4>> Entries;
};
}

#endif
