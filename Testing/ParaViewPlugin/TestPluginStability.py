"""TestPluginStability.py PLUGIN.so FOLDER: Static Stability of a box and of a ball in ParaView's pipeline."""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

from smpicture import to_colors  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, folder = sys.argv[1:3]
simple.LoadPlugin(plugin, ns=globals())
manifest = Manifest(folder)


def number(data, name):
    return data.GetFieldData().GetArray(name).GetComponent(0, 0)


def text(data, name):
    return data.GetFieldData().GetAbstractArray(name).GetValue(0)


box = manifest.solid("box")
center = box["center_of_mass"]
reader = simple.OpenDataFile(box["path"])
standing = StaticStability(Input=reader)  # noqa: F821
view = simple.CreateRenderView()
view.OrientationAxesVisibility = 0
simple.Show(reader, view)
controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
for port in (0, 2):  # as the GUI's Apply does
    controller.ShowInPreferredView(standing.SMProxy, port, view.SMProxy)
simple.ResetCamera(view)
simple.Render(view)
shown = simple.GetRepresentation(servermanager.OutputPort(standing, 0), view)
check_equal("the drawing has a representation of its own", "StabilityRepresentation", shown.GetXMLName())
check_equal("coloured by", ["CELLS", "StabilityColor"], list(shown.ColorArrayName))
check_equal("by the colours themselves", 0, int(shown.MapScalars))
check_equal("legends", [], [each for each in view.Representations if "ScalarBar" in each.GetXMLName() and each.Visibility])
shown.LineWidth = 4.0
simple.Hide(reader, view)
pixels = to_colors(view.CaptureWindow(1))
red, green, blue = (pixels[:, :, i] for i in range(3))
check_true("the verdict is drawn in green", ((green > red + 60) & (green > blue + 60)).sum() > 300)
check_equal("and nothing in red", 0, int(((red > green + 60) & (red > blue + 60)).sum()))
simple.Show(reader, view)
check_true("the input stays visible", simple.GetRepresentation(reader, view).Visibility == 1)
drawing = servermanager.Fetch(standing, idx=0)
check_equal("verdict", "stable", text(drawing, "Stability"))
margin = min(center[0], center[1])  # a corner of the box is the origin
check("margin", margin, number(drawing, "StabilityMargin"), number(drawing, "StabilityMarginBound"))
check("tip angle", math.degrees(math.atan2(margin, center[2])), number(drawing, "TipAngle"), number(drawing, "TipAngleBound"))
colors = drawing.GetCellData().GetArray("StabilityColor")
check_true("a colour for every cell", colors.GetNumberOfTuples() == drawing.GetNumberOfCells() > 3)
check_true("green somewhere", any(colors.GetTuple(i)[1] > 150 > colors.GetTuple(i)[0]
                                  for i in range(colors.GetNumberOfTuples())))
check_equal("rows of bodies", 1, servermanager.Fetch(standing, idx=1).GetNumberOfRows())
check_true("summary", "stable" in servermanager.Fetch(standing, idx=2).GetValueByName(0, "Text").ToString())
check_equal("rows of sides", 4, servermanager.Fetch(standing, idx=3).GetNumberOfRows())

# Properties reach the filter.
standing.GravityDirection = [-1, 0, -1e-3]
standing.GroundNormal = [0, 0, 1]
check_equal("nearly sideways on a slope", "unstable", text(servermanager.Fetch(standing, idx=0), "Stability"))
standing.GravityDirection = [0, 0, -1]
standing.Ground = "Plane"
standing.GroundOrigin = [0, 0, -1]
check_equal("a plane below", "no-contact", text(servermanager.Fetch(standing, idx=0), "Stability"))
reader.FileName = manifest.solid("sphere")["path"]
standing.Ground = "Lowest points"
check_equal("a ball", "too-close", text(servermanager.Fetch(standing, idx=0), "Stability"))
finish()
