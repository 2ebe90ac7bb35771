/**
 * @file smComparisonJob.h
 * @brief Reads both files of a comparison again and draws it
 */
#ifndef smComparisonJob_h
#define smComparisonJob_h

#include "smFileJob.h"

namespace sm
{
/// Reads both files of `options.Comparison` and draws them (Extras/smComparisonPicture.h). Sends an entry of
/// the file with a status and no results, and why there is no picture, as RunFileJob() does.
void DrawComparison(const JobOptions& options, const JobListener& send);
}

#endif
