"""TestPluginApply.py PLUGIN.so FOLDER OUTPUT: the view after the GUI's Apply: translucent bodies, green marker, summary, red when flagged."""
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402
from smselection import count_selected_cells, get_selected_rows, pick, select_rows  # noqa: E402

from paraview import servermanager, simple  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402

plugin, folder, output = sys.argv[1:4]
simple.LoadPlugin(plugin, ns=globals())
manifest = Manifest(folder)
controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
names = ["Center of Mass", "Solids", "Summary", "Faces", "Edges", "Bodies", "Flagged", "Parts"]
view = simple.CreateRenderView()
view.ViewSize = [500, 400]
view.OrientationAxesVisibility = 0


def apply(filter_proxy, expected):
    """As pqApplyBehavior::showData(): shows every port in the view that its hints prefer, and hides the input."""
    source = filter_proxy.SMProxy
    for port, name in enumerate(expected):
        shown = controller.ShowInPreferredView(source, port, view.SMProxy)
        check_equal(f"{names[port]}: shown", name is not None, shown is not None)
        representation = view.SMProxy.FindRepresentation(source, port)
        check_equal(f"{names[port]}: representation in the render view", name,
                    representation.GetXMLName() if representation else None)
    check_equal("the bodies replace the input", "1",
                source.GetHints().FindNestedElementByName("Visibility").GetAttribute("replace_input"))
    simple.Hide(filter_proxy.Input, view)
    simple.ResetCamera(view)


def display(filter_proxy, port):
    return simple.GetRepresentation(servermanager.OutputPort(filter_proxy, port), view)


def count_pixels(matches):
    """Pixels of the view whose red, green and blue match."""
    simple.Render(view)
    image = view.CaptureWindow(1)
    colors = vtk_to_numpy(image.GetPointData().GetScalars()).astype(int)
    return int(matches(colors[:, 0], colors[:, 1], colors[:, 2]).sum())


def is_red(red, green, blue):
    return (red > green + 100) & (red > blue + 100)


def is_white(red, green, blue):
    return (red > 240) & (green > 240) & (blue > 240)


def is_cyan(red, green, blue):
    return (green > red + 40) & (blue > red + 40)


def is_magenta(red, green, blue):
    return (red > green + 60) & (blue > green + 60)


part = manifest.solid("slanted_hole", "moved")
reader = simple.OpenDataFile(part["path"])
simple.Show(reader, view)
mass = MassProperties(Input=reader)  # noqa: F821
check_equal("ports", names, [mass.SMProxy.GetOutputPortName(port) for port in range(mass.SMProxy.GetNumberOfOutputPorts())])
everything = ["MassMarkerRepresentation", None, "MassSummaryRepresentation", None, None, "MassBodiesRepresentation",
              "FlaggedRepresentation", None]
apply(mass, everything)
check_equal("views", ["RenderView"], [each.GetXMLName() for each in simple.GetViews()])
bodies = display(mass, 5)
check_true("the bodies are translucent", 0.2 < bodies.Opacity < 0.7, str(bodies.Opacity))
check_equal("the input keeps its own opacity", 1.0, float(simple.GetRepresentation(reader, view).Opacity))
marked = count_pixels(is_cyan)
mass.MarkerSize = 0.0
check_true("cyan pixels of marker and axes", marked > count_pixels(is_cyan) + 20 and marked > 300, str(marked))
mass.MarkerSize = 0.02
check_equal("red pixels", 0, count_pixels(is_red))
white = count_pixels(is_white)
check_true("white pixels of the text", white > 300, str(white))
summary = servermanager.Fetch(mass, idx=2).GetValueByName(0, "Text").ToString()
for word in ("Volume: 13789.20", "mm^3", "Centre of mass:", "Area: ", "(+- "):
    check_true(f"the summary says '{word}'", word in summary, summary)
mass.Density = 7850.0
check_true("and the mass once there is a density", "Mass: 0.10824524" in servermanager.Fetch(mass, idx=2).GetValueByName(
    0, "Text").ToString())
mass.ShowPrincipalAxes = 0
few = count_pixels(is_cyan)
mass.ShowPrincipalAxes = 1
check_true("the axes are shown by default", count_pixels(is_cyan) > 2 * few, f"{few} without")

# A tolerance that cannot be met: the status stands on red, and is white without it.
mass.RelativeTolerance = 1e-15
check_true("flagged: a status on red", count_pixels(is_red) > 300, str(count_pixels(is_red)))
flagged = servermanager.Fetch(mass, idx=2).GetValueByName(0, "Text").ToString()
check_true("flagged: the text says why", "tolerance-not-met" in flagged and "above the tolerance" in flagged, flagged)
mass.RelativeTolerance = 1e-9
check_equal("red pixels when the status is ok again", 0, count_pixels(is_red))
check_true("and white ones", count_pixels(is_white) > 300, str(count_pixels(is_white)))

# A drawing that runs the filter highlights the same face by the cells of the new mesh.
select_rows(mass, 3, [6])
fine = count_pixels(is_magenta), count_selected_cells(mass, 5)
reader.MeshDeviation, reader.MeshAngle = 0.2, 1.5
renewed = count_pixels(is_magenta), count_selected_cells(mass, 5)
mass.SMProxy.CleanSelectionInputs(3)
select_rows(mass, 3, [6])
check_equal("a face in a new mesh: pixels and cells", (count_pixels(is_magenta), count_selected_cells(mass, 5)), renewed)
check_true("a face in a new mesh: it is highlighted, by fewer cells", renewed[0] > 100 and 0 < renewed[1] < fine[1], f"{renewed} {fine}")
mass.SMProxy.CleanSelectionInputs(3)
reader.MeshDeviation, reader.MeshAngle = 0.001, 0.35

# Cell data of the bodies, and colouring by them.
arrays = servermanager.OutputPort(mass, 5).CellData
check("the solid's volume", part["volume"], arrays["VolumeOfWholeSolid"].GetRange()[0], 1e-6 * part["volume"], "(float)")
shares = arrays["FaceShare"].GetRange()
check_true("shares differ from face to face", shares[0] < 0.1 < shares[1] < 1.0, str(shares))
check_true("gaps are small and known", 0.0 <= arrays["FaceGap"].GetRange()[1] < 1e-6, str(arrays["FaceGap"].GetRange()))
check_true("bounds are positive", 0.0 < arrays["FaceBound"].GetRange()[0], str(arrays["FaceBound"].GetRange()))
simple.ColorBy(bodies, ("CELLS", "FaceShare"))
simple.GetColorTransferFunction("FaceShare").ApplyPreset("Cool to Warm", True)  # ParaView 6 has another default
bodies.RescaleTransferFunctionToDataRange(False, True)
bodies.Opacity = 1.0
check_true("coloured by share: red and blue faces", count_pixels(is_red) > 1000, str(count_pixels(is_red)))

# Rows that are selected in the table highlight their solids.
simple.Delete(mass)
simple.Delete(reader)
COUNT = 100  # ParaView takes time by the number of solids
assembly = os.path.join(output, "PluginApply.step")
block = Part("block", [((0, 0, 0), (5, 4, 5))])
write_product(assembly, Assembly("grid", [(block, (8 * (i % 10), 8 * (i // 10), 0), None) for i in range(COUNT)]))
reader = simple.OpenDataFile(assembly)
reader.MeshDeviation, reader.MeshAngle = 0.05, 1.0  # drawing takes most of the time
simple.Show(reader, view)
many = MassProperties(Input=reader, Density=2700.0)  # noqa: F821
apply(many, everything)
check_equal("nothing is selected", 0, count_pixels(is_magenta))
total = servermanager.OutputPort(many, 5).GetDataInformation().GetNumberOfCells()
select_rows(many, 1, [COUNT - 1])
one = count_selected_cells(many, 5)
check_equal("cells of a selected solid", total // COUNT, one)
check_true("magenta pixels of a selected solid", count_pixels(is_magenta) > 5, str(count_pixels(is_magenta)))
select_rows(many, 1, range(20, 40))
check_equal("cells of twenty selected solids", 20 * one, count_selected_cells(many, 5))
check_true("more magenta pixels", count_pixels(is_magenta) > 300, str(count_pixels(is_magenta)))
many.SMProxy.CleanSelectionInputs(1)
check_equal("cleared with the rows", 0, count_pixels(is_magenta))
# A selection in the view stays when ParaView clears the rows.
select_rows(many, 1, [COUNT - 1])
many.SMProxy.SetSelectionInput(5, pick("BlockSelectorsSelectionSource", "BlockSelectors", ["/Root"]), 0)
check_equal("all are selected in the view", total, count_selected_cells(many, 5))
many.SMProxy.CleanSelectionInputs(1)
check_equal("and stay selected", total, count_selected_cells(many, 5))
check_equal("with the rows of all solids", list(range(COUNT)), get_selected_rows(many, 1))

# Two cells of the third solid and one of the tenth; composite indices count every partitioned dataset before
# its partition.
many.SMProxy.SetSelectionInput(5, pick("CompositeDataIDSelectionSource", "IDs", [6, 0, 1, 6, 0, 2, 20, 0, 0]), 0)
check_equal("rows of picked faces", [2, 9], get_selected_rows(many, 1))
check_true("their faces light up as a whole", 3 < count_selected_cells(many, 5) < 24, str(count_selected_cells(many, 5)))
faces = servermanager.Fetch(many, idx=3)
picked = get_selected_rows(many, 3)
check_equal("rows of their faces", [2, 9], sorted({faces.GetValueByName(row, "Solid").ToInt() for row in picked}))
summary = display(many, 2).SMProxy.GetProperty("SelectedText")


def get_text():
    """Returns the text that the view shows for the selection, in one line."""
    return " ".join(summary.GetElement(0).split())


solids = servermanager.Fetch(many, idx=1)
for words in ("face 0 (#", "block (solid 3)", "block (solid 10)", "mass 0.00027 kg", "area 130 mm^2 (+- ", "volume ", "mm^3 (+- ", "widest gap ", "2 solids: mass 0.00054 kg"):
    check_true(f"the view says '{words}'", words in get_text(), get_text())
many.Density = 5400.0
many.UpdatePipeline()
check_true("another density: another mass", "2 solids: mass 0.00108 kg" in get_text(), get_text())
many.Density = 2700.0
many.SMProxy.CleanSelectionInputs(5)
check_equal("rows are cleared with the pick", [], get_selected_rows(many, 1) + get_selected_rows(many, 3))
check_equal("and the text", "", get_text())
many.SMProxy.SetSelectionInput(5, pick("BlockSelectionSource", "Blocks", [8]), 0)
check_equal("row of a picked block", [3], get_selected_rows(many, 1))
select_rows(many, 1, [7])
check_equal("rows that the user selects replace a pick", one, count_selected_cells(many, 5))
many.SMProxy.CleanSelectionInputs(1)
check_equal("nothing is selected", 0, count_pixels(is_magenta))

# Rows of faces highlight these faces: two of one solid, and one of another.
faces = servermanager.Fetch(many, idx=3)
solid_of = [faces.GetValueByName(row, "Solid").ToInt() for row in range(faces.GetNumberOfRows())]
rows = [solid_of.index(4), solid_of.index(4) + 1, solid_of.index(COUNT - 1)]
select_rows(many, 3, rows)
highlighted = count_selected_cells(many, 5)
check_true("cells of selected faces", 3 <= highlighted < 2 * one, f"{highlighted}, of a solid {one}")
check_true("magenta pixels of selected faces", count_pixels(is_magenta) > 0, str(count_pixels(is_magenta)))
select_rows(many, 3, [row for row, solid in enumerate(solid_of) if solid == 4])
check_equal("all faces of a solid are its cells", one, count_selected_cells(many, 5))
select_rows(many, 3, rows[:1])
first = count_selected_cells(many, 5)
select_rows(many, 3, rows[1:2])
check_true("faces of one solid together", 0 < first < highlighted and first + count_selected_cells(many, 5) < highlighted, f"{first} of {highlighted}")
many.SMProxy.CleanSelectionInputs(1)
check_true("they stay when other rows are cleared", count_selected_cells(many, 5) > 0)
select_rows(many, 1, [COUNT - 1])
check_equal("rows of solids replace them", one, count_selected_cells(many, 5))
many.SMProxy.CleanSelectionInputs(3)
check_equal("and stay when rows of faces are cleared", one, count_selected_cells(many, 5))
many.SMProxy.CleanSelectionInputs(1)
select_rows(many, 3, rows)
many.SMProxy.CleanSelectionInputs(3)
check_equal("cleared with the rows of faces", 0, count_pixels(is_magenta))

# Rows of edges draw these edges.
edges = servermanager.Fetch(many, idx=4)
select_rows(many, 4, [0])
edge = count_pixels(is_magenta)
check_true("magenta pixels of an edge", edge > 3, str(edge))
check_true("the view names the edge", re.search(r"edge \d+ \(#\d+\) of ", get_text()) and "used 2 times by faces" in get_text(), get_text())
select_rows(many, 4, range(edges.GetNumberOfRows()))
check_true("those of all edges", count_pixels(is_magenta) > 50 * edge, str(count_pixels(is_magenta)))
check_true("lines of the edges alone: no cells", not many.SMProxy.GetSelectionInput(5))
many.SMProxy.CleanSelectionInputs(4)
check_equal("edges cleared with the rows", (0, ""), (count_pixels(is_magenta), get_text()))

# The row of the total stands for all solids.
check_equal("no row of a total by default", COUNT, solids.GetNumberOfRows())
many.TotalRow = 1
solids = servermanager.Fetch(many, idx=1)
check_equal("the total row", ("Total", "", COUNT + 1), (solids.GetValueByName(COUNT, "Name").ToString(), solids.GetValueByName(COUNT, "Id").ToString(),
                                                  solids.GetNumberOfRows()))
totals = servermanager.Fetch(many, idx=0).GetFieldData()
for name in ("Volume", "VolumeBound", "Mass", "MaxGap"):
    check_equal(f"total of {name}", totals.GetArray(name).GetValue(0), solids.GetValueByName(COUNT, name).ToDouble())
check_equal("status of the total", "ok", solids.GetValueByName(COUNT, "Status").ToString())
select_rows(many, 1, [COUNT])
check_equal("its row highlights all solids", total, count_selected_cells(many, 5))
many.SMProxy.CleanSelectionInputs(1)
many.TotalRow = 0

# Labels are white, and there are none at first.
shown = simple.GetRepresentation(servermanager.OutputPort(many, 5), view)
simple.Hide(servermanager.OutputPort(many, 2), view)


def is_white(red, green, blue):
    return (red > 240) & (green > 240) & (blue > 240)


check_equal("no labels", (0, 0), (count_pixels(is_white), shown.SMProxy.GetProperty("PartLabels").GetElement(0)))
shown.PartLabels = "Name"
short = count_pixels(is_white)
blocks = list(shown.BlockSelectors)
if hasattr(shown, "Assembly"):  # ParaView 5.12 and later
    shown.Assembly = "Hierarchy"
shown.BlockSelectors = ["/Root/*[50]"]
alone = count_pixels(is_white)
check_true("hidden solids have no label", 20 < alone < short // 3, f"{alone} of {short} pixels")
shown.BlockSelectors = blocks
check_equal("labels are back with the solids", short, count_pixels(is_white))
shown.PartLabels = "Name and mass"
both = count_pixels(is_white)
check_true("labels with names, and others with masses", 100 < short != both > 100, f"{short} {both} pixels")
shown.LabelColor = [1.0, 1.0, 0.0]
check_equal("labels of another colour", 0, count_pixels(is_white))
shown.LabelColor = [1.0, 1.0, 1.0]
shown.Visibility = 0
check_equal("labels are hidden with the solids", 0, count_pixels(is_white))
shown.Visibility = 1
shown.PartLabels = "None"
check_equal("labels switched off", 0, count_pixels(is_white))

# The edges that make a solid open are drawn in red, with their number, as long as the port is visible.
simple.HideAll(view)
opened = MassProperties(Input=simple.OpenDataFile(manifest.special("open_solid")["path"]))  # noqa: F821
simple.Show(opened.Input, view)
apply(opened, everything)
simple.Hide(servermanager.OutputPort(opened, 2), view)
flagged = servermanager.OutputPort(opened, 6)
check_equal("open edges", 4, flagged.GetDataInformation().GetNumberOfCells())
check("area in doubt: the missing face", 200.0, flagged.CellData["AreaInDoubt"].GetRange()[0], 1e-10)
check("volume in doubt", 200.0 * 0.5 * 1400.0**0.5 / 3.0, flagged.CellData["VolumeInDoubt"].GetRange()[1], 1e-10)
shown = display(opened, 6)
check_equal("not coloured by an array", "", shown.ColorArrayName[1] or "")
marked = count_pixels(is_red)
check_true("red pixels of lines and number", marked > 400, str(marked))
check_true("the number is white", count_pixels(is_white) > 10)
shown.NumberColor = [0.0, 1.0, 1.0]
check_equal("a colour of the number", 0, count_pixels(is_white))
shown.NumberColor = [1.0, 1.0, 1.0]
lines = count_pixels(is_red)
simple.Hide(flagged, view)
check_equal("hidden", 0, count_pixels(is_red))
check_equal("hidden, with the number", 0, count_pixels(is_white))
simple.Show(flagged, view, "FlaggedRepresentation")
check_equal("shown again", lines, count_pixels(is_red))

# Tables open in a spreadsheet on request.
sheet = simple.CreateView("SpreadSheetView")
for port in (1, 3):
    check_true(f"{names[port]}: opens in a spreadsheet", sheet.SMProxy.CanDisplayData(many.SMProxy, port)
               and controller.Show(many.SMProxy, port, sheet.SMProxy) is not None)
finish()
