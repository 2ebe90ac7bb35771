/**
 * @file smComparisonPicture.h
 * @brief Draws the new product of a comparison, and the removed solids of the old one
 */
#ifndef smComparisonPicture_h
#define smComparisonPicture_h

#include "smFileJob.h"

#include <string>

class vtkCADReader;

namespace sm
{
/// Draws the solids of `options.Comparison` in the colours of their states: unchanged ones grey and
/// translucent, moved ones blue, mirrored ones purple, changed ones amber and added ones green where they are
/// now, removed ones red and translucent. The readers have the old and the new file. Returns an error
/// message, empty when the picture is written.
std::string WriteComparison(vtkCADReader* before, vtkCADReader* after, const JobOptions& options);
}

#endif
