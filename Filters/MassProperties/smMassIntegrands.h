/**
 * @file smMassIntegrands.h
 * @brief Integrands of the mass properties: ten moments, the vector area and the area
 */
#ifndef smMassIntegrands_h
#define smMassIntegrands_h

#include "smFiltersMassPropertiesModule.h"
#include "smIntegrand.h"

#include <vector>

namespace sm
{
/// Order of the integrands: volume, three first, six second moments (XX YY ZZ XY YZ XZ), vector area, area.
enum MassIntegrand
{
  MassVolume = 0,
  MassFirst = 1,
  MassSecond = 4,
  MassVectorArea = 10,
  MassArea = 13,
  NumberOfMassIntegrands = 14
};

/// Returns the integrands in the order of MassIntegrand, about the origin of each part.
SMFILTERSMASSPROPERTIES_EXPORT const std::vector<Integrand>& GetMassIntegrands();
}

#endif
