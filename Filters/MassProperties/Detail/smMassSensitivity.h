/**
 * @file smMassSensitivity.h
 * @brief Derivatives of mass properties by an offset of one face along its normals
 */
#ifndef smMassSensitivity_h
#define smMassSensitivity_h

#include "smFiltersMassPropertiesModule.h"
#include "smIntegrand.h"
#include "smMassTable.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
struct BodyIntegrals;

/// Derivatives per unit of length of a solid's volume, mass, centre and principal moments, with bounds of
/// their numerical errors; NaN where they do not exist or are not known.
struct SMFILTERSMASSPROPERTIES_EXPORT FaceSensitivity
{
  double Volume, VolumeBound;
  double Mass, MassBound;
  std::array<double, 3> Center;
  double CenterBound;
  std::array<double, 3> Principal;
  double PrincipalBound;

  /// Sets all values to NaN.
  FaceSensitivity();
};

/// Returns the integrands of the mass properties, and after them the first and second moments of the area in
/// the order of MassIntegrand.
SMFILTERSMASSPROPERTIES_EXPORT const std::vector<Integrand>& GetSensitivityIntegrands();

/// Returns tolerances of those integrands from the ones of the mass properties.
SMFILTERSMASSPROPERTIES_EXPORT std::vector<double> AddAreaTolerances(
  std::vector<double> tolerances, vtkTrimmedNURBSModel& model);

/// Returns the derivatives by an outward offset of a face of a body, whose integrals are those above and
/// whose mass properties are `row`.
SMFILTERSMASSPROPERTIES_EXPORT FaceSensitivity ComputeSensitivity(
  const BodyIntegrals& body, const MassRow& row, std::size_t face);
}

#endif
