"""TestPluginPictures.py MODE PLUGIN.so SOLIDS PARTS MODELS OUTPUT BASELINES: the view after Apply in ParaView, compared with
BASELINES/TestPluginPictures_MODE.png. Each is drawn once more with a property changed, which the comparison must detect.

part      translucent body with marker, axes and text
assembly  likewise, a marker in every solid
flagged   an open solid: red text
share     faces coloured by their share of the volume
volume    solids coloured by their volume
section   a part cut by a plane, closed by its section
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check_equal, finish  # noqa: E402
from smpicture import check_noticed, check_picture, read_picture, to_colors, write_picture  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

mode, plugin, solids, parts, models, output, baselines = sys.argv[1:8]
simple.LoadPlugin(plugin, ns=globals())
view = simple.CreateRenderView()
view.ViewSize = [640, 480]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.32, 0.34, 0.43]
view.GetRenderWindow().SetMultiSamples(0)


def draw(name):
    simple.Render(view)
    image = view.CaptureWindow(1)
    write_picture(image, os.path.join(output, name))
    return to_colors(image)


def apply(path, label="MassProperties", **properties):
    """Opens a file and shows the outputs of the filter as the GUI's Apply does."""
    reader = simple.OpenDataFile(path)
    if "gear_train" in path:
        reader.MeshDeviation, reader.MeshAngle = 0.005, 0.6  # drawing a million triangles takes most of the time
    mass = globals()[label](Input=reader, **properties)
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    for port in range(mass.SMProxy.GetNumberOfOutputPorts()):
        controller.ShowInPreferredView(mass.SMProxy, port, view.SMProxy)
    view.CameraPosition = [-1.0, -1.7, 1.1]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    return mass


def color_by(mass, array, low, high):
    """The bodies, opaque, by an array of their cells."""
    bodies = simple.GetRepresentation(servermanager.OutputPort(mass, 5), view)
    bodies.Opacity = 1.0
    simple.ColorBy(bodies, ("CELLS", array))
    colors = simple.GetColorTransferFunction(array)
    colors.ApplyPreset("Cool to Warm", True)  # ParaView 6 has another default
    colors.RescaleTransferFunction(low, high)
    bodies.SetScalarBarVisibility(view, True)
    return bodies


if mode == "part":
    mass = apply(os.path.join(models, "free_form_part.step"), Density=7850.0)
elif mode == "assembly":
    mass = apply(os.path.join(parts, "gear_train.step"), SolidMarkers=1)
elif mode == "flagged":
    mass = apply(Manifest(solids).special("open_solid")["path"])
elif mode == "share":
    mass = apply(os.path.join(models, "free_form_part.step"))
    color_by(mass, "FaceShare", 0.0, 0.08)
elif mode == "section":
    mass = apply(os.path.join(models, "free_form_part.step"), "Section", Point=[0.0, 2.0, -6.0], Normal=[-0.6, -1.0, 0.4], Density=7850.0)
else:
    check_equal("mode", "volume", mode)
    mass = apply(os.path.join(parts, "gear_train.step"))
    color_by(mass, "VolumeOfWholeSolid", 0.0, 2e5)

name = "TestPluginPictures_" + mode
expected = read_picture(os.path.join(baselines, name + ".png"))
check_picture(mode, expected, draw(name + ".png"))

if mode == "part":
    mass.ShowPrincipalAxes = 0
elif mode == "assembly":
    mass.SolidMarkers = 0
elif mode == "flagged":
    # The same text, not red.
    simple.GetRepresentation(servermanager.OutputPort(mass, 2), view).FlaggedColor = [1.0, 1.0, 1.0]
elif mode == "section":
    mass.Point = [0.0, 4.0, -6.0]
elif mode == "share":
    color_by(mass, "FaceGap", 0.0, 0.08)
else:
    color_by(mass, "Volume", 0.0, 3e5)
check_noticed(mode, expected, draw(name + "_wrong.png"))
finish()
