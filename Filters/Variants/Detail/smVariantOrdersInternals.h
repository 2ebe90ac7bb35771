/**
 * @file smVariantOrdersInternals.h
 * @brief What the orders and the rounding of a face share
 */
#ifndef smVariantOrdersInternals_h
#define smVariantOrdersInternals_h

#include "smUnitRoundoff.h"
#include "smVariantOrders.h"

#include <limits>

namespace sm
{
constexpr double NoBound = std::numeric_limits<double>::infinity();

/// Sizes of a piece of a trim curve in one direction, and what rounding makes of it. Coefficients have 2
/// roundings, de Casteljau's scheme 3 a level, and the parameter of a node 3, which count by the derivative.
struct TrimReach
{
  int Degree = 1;
  bool IsConstant[2] = { true, true };
  /// Largest coefficients, and their first and second differences.
  double Size[2] = { 0.0, 0.0 };
  double Step[2] = { 0.0, 0.0 };
  double Bend[2] = { 0.0, 0.0 };

  /// A bound of |ds/dt| or |dr/dt|.
  double GetSlope(int d) const { return this->Degree * this->Step[d]; }
  /// Bounds of the rounding of s (0) or r (1), and of the derivative on a range of this width.
  double GetError(int d) const
  {
    if (this->IsConstant[d])
    {
      return this->Size[d] == 0.0 || this->Size[d] == 1.0 ? 0.0 : 2.0 * UnitRoundoff * this->Size[d];
    }
    return UnitRoundoff * ((3.0 * this->Degree + 2.0) * this->Size[d] + 3.0 * this->GetSlope(d));
  }
  double GetSlopeError(int d, double width) const
  {
    if (this->IsConstant[d])
    {
      return 0.0;
    }
    return UnitRoundoff * width *
      (2.0 * this->Degree * (3.0 * this->Degree - 1.0) * this->Size[d] + 4.0 * this->GetSlope(d) +
        3.0 * this->Degree * (this->Degree - 1.0) * this->Bend[d]);
  }
};

TrimReach GetTrimReach(const double* local, int degree);

/// Sets the values of forms, without errors.
void SetBound(TangentForms<ErrorBound>& to, const TangentForms<double>& from);

/// Bounds for parameters in a pair of ellipses around the patch.
struct VariantOrders::Target
{
  double AxisS, AxisR;
  bool IsAcross;
  /// False where the weight may vanish.
  bool IsValid = false;
  TangentForms<double> Forms;
  double Size = NoBound;
  /// The sum of the items' factors of the flux's bound.
  double Factor = 0.0;
};

struct VariantOrders::PatchState
{
  explicit PatchState(const VariantPatch& patch)
    : Source(patch)
  {
  }
  const VariantPatch& Source;
  double Outside[2] = { 0.0, 0.0 };
  bool IsReady = false;
  std::vector<Target> Targets;
  /// The target for the effect of moving samples: the smallest bound over its distance from the patch.
  const Target* Near = nullptr;
  double NearDistance = 0.0;
  /// Sums over the panels: of the absolute weights of samples, and of the errors of their parameters.
  double Weight = 0.0;
  double ParameterError = 0.0;
  TangentForms<ErrorBound> Local;
};
}

#endif
