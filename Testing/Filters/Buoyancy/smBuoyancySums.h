/**
 * @file smBuoyancySums.h
 * @brief A check that the parts below and above a plane are the whole
 */
#ifndef smBuoyancySums_h
#define smBuoyancySums_h

#include "smBuoyancyTesting.h"

#include <string>
#include <vector>

namespace smtest
{
/// Volume and first moments below and above a plane through the centre of mass, for each upward direction and
/// two tolerances, against those of the whole; with `withFaces` also face by face, where there is one solid.
void CheckBelowAndAbove(
  vtkSTEPReader* reader, const std::string& what, const std::vector<Vector>& directions, bool withFaces);
}

#endif
