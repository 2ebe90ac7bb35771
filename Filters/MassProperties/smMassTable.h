/**
 * @file smMassTable.h
 * @brief The columns that describe the mass properties of a body or of all bodies, and their summary as text
 */
#ifndef smMassTable_h
#define smMassTable_h

#include "smColumns.h"
#include "smMoments.h"

#include <string>
#include <vector>

class vtkFieldData;

namespace sm
{
/// Everything that is put out for one body, or for the total.
struct MassRow
{
  MassProperties Properties;
  double Area;
  double AreaBound;
  /// NaN without a density.
  double Mass;
  double MassBound;
  std::array<double, 9> MassInertia;
  double MassInertiaBound;
  double MovedByClosing;
  double GapSquared;
  double MaxGap;
  double GapArea;
  double Leak;

  /// Everything NaN.
  MassRow();
};

/// Appends rows to arrays named as in smMassPropertyNames.h and hands them to field data or a table.
class MassColumns
{
public:
  explicit MassColumns(bool withMass);
  void Append(const MassRow& row);
  void AddTo(vtkFieldData* data) const;

private:
  std::vector<columns::Column> Columns;
  bool WithMass;
};

/// Metres in a length unit as the reader names it ("mm", "inch", …); 0 when it is not known.
double GetMetres(const std::string& lengthUnit);

/// A bound with one digit, rounded up; "not known" for what is not finite, here and below.
std::string FormatBound(double bound);
/// A value with no more digits than its bound leaves; 0 within its bound.
std::string FormatNumber(double value, double bound);
/// Value, unit and bound.
std::string FormatWithBound(double value, double bound, const std::string& unit);

/// A few lines: status, unless it is ok, with the reason, if any, in lines of at most 64 characters; number of solids, volume, area,
/// centre, principal moments, mass.
std::string FormatSummary(const MassRow& total, const std::string& status, const std::string& reason,
  const std::string& unit, int solids);
}

#endif
