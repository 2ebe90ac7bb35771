/**
 * @file smBuoyancyNames.h
 * @brief The names of every array that vtkBuoyancy puts out, beside those of smIntegralNames.h
 */
#ifndef smBuoyancyNames_h
#define smBuoyancyNames_h

#include "smIntegralNames.h" // what all filters over surface integrals put out

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
