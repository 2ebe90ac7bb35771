/**
 * @file smMassSensitivity.h
 * @brief Derivatives of mass properties by an offset of one face along its normals
 */
#ifndef smMassSensitivity_h
#define smMassSensitivity_h

#include "smFiltersMassPropertiesModule.h"
#include "smIntegrand.h"
#include "smMassTable.h"
#include "smVector.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
struct BodyIntegrals;

struct OffsetGeometry;

/// Moments of the area of a face about the centre of its body, in axes of the world, with one bound for all
/// of each order.
struct AreaMoments
{
  double Area = 0.0;
  double AreaBound = 0.0;
  Vector3 First{};
  double FirstBound = 0.0;
  std::array<std::array<double, 3>, 3> Second{};
  double SecondBound = 0.0;

  /// Changes the point that the moments refer to by `way`.
  void Move(const Vector3& way);
};

/// Derivatives per unit of length of a solid's volume, mass, area, centre and principal moments, with bounds
/// of their numerical errors; NaN where they do not exist or are not known.
struct SMFILTERSMASSPROPERTIES_EXPORT FaceSensitivity
{
  double Volume, VolumeBound;
  double Mass, MassBound;
  double Area, AreaBound;
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

/// Returns whether the area moments of a face about its body's centre are known: the body has a volume, and
/// the face was integrated.
bool HasAreaMoments(const BodyIntegrals& body, const MassRow& row, std::size_t face);
/// Returns those moments.
AreaMoments GetAreaMoments(const BodyIntegrals& body, const MassRow& row, std::size_t face);

/// Returns the derivatives of principal moments by an offset of a face with these moments, and a bound of
/// their errors; NaN where moments coincide.
std::array<double, 3> GetPrincipalSlopes(
  const MassProperties& properties, const AreaMoments& area, double& bound);

/// The geometry of offsets of bodies with a volume; instances of a model share it.
class SMFILTERSMASSPROPERTIES_EXPORT BodyOffsets
{
public:
  /// Where `shouldContinue` returns false nothing is known of the bodies that are left.
  explicit BodyOffsets(
    const std::vector<BodyIntegrals>& bodies, const std::function<bool()>& shouldContinue = nullptr);
  const OffsetGeometry& Get(std::size_t body) const { return *this->Geometries[body]; }

private:
  std::vector<std::shared_ptr<const OffsetGeometry>> Geometries;
};

/// Returns the derivatives by an outward offset of a face of a body, whose integrals are those above and
/// whose mass properties are `row`.
SMFILTERSMASSPROPERTIES_EXPORT FaceSensitivity ComputeSensitivity(
  const BodyIntegrals& body, const MassRow& row, const OffsetGeometry& geometry, std::size_t face);
}

#endif
