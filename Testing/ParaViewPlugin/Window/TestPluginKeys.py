"""TestPluginKeys.py PARAVIEW PLUGIN.so OUTPUT: the keys s and b on *Bodies* of Mass Properties and on *Clipped* of
Section, pressed in ParaView's window.

The view shows both from below: the red rail of *Clipped* is left of that of *Bodies*. No time limit here decides
the result: a loaded machine may need minutes to start ParaView.
"""
import json
import os
import subprocess
import sys
import time

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "..", "..", "Support"))
import numpy  # noqa: E402
from smcheck import check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402
from smx11 import Display  # noqa: E402

paraview, plugin, output = sys.argv[1:4]
folder = os.path.join(output, "keys")
os.makedirs(folder, exist_ok=True)
part, report = os.path.join(folder, "keys.step"), os.path.join(folder, "report.txt")
if os.path.exists(report):
    os.remove(report)
rail = Part("rail", [((0, 0, 0), (200, 60, 30))])
bolt = Part("bolt", [((0, 0, 0), (20, 20, 60))])
write_product(part, Assembly("machine", [(bolt, (30, 20, 30), None), (rail, (0, 0, 0), None)]))
SESSION = f"""
import json
from paraview import servermanager, simple
simple.LoadPlugin({plugin!r}, remote=False, ns=globals())
reader = simple.OpenDataFile({part!r})
view = simple.GetActiveViewOrCreate("RenderView")
filters = {{"Bodies": (MassProperties(Input=reader), 5), "Clipped": (Section(Input=reader, Point=[100.0, 30.0, 15.0]), 7)}}
simple.Hide(reader, view)


def write(name):
    filter, port = filters[name]
    selection = filter.SMProxy.GetSelectionInput(port)
    sources = []
    inputs = selection.GetProperty("Input") if selection else None
    for i in range(inputs.GetNumberOfProxies() if inputs else 0):
        source = inputs.GetProxy(i)
        elements = source.GetProperty("BlockSelectors") or source.GetProperty("IDs")
        sources.append([source.GetXMLName(), [elements.GetElement(k) for k in range(elements.GetNumberOfElements())]])
    with open({report!r}, "a", encoding="utf-8") as file:
        file.write(json.dumps([name, sources]) + "\\n")


for name, (filter, port) in filters.items():
    shown = simple.Show(servermanager.OutputPort(filter, port), view)
    simple.ColorBy(shown, None)
    shown.AmbientColor = shown.DiffuseColor = [1.0, 0.0, 0.0]
    shown.Opacity, shown.Ambient, shown.Diffuse = 1.0, 1.0, 0.0
    shown.Position = [300.0 if name == "Clipped" else 0.0, 0.0, 0.0]
    simple.HideInteractiveWidgets(proxy=filter)
    filter.SMProxy.AddObserver("SelectionChangedEvent", lambda *_, name=name: write(name))
view.OrientationAxesVisibility = 0
view.CameraPosition, view.CameraFocalPoint = [250.0, 30.0, -1000.0], [250.0, 30.0, 0.0]
view.CameraViewUp = [0.0, 1.0, 0.0]
simple.ResetCamera(view)
simple.Render(view)
write("Bodies")
"""
session = os.path.join(folder, "session.py")
with open(session, "w", encoding="utf-8") as file:
    file.write(SESSION)
KEYS = {"s": 39, "b": 56}


def read_report():
    """Returns what the session wrote last, by filter."""
    if not os.path.exists(report):
        return {}
    with open(report, encoding="utf-8") as file:
        return dict(json.loads(line) for line in file.read().splitlines())


def wait_for(condition, seconds):
    deadline = time.monotonic() + seconds
    while not (found := condition()) and time.monotonic() < deadline and window.poll() is None:
        time.sleep(0.2)
    return found


def find_rails(display):
    """Returns a place on each red rail, a quarter of its size from its upper left corner: on one of the two triangles
    of its bottom."""
    width, height, pixels = display.grab()
    colors = numpy.frombuffer(pixels, dtype=numpy.uint8).reshape(height, width, 4).astype(int)
    red = (colors[:, :, 2] > 240) & (colors[:, :, 1] < 20) & (colors[:, :, 0] < 20)
    columns = numpy.nonzero(red.sum(axis=0) > 10)[0]
    if len(columns) < 20 or numpy.diff(columns).max() < 10:
        return None
    split = int(numpy.diff(columns).argmax()) + 1
    places = {}
    for name, some in (("Clipped", columns[:split]), ("Bodies", columns[split:])):
        rows = numpy.nonzero(red[:, some].sum(axis=1) > 0.5 * len(some))[0]
        places[name] = (int(some[0] + 0.25 * (some[-1] - some[0])), int(rows[0] + 0.25 * (rows[-1] - rows[0])))
    return places


def press(display, key, place):
    """Presses a key over a place, and draws a small frame around the place."""
    display.move(*place)
    time.sleep(1.0)
    display.tap(KEYS[key])
    time.sleep(3.0)
    for dx in (-2, 0, 2):
        display.move(place[0] + dx, place[1] + dx)
        time.sleep(0.5)
        if dx == -2:
            display.press()
    display.release()




def find_cells(name):
    """Returns the cells that are picked of a filter, of three numbers each: composite index, process and cell."""
    kinds = [ids for kind, ids in read_report().get(name, []) if kind == "CompositeDataIDSelectionSource"]
    return len(kinds[0]) // 3 if kinds else 0


with open(os.path.join(folder, "log.txt"), "w", encoding="utf-8") as log:
    window = subprocess.Popen(
        [paraview, "--dr", "--plugin-search-paths=" + os.path.dirname(plugin), "--plugins=SolidMoments", "--script=" + session],
        env=dict(os.environ, HOME=folder), stdout=log, stderr=log)
    try:
        display = Display()
        wait_for(read_report, 600.0)
        places = wait_for(lambda: find_rails(display), 200.0)
        if check_true("the view shows two red rails", places is not None):
            # A first click into the view, off the parts, gives the window the keyboard.
            display.click(places["Bodies"][0], places["Bodies"][1] + 150)
            time.sleep(3.0)
            for name in ("Bodies", "Clipped"):
                press(display, "b", places[name])
                blocks = wait_for(lambda: read_report().get(name), 100.0)
                check_equal(f"{name}, b: the solid", [["BlockSelectorsSelectionSource", ["/Root/rail"]]], blocks)
            # The face has two triangles and lights up as a whole.
            for name in ("Bodies", "Clipped"):
                press(display, "s", places[name])
                check_equal(f"{name}, s: triangles", 2, wait_for(lambda: find_cells(name) == 2 and 2, 100.0))
    finally:
        window.kill()
        window.wait()
with open(os.path.join(folder, "log.txt"), encoding="utf-8", errors="replace") as log:
    check_equal("errors and warnings", [], [line[:300] for line in log.read().splitlines() if " ERR|" in line or "WARN|" in line])
finish()
