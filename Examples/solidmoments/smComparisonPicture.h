/**
 * @file smComparisonPicture.h
 * @brief Draws the new product of a comparison, and the removed solids of the old one
 */
#ifndef smComparisonPicture_h
#define smComparisonPicture_h

#include "smFileJob.h"

namespace sm
{
/// Reads both files of `options.Comparison` and draws the solids in the colours of their states: unchanged
/// ones grey and translucent, moved ones blue, mirrored ones purple, changed ones amber and added ones green
/// where they are now, removed ones red and translucent. Sends an entry of the file with a status and no
/// results, and why there is no picture, as RunFileJob() does.
void DrawComparison(const JobOptions& options, const JobListener& send);
}

#endif
