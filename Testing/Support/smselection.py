"""Selecting rows of a filter's tables, as a click in ParaView's spreadsheet does, and what that highlights."""
from paraview import servermanager


def select_rows(filter, port, rows):
    """Selects rows, by number, of the table on a port of a filter of simple.*, instead of what was selected there."""
    # Pairs of process and row; the field type is that of rows.
    selection = pick("IDSelectionSource", "IDs", [number for row in rows for number in (0, row)], 5)
    filter.SMProxy.SetSelectionInput(port, selection, 0)


def pick(kind, name, values, field_type=0):
    """A selection with one source of a kind, whose property has these values."""
    source = servermanager.ProxyManager().SMProxyManager.NewProxy("sources", kind)
    source.GetProperty("FieldType").SetElement(0, field_type)
    elements = source.GetProperty(name)
    elements.SetNumberOfElements(len(values))
    for i, value in enumerate(values):
        elements.SetElement(i, value)
    source.UpdateVTKObjects()
    return servermanager.vtkSMSelectionHelper.NewAppendSelectionsFromSelectionSource(source)


def combine_picks(first, operation, second):
    """Two selections as ParaView's window combines them: Add, Subtract or Toggle."""
    getattr(servermanager.vtkSMSelectionHelper, operation + "Selection")(first, second)
    return second


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
