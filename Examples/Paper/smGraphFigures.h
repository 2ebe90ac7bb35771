/**
 * @file smGraphFigures.h
 * @brief Figures 7 and 8 of the paper: volume and error against the number of sub-patches
 */
#ifndef smGraphFigures_h
#define smGraphFigures_h

#include "smFigure.h"

#include <vector>

class vtkDataObject;

namespace smfigure
{
/// Makes Fig. 7a: the quarter cylinder's normalised volume, and its error, against the sub-patches along the
/// arc.
std::vector<Figure> MakeFigure7a();
/// Makes Fig. 7b: the same for the block with a slanted hole, against k.
std::vector<Figure> MakeFigure7b();
/// Makes Fig. 8: volume as a fraction of ADAPTIVE's, its error and the paper's estimates of it, against k.
/// Empty when the part has no volume.
std::vector<Figure> MakeFigure8(vtkDataObject* part);
}

#endif
