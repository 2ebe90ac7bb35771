/**
 * @file smPlotSeries.h
 * @brief The series that a new plot of the tables of mass properties over time shows
 */
#ifndef smPlotSeries_h
#define smPlotSeries_h

namespace sm
{
/**
 * New plots in this ParaView show volume and the coordinates of the centre of mass, each with its bound, and
 * mass and density, and not the other forty columns; the user ticks others in the panel. ParaView selects
 * series by their names only, for any data; so names that other data often have, such as Density, are not
 * changed. Repeated calls change nothing.
 */
void ChoosePlotSeries();
}

#endif
