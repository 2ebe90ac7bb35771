/**
 * @file smMassTolerance.h
 * @brief Tolerances of volume, area, centre and inertia, their distribution to the integrals, and the
 * comparison with bounds
 */
#ifndef smMassTolerance_h
#define smMassTolerance_h

#include "smFiltersMassPropertiesModule.h"
#include "smMassIntegrands.h"
#include "smMassTable.h"

#include <string>
#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
/// A bound meets the tolerance if it is at most the larger of the relative and the absolute tolerance.
struct Tolerance
{
  /// Tolerance relative to the quantity's scale: V, A, the larger of half the body's diagonal and the cube
  /// root of V for the centre, the trace of the inertia.
  double Relative = 1e-9;
  /// Absolute tolerance in the quantity's unit.
  double Absolute = 0.0;

  double Get(double scale) const
  {
    return this->Relative * scale > this->Absolute ? this->Relative * scale : this->Absolute;
  }
};

/// Tolerances of all mass properties.
struct MassTolerance
{
  Tolerance Volume;
  Tolerance Area;
  Tolerance Center;
  Tolerance Inertia;
};

/// Returns absolute tolerances of the integrands about the part's own origin such that the derived quantities
/// meet their tolerances. They depend only on the model's fixed scales, not on results. The centre's share
/// follows from the cube root of V alone: the same for a part and its longer relatives, and never more than
/// FindUnmet() permits.
SMFILTERSMASSPROPERTIES_EXPORT std::vector<double> ShareTolerance(
  const MassTolerance& tolerance, vtkTrimmedNURBSModel& model);

/// Returns the names of the quantities that do not meet their tolerance, with their relative bounds; empty if
/// all meet it. A quantity that does not exist meets its tolerance. `radius`: half the diagonal of the body.
SMFILTERSMASSPROPERTIES_EXPORT std::string FindUnmet(
  const MassRow& row, const MassTolerance& tolerance, double radius);
}

#endif
