/**
 * @file smSchemeNames.h
 * @brief The names of every array that vtkSchemeMassPropertiesGPU puts out, beside those of smMassPropertyNames.h
 */
#ifndef smSchemeNames_h
#define smSchemeNames_h

#include "smMassPropertyNames.h" // what all mass property filters put out

namespace sm
{
namespace names
{
constexpr const char* Scheme = "Scheme"; // string: "MIDPOINT", "GAUSS2" or "GAUSS3"
constexpr const char* PaperErrorEstimate =
  "PaperErrorEstimate"; // 1, L^3, Eq. 36 over whole sub-patches; no bound
constexpr const char* PaperErrorEstimateWithBoundary =
  "PaperErrorEstimateWithBoundary"; // 1, L^3, over those that a trim curve crosses as well; no bound
constexpr const char* SubPatches = "SubPatches"; // 1 (int64), of all faces that are not planar
}
}

#endif
