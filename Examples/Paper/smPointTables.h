/**
 * @file smPointTables.h
 * @brief Figures 3 to 6 of the paper: evaluation points and trim textures
 */
#ifndef smPointTables_h
#define smPointTables_h

#include "smFigureTable.h"

namespace smfigure
{
/**
 * Makes the tables of Figures 3 to 6, positions in parameters:
 * - fig3: the 2 x 2 Gauss points of a sub-patch, u, v and weight, of a square of area 4;
 * - fig4: the 2 x 2 points of every sub-patch of a patch with 4 x 5 knot intervals;
 * - fig5: the 3 x 3 Gauss points of a sub-patch;
 * - fig6: the trim texture of a trimmed face, 4 x 4 texels per sub-patch, as the filter made it;
 * - fig6_points: the 2 x 2 points of its sub-patches;
 * - fig6_curves: its trim curves as polygons, with the number of the loop.
 * The tables are empty when the filter gave no trim texture.
 */
std::vector<FigureTable> MakePointTables();
}

#endif
