/**
 * @file smGraphTables.h
 * @brief Figures 7 and 8 of the paper: volume and error against the number of sub-patches
 *
 * A row for each run: scheme, sub-patch factor k (0: ADAPTIVE), sub-patches, volume, volume and bound as
 * fractions of the reference, relative error, and the paper's estimates of it.
 */
#ifndef smGraphTables_h
#define smGraphTables_h

#include "smFigureTable.h"

class vtkDataObject;

namespace smfigure
{
/// Makes Fig. 7a: the quarter cylinder, whose k is the number of sub-patches along the arc.
FigureTable MakeFigure7a();
/// Makes Fig. 7b: the block with a slanted hole.
FigureTable MakeFigure7b();
/// Makes Fig. 8: a part, whose reference is ADAPTIVE's volume. No rows when the part has no volume.
FigureTable MakeFigure8(vtkDataObject* part);
}

#endif
