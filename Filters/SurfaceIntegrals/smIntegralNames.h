/**
 * @file smIntegralNames.h
 * @brief Names of the arrays and statuses in the outputs of all filters over surface integrals
 *
 * Field data of port 0 and columns of the tables use the same names. Tests, the ParaView plugin, the command
 * line and the documentation use these constants. L is the length unit of the model.
 */
#ifndef smIntegralNames_h
#define smIntegralNames_h

namespace sm
{
namespace names
{
// <quantity> + BoundSuffix: 1 number, the largest error of any component, in the quantity's unit.
constexpr const char* BoundSuffix = "Bound";
// <quantity> + SpreadSuffix: 1 number, the largest change of any component by closing gaps in another way
// (smClosingSpread.h), in the quantity's unit; no part of a bound.
constexpr const char* SpreadSuffix = "Spread";
// Defects of the model; they are not part of any bound.
constexpr const char* GapSquared = "GapSquared"; // 1, L^3, integral of the squared gap along the coedges
constexpr const char* MaxGap = "MaxGap";         // 1, L
constexpr const char* GapArea = "GapArea";       // 1, L^2
constexpr const char* ClosureSpread = "ClosureSpread"; // 1, L^3, VolumeSpread of one edge
constexpr const char* OpenEdges = "OpenEdges";         // 1 (int)
constexpr const char* FlippedShells = "FlippedShells"; // 1 (int), inside-out shells, all reversed

constexpr const char* BoundsEstimated =
  "BoundsEstimated"; // 1 (int), 1: some bound (of the area or an expression) is estimated, not proved

constexpr const char* LengthUnit = "LengthUnit"; // string
constexpr const char* Status = "Status";         // string, see below
constexpr const char* Backend = "Backend"; // string: "opengl", "cpu", "none"; joined by + where ranks differ
constexpr const char* Renderer = "Renderer"; // string: GL_RENDERER, or "CPU, N threads"
constexpr const char* BackendReason =
  "BackendReason";                                 // string: why AUTOMATIC took it; empty if it was chosen
constexpr const char* Evaluations = "Evaluations"; // 1 (int64), surface evaluations, counted by the device
constexpr const char* Dispatches = "Dispatches";   // 1 (int64)
constexpr const char* Faces = "Faces";             // 1 (int)
constexpr const char* Ranks = "Ranks";             // 1 (int), processes that integrated faces

// Columns of the tables only.
constexpr const char* Name = "Name"; // string: the name in the file, of one or several instances
constexpr const char* Path =
  "Path"; // string: the instance's place in the product structure, with the name by which it is selected
constexpr const char* Id = "Id";               // string: instance id, unique in the file
constexpr const char* Solid = "Solid";         // int: row of the solid in the table on port 1
constexpr const char* FaceId = "FaceId";       // vtkTypeInt64: entity number in the file
constexpr const char* EdgeId = "EdgeId";       // vtkTypeInt64: entity number in the file, 0 without one
constexpr const char* EdgeIndex = "EdgeIndex"; // int: number of the edge in its solid, from 0
constexpr const char* Uses = "Uses";           // int: coedges that use the edge
constexpr const char* Open = "Open";           // int: 1 when its signed uses do not cancel
constexpr const char* Text = "Text"; // string, the one cell of the text table; of a flagged place: what it is

// Cell data of the flagged places on port 6, in addition to Solid, Name, FaceId, EdgeId, MaxGap and Text.
constexpr const char* Flag = "Flag"; // int: number of the place, 1, 2, ..., the worst first
constexpr const char* AreaInDoubt =
  "AreaInDoubt"; // 1, L^2, estimate of what the place may change in the area
constexpr const char* VolumeInDoubt = "VolumeInDoubt"; // 1, L^3, likewise in the volume

// Names of other columns in vtkSurfaceIntegralGPU's outputs, which integrands must not have.
constexpr const char* ReservedColumnNames[] = { Name, Path, Id, Solid, FaceId, MaxGap, Faces, Status, Backend,
  Renderer, BackendReason, Evaluations, Dispatches, LengthUnit, OpenEdges, FlippedShells, BoundsEstimated,
  Ranks };

// Backends.
constexpr const char* BackendOpenGL = "opengl";
constexpr const char* BackendCPU = "cpu";
constexpr const char* BackendNone = "none";

// Statuses, in their only spelling.
constexpr const char* StatusOk = "ok";
constexpr const char* StatusOpen = "open";
constexpr const char* StatusToleranceNotMet = "tolerance-not-met";
constexpr const char* StatusSuspect = "suspect";
constexpr const char* StatusNotComputed = "not-computed";
constexpr const char* StatusEmpty = "empty";
constexpr const char* StatusUnreadable = "unreadable";
}
}

#endif
