/**
 * @file smLengthUnits.h
 * @brief Length units by name
 */
#ifndef smLengthUnits_h
#define smLengthUnits_h

#include "smFiltersCommonModule.h"

#include <string>

namespace sm
{
/// Length of a unit in mm; 0 for a name that is not known. Accepts STEP's spellings ("millimetre") and short
/// ones ("mm"), in either case.
SMFILTERSCOMMON_EXPORT double GetUnitInMillimetres(const std::string& unit);

/// The same in m.
SMFILTERSCOMMON_EXPORT double GetMetres(const std::string& unit);

/// The short name of the unit of that length, among those that models are read and written in: mm, cm, m, um,
/// inch, ft. Empty for any other length.
SMFILTERSCOMMON_EXPORT std::string GetShortUnit(double millimetres);
}

#endif
