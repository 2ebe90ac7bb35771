"""TestPluginWalk.py PARAVIEW PLUGIN.so OUTPUT [RANKS PVSERVER [MPIRUN]]: plays the session of TestPluginWalk.xml back in ParaView's window, on the
display in the environment; with RANKS of a pvserver the data is there, and both sides load the plugin at their start, as an installed one is.

After each step it keeps a picture of the screen, OUTPUT/walk/STEP.png, and the state STEP.pvsm, and checks both. ParaView writes its states into
pipes, and stands still until they are read: the picture is taken before that.
"""
import csv
import os
import re
import select
import socket
import subprocess
import sys
import time

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "..", "..", "Support"))
import numpy  # noqa: E402
from smcheck import check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402
from smx11 import Display  # noqa: E402

from vtkmodules.util.numpy_support import numpy_to_vtk  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGWriter  # noqa: E402

paraview, plugin, output = sys.argv[1:4]
ranks, pvserver, mpirun = (sys.argv[4:] + ["0", None, None])[:3]
STEPS = ("opened", "mass", "material", "saved", "picked", "section", "plotted", "emptied", "reloaded")
COLORS = {"rail": (0.85, 0.1, 0.1), "bolt": (0.1, 0.25, 0.9)}
WINDOW = "pqClientMainWindow"
FRAME = WINDOW + "/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1/Container/Frame.0"
PANEL = WINDOW + "/propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel"
folder = os.path.join(output, "walk")
os.makedirs(folder, exist_ok=True)
for step in STEPS:
    for end in (".pvsm", ".png"):
        if os.path.exists(os.path.join(folder, step + end)):
            os.remove(os.path.join(folder, step + end))
    os.mkfifo(os.path.join(folder, step + ".pvsm"))


def write_assembly(path):
    """A rail of red with two blue bolts; the bolts have a density in the file."""
    bolt = Part("bolt", [((0, 0, 0), (20, 20, 60))], "7.85", "g/cm^3")
    rail = Part("rail", [((0, 0, 0), (200, 60, 30))])
    root = Assembly("machine", [(bolt, (30, 20, 30), None), (bolt, (150, 20, 30), None), (rail, (0, 0, 0), None)])
    write_product(path, root)
    with open(path, encoding="ascii") as file:
        text = file.read()
    # In the order of the parts: the shape of a part has its name, its solid and its context.
    shapes = re.findall(r"ADVANCED_BREP_SHAPE_REPRESENTATION\('(\w+)',\(#\d+,(#\d+)\),(#\d+)\)", text)
    lines = []
    for k, (name, solid, context) in enumerate(shapes):
        at = 900001 + 10 * k
        red, green, blue = COLORS[name]
        lines += [f"#{at}=COLOUR_RGB('',{red},{green},{blue});", f"#{at + 1}=FILL_AREA_STYLE_COLOUR('',#{at});",
                  f"#{at + 2}=FILL_AREA_STYLE('',(#{at + 1}));", f"#{at + 3}=SURFACE_STYLE_FILL_AREA(#{at + 2});",
                  f"#{at + 4}=SURFACE_SIDE_STYLE('',(#{at + 3}));", f"#{at + 5}=SURFACE_STYLE_USAGE(.BOTH.,#{at + 4});",
                  f"#{at + 6}=PRESENTATION_STYLE_ASSIGNMENT((#{at + 5}));", f"#{at + 7}=STYLED_ITEM('',(#{at + 6}),{solid});",
                  f"#{at + 8}=MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#{at + 7}),{context});"]
    end = text.rindex("ENDSEC;")
    with open(path, "w", encoding="ascii") as file:
        file.write(text[:end] + "\n".join(lines) + "\n" + text[end:])


def write_events(path):
    with open(os.path.join(here, "TestPluginWalk.xml"), encoding="utf-8") as file:
        events = file.read()
    # The window shows changes with a delay.
    saved = ('<pqevent object="WINDOW" command="pause" arguments="1500" />\n'
             '  <pqevent object="WINDOW/menubar/menu_File" command="activate" arguments="actionFileSaveServerState" />\n'
             '  <pqevent object="WINDOW/FileSaveServerStateDialog" command="filesSelected" arguments="$PARAVIEW_TEST_ROOT/{}.pvsm" />')
    events = re.sub(r"STEP\((\w+)\)", lambda found: saved.format(found.group(1)), events)
    # The table of materials has titles as a first row where the plugin has no library for Qt.
    titles = 0 if os.path.exists(os.path.join(os.path.dirname(plugin), "smParaViewPanel.so")) else 1
    events = events.replace("SECOND", str(1 + titles)).replace("TOTAL", str(2 + titles))
    events = events.replace("APPLY", "WINDOW/propertiesDock/propertiesPanel/Accept")
    for word, name in (("FRAME", FRAME), ("PANEL", PANEL), ("WINDOW", WINDOW)):
        events = events.replace(word + "/", name + "/").replace(f'"{word}"', f'"{name}"')
    with open(path, "w", encoding="utf-8") as file:
        file.write(events)


def grab(display, path):
    """The screen as red, green, blue, kept as a PNG file."""
    width, height, pixels = display.grab()
    colors = numpy.frombuffer(pixels, dtype=numpy.uint8).reshape(height, width, 4)[:, :, 2::-1]
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    scalars = numpy_to_vtk(numpy.ascontiguousarray(colors[::-1]).reshape(-1, 3), deep=True)
    image.GetPointData().SetScalars(scalars)
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()
    return colors.astype(int)


def take_step(display, step, window, deadline):
    """Waits until ParaView writes the state of a step; keeps picture and state. Returns the picture; None when ParaView ends before."""
    path = os.path.join(folder, step + ".pvsm")
    pipe = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
    while not select.select([pipe], [], [], 0.0)[0] or not (state := os.read(pipe, 1)):
        if window.poll() is not None or time.monotonic() > deadline:
            os.close(pipe)
            return None
        time.sleep(0.05)
    picture = grab(display, os.path.join(folder, step + ".png"))
    os.set_blocking(pipe, True)
    while more := os.read(pipe, 1 << 20):
        state += more
    os.close(pipe)
    os.remove(path)
    with open(path, "wb") as file:
        file.write(state)
    return picture


def start_server(log, environment):
    """Starts the pvserver and returns it with its address."""
    with socket.socket() as free:
        free.bind(("localhost", 0))
        port = free.getsockname()[1]
    launcher = [mpirun, "-np", ranks] if int(ranks) > 1 else []
    started = subprocess.Popen(launcher + [pvserver, "--force-offscreen-rendering", f"--server-port={port}"], env=environment,
                               stdout=subprocess.PIPE, stderr=log, text=True)
    for line in started.stdout:
        if "Accepting connection" in line:
            break
    return started, f"cs://localhost:{port}"


write_assembly(os.path.join(folder, "walk.step"))
events = os.path.join(folder, "walk.xml")
write_events(events)
pictures = {}
with open(os.path.join(folder, "walk.log"), "w", encoding="utf-8") as log:
    # That of pvpython's start: MPI has since put variables into it with which mpirun believes to be a child.
    with open("/proc/self/environ", encoding="utf-8", errors="surrogateescape") as file:
        environment = dict(entry.split("=", 1) for entry in file.read().split("\0") if "=" in entry)
    environment["HOME"] = folder
    server, options = None, ["--plugin-search-paths=" + os.path.dirname(plugin), "--plugins=SolidMoments"]
    if pvserver:
        environment["PV_PLUGIN_CONFIG_FILE"] = os.path.join(folder, "plugins.xml")
        with open(environment["PV_PLUGIN_CONFIG_FILE"], "w", encoding="utf-8") as file:
            file.write(f'<?xml version="1.0"?>\n<Plugins>\n  <Plugin name="SolidMoments" auto_load="1" filename="{plugin}"/>\n</Plugins>\n')
        server, address = start_server(log, environment)
        options = ["--server-url=" + address]
    window = subprocess.Popen([
        paraview, *options, "--dr", "--data-directory=" + folder,
        "--test-directory=" + folder, "--test-script=" + events, "--exit"], env=environment, stdout=log, stderr=log)
    try:
        display = Display()
        deadline = time.monotonic() + 540.0
        for step in STEPS:
            picture = take_step(display, step, window, deadline)
            if picture is None:
                break
            pictures[step] = picture
        try:
            window.wait(max(0.1, deadline - time.monotonic()))
        except subprocess.TimeoutExpired:
            pass
        check_equal("the playback ends with", 0, window.poll())
    finally:
        if window.poll() is None:
            window.kill()
        if server:
            # It ends with its client.
            try:
                server.communicate(timeout=30.0)
            except subprocess.TimeoutExpired:
                server.kill()
            check_equal("the server ends with", 0, server.returncode)
with open(os.path.join(folder, "walk.log"), encoding="utf-8", errors="replace") as log:
    text = log.read()
check_equal("errors and warnings in the log", [], [line[:200] for line in text.splitlines() if " ERR|" in line or "WARN|" in line])
check_equal("steps that were done", list(STEPS), [step for step in STEPS if step in pictures])


def count(step, matches):
    if step not in pictures:
        return -1
    colors = pictures[step]
    return int(matches(colors[:, :, 0], colors[:, :, 1], colors[:, :, 2]).sum())


def is_red(red, green, blue):
    return (red > 90) & (red > 3 * green) & (red > 3 * blue)


def is_blue(red, green, blue):
    return (blue > 90) & (blue > 2 * red) & (blue > 2 * green)


def is_cyan(red, green, blue):
    return (green > 90) & (blue > 90) & (green > 1.5 * red) & (blue > 1.5 * red)


def is_magenta(red, green, blue):
    return (red > 200) & (blue > 200) & (green < 60)


def read_state(step):
    path = os.path.join(folder, step + ".pvsm")
    if step not in pictures:
        return ""
    with open(path, encoding="utf-8") as file:
        return file.read()


def get_property(state, proxy, name):
    """Values of a property of the first proxy of that type."""
    found = re.search(rf'<Proxy group="\w+" type="{proxy}".*?</Proxy>', state, re.DOTALL)
    values = found and re.search(rf'<Property name="{name}".*?</Property>', found.group(), re.DOTALL)
    return re.findall(r'<Element index="\d+" value="([^"]*)"', values.group()) if values else None


check_true("opened: the colours of the file", count("opened", is_red) > 5000 and count("opened", is_blue) > 1000,
           f"{count('opened', is_red)} red, {count('opened', is_blue)} blue")
check_equal("opened: nothing is selected", 0, count("opened", is_magenta))
check_true("mass: a cyan marker", count("mass", is_cyan) > count("opened", is_cyan) + 100, f"{count('mass', is_cyan)}")
check_equal("material: a rule", ["rail", "Aluminium", "2700"], get_property(read_state("material"), "MassPropertiesGPU", "Materials"))
with open(os.path.join(folder, "walk.csv"), encoding="utf-8", newline="") as file:
    rows = list(csv.DictReader(file))
check_equal("saved: rows of the table", ["bolt", "bolt", "rail"], [row["Name"] for row in rows])
check_equal("saved: volumes", ["24000", "24000", "360000"], [f"{float(row['Volume (mm^3)']):.12g}" for row in rows])
check_equal("saved: 17 digits", [row["Mass (kg)"] for row in rows], [f"{float(row['Mass (kg)']):.17e}" for row in rows])
check_true("picked: a face is highlighted", count("picked", is_magenta) > 500, str(count("picked", is_magenta)))
section = read_state("section")
check_true("section: a filter on the reader", 'type="SolidSection"' in section and get_property(section, "SolidSection", "Normal") is not None)
check_true("emptied: nothing is left", "<ServerManagerState" in read_state("emptied") and 'type="STEPReader"' not in read_state("emptied"))
check_equal("legends until the plot", 0, sum(read_state(step).count('type="ScalarBarWidgetRepresentation"') for step in STEPS[:6]))
plotted, reloaded = read_state("plotted"), read_state("reloaded")
for proxy in ("STEPReader", "SolidSection", "NURBSDeform", "PlotDataOverTime", "RenderView", "XYChartView|QuartileChartView"):
    check_equal(f"reloaded: as many of {proxy} as were saved", (True, True), tuple(
        bool(re.search(rf'<Proxy group="\w+" type="({proxy})"', state)) for state in (plotted, reloaded)))
check_true("what was picked is not part of a state", "SelectedText" not in plotted and "(#" not in plotted)
check_equal("reloaded: filters", plotted.count('type="MassPropertiesGPU"'), reloaded.count('type="MassPropertiesGPU"'))
check_equal("reloaded: the rule", ["rail", "Aluminium", "2700"], get_property(reloaded, "MassPropertiesGPU", "Materials"))
check_true("reloaded: the view shows the part", count("reloaded", is_blue) > 300, str(count("reloaded", is_blue)))
finish()
