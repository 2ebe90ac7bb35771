#!/usr/bin/env python3
"""
Mass properties of STEP files by VTK alone: a table of all solids and, if requested, a CSV file and a picture of the part,
translucent around its centre of mass and principal axes. Needs no display and no GPU.

  PYTHONPATH=PREFIX/lib/python3.11/site-packages python3 mass_properties.py --density 7850 --png part.png part.step

PREFIX: where SolidMoments is installed, or its build folder. pvpython runs it just as well.
Exit status: 0 all ok; 1 wrong usage, or a picture or CSV file that cannot be written; 2 a file that cannot be read; 3 a result
that is flagged. When several apply, the first of 1, 2, 3.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import mass_table  # noqa: E402

try:
    from vtkmodules.vtkCommonCore import vtkObject, vtkSMPTools
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkTextActor, vtkWindowToImageFilter
    import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws text)
    from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU
    from solidmoments.smReadersSTEP import vtkSTEPReader
    from solidmoments.smRenderingCompute import vtkComputeContext
except ImportError as error:
    mass_table.exit_without_package(error)
try:
    from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLBatchedPolyDataMapper  # noqa: F401  (from VTK 9.3 on)
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as CompositeMapper
except ImportError:
    # Until VTK 9.2 the class without the 2 is a different one, whose pictures differ.
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as CompositeMapper

SIZE = (900, 700)
STEEL, BLACK, RED = (0.40, 0.56, 0.78), (0.1, 0.1, 0.1), (0.85, 0.1, 0.1)


def make_pipeline(file, arguments):
    """Reader and filter, updated."""
    reader = vtkSTEPReader()
    reader.SetFileName(file)
    reader.SetOutputUnit(arguments.unit)
    mass = vtkMassPropertiesGPU()
    mass.SetInputConnection(reader.GetOutputPort())
    mass.SetDensity(arguments.density)
    mass.Update()
    return reader, mass


def messages(algorithm):
    return [algorithm.GetMessage(i) for i in range(algorithm.GetNumberOfMessages())]


def add_actor(renderer, mapper, port):
    mapper.SetInputConnection(port)
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    return actor


def make_scene(mass):
    """A renderer with the filter's outputs: bodies, marker and axes, and the text."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    # Depth peeling draws the layers of a translucent body in the right order.
    renderer.SetUseDepthPeeling(1)
    renderer.SetMaximumNumberOfPeels(12)
    renderer.SetUseFXAA(1)

    bodies = add_actor(renderer, CompositeMapper(), mass.GetOutputPort(5))
    bodies.GetMapper().ScalarVisibilityOff()
    bodies.GetProperty().SetColor(*STEEL)
    bodies.GetProperty().SetOpacity(0.4)
    marker = add_actor(renderer, vtkPolyDataMapper(), mass.GetOutputPort(0))  # green, or red: its scalars
    marker.GetProperty().SetLineWidth(2.0)

    summary = vtkTextActor()
    summary.SetInput(mass.GetOutputDataObject(2).GetColumnByName("Text").GetValue(0))
    style = summary.GetTextProperty()
    style.SetFontSize(16)
    style.SetColor(*(BLACK if mass.GetStatus() == "ok" else RED))
    style.SetVerticalJustificationToTop()
    summary.SetDisplayPosition(15, SIZE[1] - 15)
    renderer.AddViewProp(summary)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(-1.0, -1.7, 1.1)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    camera.Zoom(1.3)
    return renderer


def draw(mass, path):
    """Writes a PNG file. Returns an error message, or an empty string."""
    context = mass.GetComputeContext()  # the filter's own; its window draws off screen
    if context.Start() != vtkComputeContext.READY:
        return context.GetReason()
    window = context.GetRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    window.SetSize(*SIZE)
    renderer = make_scene(mass)
    window.AddRenderer(renderer)
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.WriteToMemoryOn()
    writer.Write()
    window.RemoveRenderer(renderer)
    try:
        mass_table.save_file(path, memoryview(writer.GetResult()))
    except OSError as error:
        return error.strerror
    return ""


def compute(file, picture, arguments, rows):
    """Prints a file's table, adds to `rows`, draws. Returns the exit status."""
    reader, mass = make_pipeline(file, arguments)
    status = mass_table.print_report(file, mass.GetOutputDataObject(0), mass.GetOutputDataObject(1),
                                     messages(reader) + messages(mass), arguments, rows)
    return mass_table.add_picture(status, picture, lambda path: draw(mass, path))


def main():
    arguments = mass_table.Parser(__doc__).parse()
    vtkSMPTools.SetBackend("STDThread")  # VTK's default may be a single thread
    vtkObject.GlobalWarningDisplayOff()  # the table has the messages
    return mass_table.run(arguments, compute)


if __name__ == "__main__":
    sys.exit(main())
