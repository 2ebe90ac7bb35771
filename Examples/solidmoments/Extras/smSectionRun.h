/**
 * @file smSectionRun.h
 * @brief Cuts the solids by planes
 */
#ifndef smSectionRun_h
#define smSectionRun_h

#include "smSectionAnalysis.h"

namespace sm
{
/// Computes the sections and adds them to the results of the run.
void RunSections(const SectionPlanes& planes, const AnalysisRun& run);
}

#endif
