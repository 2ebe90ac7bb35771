"""Selecting rows of a filter's tables, as a click in ParaView's spreadsheet does, and what that highlights."""
from paraview import servermanager


def select_rows(filter, port, rows):
    """Selects rows, by number, of the table on a port of a filter of simple.*, instead of what was selected there."""
    source = servermanager.ProxyManager().SMProxyManager.NewProxy("sources", "IDSelectionSource")
    source.GetProperty("FieldType").SetElement(0, 5)  # rows
    ids = source.GetProperty("IDs")
    ids.SetNumberOfElements(2 * len(rows))
    for i, row in enumerate(rows):
        ids.SetElement(2 * i, 0)
        ids.SetElement(2 * i + 1, row)
    source.UpdateVTKObjects()
    selection = servermanager.vtkSMSelectionHelper.NewAppendSelectionsFromSelectionSource(source)
    filter.SMProxy.SetSelectionInput(port, selection, 0)


def get_selected_rows(filter, port):
    """Numbers of the rows that are selected, in their order."""
    selection = filter.SMProxy.GetSelectionInput(port)
    if not selection:
        return []
    ids = selection.GetProperty("Input").GetProxy(0).GetProperty("IDs")
    return [ids.GetElement(i) for i in range(1, ids.GetNumberOfElements(), 2)]


def count_selected_cells(filter, port):
    """Cells of an output that are highlighted by what is selected."""
    output = filter.SMProxy.GetSelectionOutput(port)
    output.UpdatePipeline()
    return output.GetDataInformation(0).GetNumberOfCells()
