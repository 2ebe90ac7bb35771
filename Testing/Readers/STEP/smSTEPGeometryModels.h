/**
 * @file smSTEPGeometryModels.h
 * @brief Compares every curve and surface of real files with OpenCASCADE's
 */
#ifndef smSTEPGeometryModels_h
#define smSTEPGeometryModels_h

#include <string>
#include <vector>

/// `paths` are STEP files, or folders of them. Points and derivatives at sample parameters must agree to
/// rounding. An entity that only one side converts is counted by type, and those that only OpenCASCADE
/// converts are failures.
void CompareGeometryWithKernel(const std::vector<std::string>& paths);

#endif
