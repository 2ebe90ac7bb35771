"""
Mass properties of STEP files by ParaView and its plugin SolidMoments: a table of all solids and, if requested, a CSV file and a
picture of the part as Apply shows it in the window. Pictures need a display.

  pvpython paraview_mass_properties.py --plugin PREFIX/lib/paraview-5.11/plugins/SolidMoments/SolidMoments.so --png part.png part.step

PREFIX: where SolidMoments is installed, or its build folder.
Exit status: 0 all ok; 1 wrong usage, or a picture or CSV file that cannot be written; 2 a file that cannot be read; 3 a result
that is flagged. When several apply, the first of 1, 2, 3.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import mass_table  # noqa: E402

try:
    from paraview import servermanager, simple
    from vtkmodules.vtkCommonCore import vtkSMPTools
except ImportError as error:
    sys.exit(f"{error}\nRun this script by pvpython, or let PYTHONPATH name the folder that holds the package paraview.")

MARKER, SOLIDS, SUMMARY, BODIES = 0, 1, 2, 5  # ports of the filter


def can_draw():
    """False where the display does not answer; creating a view would then end the process."""
    abilities = servermanager.vtkPVRenderingCapabilitiesInformation
    return bool(abilities.GetLocalCapabilities() & abilities.RENDERING)


def make_pipeline(file, arguments):
    reader = simple.STEPReader(FileName=file, OutputUnit=arguments.unit)
    return simple.MassProperties(Input=reader, Density=arguments.density)


def draw(mass, path):
    """Writes a PNG file. Returns an error message, or an empty string."""
    if not can_draw():
        return "there is no display, or it does not answer"
    own = path + ".saving.png"
    try:
        open(own, "wb").close()  # SaveScreenshot() reports no error
    except OSError as error:
        return error.strerror
    view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0)
    view.GetRenderWindow().SetMultiSamples(0)
    for port in (BODIES, MARKER, SUMMARY):
        simple.Show(servermanager.OutputPort(mass, port), view)
    view.CameraPosition = [-1.0, -1.7, 1.1]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    view.GetActiveCamera().Zoom(1.3)
    simple.Render(view)
    simple.SaveScreenshot(own, view)
    simple.Delete(view)  # with one open, sys.exit() crashes ParaView 5.11
    try:
        if not os.path.getsize(own):
            os.remove(own)
            return "the file cannot be written"
        os.replace(own, path)
    except OSError as error:
        return error.strerror
    return ""


def compute(file, picture, arguments, rows):
    """Prints a file's table, adds to `rows`, draws. Returns the exit status."""
    if not os.path.isfile(file):
        mass_table.complain(f"{file} is unreadable: there is no such file")
        return mass_table.UNREADABLE
    mass = make_pipeline(file, arguments)
    # Tables and the marker are fetched as plain data; the bodies stay on the server.
    marker, solids = (servermanager.Fetch(mass, idx=port) for port in (MARKER, SOLIDS))
    status = mass_table.print_report(file, marker, solids, [], arguments, rows)  # VTK prints the messages
    return mass_table.add_picture(status, picture, lambda path: draw(mass, path))


def main():
    parser = mass_table.Parser(__doc__)
    parser.add_argument("--plugin", required=True, metavar="SolidMoments.so")
    arguments = parser.parse()
    vtkSMPTools.SetBackend("STDThread")  # VTK's default may be a single thread
    try:
        simple.LoadPlugin(arguments.plugin)
    except RuntimeError as error:
        return mass_table.complain(str(error))
    return mass_table.run(arguments, compute)


if __name__ == "__main__":
    sys.exit(main())
