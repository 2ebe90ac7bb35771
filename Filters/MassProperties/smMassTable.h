/**
 * @file smMassTable.h
 * @brief The columns that describe the mass properties of a body or of all bodies, and their summary as text
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
/// Everything that is put out for one body, or for the total.
struct SMFILTERSMASSPROPERTIES_EXPORT MassRow
{
  MassProperties Properties;
  double Area;
  double AreaBound;
  /// NaN without a density.
  double Mass;
  double MassBound;
  std::array<double, 9> MassInertia;
  double MassInertiaBound;
  double ClosureCorrection;
  double GapSquared;
  double MaxGap;
  double GapArea;
  double ClosureResidual;

  /// Everything NaN.
  MassRow();
  /// Makes every bound NaN.
  void RemoveBounds();
};

/// Appends rows to arrays named as in smMassPropertyNames.h and hands them to field data or a table.
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

/// A few lines: status, unless it is ok, with the reason, if any, in lines of at most 64 characters; number of solids, volume, area,
/// centre, principal moments, mass.
SMFILTERSMASSPROPERTIES_EXPORT std::string FormatSummary(const MassRow& total, const std::string& status,
  const std::string& reason, const std::string& unit, int solids);
}

#endif
