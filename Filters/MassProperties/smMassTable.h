/**
 * @file smMassTable.h
 * @brief Columns of the mass properties of a body or of all bodies, and their summary as text
 */
#ifndef smMassTable_h
#define smMassTable_h

#include "smColumns.h"
#include "smFiltersMassPropertiesModule.h"
#include "smLengthUnits.h"
#include "smMoments.h"

#include <string>
#include <vector>

class vtkFieldData;

namespace sm
{
/// All values that are written for one body, or for the total.
struct SMFILTERSMASSPROPERTIES_EXPORT MassRow
{
  MassProperties Properties;
  double Area;
  double AreaBound;
  /// Mass and its inertia; NaN without a density.
  double Mass;
  double MassBound;
  std::array<double, 9> MassInertia;
  double MassInertiaBound;
  double ClosureCorrection;
  double GapSquared;
  double MaxGap;
  double GapArea;
  double ClosureResidual;

  /// Sets all values to NaN.
  MassRow();
  /// Sets all bounds to NaN.
  void RemoveBounds();
};

/// Appends rows to arrays named as in smMassPropertyNames.h, and adds these to field data or to a table.
class SMFILTERSMASSPROPERTIES_EXPORT MassColumns
{
public:
  explicit MassColumns(bool withMass);
  void Append(const MassRow& row);
  void AddTo(vtkFieldData* data) const;

private:
  std::vector<columns::Column> Columns;
  bool WithMass;
};

/// Returns a summary in a few lines: the status with its reason, unless the status is ok, in lines of at most 64 characters; the
/// number of solids, volume, area, centre, principal moments and mass.
SMFILTERSMASSPROPERTIES_EXPORT std::string FormatSummary(const MassRow& total, const std::string& status,
  const std::string& reason, const std::string& unit, int solids);
}

#endif
