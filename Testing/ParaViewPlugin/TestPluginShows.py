"""TestPluginShows.py PLUGIN.so SOLIDS OUTPUT HELP.qch: what Apply shows in addition to the numbers: the colours of the file, several summaries, units in
colour bars, values of a new NURBS Deform, the button that runs a filter again, arrays per face, and the pages behind "?"."""
import os
import re
import sqlite3
import sys
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402
from smpicture import to_colors  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, folder, output, pages = sys.argv[1:5]
simple.LoadPlugin(plugin, ns=globals())
manifest = Manifest(folder)
view = simple.CreateRenderView()
view.ViewSize = [640, 480]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.2, 0.2, 0.2]
controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()


def paint_red(source):
    """The path of a copy of a file with one solid, in which the solid is red."""
    with open(source, encoding="utf-8") as file:
        text = file.read()
    brep = re.search(r"(#\d+)\s*=\s*MANIFOLD_SOLID_BREP", text).group(1)
    context = re.search(r"ADVANCED_BREP_SHAPE_REPRESENTATION\('[^']*',\([^)]*\),(#\d+)\)", text).group(1)
    lines = ("#900001=COLOUR_RGB('',0.9,0.1,0.1);", "#900002=FILL_AREA_STYLE_COLOUR('',#900001);", "#900003=FILL_AREA_STYLE('',(#900002));",
             "#900004=SURFACE_STYLE_FILL_AREA(#900003);", "#900005=SURFACE_SIDE_STYLE('',(#900004));",
             "#900006=SURFACE_STYLE_USAGE(.BOTH.,#900005);", "#900007=PRESENTATION_STYLE_ASSIGNMENT((#900006));",
             f"#900008=STYLED_ITEM('',(#900007),{brep});",
             f"#900009=MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#900008),{context});")
    end = text.rindex("ENDSEC;")
    path = os.path.join(output, "PluginShows_red.step")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text[:end] + "\n".join(lines) + "\n" + text[end:])
    return path


def show_all(source):
    """The outputs as the GUI's Apply shows them."""
    for port in range(source.SMProxy.GetNumberOfOutputPorts()):
        controller.ShowInPreferredView(source.SMProxy, port, view.SMProxy)
    return source


def display(source, port=0):
    return simple.GetRepresentation(servermanager.OutputPort(source, port), view)


def picture():
    simple.Render(view)
    return to_colors(view.CaptureWindow(1))


def count_red():
    colors = picture()
    return int(((colors[:, :, 0] > 100) & (colors[:, :, 0] > 3 * colors[:, :, 1])).sum())


# --- colours of the file
red = show_all(simple.OpenDataFile(paint_red(manifest.solid("box")["path"])))
simple.ResetCamera(view)
shown = display(red)
check_equal("the part is coloured by its file", ("CELLS", "Color"), (shown.ColorArrayName[0], shown.ColorArrayName[1]))
check_true("red pixels", count_red() > 5000, str(count_red()))
check_true("no colour bar", not shown.SMProxy.IsScalarBarVisible(view.SMProxy))
shown.SetScalarBarVisibility(view, True)
check_true("not on request either", not shown.SMProxy.IsScalarBarVisible(view.SMProxy))
plain = show_all(simple.OpenDataFile(manifest.solid("box")["path"]))
check_true("a file without colours has one colour", not display(plain).ColorArrayName[1], str(display(plain).ColorArrayName))
simple.Delete(plain)

# --- arrays per face, and their units
mass = show_all(MassProperties(Input=red, Density=1000.0))  # noqa: F821
bodies = display(mass, 5)
bodies.Opacity = 1.0
simple.Hide(red, view)
check_equal("the bodies, too", "Color", bodies.ColorArrayName[1])
check_true("red pixels of the bodies", count_red() > 5000, str(count_red()))
simple.ColorBy(bodies, ("CELLS", "VolumeOfWholeSolid"))
bodies.SetScalarBarVisibility(view, True)
bar = simple.GetScalarBar(simple.GetColorTransferFunction("VolumeOfWholeSolid"), view)
check_equal("title of a colour bar", "VolumeOfWholeSolid (mm^3)", bar.Title)
check_true("coloured by an array: red in the colour bar only", count_red() < 1000, str(count_red()))
bar.Title = "mine"
bodies.SetScalarBarVisibility(view, True)
check_equal("a title of one's own stays", "mine", bar.Title)
simple.ColorBy(bodies, ("CELLS", "Color"))
check_true("and back", count_red() > 5000, str(count_red()))
box = manifest.solid("box")
cells = servermanager.OutputPort(mass, 5).CellData
check("mass on the cells", 1e-6 * box["volume"], cells["MassOfWholeSolid"].GetRange()[0], 1e-12 * box["volume"], "(float)")
areas = cells["FaceArea"].GetRange()
faces = servermanager.Fetch(mass, idx=3)
column = [faces.GetValueByName(i, "SurfaceArea").ToDouble() for i in range(faces.GetNumberOfRows())]
check("area of the smallest face", min(column), areas[0], 1e-6 * areas[0], "(float)")
check("area of the largest face", max(column), areas[1], 1e-6 * areas[1], "(float)")
check_equal("indices of the faces, as in the meshes", list(range(6)), [faces.GetValueByName(i, "FaceIndex").ToInt() for i in range(6)])

# --- several summaries
if servermanager.ProxyManager().SMProxyManager.HasDefinition("filters", "SolidStability"):
    standing = show_all(StaticStability(Input=red))  # noqa: F821
    check_equal("the summary of Static Stability", "MassSummaryRepresentation", display(standing, 2).SMProxy.GetXMLName())
    simple.Delete(standing)
if servermanager.ProxyManager().SMProxyManager.HasDefinition("filters", "SolidSection"):
    cut = show_all(Section(Input=red, Point=[0.0, 0.0, 5.0]))  # noqa: F821
    check_equal("the clipped part", ("SectionRepresentation", "Color"), (display(cut, 7).SMProxy.GetXMLName(), display(cut, 7).ColorArrayName[1]))
    check_true("the solids next to it are not shown", view.SMProxy.FindRepresentation(cut.SMProxy, 5) is None)
    simple.Delete(cut)
tilted = show_all(Buoyancy(Input=red, Point=[0.0, 0.0, 5.0]))  # noqa: F821
for source in (mass, tilted):
    for port in (0, 5):
        display(source, port).Visibility = 0
texts = [display(source, 2) for source in (mass, tilted)]


def count_text(first, second):
    texts[0].Visibility, texts[1].Visibility = first, second
    colors = picture()
    lit = (colors > 120).all(axis=2)
    rows = lit.any(axis=1).nonzero()[0]
    return int(lit.sum()), (int(rows.max()) if len(rows) else -1)  # the first row is the lowest


bodies.SetScalarBarVisibility(view, False)
simple.HideScalarBarIfNotNeeded(simple.GetColorTransferFunction("VolumeOfWholeSolid"), view)
check_equal("nothing but text is lit", 0, count_text(0, 0)[0])
both, _ = count_text(1, 1)
one, top_of_one = count_text(1, 0)
other, top_of_other = count_text(0, 1)
view.ViewSize = [200, 480]
narrow, _ = count_text(1, 0)
beyond = int((picture()[:, -1:] > 120).all(axis=2).sum())
check_true("lines of a narrow view are broken, not cut", abs(narrow - one) < 0.05 * one and beyond == 0, f"{narrow}, {one}; {beyond} at the border")
view.ViewSize = [640, 480]
# Both have a heading then; where they overlapped, fewer pixels would be lit.
check_true("two summaries do not overlap", one > 300 and other > 300 and both > one + other, f"{one} + {other}, {both}")
check_true("the second is at the top when the first is hidden", abs(top_of_other - top_of_one) <= 4, f"{top_of_one} {top_of_other}")

# --- the button that runs a filter again
runs = []
mass.GetClientSideObject().AddObserver("StartEvent", lambda *_: runs.append(1))
mass.UpdatePipeline()
before = len(runs)
mass.SMProxy.InvokeCommand("ComputeAgain")
mass.UpdatePipeline()
check_equal("Compute again runs the filter", before + 1, len(runs))

# --- a new NURBS Deform


def points(source):
    return servermanager.OutputPort(source, 0).GetDataInformation().GetBounds()


deform = NURBSDeform(Input=red)  # noqa: F821
before = points(red)
check_equal("displacement of a new filter", [0.0, 0.0, 0.0], list(deform.Displacement))
for axis in range(3):
    check(f"its centre is that of the part, {axis}", 0.5 * (before[2 * axis] + before[2 * axis + 1]), deform.Center[axis], 1e-12)
diagonal = sum((before[2 * axis + 1] - before[2 * axis]) ** 2 for axis in range(3)) ** 0.5
check("its radius is a quarter of the part", 0.25 * diagonal, deform.Radius, 1e-12)
for mode in ("Displace", "Lattice"):
    deform.Mode = mode
    deform.UpdatePipeline()
    check_equal(f"{mode}: nothing moves at first", before, points(deform))
deform.LatticeDisplacements = [number for corner in range(4) for number in (corner % 2, corner // 2, 1, 3.0, 0.0, 0.0)]
deform.UpdatePipeline()
check("the lattice shears it", before[1] + 3.0, points(deform)[1], 0.02, "(the lattice is a little larger than the part)")
check("and leaves its bottom", before[0], points(deform)[0], 0.02)
still = NURBSDeform(Input=red, Displacement=[0.0, 2.0, 0.0])  # noqa: F821
check_equal("a displacement that a script gives, of everything", ([0.0, 2.0, 0.0], 0.0), (list(still.Displacement), still.Radius))

# --- times of an edit
moved = NURBSTransform(Input=red, Translation=[8.0, 0.0, 0.0], TimeSteps=5)  # noqa: F821
moved.UpdatePipeline()
check_equal("times of a Transform", [0.0, 0.25, 0.5, 0.75, 1.0], list(moved.TimestepValues))
sheared = NURBSDeform(Input=red, Mode="Lattice", TimeSteps=3, LatticeDisplacements=list(deform.LatticeDisplacements))  # noqa: F821
manager_type = servermanager.vtkSMProxyManager
for source, count, step in ((moved, 5, 2.0), (sheared, 3, None)):
    total = MassProperties(Input=source, Density=1000.0)  # noqa: F821
    plot = simple.PlotDataOverTime(Input=servermanager.OutputPort(total, 1), FieldAssociation="Rows", OnlyReportSelectionStatistics=0)
    plot.UpdatePipeline()
    table = servermanager.Fetch(plot).GetBlock(0)
    centers = [table.GetColumnByName("CenterOfMass").GetComponent(i, 0) for i in range(table.GetNumberOfRows())]
    volumes = [table.GetColumnByName("Volume").GetComponent(i, 0) for i in range(table.GetNumberOfRows())]
    check_equal("rows of Plot Data Over Time", count, len(centers))
    chart = simple.CreateView("QuartileChartView")
    shown = simple.Show(plot, chart, "QuartileChartRepresentation")
    # From 5.12 on ParaView hides components of vectors, whatever a plugin says. From 6.1 on names have no
    # "(id=0)", and the plugin leaves alone those that other data may have.
    version = (manager_type.GetVersionMajor(), manager_type.GetVersionMinor())
    series = ["CenterOfMassBound", "CenterOfMassSpread", "Volume", "VolumeBound", "VolumeSpread"]
    series += ["CenterOfMass_X", "CenterOfMass_Y", "CenterOfMass_Z"] if version < (5, 12) else []
    series += ["Density", "Faces", "Mass", "MassBound", "MassSpread"] if version >= (6, 1) else []
    check_equal("series that are shown at first", sorted(series), sorted(name.replace(" (id=0)", "") for name in shown.SeriesVisibility))
    simple.Delete(chart)
    for i, (volume, center) in enumerate(zip(volumes, centers)):
        check(f"volume at step {i}", box["volume"], volume, 1e-9 * box["volume"])
        # The shear moves the centre by half of what the top moves, 3 at the end.
        check(f"centre at step {i}", centers[0] + i * (step or 0.75), center, 1e-9)
check("and starts where the input is", box["center_of_mass"][0], centers[0], 1e-9)

# --- help
if os.path.exists(pages):
    with sqlite3.connect(pages) as help_file:
        names = {os.path.basename(row[0]) for row in help_file.execute("SELECT Name FROM FileNameTable")}
        contents = {os.path.basename(name): zlib.decompress(data[4:]).decode("utf-8") for name, data in help_file.execute(
            "SELECT Name, Data FROM FileNameTable JOIN FileDataTable ON FileNameTable.FileId = FileDataTable.Id WHERE Data IS NOT NULL")}
    for name in ("MassPropertiesGPU", "SolidSection", "SurfaceIntegralGPU", "Buoyancy", "SolidStability"):
        listed = re.search("<ol.*</ol>", contents.get(f"filters.{name}.html", "")) or [""]
        check_true(f"{name} says what each of its outputs is", listed[0].count("<li>") > 3 and listed[0].count("<li>") == listed[0].count("</b>: "),
                   str(listed[0])[:300])
    for name in ("sources.STEPReader", "filters.MassPropertiesGPU", "filters.NURBSDeform", "filters.SolidStability", "writers.STEPWriter"):
        check_true(f"a page for {name}", name + ".html" in names, str(sorted(names)))
    with open(plugin, "rb") as file:
        check_true("the plugin brings them", file.read().count(b"SolidMoments_qch") > 0)
# --- a display mesh that is switched on, and a coarse one of an assembly
for port in (None, 5):
    lazy = simple.OpenDataFile(paint_red(manifest.solid("box")["path"]))
    lazy.DisplayMesh = "Never"
    weighed = MassProperties(Input=lazy)  # noqa: F821
    weighed.UpdatePipeline()
    check_equal("no cells without a view", 0, lazy.GetDataInformation().GetNumberOfCells())
    simple.HideAll(view)
    lazy.DisplayMesh = "Always"
    shown = simple.Show(lazy if port is None else servermanager.OutputPort(weighed, port), view)
    simple.ResetCamera(view)
    simple.Render(view)
    simple.ColorBy(shown, ("CELLS", "Color"))
    check_true("red pixels with a mesh", count_red() > 5000, str(count_red()))
    lazy.SMProxy.GetOutputPort(0).InvalidateDataInformation()
    check_true("cells with a view", lazy.GetDataInformation().GetNumberOfCells() > 0)
    simple.Delete(weighed)
    simple.Delete(lazy)
assembly = simple.OpenDataFile(manifest.special("assembly")["path"])
cells = {}
for above, refined in ((5000000, 0), (1000, 0), (1000, 1)):
    assembly.CoarseAbove = above
    assembly.Refined = refined
    assembly.UpdatePipeline()
    cells[above, refined] = assembly.GetDataInformation().GetNumberOfCells()
check_true("fewer triangles of a large assembly", 0 < cells[1000, 0] < cells[5000000, 0] / 2, str(cells))
check_equal("as many on request", cells[5000000, 0], cells[1000, 1])

finish()
