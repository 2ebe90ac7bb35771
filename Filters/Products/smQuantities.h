/**
 * @file smQuantities.h
 * @brief The outputs of vtkMassPropertiesGPU as typed results; not installed
 *
 * `data` is the field data of port 0 (row 0) or the columns of a table. A value that is missing or not finite
 * is not known.
 */
#ifndef smQuantities_h
#define smQuantities_h

#include "smFields.h"
#include "smFiltersProductsModule.h"

#include "vtkType.h"

#include <functional>
#include <string>

class vtkFieldData;

namespace sm
{
/// Copies the components of a row; NaN in all of them if the array is missing, has another number of
/// components, or one is not finite.
SMFILTERSPRODUCTS_EXPORT void ReadNumbers(
  vtkFieldData* data, vtkIdType row, const std::string& name, double* values, int components);
SMFILTERSPRODUCTS_EXPORT double GetNumber(vtkFieldData* data, vtkIdType row, const std::string& name);
SMFILTERSPRODUCTS_EXPORT std::array<double, 3> GetPoint(
  vtkFieldData* data, vtkIdType row, const std::string& name);
/// Returns a whole number; -1 if it is not known.
SMFILTERSPRODUCTS_EXPORT long long GetCount(vtkFieldData* data, vtkIdType row, const std::string& name);
/// Returns a text; empty if the array is missing.
SMFILTERSPRODUCTS_EXPORT std::string GetText(vtkFieldData* data, vtkIdType row, const char* name);
/// Returns the value of that name, and its bound.
template <std::size_t N>
Quantity<N> GetQuantity(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  Quantity<N> quantity;
  ReadNumbers(data, row, name, quantity.Value.data(), static_cast<int>(N));
  quantity.Bound = GetNumber(data, row, name + "Bound");
  return quantity;
}

/// How far closing the gaps in another way may change quantities; that of the largest entry of each.
struct SpreadQuantities
{
  double Volume = Unknown, Area = Unknown, Center = Unknown, Inertia = Unknown, PrincipalMoments = Unknown;
  double Mass = Unknown, MassCenter = Unknown, MassInertia = Unknown, MassPrincipalMoments = Unknown;
};

/// Centre of mass and inertia in a frame of reference.
struct FrameQuantities
{
  VectorQuantity Center, MassCenter;
  TensorQuantity Inertia, MassInertia, CentralInertia, MassCentralInertia;
};

/// The quantities of all solids together, or of one. The user guide has their meaning.
struct SMFILTERSPRODUCTS_EXPORT Quantities
{
  ScalarQuantity Volume, Area, Mass;
  VectorQuantity Center, MassCenter, PrincipalMoments, MassPrincipalMoments;
  VectorQuantity RadiiOfGyration, MassRadiiOfGyration;
  TensorQuantity Inertia, InertiaAtOrigin, MassInertia, PrincipalAxes, MassPrincipalAxes;
  std::optional<bool> PrincipalAxesDegenerate, BoundsEstimated;
  std::array<double, 4> BoundsMeasured{ Unknown, Unknown, Unknown,
    Unknown }; ///< volume, area, centre, inertia
  /// Sum, density, gaps, numerical, overridden masses, tolerances of faces; the last one only if there are
  /// such.
  std::array<double, 6> MassUncertainty{ Unknown, Unknown, Unknown, Unknown, Unknown, Unknown };
  double OverriddenMass = Unknown;
  double Density = Unknown;
  std::string Material;
  SpreadQuantities Spread;
  double ClosureCorrection = Unknown, ClosureResidual = Unknown;
  double GapSquared = Unknown, MaxGap = Unknown, GapArea = Unknown;
  long long OpenEdges = -1, FlippedShells = -1;
  std::optional<FrameQuantities> About;

  /// Visits all members; `inBounds` visits further bounds, the last of "bounds".
  void Visit(Fields& fields, const std::function<void()>& inBounds = {});
};

SMFILTERSPRODUCTS_EXPORT Quantities ReadQuantities(vtkFieldData* data, vtkIdType row);
}

#endif
