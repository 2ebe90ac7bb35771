/**
 * @file smPlotSeries.h
 * @brief The series with which a plot of the tables of mass properties over time begins
 */
#ifndef smPlotSeries_h
#define smPlotSeries_h

namespace sm
{
/**
 * New plots in this ParaView show volume and the coordinates of the centre of mass, each with its bound, and mass and density, and not the other forty columns;
 * the user ticks others in the panel. ParaView decides by the names of series, whatever they come from: names that other data often have, such as
 * Density, are left alone. Repeated calls change nothing.
 */
void ChoosePlotSeries();
}

#endif
