"""HeldView.py [drop]: shows an error of ParaView 5.11 and 5.13, without the plugin. A render view that Python still holds when
ResetSession() ends its session, and drops when the next session has a view, leaves that one with OpenGL errors, and ParaView ends with
SIGSEGV in DrawIBO() of the mapper of composite datasets. With `drop`, which gives the view up before the reset, all is drawn.
"""
import sys

from paraview import simple


def make_view():
    """Translucent spheres of a composite dataset, drawn once."""
    view = simple.CreateRenderView()
    spheres = [simple.Sphere(Center=[float(i), 0.0, 0.0]) for i in range(3)]
    simple.Show(simple.GroupDatasets(Input=spheres), view).Opacity = 0.5
    simple.Render(view)
    return view


held = make_view()
for session in range(4):
    if "drop" in sys.argv[1:]:
        held = None
    simple.ResetSession()
    held = make_view()
    simple.Render(held)
    print("session", session + 2, "is drawn", flush=True)
