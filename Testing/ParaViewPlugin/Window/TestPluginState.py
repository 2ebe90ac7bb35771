"""TestPluginState.py PLUGIN.so FOLDER: a loaded state has the saved properties, and rows of a table highlight solids in it."""
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402
from smselection import count_selected_cells, select_rows  # noqa: E402

from paraview import servermanager, simple, smstate  # noqa: E402

plugin, folder = sys.argv[1:3]
# ParaView takes time by the number of solids, three times here.
assembly = os.path.join(folder, "PluginState.step")
bolt = Part("bolt", [((0, 0, 0), (2, 2, 10))])
write_product(assembly, Assembly("row", [(bolt, (5 * i, 0, 0), None) for i in range(12)]))
simple.LoadPlugin(plugin, ns=globals())
controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
# Neither ParaView's defaults nor the plugin's.
VALUES = {0: {"LineWidth": 5.0, "DiffuseColor": [0.2, 0.3, 0.9]}, 2: {"FontSize": 20, "FlaggedColor": [0.9, 0.1, 0.8]}, 5: {"Opacity": 0.65}}


def check_pipeline(what, mass, view):
    """Checks the display properties, the numbers, and the rows that highlight solids."""
    for port, values in VALUES.items():
        shown = simple.GetRepresentation(servermanager.OutputPort(mass, port), view)
        for name, value in values.items():
            actual = getattr(shown, name)
            check_equal(f"{what}: {name} of port {port}", value, list(actual) if isinstance(value, list) else type(value)(actual))
    check_equal(f"{what}: density", 2700.0, float(mass.Density))
    check_equal(f"{what}: materials", ["*", "aluminium", "2700"], list(mass.Materials))
    simple.Render(view)
    fields = servermanager.Fetch(mass, idx=0).GetFieldData()
    check_equal(f"{what}: status", "ok", fields.GetAbstractArray("Status").GetValue(0))
    cells = servermanager.OutputPort(mass, 5).GetDataInformation().GetNumberOfCells()
    select_rows(mass, 1, [0])
    one = count_selected_cells(mass, 5)
    check_true(f"{what}: a selected row highlights its solid", 0 < one < cells, f"{one} of {cells} cells")
    select_rows(mass, 1, range(5))
    check_true(f"{what}: five rows highlight more", one < count_selected_cells(mass, 5) < cells, str(count_selected_cells(mass, 5)))
    mass.SMProxy.CleanSelectionInputs(1)
    check_true(f"{what}: cleared with the rows", not mass.SMProxy.GetSelectionInput(5))
    return fields.GetArray("Volume").GetValue(0)


reader = simple.OpenDataFile(assembly)
view = simple.CreateRenderView()
simple.Show(reader, view)
mass = MassProperties(Input=reader, Density=2700.0)  # noqa: F821
for port in range(7):
    controller.ShowInPreferredView(mass.SMProxy, port, view.SMProxy)
simple.Hide(reader, view)
for port, values in VALUES.items():
    shown = simple.GetRepresentation(servermanager.OutputPort(mass, port), view)
    for name, value in values.items():
        setattr(shown, name, value)
mass.Materials = ["*", "aluminium", "2700"]
volume = check_pipeline("made", mass, view)
states = [os.path.join(folder, "PluginState." + end) for end in ("pvsm", "py")]
simple.SaveState(states[0])
with open(states[1], "w", encoding="utf-8") as file:
    # As File > Save State does for Python; SaveState() of 5.11 writes XML whatever the name.
    text = smstate.get_state()
    file.write(text)
# As a state of an earlier version, whose reader had a property that is gone.
with open(states[0], encoding="utf-8") as file:
    saved = file.read()
found = re.search(r'<Proxy group="sources" type="STEPReader" id="(\d+)"[^>]*>', saved)
if check_true("the state has the reader", found is not None):
    old = f'<Property name="Isolated" id="{found[1]}.Isolated" number_of_elements="1"><Element index="0" value="0"/></Property>'
    with open(states[0], "w", encoding="utf-8") as file:
        file.write(saved[:found.end()] + old + saved[found.end():])
check_true("a state in Python has the rules of materials, not the table", "Materials" in text and "MaterialTable" not in text)
del reader, shown
for state in states:
    what = os.path.splitext(state)[1][1:]
    # Nothing of a session is held when it ends.
    mass = view = masses = views = None
    simple.ResetSession()
    simple.LoadPlugin(plugin, ns=globals())
    check_equal(f"{what}: an empty session", 0, len(simple.GetSources()))
    if what == "pvsm":
        simple.LoadState(state)
    else:
        with open(state, encoding="utf-8") as file:
            exec(compile(file.read(), state, "exec"), {"__name__": "__main__"})
    masses = [source for source in simple.GetSources().values() if source.GetXMLName() == "MassPropertiesGPU"]
    views = [each for each in simple.GetViews() if each.GetXMLName() == "RenderView"]
    if check_equal(f"{what}: filters and views", (1, 1), (len(masses), len(views))):
        mass, view = masses[0], views[0]
        check(f"{what}: the same volume", volume, check_pipeline(what, mass, view), 0.0)
finish()
