/**
 * @file smSolidHighlight.h
 * @brief Highlights the solids whose rows are selected in the table of a mass filter
 *
 * From the call on a selection of rows (by index, as a spreadsheet makes it) selects the blocks, and the render views that show them
 * are rendered again; an empty one clears what was selected so, and leaves what the user selected in a view. Works on the client,
 * without Qt, so that scripts have it too. Selections by other means than indices clear the blocks.
 */
#ifndef smSolidHighlight_h
#define smSolidHighlight_h

class vtkSMSourceProxy;

namespace sm
{
/** For a filter with a table on one port and, in the order of its rows, partitioned datasets on another; once in its life. */
void HighlightSolidsOfRows(vtkSMSourceProxy* filter, unsigned int tablePort, unsigned int meshesPort);
}

#endif
