/**
 * @file smSchemeNames.h
 * @brief Names of all arrays in the outputs of vtkSchemeMassPropertiesGPU except those of
 * smMassPropertyNames.h
 */
#ifndef smSchemeNames_h
#define smSchemeNames_h

#include "smMassPropertyNames.h" // names common to all mass property filters

namespace sm
{
namespace names
{
constexpr const char* Scheme = "Scheme"; // string: "MIDPOINT", "GAUSS2" or "GAUSS3"
constexpr const char* PaperErrorEstimate =
  "PaperErrorEstimate"; // 1, L^3, Eq. 36 over sub-patches entirely in a face; not a bound
constexpr const char* PaperErrorEstimateWithBoundary =
  "PaperErrorEstimateWithBoundary"; // 1, L^3, including sub-patches that a trim curve crosses; not a bound
constexpr const char* SubPatches = "SubPatches"; // 1 (int64), number in all faces that are not planar
}
}

#endif
