/**
 * @file smBuoyancyNames.h
 * @brief Names of all arrays in the outputs of vtkBuoyancy except those of smIntegralNames.h
 */
#ifndef smBuoyancyNames_h
#define smBuoyancyNames_h

#include "smIntegralNames.h" // names common to all filters over surface integrals

namespace sm
{
namespace names
{
constexpr const char* DisplacedVolume = "DisplacedVolume"; // 1, L^3, with bound
constexpr const char* DisplacedFirstMoments =
  "DisplacedFirstMoments";                                   // 3, L^4, about the world origin, with bound
constexpr const char* CenterOfBuoyancy = "CenterOfBuoyancy"; // 3, L, with bound
}
}

#endif
