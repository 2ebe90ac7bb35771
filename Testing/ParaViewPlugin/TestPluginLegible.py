"""TestPluginLegible.py PLUGIN.so FOLDER OUTPUT: text in the view has a contrast of 4.5 : 1 on ParaView's backgrounds and before parts of any colour.

The contrast is measured in the picture: pixels of the text's own colour against those of the same place when the text itself is transparent.
The status has a red box of its own, by which its pixels differ from those of a shadow of the text.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402
from paraview.vtk.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import vtkOutputWindow  # noqa: E402

plugin, folder, output = sys.argv[1:4]
simple.LoadPlugin(plugin, remote=False, ns=globals())
view = simple.CreateRenderView(ViewSize=[640, 480])
view.OrientationAxesVisibility = 0
manager = servermanager.vtkSMParaViewPipelineControllerWithRendering()
reader = simple.OpenDataFile(Manifest(folder).special("open_solid")["path"])
mass = MassProperties(Input=reader)  # noqa: F821
mass.UpdatePipeline()
for port in (2, 5, 6):
    manager.ShowInPreferredView(mass.SMProxy, port, view.SMProxy)
manager.Hide(reader.SMProxy, 0, view.SMProxy)
summary = simple.GetRepresentation(servermanager.OutputPort(mass, 2), view)
bodies = simple.GetRepresentation(servermanager.OutputPort(mass, 5), view)
flagged = simple.GetRepresentation(servermanager.OutputPort(mass, 6), view)
simple.ResetCamera(view)
view.CameraParallelScale *= 0.3
simple.GetActiveCamera().Zoom(4.0)
PALETTES = ("BlueGrayBackground", "WhiteBackground", "LightGrayBackground", "BlackBackground", "WarmGrayBackground", "NeutralGrayBackground")


def picture():
    simple.Render(view)
    image = view.CaptureWindow(1)
    return vtk_to_numpy(image.GetPointData().GetScalars()).astype(float) / 255.0


def luminance(colors):
    linear = colors / 12.92 * (colors <= 0.04045) + ((colors + 0.055) / 1.055) ** 2.4 * (colors > 0.04045)
    return linear @ (0.2126, 0.7152, 0.0722)


def measure_contrast(drawn, behind, color, where):
    """Returns the smallest contrast of the pixels that have a colour only when the text is drawn, and their number."""
    is_text = where & (abs(drawn - color).max(axis=1) < 0.04) & (abs(drawn - behind).max(axis=1) > 0.1)
    a, b = luminance(drawn[is_text]), luminance(behind[is_text])
    contrast = (a.clip(min=b) + 0.05) / (b.clip(max=a) + 0.05)
    return (contrast.min() if len(a) else 0.0), len(a)


def measure_summary():
    """Returns the contrast and the number of pixels of the text and of the status."""
    drawn = picture()
    summary.Opacity = 0.0
    behind = picture()
    summary.Opacity = 1.0
    is_status = abs(behind - list(summary.FlaggedColor)).max(axis=1) < 0.02
    return measure_contrast(drawn, behind, list(summary.Color), ~is_status), measure_contrast(drawn, behind, [1.0, 1.0, 1.0], is_status)


def check_contrast(what, measured):
    """Checks for 4.5 : 1. Strokes are thin: "Status: open" has 14 pixels that are not blended with what is behind."""
    contrast, pixels = measured
    check_true(f"{what}: contrast", pixels >= 10 and contrast >= 4.5, f"{contrast:.2f} of {pixels} pixels")


errors = []
vtkOutputWindow.GetInstance().AddObserver("ErrorEvent", lambda *_: errors.append("an error was printed"))
check_true("the solid is flagged", "Status: open" in servermanager.Fetch(mass, idx=2).GetValueByName(0, "Text").ToString())
for opacity, color in ((0.0, [1.0, 1.0, 1.0]), (1.0, [1.0, 1.0, 1.0]), (1.0, [1.0, 0.9, 0.0]), (1.0, [0.1, 0.8, 0.1]), (1.0, [0.9, 0.1, 0.1]), (1.0, [0.0, 0.0, 0.0])):
    bodies.Opacity = max(opacity, 0.01)
    bodies.AmbientColor = bodies.DiffuseColor = color
    bodies.Ambient, bodies.Diffuse, bodies.Specular = 1.0, 0.0, 0.0
    simple.ColorBy(bodies, None)
    for palette in PALETTES:
        simple.LoadPalette(palette)
        for name, measured in zip(("text", "status"), measure_summary()):
            check_contrast(f"{name}, part {color} with opacity {opacity} on {palette}", measured)
simple.LoadPalette("WhiteBackground")
bodies.AmbientColor = bodies.DiffuseColor = [1.0, 1.0, 1.0]
# The number of the open side is outside the summary.
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-1.0, -1.7, 1.1], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]
simple.ResetCamera(view)
drawn, number_color = picture(), list(flagged.NumberColor)
flagged.NumberColor = list(summary.FlaggedColor)
check_contrast("numbers of flagged places", measure_contrast(drawn, picture(), number_color, True))
flagged.NumberColor = number_color
# The measurement finds what is not legible: white on a white part without the box, and white on light red.
summary.BoxOpacity, summary.FlaggedColor = 0.0, [1.0, 0.5, 0.5]
simple.LoadPalette("BlackBackground")
check_true("text and status that are not legible", max(measured[0] for measured in measure_summary()) < 4.5)
summary.BoxOpacity, summary.FlaggedColor = 0.7, [0.75, 0.1, 0.1]
simple.LoadPalette("BlueGrayBackground")

# Two summaries have headings, one has none.
heading = summary.SMProxy.GetProperty("Heading")
single = picture()
check_equal("the heading", f"MassProperties1 of {os.path.basename(Manifest(folder).special('open_solid')['path'])}", heading.GetElement(0))
other = MassProperties(Input=reader, registrationName="Another")  # noqa: F821
other.UpdatePipeline()
manager.ShowInPreferredView(other.SMProxy, 2, view.SMProxy)
rows_of_two = picture().reshape(480, 640, 3)
check_true("two summaries: the first moved down by a heading", abs(rows_of_two - single.reshape(480, 640, 3)).max(axis=2).any(axis=1).sum() > 100)
check_true("the heading of the second", simple.GetRepresentation(servermanager.OutputPort(other, 2), view).SMProxy.GetProperty(
    "Heading").GetElement(0).startswith("Another of "))
simple.SaveScreenshot(os.path.join(output, "PluginLegible.png"), view)
check_equal("errors", [], errors)
finish()
