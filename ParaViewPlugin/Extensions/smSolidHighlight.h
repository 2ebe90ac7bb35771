/**
 * @file smSolidHighlight.h
 * @brief Keeps the selections in the tables of a filter and in its views equal: solids, faces, edges
 *
 * After the call, a selection of rows by index, as a spreadsheet makes it, highlights the solids, faces or
 * edges of these rows; a selection of cells or blocks, as a click in a view makes it, selects the rows of
 * their solids and faces. The summary in a view describes the selection. The views that show the filter are
 * rendered again. An empty selection clears what was selected in this way and leaves a selection that the
 * user made; one by other means, such as a query, changes nothing. Views show the selection on Bodies, or, if
 * the filter's hints have HighlightClipped, on the clipped meshes; both can be picked. Works on the client
 * without Qt, so also in scripts.
 */
#ifndef smSolidHighlight_h
#define smSolidHighlight_h

class vtkSMSourceProxy;

namespace sm
{
/** Installs the observer on a filter with the ports of vtkSurfaceIntegralBase. Call it once per filter. */
void HighlightSelectedEntities(vtkSMSourceProxy* filter);
}

#endif
