/**
 * @file smSolidHighlight.h
 * @brief Highlights the solids or faces whose rows are selected in the tables of a filter, and selects the rows of solids that are picked in a view
 *
 * After the call, a selection of rows by index, as a spreadsheet makes it, selects the blocks of these rows, or the cells of these faces; a selection of cells or
 * blocks, as a click in a view makes it, selects the rows of their solids. The views that show them are rendered again. An empty
 * selection, or one by other means, clears what was selected in this way and leaves a selection that the user made. Works on the
 * client without Qt, so also in scripts.
 */
#ifndef smSolidHighlight_h
#define smSolidHighlight_h

class vtkSMSourceProxy;

namespace sm
{
/** Installs the observer: `tablePort` has a table of solids, `meshesPort` partitioned datasets in the order of its rows, and `facesPort` a table
 * of faces (vtkFaceRowsInformation.h) or, where it is negative, none. Call it once per filter. */
void HighlightSolidsOfRows(
  vtkSMSourceProxy* filter, unsigned int tablePort, unsigned int meshesPort, int facesPort);
}

#endif
