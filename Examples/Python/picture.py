"""Pictures of the examples, which need no display: OpenGL renders where SolidMoments computes."""
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from solidmoments.smRenderingCompute import vtkComputeContext
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


def open_window(file, size):
    """The context, which has to be kept, and its window. Exits with the reason if there is no OpenGL for the picture `file`."""
    context = vtkComputeContext()
    if context.Start() != vtkComputeContext.READY:
        raise SystemExit(f"{file} was not drawn: {context.GetReason()}")
    window = context.GetRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(*size)
    return context, window


def save_window(window, file):
    """Renders the window and writes a PNG file."""
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()


def save_scene(renderer, file, size, direction, zoom):
    """Writes what the renderer shows, seen from a direction, with z upwards."""
    context, window = open_window(file, size)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*direction)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    save_window(window, file)
    window.RemoveRenderer(renderer)
    del context
