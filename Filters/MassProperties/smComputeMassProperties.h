/**
 * @file smComputeMassProperties.h
 * @brief Mass properties of exact solids by one call: no pipeline, no window, no OpenGL
 *
 * The call runs the code of vtkMassPropertiesGPU with its CPU backend, on the threads of vtkSMPTools; its
 * results are bitwise equal to those. Coordinates are world coordinates; L is the length unit of the model.
 * Tensors are row-major, with negative products off the diagonal. A quantity that does not exist is NaN, and
 * so is its bound: the volume of a surface, the mass without a density.
 */
#ifndef smComputeMassProperties_h
#define smComputeMassProperties_h

#include "smFiltersMassPropertiesModule.h"
#include "smMaterials.h"
#include "smProgressCallback.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

class vtkDataObject;

namespace sm
{
/// A quantity, and an upper bound of the numerical error of each of its components, in its unit.
template <typename T>
struct Bounded
{
  T Value{};
  double Bound = std::numeric_limits<double>::quiet_NaN();
  /// Largest change of a component by closing the gaps of the model in another way (smClosingSpread.h); no
  /// part of the bound. NaN where it is not known, as for open solids, and for quantities that have none:
  /// those about the origin, axes and radii of gyration.
  double Spread = std::numeric_limits<double>::quiet_NaN();
};

/// Options of ComputeMassProperties(); see the setters of vtkMassPropertiesGPU for their meaning.
struct MassPropertiesOptions
{
  /// Tolerance of every quantity, relative to its scale. In (0, 1]; values below 1e-15 count as that.
  double RelativeTolerance = 1e-9;
  /// kg/m^3 of all solids; 0: what the file of each part states. Finite, not negative.
  double Density = 0.0;
  /// In [0, 1].
  double DensityTolerance = 0.0;
  /// Materials by the names of solids, and masses that override volume times density; they take precedence
  /// over Density. See FindRuleProblem() for their ranges.
  std::vector<MaterialRule> Materials;
  /// Gaps between faces and edges above this fraction of the diagonal of a body make its result suspect. In
  /// [0, 1].
  double GapLimit = 1e-3;
  /// At least 1.
  std::int64_t MaximumEvaluations = 2000000000;
  /// Not negative; 0: no limit.
  double MaximumSeconds = 0.0;
  /// Gets the progress and may stop the run. It is called by the calling thread.
  ProgressCallback Progress;
};

/// Mass properties of one instance of a solid or of a free shell, or of all together.
struct BodyMassProperties
{
  /// Name of the solid, and number of the instance, from 1 in the order of the input; both are empty in the
  /// total.
  std::string Name, Id;
  /// The status, with the names of vtkSurfaceIntegralBase: "ok", "open", "suspect", ...
  std::string Status;
  /// Messages about this body; in the total, those about the input and the sums.
  std::vector<std::string> Messages;

  Bounded<double> Volume;                 ///< L^3
  Bounded<double> Area;                   ///< L^2
  Bounded<std::array<double, 3>> Center;  ///< L, centre of the volume
  Bounded<std::array<double, 9>> Inertia; ///< L^5, about Center, at density 1
  Bounded<std::array<double, 9>> InertiaAtOrigin;
  Bounded<std::array<double, 3>> PrincipalMoments; ///< L^5, ascending
  /// Rows are unit vectors; the bound is an angle in radians. Not determined where moments coincide.
  Bounded<std::array<double, 9>> PrincipalAxes;
  bool PrincipalAxesDegenerate = false;
  Bounded<std::array<double, 3>> RadiiOfGyration; ///< L

  /// Density in kg/m^3, and name of the material. NaN and empty where there is none, or where bodies differ.
  double Density = std::numeric_limits<double>::quiet_NaN();
  std::string Material;
  Bounded<double> Mass; ///< kg
  /// The part of the mass that materials state, in kg; NaN without a mass.
  double OverriddenMass = std::numeric_limits<double>::quiet_NaN();
  Bounded<std::array<double, 3>> MassCenter;  ///< L, with the densities as weight
  Bounded<std::array<double, 9>> MassInertia; ///< kg L^2, about MassCenter

  /// Defects of the model, which no bound includes; see vtkMassPropertiesBase.
  double ClosureCorrection = 0.0;
  double ClosureResidual = 0.0;
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
  int OpenEdges = 0;
};

struct MassPropertiesResult
{
  std::vector<BodyMassProperties> Solids;
  /// All bodies together. The status is the worst of all bodies and of the file that the input was read from.
  /// Where the bodies differ in their length units, there are no sums.
  BodyMassProperties Total;
  /// The reason why the status is not "ok"; empty if it is.
  std::string Reason;
  std::string LengthUnit;
  /// Mass of the solids that have a density, and the numbers of these and of those that have a volume.
  Bounded<double> KnownMass;
  int SolidsWithMass = 0;
  int SolidsWithVolume = 0;
  int Faces = 0;
  std::int64_t Evaluations = 0;
};

/**
 * Computes the mass properties of `model`: a vtkNURBSDataSet with a model, or a composite dataset with any
 * number of them, for example the output of vtkSTEPReader. Instances of one vtkTrimmedNURBSModel are
 * integrated once. Failure is a status, never an exception: an option out of its range, a run that was
 * stopped, a lack of memory and an exception of the callback are "not-computed", null and an input without
 * exact geometry are "empty"; Reason has a sentence.
 */
SMFILTERSMASSPROPERTIES_EXPORT MassPropertiesResult ComputeMassProperties(
  vtkDataObject* model, const MassPropertiesOptions& options = {});
}

#endif
