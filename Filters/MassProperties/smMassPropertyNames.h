/**
 * @file smMassPropertyNames.h
 * @brief Names of all arrays in the outputs of vtkMassPropertiesGPU except those of smIntegralNames.h
 *
 * Field data of port 0 and columns of the table on port 1 use the same names. Tests, the ParaView plugin,
 * the command line and the documentation use these constants. L is the length unit of the model.
 */
#ifndef smMassPropertyNames_h
#define smMassPropertyNames_h

#include "smIntegralNames.h" // names common to all filters over surface integrals

namespace sm
{
namespace names
{
// Quantities: components, unit.
constexpr const char* Volume = "Volume";               // 1, L^3
constexpr const char* SurfaceArea = "SurfaceArea";     // 1, L^2
constexpr const char* CenterOfMass = "CenterOfMass";   // 3, L
constexpr const char* FirstMoments = "FirstMoments";   // 3, L^4, about the world origin
constexpr const char* SecondMoments = "SecondMoments"; // 6 XX YY ZZ XY YZ XZ, L^5, about the centre
constexpr const char* VolumeInertia = "VolumeInertia"; // 9 row-major, L^5, about the centre
constexpr const char* VolumeInertiaAtOrigin = "VolumeInertiaAtOrigin";     // 9, L^5, about the world origin
constexpr const char* PrincipalMoments = "PrincipalMoments";               // 3 ascending, L^5
constexpr const char* PrincipalAxes = "PrincipalAxes";                     // 9, rows are unit vectors
constexpr const char* PrincipalAxesDegenerate = "PrincipalAxesDegenerate"; // 1, 1: moments coincide
constexpr const char* RadiiOfGyration = "RadiiOfGyration";                 // 3, L, about the principal axes
constexpr const char* Mass = "Mass";                                       // 1, kg; only with a density
constexpr const char* MassInertia = "MassInertia"; // 9, kg L^2, about the centre; with a density
constexpr const char* MassCenter = "MassCenter";   // 3, L, centre of mass weighted with the densities
constexpr const char* MassPrincipalMoments = "MassPrincipalMoments"; // 3 ascending, kg L^2
constexpr const char* MassPrincipalAxes = "MassPrincipalAxes";       // 9, rows are unit vectors
constexpr const char* MassRadiiOfGyration = "MassRadiiOfGyration";   // 3, L
constexpr const char* MassUncertainty =
  "MassUncertainty"; // 5, kg: in all, by density, closings, numerical bound, overridden masses
constexpr const char* OverriddenMass = "OverriddenMass"; // 1, kg: the part of Mass that materials state
constexpr const char* Density = "Density";               // 1, kg/m^3
constexpr const char* Material = "Material";             // string
constexpr const char* BoundsMeasured = "BoundsMeasured"; // 4, parts of the bounds of volume, area, centre and
                                                         // inertia that are measured, not proved
// The total of solids of which only some have a density.
constexpr const char* KnownMass = "KnownMass";               // 1, kg, of those
constexpr const char* SolidsWithVolume = "SolidsWithVolume"; // 1 (int)
constexpr const char* SolidsWithMass = "SolidsWithMass";     // 1 (int)

// Columns of the parts list on port 7 of the filters of mass properties. Quantities of one product have the
// names above.
constexpr const char* Kind = "Kind";                     // string: part, assembly, or total
constexpr const char* Level = "Level";                   // 1 (int), 1 for the products of the root
constexpr const char* Count = "Count";                   // 1 (int), equal products in the product above
constexpr const char* CountInAll = "CountInAll";         // 1 (int), in the input
constexpr const char* Solids = "Solids";                 // 1 (int), of one
constexpr const char* Layer = "Layer";                   // string; where a product has one
constexpr const char* MassInAll = "MassInAll";           // 1, kg, of all
constexpr const char* KnownMassInAll = "KnownMassInAll"; // 1, kg, of those of all that have a density

// Quantities in the coordinates of the frame of reference, about its origin.
constexpr const char* CenterOfMassInFrame = "CenterOfMassInFrame";   // 3, L
constexpr const char* VolumeInertiaInFrame = "VolumeInertiaInFrame"; // 9, L^5
constexpr const char* MassCenterInFrame = "MassCenterInFrame";       // 3, L
constexpr const char* MassInertiaInFrame = "MassInertiaInFrame";     // 9, kg L^2
// Inertia with the axes of the frame, about the centres of volume and of mass.
constexpr const char* CentralInertiaInFrame = "CentralInertiaInFrame";         // 9, L^5
constexpr const char* MassCentralInertiaInFrame = "MassCentralInertiaInFrame"; // 9, kg L^2

// Defects of the model; they are not part of any bound.
constexpr const char* ClosureCorrection =
  "ClosureCorrection"; // 1, L^3, |volume closed - volume of the faces alone|
constexpr const char* ClosureResidual =
  "ClosureResidual"; // 1, relative change of V when the origin moves by cbrt(V)

// Cell data (float) of the meshes on port 5 of vtkMassPropertiesGPU. Those of the whole solid are the same in
// all its cells: no sum or integral over cells has a meaning, and their names say so.
constexpr const char* VolumeOfWholeSolid = "VolumeOfWholeSolid"; // 1, L^3
constexpr const char* MassOfWholeSolid = "MassOfWholeSolid";     // 1, kg
constexpr const char* FaceShare =
  "FaceShare"; // 1, part of the solid's volume: flux about the part's origin / Volume
constexpr const char* FaceArea = "FaceArea";   // 1, L^2
constexpr const char* FaceGap = "FaceGap";     // 1, L, widest gap between the face and its edges
constexpr const char* FaceBound = "FaceBound"; // 1, L^3, bound of the face's part of the volume
// Columns of the table of faces and cell data of the meshes of vtkMassSensitivity: derivatives of properties
// of the solid by an offset of the face along its outward normals. The cell data of vectors are one array for
// each component, with _X, _Y, _Z, or _1, _2, _3 for the principal moments.
constexpr const char* VolumePerOffset = "VolumePerOffset";                     // 1, L^2
constexpr const char* MassPerOffset = "MassPerOffset";                         // 1, kg/L
constexpr const char* SurfaceAreaPerOffset = "SurfaceAreaPerOffset";           // 1, L
constexpr const char* CenterOfMassPerOffset = "CenterOfMassPerOffset";         // 3, 1
constexpr const char* PrincipalMomentsPerOffset = "PrincipalMomentsPerOffset"; // 3, L^4
// Field data and columns of vtkMassTolerances: the limits of the worst case, how far it reaches from the
// nominal value, and standard deviations of independent offsets.
constexpr const char* VolumeLower = "VolumeLower";                             // 1, L^3
constexpr const char* VolumeUpper = "VolumeUpper";                             // 1, L^3
constexpr const char* VolumeDeviation = "VolumeDeviation";                     // 1, L^3
constexpr const char* MassLower = "MassLower";                                 // 1, kg
constexpr const char* MassUpper = "MassUpper";                                 // 1, kg
constexpr const char* MassDeviation = "MassDeviation";                         // 1, kg
constexpr const char* CenterOfMassReach = "CenterOfMassReach";                 // 1, L
constexpr const char* CenterOfMassDeviation = "CenterOfMassDeviation";         // 3, L
constexpr const char* VolumeInertiaReach = "VolumeInertiaReach";               // 1, L^5
constexpr const char* VolumeInertiaDeviation = "VolumeInertiaDeviation";       // 9, L^5
constexpr const char* PrincipalMomentsReach = "PrincipalMomentsReach";         // 1, L^5
constexpr const char* PrincipalMomentsDeviation = "PrincipalMomentsDeviation"; // 3, L^5
// Its columns of the table of faces, and cell data: the range of offsets, and what it adds to the worst case.
constexpr const char* ToleranceLower = "ToleranceLower";       // 1, L
constexpr const char* ToleranceUpper = "ToleranceUpper";       // 1, L
constexpr const char* VolumeByTolerance = "VolumeByTolerance"; // 1, L^3
constexpr const char* MassByTolerance = "MassByTolerance";     // 1, kg
// Cell data of the glyph on port 0: its colour.
constexpr const char* Color = "Color"; // 3 (uchar), sRGB: green, red where the result is flagged
}
}

#endif
