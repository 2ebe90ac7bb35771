"""TestPluginMaterialsWindow.py PARAVIEW PLUGIN.so OUTPUT: plays TestPluginMaterialsWindow.xml back; its checks read the table in the panel,
and the state that it saves has the rules, and no colours of blocks."""
import os
import re
import subprocess
import sys

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "..", "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402

paraview, plugin, output = sys.argv[1:4]
folder = os.path.join(output, "materials_window")
os.makedirs(folder, exist_ok=True)
bolt = Part("bolt", [((0, 0, 0), (2, 2, 10))], "7.85", "g/cm^3")
rail = Part("rail", [((0, 0, 0), (200, 10, 10))])
write_product(os.path.join(folder, "materials_window.step"), Assembly("machine", [(bolt, (0, 0, 10), None), (rail, (0, 0, 0), None)]))
panel = "pqClientMainWindow/propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel"
with open(os.path.join(here, "TestPluginMaterialsWindow.xml"), encoding="utf-8") as file:
    # Qt 6, which newer versions of ParaView have, writes exponents with as few digits as it can; ParaView 6.1
    # writes all digits of a double.
    version = re.search(r"paraview-([0-9]+[.][0-9]+)", plugin).group(1)
    tolerance = {"5.11": "1e-09", "5.13": "1e-9"}.get(version, "1.00000000000000006e-09")
    events = file.read()
# Titles are those of the table's header where the plugin has its library for Qt, else a first row.
table = 'object="PANEL/MaterialTable/ScalarValueList/Table'
has_header = os.path.exists(os.path.join(os.path.dirname(plugin), "smParaViewPanel.so"))
titles = (f'<pqcheck {table}/1QHeaderView0" property="visible" arguments="true" />' if has_header
          else f'<pqcheck {table}" property="modelItemData" arguments="0.2,kg/m^3" />')
rows = [str(row - has_header) for row in (1, 2, 3)]
for word, text in zip(("TITLES", "BOLT", "RAIL", "TOTAL", "PANEL", "DEFAULT_TOLERANCE"),
                      [titles, *rows, panel, tolerance]):
    events = events.replace(word, text)
script, state = (os.path.join(folder, "materials_window." + end) for end in ("xml", "pvsm"))
with open(script, "w", encoding="utf-8") as file:
    file.write(events)
if os.path.exists(state):
    os.remove(state)
status = subprocess.call([
    paraview, "--dr", "--plugin-search-paths=" + os.path.dirname(plugin), "--plugins=SolidMoments", "--data-directory=" + folder,
    "--test-directory=" + folder, "--test-script=" + script, "--exit"])
check_equal("the playback ends with", 0, status)
if check_true("the state was saved", os.path.exists(state), state):
    with open(state, encoding="utf-8") as file:
        text = file.read()
    materials = re.search(r'<Property name="Materials".*?</Property>', text, re.DOTALL).group()
    colors = re.findall(r'<Property name="ColorArrayName".*?</Property>', text, re.DOTALL)
    check_equal("solids without colours in their file are not coloured by their block", (True, []), (
        len(colors) >= 3, [color for color in colors if 'value="vtkBlockColors"' in color]))
    tolerance = re.search(r'<Property name="RelativeTolerance".*?</Property>', text, re.DOTALL).group()
    check_equal("a tolerance that was typed", [1e-6], [float(value) for value in re.findall(r'<Element index="\d+" value="([^"]*)"', tolerance)])
    check_equal("and there is no legend", 0, text.count('type="ScalarBarWidgetRepresentation"'))
    check_equal("rules of the state", ["rail", "Steel", "7850"], re.findall(r'<Element index="\d+" value="([^"]*)"', materials))
finish()
