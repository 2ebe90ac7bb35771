/**
 * @file smMassPropertyNames.h
 * @brief The names of every array and status that vtkSurfaceIntegralGPU and vtkMassPropertiesGPU put out
 *
 * Field data of port 0 and columns of the table on port 1 use the same names. Tests, the ParaView plugin,
 * the command line and the documentation use these constants. L is the length unit of the model.
 */
#ifndef smMassPropertyNames_h
#define smMassPropertyNames_h

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

// <quantity> + BoundSuffix: 1 number, the largest error of any component, in the quantity's unit.
constexpr const char* BoundSuffix = "Bound";
// <waterline> + CenterSuffix: 3, L, the centre of buoyancy, see vtkSurfaceIntegralGPU::AddBuoyancy.
constexpr const char* CenterSuffix = "Center";

// The model's own doubt; no part of a bound.
constexpr const char* MovedByClosing =
  "MovedByClosing";                              // 1, L^3, |volume closed - volume of the faces alone|
constexpr const char* GapSquared = "GapSquared"; // 1, L^3, integral of the squared gap along the coedges
constexpr const char* MaxGap = "MaxGap";         // 1, L
constexpr const char* GapArea = "GapArea";       // 1, L^2
constexpr const char* Leak = "Leak";             // 1, relative change of V when the origin moves by cbrt(V)
constexpr const char* OpenEdges = "OpenEdges";   // 1 (int)
constexpr const char* FlippedShells = "FlippedShells"; // 1 (int), shells that were inside out and were turned

constexpr const char* BoundsEstimated =
  "BoundsEstimated"; // 1 (int), 1: some bound (the area's, or of an expression) is an estimate, no theorem

// Only with one of the paper's schemes, see vtkMassPropertiesGPU::SetScheme.
constexpr const char* Scheme = "Scheme"; // string: "MIDPOINT", "GAUSS2" or "GAUSS3"
constexpr const char* PaperErrorEstimate =
  "PaperErrorEstimate"; // 1, L^3, Eq. 36 over whole sub-patches; no bound
constexpr const char* PaperErrorEstimateWithBoundary =
  "PaperErrorEstimateWithBoundary"; // 1, L^3, over those that a trim curve crosses as well; no bound
constexpr const char* SubPatches = "SubPatches"; // 1 (int64), of all faces that are not planar

constexpr const char* LengthUnit = "LengthUnit"; // string
constexpr const char* Status = "Status";         // string, see below
constexpr const char* Backend = "Backend"; // string: "opengl", "cpu", "none"; joined by + where ranks differ
constexpr const char* Renderer = "Renderer"; // string: GL_RENDERER, or "CPU, N threads"
constexpr const char* Evaluations =
  "Evaluations"; // 1 (int64), surface evaluations, as counted by what computed
constexpr const char* Dispatches = "Dispatches"; // 1 (int64)
constexpr const char* Faces = "Faces";           // 1 (int)
constexpr const char* Ranks = "Ranks";           // 1 (int), processes that integrated faces

// Columns of the tables only.
constexpr const char* Name = "Name";     // string
constexpr const char* Id = "Id";         // string: instance id, unique in the file
constexpr const char* Solid = "Solid";   // int: row of the solid in the table on port 1
constexpr const char* FaceId = "FaceId"; // int: entity number in the file
constexpr const char* EdgeId = "EdgeId"; // int: entity number in the file, 0 without one
constexpr const char* Uses = "Uses";     // int: coedges that use the edge
constexpr const char* Open = "Open";     // int: 1 when its signed uses do not cancel
constexpr const char* Text = "Text";     // string, the one cell of the text table

// What stands beside the integrands' columns in vtkSurfaceIntegralGPU's outputs: an integrand has none of these names.
constexpr const char* BesideIntegrands[] = { Name, Id, Solid, FaceId, Faces, Status, Backend, Renderer,
  Evaluations, Dispatches, LengthUnit, OpenEdges, FlippedShells, BoundsEstimated, Ranks };

// Cell data of the meshes on port 5 of vtkMassPropertiesGPU, besides Volume, that of the whole solid; floats.
constexpr const char* FaceShare =
  "FaceShare"; // 1, part of the solid's volume: flux about the part's origin / Volume
constexpr const char* FaceGap = "FaceGap";     // 1, L, widest gap between the face and its edges
constexpr const char* FaceBound = "FaceBound"; // 1, L^3, bound of the face's part of the volume
// Cell data of the glyph on port 0: what to draw it in.
constexpr const char* Color = "Color"; // 3 (uchar), sRGB: green, red where the result is flagged

// What computed.
constexpr const char* BackendOpenGL = "opengl";
constexpr const char* BackendCPU = "cpu";
constexpr const char* BackendNone = "none";

// One spelling of every status.
constexpr const char* StatusOk = "ok";
constexpr const char* StatusOpen = "open";
constexpr const char* StatusToleranceNotMet = "tolerance-not-met";
constexpr const char* StatusSuspect = "suspect";
constexpr const char* StatusEmpty = "empty";
constexpr const char* StatusUnreadable = "unreadable";
}
}

#endif
