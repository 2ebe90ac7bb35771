/**
 * @file smMassTolerance.h
 * @brief Tolerances of volume, area, centre and inertia: shared out to the integrals, and compared with their bounds
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
/// A bound meets its tolerance when it is at most the larger of the two.
struct Tolerance
{
  /// Of the quantity's scale: V, A, the cube root of V for the centre, the trace of the inertia.
  double Relative = 1e-9;
  /// In the quantity's unit.
  double Absolute = 0.0;

  double Get(double scale) const
  {
    return this->Relative * scale > this->Absolute ? this->Relative * scale : this->Absolute;
  }
};

struct MassTolerance
{
  Tolerance Volume;
  Tolerance Area;
  Tolerance Center;
  Tolerance Inertia;
};

/// Absolute tolerances of the integrands about the part's own origin, such that the derived quantities meet theirs. They depend
/// on the model's fixed scales only, not on results.
SMFILTERSMASSPROPERTIES_EXPORT std::vector<double> ShareTolerance(
  const MassTolerance& tolerance, vtkTrimmedNURBSModel& model);

/// What did not meet its tolerance and by how much, relative; empty when everything did. A quantity that does not exist did.
SMFILTERSMASSPROPERTIES_EXPORT std::string FindUnmet(const MassRow& row, const MassTolerance& tolerance);
}

#endif
