"""TestPluginTicks.py PARAVIEW PLUGIN.so OUTPUT: ticks one of several equal parts in the tree of each filter that has one, in ParaView's window.

The product is machine = 2 x arm + base; arm = 2 x nut + rod, so that four parts are called nut, and two rod. ParaView saves its state, whose
selectors select the one part.
"""
import os
import subprocess
import sys
from xml.etree import ElementTree

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "..", "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

paraview, plugin, output = sys.argv[1:4]
WINDOW = "pqClientMainWindow"
PANEL = WINDOW + "/propertiesDock/propertiesPanel"
PROPERTIES = PANEL + "/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel"
TREE = PROPERTIES + "/DataAssemblyEditor/tabWidget/qt_tabwidget_stackedwidget/hierarchyTab/hierarchy"
# Rows below machine, each with its column, and the selector of the part: another one for each filter.
PARTS = (("0.0.0.0", "arm1/nut1"), ("0.0.1.0", "arm1/nut2"), ("0.0.2.0", "arm1/rod"), ("1.0.0.0", "arm2/nut1"), ("1.0.1.0", "arm2/nut2"),
         ("1.0.2.0", "arm2/rod"), ("2.0", "base"))
simple.LoadPlugin(plugin, remote=False, ns=globals())
FILTERS = [name for name in ("MassPropertiesGPU", "SurfaceIntegralGPU", "SolidSection", "Buoyancy", "SolidStability", "SchemeMassProperties",
                             "MomentGradient", "NURBSTransform", "NURBSDeform", "MassSensitivity", "MassTolerances")
           if (prototype := servermanager.ProxyManager().GetPrototypeProxy("filters", name)) and prototype.GetProperty("Selectors")]
check_true("filters with a tree", len(FILTERS) >= 4, str(FILTERS))
folder = os.path.join(output, "ticks")
os.makedirs(folder, exist_ok=True)
state = os.path.join(folder, "ticks.pvsm")
if os.path.exists(state):
    os.remove(state)
nut, rod, base = (Part(name, [((0, 0, 0), size)], "7.85", "g/cm^3") for name, size in (("nut", (2, 2, 2)), ("rod", (3, 3, 3)), ("base", (10, 10, 10))))
arm = Assembly("arm", [(nut, (0, 0, 0), None), (nut, (5, 0, 0), None), (rod, (10, 0, 0), None)])
write_product(os.path.join(folder, "ticks.step"), Assembly("machine", [(arm, (0, 20, 0), None), (arm, (0, 30, 0), None), (base, (0, 0, 0), None)]))
events = [(WINDOW + "/menubar/menu_File", "activate", "actionFileOpen"),
          (WINDOW + "/FileOpenDialog", "filesSelected", "$PARAVIEW_DATA_ROOT/ticks.step"), (PANEL + "/Accept", "activate", "")]
ticked = {}
for i, name in enumerate(FILTERS):
    rows, ticked[name] = PARTS[i % len(PARTS)]
    events += [(WINDOW + "/pipelineBrowserDock/pipelineBrowser", "currentChanged", "/0/0|0"),
               (WINDOW + "/menubar/menuFilters/Alphabetical", "activate", name),
               (TREE, "setCheckState", f"0.0.0.0.{rows},2"), (PANEL + "/Accept", "activate", "")]
events += [(WINDOW + "/menubar/menu_File", "activate", "actionFileSaveServerState"),
           (WINDOW + "/FileSaveServerStateDialog", "filesSelected", "$PARAVIEW_TEST_ROOT/ticks.pvsm")]
script = os.path.join(folder, "ticks.xml")
with open(script, "w", encoding="utf-8") as file:
    file.write('<?xml version="1.0" ?>\n<pqevents>\n')
    file.writelines(f'  <pqevent object="{target}" command="{command}" arguments="{arguments}" />\n' for target, command, arguments in events)
    file.write("</pqevents>\n")
status = subprocess.call([
    paraview, "--dr", "--plugin-search-paths=" + os.path.dirname(plugin), "--plugins=SolidMoments", "--data-directory=" + folder,
    "--test-directory=" + folder, "--test-script=" + script, "--exit"])
check_equal("the playback ends with", 0, status)
if check_true("the state was saved", os.path.exists(state), state):
    selectors = {proxy.get("type"): [element.get("value") for element in proxy.findall("./Property[@name='Selectors']/Element")]
                 for proxy in ElementTree.parse(state).iter("Proxy") if proxy.get("group") == "filters"}
    reader = simple.OpenDataFile(os.path.join(folder, "ticks.step"))
    for name in FILTERS:
        check_equal(f"{name}: ticked", ["/STEP/machine/" + ticked[name]], selectors.get(name))
        mass = MassProperties(Input=reader, Selectors=selectors.get(name, []))  # noqa: F821
        solids = servermanager.Fetch(mass, idx=1)
        path = ticked[name].split("/")
        label = "base" if path == ["base"] else f"arm ({path[0][3]})/" + ("rod" if path[1] == "rod" else f"nut ({path[1][3]})")
        check_equal(f"{name}: this one", [label], [solids.GetValueByName(row, "Path").ToString() for row in range(solids.GetNumberOfRows())])
finish()
