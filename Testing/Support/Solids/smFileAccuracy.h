/**
 * @file smFileAccuracy.h
 * @brief How far a file can be from the solid that it was written for: the allowance of the value tests
 */
#ifndef smFileAccuracy_h
#define smFileAccuracy_h

#include "smExactSolids.h"

namespace smtest
{
struct FileAccuracy
{
  double Volume = 0;
  double Area = 0;
  double Center = 0;
  double Inertia = 0;
};

/// Largest change of the moments when the boundary is displaced by at most `displacement`.
FileAccuracy GetFileAccuracy(const ExactMoments& moments, double size, double displacement);

/// Bound of the displacement by OCCT's format of 12 digits.
double GetShortFormatDisplacement(const ExactMoments& moments, double size);

/// Bound of the displacement by moving `original` (OCCT rounds, above all far from the origin) and writing 17
/// digits. Measured at the poles and vertices of `moved`; where surfaces have no poles their rounding is
/// estimated.
double GetDisplacement(const TopoDS_Shape& original, const TopoDS_Shape& moved, const Placement& placement,
  const ExactMoments& moments, double size);
}

#endif
