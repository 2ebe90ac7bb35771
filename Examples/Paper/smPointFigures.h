/**
 * @file smPointFigures.h
 * @brief Figures 3 to 6 of the paper: evaluation points and trim textures
 */
#ifndef smPointFigures_h
#define smPointFigures_h

#include "smFigure.h"

#include <string>

namespace smfigure
{
/// The 2 x 2 Gauss points of a sub-patch, and the fractions of its side that they divide it into.
Figure MakeFigure3();
/// The 2 x 2 points of every sub-patch of a patch with 4 x 5 knot intervals.
Figure MakeFigure4();
/// The 3 x 3 Gauss points, with areas in proportion to their weights.
Figure MakeFigure5();
/// The trim texture of a trimmed face, 4 x 4 texels per sub-patch, as the filter made it, over its 2 x 2
/// points. Returns an error message, empty when it succeeds.
std::string MakeFigure6(Figure& figure);
}

#endif
