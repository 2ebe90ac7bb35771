/**
 * @file smSectionNames.h
 * @brief Names of all arrays in the outputs of vtkSolidSection except those of smIntegralNames.h
 */
#ifndef smSectionNames_h
#define smSectionNames_h

#include "smIntegralNames.h" // names common to all filters over surface integrals

namespace sm
{
namespace names
{
constexpr const char* SectionArea = "SectionArea";         // 1, L^2, with bound
constexpr const char* SectionCentroid = "SectionCentroid"; // 3, L, with bound
// 6, L^4: xx, yy, zz, xy, yz, xz about the centroid, along the world's axes, with bound
constexpr const char* SectionSecondMoments = "SectionSecondMoments";
constexpr const char* SectionPrincipalMoments = "SectionPrincipalMoments"; // 2, L^4, ascending, with bound
constexpr const char* SectionPrincipalDirections = "SectionPrincipalDirections"; // 6, two unit vectors
constexpr const char* VolumeBelow = "VolumeBelow";                               // 1, L^3, with bound
constexpr const char* CenterBelow = "CenterBelow";                               // 3, L, with bound
constexpr const char* VolumeAbove = "VolumeAbove";                               // 1, L^3, with bound
constexpr const char* CenterAbove = "CenterAbove";                               // 3, L, with bound
constexpr const char* MassBelow = "MassBelow";                                   // 1, kg, with bound
constexpr const char* MassAbove = "MassAbove";                                   // 1, kg, with bound

// Cell arrays of the clipped mesh, with vtkNURBSDataSet::FaceIndexArrayName() (-1 on the section).
constexpr const char* SectionSolid = "Solid"; // int, row of the table of solids
constexpr const char* SectionCap = "Cap";     // int, 1 on the section
}
}

#endif
